// SPDX-License-Identifier: MIT
#include <graze/broad/touching/manifolds.hpp>

namespace graze {

template Manifold<3, float> manifold(const AnyShape<3, float>&, const AnyShape<3, float>&);
template Manifold<3, double> manifold(const AnyShape<3, double>&, const AnyShape<3, double>&);

}  // namespace graze
