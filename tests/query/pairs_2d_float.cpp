// SPDX-License-Identifier: MIT
#include "query/pairs_instances.hpp"

namespace graze::test {

using Any = AnyShape<2, float>;
template Relation relation_of<2, float>(const Any&, const Any&);
template ExactVerdict true_verdict<2, float>(const Any&, const Any&, Relation);

}  // namespace graze::test
