// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/hull/frame.hpp>
#include <graze/shape/hull/quickhull.hpp>

namespace graze::detail {

/// Groups the faces of a hull that are coplanar up to rounding, by union-find. A group is identified by its smallest
/// face index.
template <class T>
class FlatParts {
 public:
  explicit FlatParts(const Quickhull<T>& hull) : hull_(&hull), parts_(hull.faces().size()) {
    std::iota(parts_.begin(), parts_.end(), 0U);
    for (std::uint32_t face = 0; face < hull.faces().size(); ++face) {
      if (hull.faces()[face].is_alive) join_around(face);
    }
  }

  std::uint32_t of(std::uint32_t face) {
    while (parts_[face] != face) face = parts_[face] = parts_[parts_[face]];
    return face;
  }

 private:
  using Face = typename Quickhull<T>::Face;

  void join(std::uint32_t a, std::uint32_t b) {
    a = of(a);
    b = of(b);
    parts_[std::max(a, b)] = std::min(a, b);
  }

  /// For a needle-shaped face, even distant points are within the error of its plane. It joins only the face beyond its
  /// longest side; otherwise it would join faces that meet at an edge.
  void join_around(std::uint32_t place) {
    const Face& face = hull_->faces()[place];
    if (is_needle(face)) {
      join(place, face.twins[longest_side(face)] / 4);
      return;
    }
    for (std::uint32_t side = 0; side < 3; ++side) {
      const std::uint32_t beyond = face.twins[side] / 4;
      if (beyond < place || is_needle(hull_->faces()[beyond])) continue;
      if (is_flat(4 * place + side) && is_flat(face.twins[side])) join(place, beyond);
    }
  }

  static bool is_needle(const Face& face) {
    return !(face.plane.doubt < tolerance::hull_needle * sum_abs(face.plane.normal));
  }

  std::size_t longest_side(const Face& face) const {
    std::size_t longest = 0;
    double most = -1;
    for (std::size_t side = 0; side < 3; ++side) {
      const Vec<3, double> way =
          hull_->corners()[face.corners[(side + 1) % 3]].place - hull_->corners()[face.corners[side]].place;
      if (!(dot(way, way) > most)) continue;
      most = dot(way, way);
      longest = side;
    }
    return longest;
  }

  /// Whether the face beyond a half-edge is not clearly bent away from this one.
  bool is_flat(std::uint32_t half_edge) const {
    const HullPlane& plane = hull_->faces()[half_edge / 4].plane;
    const std::uint32_t last = Quickhull<T>::next(Quickhull<T>::next(hull_->twin(half_edge)));
    return plane.height(hull_->corners()[hull_->origin(last)].place) > -plane.doubt;
  }

  const Quickhull<T>* hull_;
  std::vector<std::uint32_t> parts_;
};

}  // namespace graze::detail
