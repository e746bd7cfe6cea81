// SPDX-License-Identifier: MIT
#include "query/manifolds.hpp"

namespace graze::test {

template <>
Manifold<3, float> manifold_of<3, float>(const AnyShape<3, float>& a, const AnyShape<3, float>& b) {
  return manifold(a, b);
}

}  // namespace graze::test
