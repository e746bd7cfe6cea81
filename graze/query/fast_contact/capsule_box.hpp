// SPDX-License-Identifier: MIT
// How a capsule touches a box in space: what penetration_of_simple and the patches of manifold.hpp find for any two
// shapes, of capsules whose axis is clearly out of the box or clearly in it, and the nearest to its surface over one of
// its faces, or at one place of an edge or a corner. Include manifold.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/contact/boxes.hpp>
#include <graze/query/fast_contact/axis_over_face.hpp>
#include <graze/query/fast_contact/fast_result.hpp>
#include <graze/query/fast_contact/minimum_translation.hpp>
#include <graze/query/fast_contact/oriented_box.hpp>
#include <graze/query/fast_contact/sphere_box.hpp>
#include <graze/query/fast_contact/spheres_and_capsules.hpp>
#include <graze/query/patch/clipped.hpp>
#include <graze/query/patch/manifold_points.hpp>
#include <graze/query/patch/patch.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/capsule.hpp>
#include <graze/shape/obb.hpp>

namespace graze::detail {

/// A segment as a box sees it along its axes, up to how far these are from orthonormal.
struct WayPastBox {
  Vec<3, double> start;
  Vec<3, double> way;
  Vec<3, double> half_extents;

  Vec<3, double> at(double t) const { return start + way * t; }

  /// Half of how the squared distance grows with t, which is more the larger t is.
  double slope(double t) const {
    double result = 0;
    for (Dim i = 0; i < 3; ++i) {
      const double x = start[i] + way[i] * t;
      result += way[i] * (x - std::min(std::max(x, -half_extents[i]), half_extents[i]));
    }
    return result;
  }

  /// Where it is nearest, from 0 to 1: the slope is a straight line between the places where the segment passes a side.
  double nearest() const {
    double low = 0;
    double high = 1;
    double slope_low = slope(low);
    if (slope_low >= 0) return 0;
    double slope_high = slope(high);
    if (slope_high <= 0) return 1;
    for (Dim i = 0; i < 3; ++i) {
      const double per_way = 1 / way[i];
      for (const double side : {-half_extents[i], half_extents[i]}) {
        const double t = (side - start[i]) * per_way;
        if (!(t > low && t < high)) continue;
        const double here = slope(t);
        (here < 0 ? low : high) = t;
        (here < 0 ? slope_low : slope_high) = here;
      }
    }
    return low - slope_low * (high - low) / (slope_high - slope_low);
  }
};

/// On a face a capsule may have two points, which not all who look want.
struct CapsuleLook : FastContact<3> {
  std::optional<AxisOverFace> over;

  std::size_t put_points(SurfacePair<3>* points) const {
    if (!over) return FastContact<3>::put_points(points);
    return over->put_points(points);
  }
};

/// On which side of a box' faces a place is, by more than what is in doubt.
struct PlaceByFaces {
  std::array<bool, 3> is_beyond{};
  int count = 0;         ///< Of the axes along which it is.
  Dim last = 0;          ///< The last of them.
  bool is_clear = true;  ///< Whether it is in no doubt on which side it is.
  double squared = 0;    ///< How far it is from the box.
  double least_beyond = std::numeric_limits<double>::infinity();

  PlaceByFaces(const Vec<3, double>& place, const Vec<3, double>& half_extents, double doubt) {
    for (Dim i = 0; i < 3; ++i) {
      const double beyond = std::fabs(place[i]) - half_extents[i];
      is_clear = is_clear && std::fabs(beyond) > doubt;
      squared += std::max(beyond, 0.0) * std::max(beyond, 0.0);
      if (!(beyond > doubt)) continue;
      is_beyond[static_cast<std::size_t>(i)] = true;
      ++count;
      last = i;
      least_beyond = std::min(least_beyond, beyond);
    }
  }
};

/// A capsule and a box, seen from the capsule's first end.
class CapsuleTouch {
 public:
  explicit CapsuleTouch(const CapsuleAndBox& pair) : pair_(pair), size_(pair_.size()) {
    const Obb<3, double>& box = pair_.box;
    for (Dim i = 0; i < 3; ++i) {
      seen_.start[i] = -dot(box.center, box.axes[i]);
      seen_.way[i] = dot(pair_.way, box.axes[i]);
    }
    seen_.half_extents = box.half_extents;
    // Of places, by the axes: twice what the quick test of a sphere allows for, and what is far above rounding.
    constexpr double least_orthonormality_error = 1e-10;
    doubt_ = 2 * tolerance::box_filter * (orthonormality_error_of_axes(box.axes) + least_orthonormality_error) * size_;
  }

