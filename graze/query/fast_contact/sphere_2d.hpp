// SPDX-License-Identifier: MIT
// How a sphere touches a box in the plane: what penetration_of_simple and the patches of manifold.hpp find for any two
// shapes, of spheres whose center is clearly in the box or clearly out of it, over a side or beyond a corner. Include
// manifold.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/fast_contact/cores_2d.hpp>
#include <graze/query/fast_contact/fast_result.hpp>
#include <graze/query/patch/clipped.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/obb.hpp>
#include <graze/shape/sphere.hpp>

namespace graze::detail {

/// A sphere and a box that is seen from its center.
class SphereContact2d {
 public:
  using V = Vec<2, double>;

  /// `turns` if the box is the first of both.
  [[gnu::always_inline]] SphereContact2d(const V& center, double radius, const Core2d<2>& box, bool turns)
      : center_(center), radius_(radius), box_(box), turns_(turns), size_(box.size() + radius) {}

  [[gnu::always_inline]] FastContact<2> run() const {
    const V way = -box_.center;
    const double ahead_x = dot(way, box_.normal[0]);
    const double ahead_y = dot(way, box_.normal[1]);
    const double gap_x = std::fabs(ahead_x) - dot(box_.half_edge[0], box_.normal[0]);
    const double gap_y = std::fabs(ahead_y) - dot(box_.half_edge[1], box_.normal[1]);
    const bool is_y = gap_y > gap_x + tolerance::rounding * size_;  // of sides that are as good the first
    const double gap = is_y ? gap_y : gap_x;
    const double doubt = tolerance::coarse * size_;
    FastContact<2> look;
    look.is_known = gap - radius_ > doubt;
    look.found.error = 2 * tolerance::rounding * size_;
    const double margin = tolerance::known_direction * size_;
    const bool is_plain = std::min(box_.half_length[0], box_.half_length[1]) > margin && size_ > 0x1p-400 &&
                          size_ < 0x1p400 && radius_ - gap > doubt;
    if (!is_plain) return look;
    const double side = std::copysign(1.0, is_y ? ahead_y : ahead_x);
    const V half_edge = is_y ? box_.half_edge[1] : box_.half_edge[0];
    const V along = is_y ? box_.along[0] : box_.along[1];
    const double half = is_y ? box_.half_length[0] : box_.half_length[1];
    const double place = dot(way - half_edge * side, along);
    if (std::fabs(place) < half - margin) {
      const V up = (is_y ? box_.normal[1] : box_.normal[0]) * side;
      set(look, up, gap, {FeatureKind::edge, (is_y ? 2U : 0U) + (side > 0 ? 1U : 0U)});
    } else if (gap > margin) {
      find_corner(look, way);
    }
    return look;
  }

 private:
  /// From the box' surface, `gap` below the center, up to that.
  [[gnu::always_inline]] void set(FastContact<2>& look, const V& up, double gap, const Feature& of_box) const {
    look.is_known = look.meets = look.is_single = true;
    look.set(-up, radius_ - gap, center_ - up * radius_, center_ - up * gap, turns_);
    look.set_features({FeatureKind::vertex, 0}, of_box, turns_);
  }

  /// Beyond both sides at a corner by more than what would be laid flat on one.
  [[gnu::always_inline]] void find_corner(FastContact<2>& look, const V& way) const {
    constexpr double least_cosine = 16 * tolerance::aligned;
    const double x = dot(way, box_.half_edge[0]);
    const double y = dot(way, box_.half_edge[1]);
    const V sides(std::copysign(1.0, x), std::copysign(1.0, y));
    const V up = -box_.corner(sides);
    const double distance = std::sqrt(dot(up, up));
    const double least = least_cosine * distance;
    const double depth = radius_ - distance;
    const bool is_beyond = dot(up, box_.along[0]) * sides.x > least && dot(up, box_.along[1]) * sides.y > least;
    if (!is_beyond || std::fabs(depth) <= tolerance::coarse * size_) return;
    look.is_known = true;
    if (depth > 0) set(look, up * (1 / distance), distance, Core2d<2>::corner_feature(sides));
  }

  V center_;
  double radius_;
  const Core2d<2>& box_;
  bool turns_;
  double size_;
};

template <class T, class Box>
[[gnu::always_inline]] inline FastContact<2> look_at_sphere_2d(const Sphere<2, T>& sphere, const Box& box, bool turns) {
  const Vec<2, double> center = wide<2, T>(sphere.center);
  const Core2d<2> core = core_2d(box, center);
  return SphereContact2d(center, static_cast<double>(sphere.radius), core, turns).run();
}

template <class T>
[[gnu::always_inline]] inline FastContact<2> find_fast_contact(const Sphere<2, T>& sphere, const Aabb<2, T>& box,
                                                               bool turns) {
  return look_at_sphere_2d(sphere, box, turns);
}
template <class T>
[[gnu::always_inline]] inline FastContact<2> find_fast_contact(const Sphere<2, T>& sphere, const Obb<2, T>& box,
                                                               bool turns) {
  return look_at_sphere_2d(sphere, box, turns);
}

}  // namespace graze::detail
