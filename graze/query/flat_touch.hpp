// SPDX-License-Identifier: MIT
// How balls, capsules and boxes touch each other in the plane: what penetration_of_simple and the patches of
// manifold.hpp find for any two shapes, of pairs whose cores are nearest, or least deep, at a side of one of them or
// clearly between two corners. As Box2D has it (Catto, "Contact Manifolds", GDC 2007): a side of one is the reference,
// and what lies over it of a side of the other is cut. Include manifold.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/clipped_patch.hpp>
#include <graze/query/flat_core.hpp>
#include <graze/query/manifold_points.hpp>
#include <graze/query/patch.hpp>
#include <graze/query/shape_order.hpp>
#include <graze/query/touch_look.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/capsule.hpp>
#include <graze/shape/obb.hpp>
#include <graze/shape/sphere.hpp>

namespace graze::detail {

/// A look that may show both points of a manifold.
struct FlatLook : TouchLook<2> {
  std::array<SurfacePair<2>, 2> points;
  std::size_t size = 0;

  std::size_t put_points(SurfacePair<2>* to) const {
    for (std::size_t i = 0; i < size; ++i) to[i] = points[i];
    return size;
  }
};

/// Two cores in the order of their contact, with so many axes each, one at least with a side.
template <std::size_t first_axes, std::size_t second_axes>
class FlatTouch {
 public:
  using V = Vec<2, double>;

  /// Seen from `origin`. `turns` if the second is the first of the pair.
  FlatTouch(const V& origin, const FlatCore<first_axes>& first, const FlatCore<second_axes>& second, bool turns)
      : origin_(origin),
        first_(first),
        second_(second),
        turns_(turns ? -1.0 : 1.0),
        size_(first.size() + second.size()),
        reach_(first.radius + second.radius),
        noise_(tolerance::rounding * size_),
        doubt_(tolerance::coarse * size_) {}

  FlatLook run() {
    find_side();
    const double depth = reach_ - gap_;
    if (depth < -doubt_) {
      FlatLook apart;
      apart.is_known = true;
      return apart;
    }
    // Sides that are too short to have a direction, and numbers that are not moderate, are left.
    const double shortest = std::min(first_.shortest(), second_.shortest());
    const bool is_plain = shortest > least_share * size_ && size_ > 0x1p-400 && size_ < 0x1p400 && depth > doubt_;
    if (!is_plain) return {};
    if (is_of_first_) return over_side<true>({axis_, side_, up_});
    FlatLook look = over_side<false>({axis_, side_, up_});
    if (look.is_known) take_carried_points(look);
    return look;
  }

 private:
  static constexpr double least_share = tolerance::known_direction;
  static constexpr bool are_boxes = first_axes == 2 && second_axes == 2;

  /// A side of a core: across which axis, at its half edge or, with -1, against it, and its normal.
  struct Side {
    std::size_t axis;
    double at;
    V up;
  };

  /// The reference side and the other core's: the ends of that as the reference sees them from its middle, and what is
  /// left of the way from one end to the other.
  struct Cut {
    Side own;
    std::size_t axis;  ///< The other side is across that.
    double at;
    std::array<double, 2> along;
    std::array<double, 2> above;
    std::array<double, 2> share;
    std::array<bool, 2> is_cut;
  };

  template <bool of_first>
  const auto& own() const {
    if constexpr (of_first) {
      return first_;
    } else {
      return second_;
    }
  }

  // ---- The side on which the cores are least deep

  void find_side() {
    for (std::size_t axis = FlatCore<first_axes>::first_face; axis < 2; ++axis) {
      try_side(first_, second_, axis, true);
    }
    for (std::size_t axis = FlatCore<second_axes>::first_face; axis < 2; ++axis) {
      try_side(second_, first_, axis, false);
    }
    up_ = (is_of_first_ ? first_.normal[axis_] : second_.normal[axis_]) * side_;
  }

  /// Of sides that are as good, up to rounding, the first.
  template <class Own, class Other>
  [[gnu::always_inline]] void try_side(const Own& own, const Other& other, std::size_t axis, bool is_of_first) {
    const V& normal = own.normal[axis];
    const double ahead = dot(normal, other.center - own.center);
    const double reach = std::fabs(dot(normal, own.half_edge[axis])) + std::fabs(dot(normal, other.half_edge[0])) +
                         std::fabs(dot(normal, other.half_edge[1]));
    const double gap = std::fabs(ahead) - reach;
    const bool is_better = gap > gap_ + noise_;
    gap_ = is_better ? gap : gap_;
    side_ = is_better ? std::copysign(1.0, ahead) : side_;
    axis_ = is_better ? axis : axis_;
    is_of_first_ = is_better ? is_of_first : is_of_first_;
  }

  // ---- What lies over the reference side

