// SPDX-License-Identifier: MIT
// How a ball touches an oriented box in space, in the box' own coordinates: what penetration_of_simple and the patches
// of manifold.hpp find for any two shapes, of balls whose center is clearly in the box or clearly out of it, and not
// nearly above the line between two of its faces, edges and corners. Include manifold.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/clipped_patch.hpp>
#include <graze/query/patch.hpp>
#include <graze/query/penetration.hpp>
#include <graze/query/surface_point.hpp>
#include <graze/query/surface_point_box.hpp>
#include <graze/shape/obb.hpp>
#include <graze/shape/shape.hpp>
#include <graze/shape/sphere.hpp>

namespace graze::detail {

/// A ball and an oriented box in space, for which there is a quick way.
template <class A, class B>
inline constexpr bool are_ball_and_obb = false;
template <class T>
inline constexpr bool are_ball_and_obb<Sphere<3, T>, Obb<3, T>> = true;

/// What a quick look at a ball and a box shows.
struct BallOnBox {
  bool is_known = false;
  bool meets = false;
  Penetration<3> found;                   ///< If they meet.
  Feature feature{FeatureKind::face, 0};  ///< Of the box, which the ball lies on.
};

/// The box as the ball's center sees it.
class BallTouch {
 public:
  template <class T>
  BallTouch(const Sphere<3, T>& ball, const Obb<3, T>& box)
      : origin_(wide<3, T>(ball.center)),
        radius_(static_cast<double>(ball.radius)),
        box_{wide<3, T>(box.center) - origin_, wide<3, T>(box.half_extents), wide_matrix<3, T>(box.axes)},
        size_(sum_abs(box_.center) + sum_abs(box_.half_extents)) {}

  BallOnBox run() const {
    PlaceInBox<3> nearest{Vec<3, double>(0.0), -box_.center};
    const double noise = tolerance::epsilon * sum_abs(box_.center);
    double moved = descend(nearest);
    const double reach = radius_ + first_doubt();
    if (dot(nearest.off, nearest.off) > reach * reach) return {true, false, {}};
    for (int round = 1; round < rounds && moved * shrinks_to > noise; ++round) moved = descend(nearest);
    const double squared = dot(nearest.off, nearest.off);
    const double clear = tolerance::known_direction * size_;
    if (squared > clear * clear) return from_outside(nearest, std::sqrt(squared));
    return from_inside(nearest.place);
  }

 private:
  // place_in without divisions, because a round shrinks what is wrong as much if the axes are not of length 1.
  static constexpr int rounds = 5;
  static constexpr double shrinks_to = 4 * tolerance::orthonormal;

  /// How far the axes may put the point wrong in the first round, as filter_of_ball has it.
  double first_doubt() const { return tolerance::box_filter * tolerance::orthonormal * (size_ + radius_); }

  /// One round of it; by how much it has moved the place.
  double descend(PlaceInBox<3>& nearest) const {
    Vec<3, double> step;
    for (Dim i = 0; i < 3; ++i) {
      const double wanted = nearest.place[i] + dot(nearest.off, box_.axes[i]);
      step[i] = std::min(std::max(wanted, -box_.half_extents[i]), box_.half_extents[i]) - nearest.place[i];
    }
    nearest.place += step;
    for (Dim i = 0; i < 3; ++i) nearest.off -= box_.axes[i] * step[i];
    return sum_abs(step);
  }

  /// The center is clearly out of the box: this far, if anything, along one, two or three axes, or between the faces
  /// across one by more than rounding.
  BallOnBox from_outside(const PlaceInBox<3>& nearest, double distance) const {
    constexpr double least_cosine = 16 * tolerance::aligned;  // with a face or edge it would not be laid flat on
    BallOnBox result;
    const double depth = radius_ - distance;
    const double doubt = tolerance::coarse * (size_ + radius_);
    result.meets = depth > doubt;
    if (depth < -doubt) {
      result.is_known = true;
      return result;
    }
    const double margin = tolerance::known_direction * size_;
    bool is_clear = result.meets;
    std::array<bool, 3> is_beyond{};
    for (Dim i = 0; i < 3; ++i) {
      const double room = box_.half_extents[i] - std::fabs(nearest.place[i]);
      is_beyond[static_cast<std::size_t>(i)] = room <= 0;
      is_clear = is_clear && (room > margin || (room <= 0 && box_.half_extents[i] > margin &&
                                                std::fabs(dot(nearest.off, box_.axes[i])) > least_cosine * distance));
    }
    result.is_known = is_clear;
    result.feature = feature_at(nearest.place, is_beyond);
    const Vec<3, double> normal = nearest.off * (-1 / distance);
    result.found = {normal, depth, origin_ + normal * radius_, origin_ - nearest.off, Status::converged, error()};
    return result;
  }

