// SPDX-License-Identifier: MIT
#include "query/pairs_instances.hpp"

namespace graze::test {

using Any = AnyShape<3, double>;
template Relation relation_of<3, double>(const Any&, const Any&);
template ExactVerdict true_verdict<3, double>(const Any&, const Any&, Relation);

}  // namespace graze::test
