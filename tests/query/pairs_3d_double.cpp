// SPDX-License-Identifier: MIT
#include "query/pairs_instances.hpp"

namespace graze::test {

template Relation relation_of<3, double>(const AnyShape<3, double>&, const AnyShape<3, double>&);
template ExactVerdict true_verdict<3, double>(const AnyShape<3, double>&, const AnyShape<3, double>&, Relation);

}  // namespace graze::test
