// SPDX-License-Identifier: MIT
// Contacts of 2D capsules and boxes: the same results as the general penetration_of_simple and the patches of
// manifold.hpp, for pairs whose cores are nearest or least deep at a side of one of them, or clearly between two
// corners. As in Box2D (Catto, "Contact Manifolds", GDC 2007), a side of one is the reference, and a side of the other
// is clipped to it. Include manifold.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/fast_contact/cores_2d.hpp>
#include <graze/query/fast_contact/fast_result.hpp>
#include <graze/query/patch/clipped.hpp>
#include <graze/query/patch/manifold_points.hpp>
#include <graze/query/patch/patch.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/capsule.hpp>
#include <graze/shape/fields/shape_order.hpp>
#include <graze/shape/obb.hpp>

namespace graze::detail {

/// A result that may include both points of a manifold.
struct FastContact2d : FastContact<2> {
  std::array<SurfacePair<2>, 2> points;
  std::size_t size = 0;

  std::size_t put_points(SurfacePair<2>* to) const {
    for (std::size_t i = 0; i < size; ++i) to[i] = points[i];
    return size;
  }
};

using one_pair::Core2d;

/// The feature of the side of a core across an axis, at its half edge or, with -1, on the opposite side.
template <std::size_t axes>
[[gnu::always_inline]] inline Feature side_feature(const Core2d<axes>& /*core*/, bool across_second, double at) {
  return {FeatureKind::edge, axes == 2 ? (across_second ? 2U : 0U) | (at > 0 ? 1U : 0U) : 0U};
}
template <std::size_t axes>
[[gnu::always_inline]] inline Feature corner_feature(const Core2d<axes>& /*core*/, const Vec<2, double>& sides) {
  return {FeatureKind::vertex, (sides.x > 0 ? 1U : 0U) | (axes > 1 && sides.y > 0 ? 2U : 0U)};
}
/// The feature of the corner at one end of a side: `end` along the other axis.
template <std::size_t axes>
[[gnu::always_inline]] inline Feature corner_of_side(const Core2d<axes>& core, bool across_second, double at,
                                                     double end) {
  return corner_feature(core, across_second ? Vec<2, double>(end, at) : Vec<2, double>(at, end));
}

/// One of two values that belong to the axes. Not by an index, because arrays would then have to be in memory.
template <class V>
[[gnu::always_inline]] inline V of_axis(bool is_second, const V (&of_axes)[2]) {
  return is_second ? of_axes[1] : of_axes[0];
}

/// Two cores in the order of their contact, with one or two axes each. Written twice, here and for many pairs
/// (broad/contacts/2d/boxes-inl.hpp): with one source, which has to select where this branches, boxes took 1.15 times
/// as long.
template <std::size_t first_axes, std::size_t second_axes>
class Contact2d {
 public:
  using V = Vec<2, double>;

  /// Relative to `origin`. `turns` if the second core is the first shape of the pair.
  [[gnu::always_inline]] Contact2d(const V& origin, const Core2d<first_axes>& first, const Core2d<second_axes>& second,
                                   bool turns)
      : origin_(origin),
        first_(first),
        second_(second),
        turns_(turns ? -1.0 : 1.0),
        size_(first.size() + second.size()),
        reach_(first.radius + second.radius),
        noise_(tolerance::rounding * size_),
        doubt_(tolerance::coarse * size_) {}

  [[gnu::always_inline]] FastContact2d run() {
    find_side();
    const double depth = reach_ - gap_;
    FastContact2d look;
    look.is_known = depth < -doubt_;
    look.found.error = 2 * noise_;
    // Sides too short to have a direction, and very large or small numbers, are left to the general algorithm.
    const double shortest = std::min(first_.shortest(), second_.shortest());
    const bool is_plain = shortest > least_share * size_ && size_ > 0x1p-400 && size_ < 0x1p400 && depth > doubt_;
    if (!is_plain) return look;
    if (is_of_first_) {
      over_side<true>({across_second_, side_, up_}, look);
    } else {
      over_side<false>({across_second_, side_, up_}, look);
      if (look.is_known) put_on_first_if_along(look);
    }
    return look;
  }

 private:
  static constexpr double least_share = tolerance::known_direction;
  static constexpr bool are_boxes = first_axes == 2 && second_axes == 2;

  /// A side of a core: the axis it is across, whether it is at its half edge or, with -1, opposite, and its normal.
  struct Side {
    bool across_second;
    double at;
    V up;
  };

