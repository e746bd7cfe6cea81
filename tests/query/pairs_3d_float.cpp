// SPDX-License-Identifier: MIT
#include "query/pairs_instances.hpp"

namespace graze::test {

using Any = AnyShape<3, float>;
template Relation relation_of<3, float>(const Any&, const Any&);
template ExactVerdict true_verdict<3, float>(const Any&, const Any&, Relation);

}  // namespace graze::test
