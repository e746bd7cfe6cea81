// SPDX-License-Identifier: MIT
#include "query/manifolds.hpp"

namespace graze::test {

template <>
Manifold<2, float> manifold_of<2, float>(const AnyShape<2, float>& a, const AnyShape<2, float>& b) {
  return manifold(a, b);
}

}  // namespace graze::test