  /// The reference side and the other core's side: the ends of the other side relative to the middle of the reference
  /// side, and the part that remains of it after clipping.
  struct Cut {
    Side own;
    bool across_second;  ///< The other side is across that axis.
    double at;
    V middle;     ///< Of the other side.
    V half_edge;  ///< From there to its end.
    double half;  ///< Half the length of the reference side.
    double other_half;
    std::array<double, 2> along;
    std::array<double, 2> above;
    std::array<double, 2> share;
    std::array<bool, 2> is_cut;
  };

  template <bool of_first>
  [[gnu::always_inline]] const auto& own() const {
    if constexpr (of_first) {
      return first_;
    } else {
      return second_;
    }
  }

  // ---- The side of least depth

  [[gnu::always_inline]] void find_side() {
    if constexpr (first_axes == 2) try_side(first_, second_, 0, true);
    try_side(first_, second_, 1, true);
    if constexpr (second_axes == 2) try_side(second_, first_, 0, false);
    try_side(second_, first_, 1, false);
  }

  /// Of sides that are equally good up to rounding, the first.
  template <class Own, class Other>
  [[gnu::always_inline]] void try_side(const Own& own, const Other& other, std::size_t axis, bool is_of_first) {
    const V& normal = own.normal[axis];
    const double ahead = dot(normal, other.center - own.center);
    const double reach = std::fabs(dot(normal, own.half_edge[axis])) + std::fabs(dot(normal, other.half_edge[0])) +
                         std::fabs(dot(normal, other.half_edge[1]));
    const double gap = std::fabs(ahead) - reach;
    if (!(gap > gap_ + noise_)) return;
    gap_ = gap;
    side_ = std::copysign(1.0, ahead);
    across_second_ = axis == 1;
    is_of_first_ = is_of_first;
    up_ = normal * side_;
  }

  // ---- The part over the reference side

  template <bool of_first>
  [[gnu::always_inline]] void over_side(const Side& own_side, FastContact2d& look) const {
    Cut cut = cut_at_ends<of_first>(own_side);
    const double margin = least_share * size_;
    const double rise = cut.above[1] - cut.above[0];
    // The lowest point is an end that is clearly over the side; if both ends are equally low, any remaining point.
    const double lowest = rise < 0 ? cut.along[1] : cut.along[0];
    const double left = (cut.share[1] - cut.share[0]) * std::fabs(cut.along[1] - cut.along[0]);
    const bool is_clear = std::fabs(lowest) < cut.half - margin || (std::fabs(rise) <= noise_ && left > margin);
    if (is_clear || are_boxes) {
      on_side<of_first>(cut, look);
    } else if (gap_ > margin) {
      between_corners<of_first>(look);
    }
  }

  template <bool of_first>
  [[gnu::always_inline]] Cut cut_at_ends(const Side& own_side) const {
    const auto& own = this->own<of_first>();
    const auto& other = this->own<!of_first>();
    const auto of = [](bool is_second, const auto& of_axes) { return of_axis(is_second, of_axes); };
    Cut cut;
    cut.own = own_side;
    cut.across_second = is_second_incident(other, own_side.up);
    cut.at = -std::copysign(1.0, dot(of(cut.across_second, other.normal), own_side.up));
    cut.middle = other.center + of(cut.across_second, other.half_edge) * cut.at;
    cut.half_edge = of(!cut.across_second, other.half_edge);
    cut.half = of(!own_side.across_second, own.half_length);
    cut.other_half = of(!cut.across_second, other.half_length);
    const V off = cut.middle - (own.center + of(own_side.across_second, own.half_edge) * own_side.at);
    const V along = of(!own_side.across_second, own.along);
    const double middle = dot(off, along);
    const double half_way = dot(cut.half_edge, along);
    const double height = dot(off, own_side.up);
    const double half_rise = dot(cut.half_edge, own_side.up);
    cut.along = {middle - half_way, middle + half_way};
    cut.above = {height - half_rise, height + half_rise};
    // Anything beyond the ends by more than rounding is clipped.
    const double per_way = 0.5 / half_way;
    for (std::size_t i = 0; i < 2; ++i) {
      cut.is_cut[i] = std::fabs(cut.along[i]) > cut.half + doubt_;
      const double share = (std::copysign(cut.half, cut.along[i]) - cut.along[0]) * per_way;
      cut.share[i] = cut.is_cut[i] ? share : static_cast<double>(i);
    }
    return cut;
  }

  /// Whether the side across the second axis faces most against a direction; of equally good sides, the first.
  template <std::size_t axes>
  [[gnu::always_inline]] static bool is_second_incident(const Core2d<axes>& other, const V& up) {
    if constexpr (axes < 2) return true;
    return looks_more(std::fabs(dot(other.normal[1], up)), std::fabs(dot(other.normal[0], up)));
  }

