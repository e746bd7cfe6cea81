// SPDX-License-Identifier: MIT
#include "query/manifolds.hpp"

namespace graze::test {

template <>
Manifold<3, double> manifold_of<3, double>(const AnyShape<3, double>& a, const AnyShape<3, double>& b) {
  return manifold(a, b);
}

}  // namespace graze::test