  CapsuleLook run() const {
    CapsuleLook look;
    const double t = seen_.nearest();
    const Vec<3, double> place = seen_.at(t);
    const PlaceByFaces by_faces(place, pair_.box.half_extents, doubt_);
    const double reach = pair_.radius + doubt_;
    if (by_faces.squared > reach * reach) {
      look.is_known = true;
      look.found.error = 2 * tolerance::rounding * size_;
      return look;
    }
    const Vec<3, double>& half = pair_.box.half_extents;
    if (!(std::min(std::min(half.x, half.y), half.z) > doubt_)) return look;
    if (by_faces.squared <= doubt_ * doubt_) {
      find_minimum_translation(look);
    } else if (by_faces.count == 1) {
      lie_on_face({by_faces.last, place[by_faces.last] > 0}, false, look);
    } else if (by_faces.is_clear) {
      pass_by(t, place, by_faces, look);
    }
    return look;
  }

 private:
  /// Of an axis in the box.
  void find_minimum_translation(CapsuleLook& look) const {
    const MinimumTranslation way = MinimumTranslationSearch(seen_.start, seen_.way, pair_.box.half_extents, doubt_)
                                       .run(tolerance::rounding * size_);
    if (!way.is_known) return;
    if (way.is_face) {
      lie_on_face({way.axis, way.outward[way.axis] > 0}, way.is_level, look);
      return;
    }
    std::array<bool, 3> is_beyond{true, true, true};
    is_beyond[static_cast<std::size_t>(way.axis)] = false;
    cross_edge(way.outward, is_beyond, look);
    look.is_single = way.is_oblique;
  }

  /// The lowest place is the nearest, or the deepest, if it is over the face.
  void lie_on_face(const BoxFaceNumbers& face, bool has_to_be_level, CapsuleLook& look) const {
    const AxisOverFace& over = look.over.emplace(pair_, size_, face);
    const SurfacePair<3> lowest = over.lowest_pair();
    judge(pair_.radius - over.lowest_gap(), over.is_lowest_over() && (over.is_level() || !has_to_be_level), look);
    look.found.normal = over.up() * (pair_.turns ? -1.0 : 1.0);
    look.found.point_a = lowest.point_a;
    look.found.point_b = lowest.point_b;
    look.set_features({FeatureKind::face, face.face()}, {FeatureKind::vertex, over.lowest_end()}, pair_.turns);
  }

  /// Of an axis out of the box, and nearest to it at t, beside an edge or a corner.
  void pass_by(double t, const Vec<3, double>& place, const PlaceByFaces& by_faces, CapsuleLook& look) const {
    const bool is_at_end = t <= 0 || t >= 1;
    const double along = t * max_abs(pair_.way);
    if (!is_at_end && !(along > doubt_ && max_abs(pair_.way) - along > doubt_)) return;
    if (is_at_end) {
      end_at(t <= 0 ? 0 : 1, place, by_faces, look);
    } else if (by_faces.count == 2) {
      cross_edge(place, by_faces.is_beyond, look);
    } else {
      pass_corner(place, look);
    }
    // On a face that the normal is hardly turned from it would be laid flat.
    constexpr double least_cosine = 16 * tolerance::aligned;
    look.is_single = by_faces.least_beyond > least_cosine * std::sqrt(by_faces.squared);
  }

  /// The middle of the edge at the sides that a place is beyond, or a corner.
  Vec<3, double> middle_at(const Vec<3, double>& place, const std::array<bool, 3>& is_beyond) const {
    Vec<3, double> result = pair_.box.center;
    for (Dim i = 0; i < 3; ++i) {
      const double side =
          is_beyond[static_cast<std::size_t>(i)] ? std::copysign(pair_.box.half_extents[i], place[i]) : 0.0;
      result += pair_.box.axes[i] * side;
    }
    return result;
  }

  static Dim edge_beside(const std::array<bool, 3>& is_beyond) { return is_beyond[0] ? (is_beyond[1] ? 2 : 1) : 0; }

  /// The axis' place there is the nearest if the way from it leads away from the box' nearest point: both are convex.
  void end_at(std::uint32_t end, const Vec<3, double>& place, const PlaceByFaces& by_faces, CapsuleLook& look) const {
    const Vec<3, double> on_axis = pair_.way * (end == 0 ? 0.0 : 1.0);
    Vec<3, double> on_box = middle_at(place, by_faces.is_beyond);
    bool is_on_edge = true;
    if (by_faces.count == 2) {
      const Dim along = edge_beside(by_faces.is_beyond);
      const Vec<3, double>& edge = pair_.box.axes[along];
      const double on_edge = dot(edge, on_axis - on_box) / dot(edge, edge);
      is_on_edge = std::fabs(on_edge) < pair_.box.half_extents[along];
      on_box += edge * on_edge;
    }
    touch_at(on_box, on_axis, look);
    const double away = dot(pair_.way, look.found.normal) * (pair_.turns == (end == 0) ? -1.0 : 1.0);
    look.is_known = look.is_known && is_on_edge && away >= -tolerance::rounding * sum_abs(pair_.way);
    look.set_features(feature_of_box(place, by_faces.is_beyond), {FeatureKind::vertex, end}, pair_.turns);
  }