  /// Whether a side of a box rests on another, up to `high`; as in FacingPatches.
  [[gnu::always_inline]] bool is_resting(const Cut& cut, double high) const {
    return are_boxes && high <= 2 * tolerance::aligned * std::min(cut.half, cut.other_half);
  }

  /// Anything above the reach is clipped, too, unless the whole side rests.
  template <bool of_first>
  [[gnu::always_inline]] void on_side(Cut& cut, FastContact2d& look) const {
    if (!(cut.share[0] < cut.share[1])) return;  // beside the side
    const double rise = cut.above[1] - cut.above[0];
    const double start = cut.above[0] + rise * cut.share[0];
    const double end = cut.above[0] + rise * cut.share[1];
    bool is_start_high = start > reach_ + doubt_;
    bool is_end_high = end > reach_ + doubt_;
    if (is_start_high && is_end_high) return;  // rounding hides whether anything is below
    if (is_resting(cut, std::max(start, end))) is_start_high = is_end_high = false;
    const double at_height = (reach_ - cut.above[0]) / rise;
    if (is_start_high) cut.share[0] = at_height;
    if (is_end_high) cut.share[1] = at_height;
    set_result(reach_ - gap_, up_ * (is_of_first_ ? 1.0 : -1.0), look);
    put_point<of_first>(cut, 0, is_start_high, look.points[0]);
    put_point<of_first>(cut, 1, is_end_high, look.points[1]);
    look.size = 2;
    take_point(look, look.points[1].depth > look.points[0].depth);
  }

  /// The point at one end of the clipped side.
  template <bool of_first>
  [[gnu::always_inline]] void put_point(const Cut& cut, std::size_t i, bool is_high, SurfacePair<2>& point) const {
    const auto& own = this->own<of_first>();
    const auto& other = this->own<!of_first>();
    const V on_core = cut.middle + cut.half_edge * (2 * cut.share[i] - 1);
    const V up = is_of_first_ == of_first ? up_ : -up_;
    const V on_other = on_core - up * other.radius;
    const double gap = cut.above[0] + (cut.above[1] - cut.above[0]) * cut.share[i];
    const double depth = std::max(0.0, reach_ - gap);
    const bool is_at_corner = cut.is_cut[i] && !is_high;
    const Feature of_own = is_at_corner ? corner_of_side(own, cut.own.across_second, cut.own.at, cut.along[i])
                                        : side_feature(own, cut.own.across_second, cut.own.at);
    const Feature of_other = is_high || cut.is_cut[i]
                                 ? side_feature(other, cut.across_second, cut.at)
                                 : corner_of_side(other, cut.across_second, cut.at, i == 1 ? 1.0 : -1.0);
    put_pair<of_first>(on_other + up * depth, on_other, depth, {of_own, of_other}, point);
  }

  /// If a side of the first core faces along the normal, too, the points are on that side, even if the contact is not.
  [[gnu::always_inline]] void put_on_first_if_along(FastContact2d& look) const {
    const bool is_first_along = first_axes == 2 && is_along(first_.normal[0]);
    if (is_first_along || is_along(first_.normal[1])) put_on_first(!is_first_along, look);
  }

  [[gnu::always_inline]] bool is_along(const V& normal) const {
    return is_aligned(normal, up_) || is_aligned(normal, -up_);
  }

  [[gnu::noinline]] void put_on_first(bool across_second, FastContact2d& look) const {
    const V normal = of_axis(across_second, first_.normal);
    const double side = -std::copysign(1.0, dot(normal, up_));
    FastContact2d on_first;
    over_side<true>({across_second, side, normal * side}, on_first);
    look.is_known = on_first.is_known;
    look.points = on_first.points;
    look.size = on_first.size;
  }

  // ---- Corners

  /// Disjoint cores that are nearest at a corner of each.
  template <bool of_first>
  [[gnu::always_inline]] void between_corners(FastContact2d& look) const {
    const auto& own = this->own<of_first>();
    const auto& other = this->own<!of_first>();
    V own_sides = own.sides_of(other.center);
    own_sides = own.sides_of(other.corner(other.sides_of(own.corner(own_sides))));
    const V corner = own.corner(own_sides);
    const V other_sides = other.sides_of(corner);
    const V way = other.corner(other_sides) - corner;
    const double distance = std::sqrt(dot(way, way));
    const bool is_clear = distance > least_share * size_ && is_beyond(own, own_sides, way, distance) &&
                          is_beyond(other, other_sides, -way, distance);
    const double depth = reach_ - distance;
    if (!is_clear || std::fabs(depth) <= doubt_) return;
    const V normal = way * (1 / distance);
    set_result(depth, of_first ? normal : -normal, look);
    put_pair<of_first>(corner + normal * own.radius, corner + way - normal * other.radius, depth,
                       {corner_feature(own, own_sides), corner_feature(other, other_sides)}, look.points[0]);
    look.size = 1;
    take_point(look, false);
  }