  template <bool of_first>
  FlatLook over_side(const Side& own_side) const {
    Cut cut = cut_at_ends<of_first>(own_side);
    const double half = own<of_first>().half_length[1 - own_side.axis];
    const double margin = least_share * size_;
    const double rise = cut.above[1] - cut.above[0];
    // The lowest place is an end that is clearly over the side; where both are as low, any place that is left.
    const double lowest = rise < 0 ? cut.along[1] : cut.along[0];
    const double left = (cut.share[1] - cut.share[0]) * std::fabs(cut.along[1] - cut.along[0]);
    const bool is_clear = std::fabs(lowest) < half - margin || (std::fabs(rise) <= noise_ && left > margin);
    if (is_clear || are_boxes) return on_side<of_first>(cut);
    return gap_ > margin ? between_corners<of_first>() : FlatLook{};
  }

  template <bool of_first>
  Cut cut_at_ends(const Side& own_side) const {
    const auto& own = this->own<of_first>();
    const auto& other = this->own<!of_first>();
    Cut cut;
    cut.own = own_side;
    cut.axis = incident_axis(other, own_side.up);
    cut.at = -std::copysign(1.0, dot(other.normal[cut.axis], own_side.up));
    const V off = other.middle(cut.axis, cut.at) - own.middle(own_side.axis, own_side.at);
    const V& half_edge = other.half_edge[1 - cut.axis];
    const V& along = own.along[1 - own_side.axis];
    const double middle = dot(off, along);
    const double half_way = dot(half_edge, along);
    const double height = dot(off, own_side.up);
    const double half_rise = dot(half_edge, own_side.up);
    cut.along = {middle - half_way, middle + half_way};
    cut.above = {height - half_rise, height + half_rise};
    // What is beyond the ends by more than rounding is cut.
    const double half = own.half_length[1 - own_side.axis];
    for (std::size_t i = 0; i < 2; ++i) {
      cut.is_cut[i] = std::fabs(cut.along[i]) > half + doubt_;
      const double share = (std::copysign(half, cut.along[i]) - cut.along[0]) / (2 * half_way);
      cut.share[i] = cut.is_cut[i] ? share : static_cast<double>(i);
    }
    return cut;
  }

  /// The axis across the side that looks most against a direction: of those that do so as much the first.
  template <std::size_t axes>
  static std::size_t incident_axis(const FlatCore<axes>& other, const V& up) {
    if constexpr (axes < 2) return 1;
    return looks_more(std::fabs(dot(other.normal[1], up)), std::fabs(dot(other.normal[0], up))) ? 1 : 0;
  }

  /// Whatever is above the reach is cut, too.
  template <bool of_first>
  FlatLook on_side(Cut& cut) const {
    constexpr std::size_t count = (of_first ? second_axes : first_axes) == 0 ? 1 : 2;
    if (count == 2 && !(cut.share[0] < cut.share[1])) return {};  // beside the side
    FlatLook look = found_at(reach_ - gap_, up_ * (is_of_first_ ? 1.0 : -1.0));
    const double rise = cut.above[1] - cut.above[0];
    std::array<bool, 2> is_at_height;
    for (std::size_t i = 0; i < count; ++i) {
      is_at_height[i] = cut.above[0] + rise * cut.share[i] > reach_ + doubt_;
    }
    if (is_at_height[0] && (count == 1 || is_at_height[1])) return {};  // rounding hides what is below
    for (std::size_t i = 0; i < count; ++i) {
      if (is_at_height[i]) cut.share[i] = (reach_ - cut.above[0]) / rise;
      look.points[i] = point_of<of_first>(cut, i, is_at_height[i]);
    }
    look.size = count;
    take_point(look, count == 2 && look.points[1].depth > look.points[0].depth ? 1 : 0);
    return look;
  }

  /// What is left of a side at one of its ends.
  template <bool of_first>
  SurfacePair<2> point_of(const Cut& cut, std::size_t i, bool is_at_height) const {
    const auto& own = this->own<of_first>();
    const auto& other = this->own<!of_first>();
    const V on_core = other.middle(cut.axis, cut.at) + other.half_edge[1 - cut.axis] * (2 * cut.share[i] - 1);
    const V up = up_ * (is_of_first_ == of_first ? 1.0 : -1.0);
    const V on_other = on_core - up * other.radius;
    const double gap = cut.above[0] + (cut.above[1] - cut.above[0]) * cut.share[i];
    const double depth = std::max(0.0, reach_ - gap);
    const bool is_at_corner = cut.is_cut[i] && !is_at_height;
    const Feature of_own =
        is_at_corner ? own.corner_of_side(cut.own.axis, cut.own.at, cut.along[i]) : own.side(cut.own.axis, cut.own.at);
    const Feature of_other = is_at_height || cut.is_cut[i]
                                 ? other.side(cut.axis, cut.at)
                                 : other.corner_of_side(cut.axis, cut.at, i == 1 ? 1.0 : -1.0);
    return pair_of<of_first>(on_other + up * depth, on_other, depth, of_own, of_other);
  }

