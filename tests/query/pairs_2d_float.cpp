// SPDX-License-Identifier: MIT
#include "query/pairs_instances.hpp"

namespace graze::test {

template Relation relation_of<2, float>(const AnyShape<2, float>&, const AnyShape<2, float>&);
template ExactVerdict true_verdict<2, float>(const AnyShape<2, float>&, const AnyShape<2, float>&, Relation);

}  // namespace graze::test
