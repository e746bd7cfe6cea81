// SPDX-License-Identifier: MIT
#include "query/manifolds.hpp"

namespace graze::test {

template <>
Manifold<2, double> manifold_of<2, double>(const AnyShape<2, double>& a, const AnyShape<2, double>& b) {
  return manifold(a, b);
}

}  // namespace graze::test
