// SPDX-License-Identifier: MIT
#include "query/pairs_instances.hpp"

namespace graze::test {

template Relation relation_of<2, double>(const AnyShape<2, double>&, const AnyShape<2, double>&);
template ExactVerdict true_verdict<2, double>(const AnyShape<2, double>&, const AnyShape<2, double>&, Relation);

}  // namespace graze::test