  /// Whether a direction from a corner points away from both sides, by more than the angle within which shapes lie flat
  /// on a side.
  template <std::size_t axes>
  [[gnu::always_inline]] static bool is_beyond(const Core2d<axes>& core, const V& sides, const V& way,
                                               double distance) {
    constexpr double least_cosine = 16 * tolerance::aligned;
    const bool of_first = dot(way, core.along[0]) * sides.x > least_cosine * distance;
    return of_first && (axes == 1 || dot(way, core.along[1]) * sides.y > least_cosine * distance);
  }

  // ---- From the first of the pair to the second

  /// With the normal from the first core to the second, but without points.
  [[gnu::always_inline]] void set_result(double depth, const V& normal, FastContact2d& look) const {
    look.is_known = true;
    look.meets = depth > 0;
    look.found.normal = normal * turns_;
    look.found.depth = depth;
  }

  [[gnu::always_inline]] static void take_point(FastContact2d& look, bool is_second) {
    look.found.point_a = is_second ? look.points[1].point_a : look.points[0].point_a;
    look.found.point_b = is_second ? look.points[1].point_b : look.points[0].point_b;
  }

  template <bool of_first>
  [[gnu::always_inline]] void put_pair(const V& on_own, const V& on_other, double depth,
                                       const std::array<Feature, 2>& features, SurfacePair<2>& pair) const {
    const V own = origin_ + on_own;
    const V other = origin_ + on_other;
    const bool is_own_first = (turns_ > 0) == of_first;
    pair.point_a = is_own_first ? own : other;
    pair.point_b = is_own_first ? other : own;
    pair.depth = depth;
    pair.feature_a = is_own_first ? features[0] : features[1];
    pair.feature_b = is_own_first ? features[1] : features[0];
  }

  V origin_;
  const Core2d<first_axes>& first_;
  const Core2d<second_axes>& second_;
  double turns_;
  double size_;
  double reach_;
  double noise_;
  double doubt_;
  double gap_ = -std::numeric_limits<double>::infinity();
  double side_ = 1;
  bool across_second_ = false;
  bool is_of_first_ = false;
  V up_ = V(0.0);  ///< The normal of that side.
};

// ---- In the order of AnyShape

template <class A, class B>
[[gnu::always_inline]] inline FastContact2d fast_contact_2d(const A& first, const B& second, bool turns) {
  const auto of_first = one_pair::numbers_of(first);
  const auto of_second = one_pair::numbers_of(second);
  const Vec<2, double> origin = one_pair::origin_2d(of_first);
  const auto core_of_first = one_pair::core_2d(of_first, origin);
  const auto core_of_second = one_pair::core_2d(of_second, origin);
  return Contact2d(origin, core_of_first, core_of_second, turns).run();
}

/// For two shapes of a type, in the order of their contact.
template <class S>
FastContact2d fast_contact_2d_of_alike(const S& a, const S& b, bool turns) {
  const bool is_first = is_in_order(a, b);
  return fast_contact_2d(is_first ? a : b, is_first ? b : a, turns == is_first);
}

template <class T>
FastContact2d find_fast_contact(const Aabb<2, T>& box, const Capsule<2, T>& capsule, bool turns) {
  return fast_contact_2d(box, capsule, turns);
}
template <class T>
FastContact2d find_fast_contact(const Obb<2, T>& box, const Capsule<2, T>& capsule, bool turns) {
  return fast_contact_2d(box, capsule, turns);
}
/// The oriented box is the first in the order of contacts.
template <class T>
FastContact2d find_fast_contact(const Aabb<2, T>& a, const Obb<2, T>& b, bool turns) {
  return fast_contact_2d(b, a, !turns);
}
template <class T>
FastContact2d find_fast_contact(const Obb<2, T>& a, const Obb<2, T>& b, bool turns) {
  return fast_contact_2d_of_alike(a, b, turns);
}
template <class T>
FastContact2d find_fast_contact(const Capsule<2, T>& a, const Capsule<2, T>& b, bool turns) {
  return fast_contact_2d_of_alike(a, b, turns);
}

}  // namespace graze::detail