  /// Where two lines are nearest, as in segment_filter.hpp. The normal is across both, on the side of the edge that is
  /// out of the box, on which the axis need not be.
  void cross_edge(const Vec<3, double>& place, const std::array<bool, 3>& is_beyond, CapsuleLook& look) const {
    constexpr double least_sine_squared = 1.0 / 64;
    const Dim along = edge_beside(is_beyond);
    const Vec<3, double> middle = middle_at(place, is_beyond);
    const Vec<3, double>& edge = pair_.box.axes[along];
    const Vec<3, double>& way = pair_.way;
    const double uu = dot(way, way);
    const double vv = dot(edge, edge);
    const double uv = dot(way, edge);
    const double uw = dot(way, middle);
    const double vw = dot(edge, middle);
    const double det = uu * vv - uv * uv;
    const double per_det = 1 / det;
    const double on_axis = (uw * vv - vw * uv) * per_det;
    const double on_edge = (uw * uv - vw * uu) * per_det;
    const Vec<3, double> across = cross(way, edge);
    const double length = std::sqrt(dot(across, across));
    const Vec<3, double> normal = across * (std::copysign(1.0, dot(across, middle - pair_.box.center)) / length);
    const double gap = -dot(normal, middle);
    const double place_along = on_axis * max_abs(way);
    judge(pair_.radius - gap,
          det > least_sine_squared * (uu * vv) && place_along > doubt_ && max_abs(way) - place_along > doubt_ &&
              pair_.box.half_extents[along] - std::fabs(on_edge) > doubt_,
          look);
    const Vec<3, double> on_box = middle + edge * on_edge;
    look.set(normal, pair_.radius - gap, pair_.origin + on_box, pair_.origin + (way * on_axis - normal * pair_.radius),
             pair_.turns);
    look.set_features(feature_of_box(place, is_beyond), {FeatureKind::edge, 0}, pair_.turns);
  }

  void pass_corner(const Vec<3, double>& place, CapsuleLook& look) const {
    const Vec<3, double> corner = middle_at(place, {true, true, true});
    const double on_axis = dot(pair_.way, corner) / dot(pair_.way, pair_.way);
    touch_at(corner, pair_.way * on_axis, look);
    look.is_known = look.is_known && on_axis > 0 && on_axis < 1;
    look.set_features(feature_of_box(place, {true, true, true}), {FeatureKind::edge, 0}, pair_.turns);
  }

  /// Of two points that are the nearest, as touch_of_cores.
  void touch_at(const Vec<3, double>& on_box, const Vec<3, double>& on_axis, CapsuleLook& look) const {
    const Vec<3, double> between = on_axis - on_box;
    const double distance = std::sqrt(dot(between, between));
    const double depth = pair_.radius - distance;
    judge(depth, distance > tolerance::known_direction * size_, look);
    const Vec<3, double> normal = between * (1 / distance);
    look.set(normal, depth, pair_.origin + on_box, pair_.origin + (on_axis - normal * pair_.radius), pair_.turns);
  }

  /// What is known of a depth, if it is known where it is.
  void judge(double depth, bool is_place_known, CapsuleLook& look) const {
    const double doubt = tolerance::coarse * size_;
    look.is_known = is_place_known && std::fabs(depth) > doubt;
    look.meets = depth > doubt;
    look.found.depth = depth;
    look.found.error = 2 * tolerance::rounding * size_;
  }

  const CapsuleAndBox& pair_;
  double size_;
  double doubt_;
  WayPastBox seen_;
};

template <class T, class Box>
CapsuleLook look_at_capsule(const Box& box, const Capsule<3, T>& capsule, bool turns) {
  const Vec<3, double> origin = wide<3, T>(capsule.a);
  const CapsuleAndBox pair{origin, wide<3, T>(capsule.b) - origin, static_cast<double>(capsule.radius),
                           oriented_box_from(origin, box), turns};
  return CapsuleTouch(pair).run();
}

template <class T>
CapsuleLook find_fast_contact(const Aabb<3, T>& box, const Capsule<3, T>& capsule, bool turns) {
  return look_at_capsule(box, capsule, turns);
}
template <class T>
CapsuleLook find_fast_contact(const Obb<3, T>& box, const Capsule<3, T>& capsule, bool turns) {
  return look_at_capsule(box, capsule, turns);
}

}  // namespace graze::detail
