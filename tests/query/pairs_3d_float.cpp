// SPDX-License-Identifier: MIT
#include "query/pairs_instances.hpp"

namespace graze::test {

template Relation relation_of<3, float>(const AnyShape<3, float>&, const AnyShape<3, float>&);
template ExactVerdict true_verdict<3, float>(const AnyShape<3, float>&, const AnyShape<3, float>&, Relation);

}  // namespace graze::test