  /// Where a side of the first core looks along the normal, too, it is that which carries the points, if not the
  /// contact.
  void take_carried_points(FlatLook& look) const {
    if constexpr (first_axes > 0) {
      for (std::size_t axis = FlatCore<first_axes>::first_face; axis < 2; ++axis) {
        const double side = -std::copysign(1.0, dot(first_.normal[axis], up_));
        const V up = first_.normal[axis] * side;
        if (!is_aligned(up, -up_)) continue;
        const FlatLook carried = over_side<true>({axis, side, up});
        look.is_known = carried.is_known;
        look.points = carried.points;
        look.size = carried.size;
      }
    }
  }

  // ---- Corners

  /// Cores that are apart, nearest at a corner of each.
  template <bool of_first>
  FlatLook between_corners() const {
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
    if (!is_clear || std::fabs(depth) <= doubt_) return {};
    const V normal = way * (1 / distance);
    FlatLook look = found_at(depth, of_first ? normal : -normal);
    look.points[0] = pair_of<of_first>(corner + normal * own.radius, corner + way - normal * other.radius, depth,
                                       own.corner_feature(own_sides), other.corner_feature(other_sides));
    look.size = 1;
    take_point(look, 0);
    return look;
  }

  /// Whether a way from a corner leads away from both sides, by more than what would be laid flat on one.
  template <std::size_t axes>
  static bool is_beyond(const FlatCore<axes>& core, const V& sides, const V& way, double distance) {
    constexpr double least_cosine = 16 * tolerance::aligned;
    bool result = true;
    for (std::size_t i = 0; i < axes; ++i) {
      const double side = i == 0 ? sides.x : sides.y;
      result = result && dot(way, core.along[i]) * side > least_cosine * distance;
    }
    return result;
  }

  // ---- From the first of the pair to the second

  /// With the normal from the first core to the second, but no points.
  FlatLook found_at(double depth, const V& normal) const {
    FlatLook look;
    look.is_known = true;
    look.meets = depth > 0;
    look.found.normal = normal * turns_;
    look.found.depth = depth;
    look.found.error = 2 * noise_;
    return look;
  }

  static void take_point(FlatLook& look, std::size_t i) {
    look.found.point_a = look.points[i].point_a;
    look.found.point_b = look.points[i].point_b;
  }

  template <bool of_first>
  SurfacePair<2> pair_of(const V& on_own, const V& on_other, double depth, const Feature& of_own,
                         const Feature& of_other) const {
    const V own = origin_ + on_own;
    const V other = origin_ + on_other;
    if ((turns_ > 0) == of_first) return {own, other, depth, of_own, of_other};
    return {other, own, depth, of_other, of_own};
  }

  V origin_;
  const FlatCore<first_axes>& first_;
  const FlatCore<second_axes>& second_;
  double turns_;
  double size_;
  double reach_;
  double noise_;
  double doubt_;
  double gap_ = -std::numeric_limits<double>::infinity();
  double side_ = 1;
  std::size_t axis_ = 0;
  bool is_of_first_ = false;
  V up_ = V(0.0);  ///< The normal of that side.
};

// ---- In the order of AnyShape

template <class A, class B>
FlatLook flat_look(const A& first, const B& second, bool turns) {
  const Vec<2, double> origin = flat_origin(first);
  const auto core_of_first = flat_core(first, origin);
  const auto core_of_second = flat_core(second, origin);
  return FlatTouch(origin, core_of_first, core_of_second, turns).run();
}

/// Of two of a type, in the order of their contact.
template <class S>
FlatLook flat_look_of_alike(const S& a, const S& b, bool turns) {
  return is_in_order(a, b) ? flat_look(a, b, turns) : flat_look(b, a, !turns);
}

template <class T>
FlatLook touch_look(const Sphere<2, T>& ball, const Aabb<2, T>& box, bool turns) {
  return flat_look(ball, box, turns);
}
template <class T>
FlatLook touch_look(const Sphere<2, T>& ball, const Obb<2, T>& box, bool turns) {
  return flat_look(ball, box, turns);
}
template <class T>
FlatLook touch_look(const Aabb<2, T>& box, const Capsule<2, T>& capsule, bool turns) {
  return flat_look(box, capsule, turns);
}
template <class T>
FlatLook touch_look(const Obb<2, T>& box, const Capsule<2, T>& capsule, bool turns) {
  return flat_look(box, capsule, turns);
}
/// The oriented one is the first in the order of contacts.
template <class T>
FlatLook touch_look(const Aabb<2, T>& a, const Obb<2, T>& b, bool turns) {
  return flat_look(b, a, !turns);
}
template <class T>
FlatLook touch_look(const Obb<2, T>& a, const Obb<2, T>& b, bool turns) {
  return flat_look_of_alike(a, b, turns);
}
template <class T>
FlatLook touch_look(const Capsule<2, T>& a, const Capsule<2, T>& b, bool turns) {
  return flat_look_of_alike(a, b, turns);
}

}  // namespace graze::detail
