// SPDX-License-Identifier: MIT
#include <graze/broad/touching/relations.hpp>

namespace graze {

template Relation relation(const AnyShape<2, float>&, const AnyShape<2, float>&);
template Relation relation(const AnyShape<3, float>&, const AnyShape<3, float>&);
template Relation relation(const AnyShape<2, double>&, const AnyShape<2, double>&);
template Relation relation(const AnyShape<3, double>&, const AnyShape<3, double>&);

}  // namespace graze
