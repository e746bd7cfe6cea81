// SPDX-License-Identifier: MIT
#include <graze/broad/touching/manifolds.hpp>

namespace graze {

template Manifold<2, float> manifold(const AnyShape<2, float>&, const AnyShape<2, float>&);
template Manifold<2, double> manifold(const AnyShape<2, double>&, const AnyShape<2, double>&);

}  // namespace graze