  /// The center is in the box. Of faces that are as near, by more than the box is oblique, the careful way chooses.
  BallOnBox from_inside(const Vec<3, double>& place) const {
    BallOnBox result;
    Vec<3, double> room;
    for (Dim i = 0; i < 3; ++i) room[i] = box_.half_extents[i] - std::fabs(place[i]);
    Dim axis = room.y < room.x ? 1 : 0;
    if (room.z < room[axis]) axis = 2;
    const double doubt = 8 * tolerance::orthonormal * size_;
    const double second = std::min(room[(axis + 1) % 3], room[(axis + 2) % 3]);
    result.is_known = room[axis] > tolerance::known_direction * size_ && second - room[axis] > doubt &&
                      std::fabs(place[axis]) > tolerance::known_direction * size_;
    if (!result.is_known) return result;
    const Vec<3, double> adjoint = adjoint_column(box_.axes, axis);
    const Vec<3, double> across = adjoint / std::sqrt(dot(adjoint, adjoint));  // about 1
    const double ahead = dot(across, box_.center);
    double reach = 0;
    for (Dim i = 0; i < 3; ++i) reach += std::fabs(dot(across, box_.axes[i] * box_.half_extents[i]));
    const double gap = std::fabs(ahead) - reach;
    const Vec<3, double> normal = ahead < 0 ? -across : across;
    result.meets = true;
    result.feature.index = BoxFaceNumbers{axis, place[axis] > 0}.face();
    result.found = {normal, radius_ - gap, origin_ + normal * radius_, origin_ + normal * gap, Status::converged,
                    error()};
    return result;
  }

  /// By the axes along which a point is at the end of the box.
  static Feature feature_at(const Vec<3, double>& place, const std::array<bool, 3>& is_beyond) {
    const auto far = [&](Dim i) { return place[i] > 0 ? 1U : 0U; };
    const int count = (is_beyond[0] ? 1 : 0) + (is_beyond[1] ? 1 : 0) + (is_beyond[2] ? 1 : 0);
    if (count == 3) return {FeatureKind::vertex, far(0) | far(1) << 1U | far(2) << 2U};
    const Dim other = is_beyond[0] ? (is_beyond[1] ? 2 : 1) : 0;  // of an edge: along which it lies
    if (count == 2) {
      const Dim along = is_beyond[0] && is_beyond[2] ? 1 : other;
      return {FeatureKind::edge,
              static_cast<std::uint32_t>(4 * along) + far((along + 1) % 3) + 2 * far((along + 2) % 3)};
    }
    const Dim across = is_beyond[0] ? 0 : (is_beyond[1] ? 1 : 2);
    return {FeatureKind::face, BoxFaceNumbers{across, far(across) != 0}.face()};
  }

  double error() const { return 2 * tolerance::rounding * (size_ + radius_); }

  Vec<3, double> origin_;
  double radius_;
  Obb<3, double> box_;
  double size_;
};

template <class T>
BallOnBox ball_on_box(const Sphere<3, T>& ball, const Obb<3, T>& box) {
  return BallTouch(ball, box).run();
}

/// Two that the quick way was asked about, either first.
template <class A, class B>
inline constexpr bool has_ball_on_box = are_ball_and_obb<A, B> || are_ball_and_obb<B, A>;

/// With the normal from the first of the two.
template <class A, class B>
requires has_ball_on_box<A, B> BallOnBox ball_and_box(const A& a, const B& b) {
  if constexpr (are_ball_and_obb<A, B>) {
    return ball_on_box(a, b);
  } else {
    BallOnBox result = ball_on_box(b, a);
    result.found = exchanged(result.found);
    return result;
  }
}

}  // namespace graze::detail
