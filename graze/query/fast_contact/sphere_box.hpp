// SPDX-License-Identifier: MIT
// How a sphere touches a box in space, in the box' own coordinates: what penetration_of_simple and the patches
// of manifold.hpp find for any two shapes, of spheres whose center is clearly in the box or clearly out of it, and not
// nearly above the line between two of its faces, edges and corners. Include manifold.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/cores/penetration.hpp>
#include <graze/query/cores/surface_point.hpp>
#include <graze/query/cores/surface_point_box.hpp>
#include <graze/query/fast_contact/fast_result.hpp>
#include <graze/query/fast_contact/oriented_box.hpp>
#include <graze/query/patch/clipped.hpp>
#include <graze/query/patch/patch.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/obb.hpp>
#include <graze/shape/shape.hpp>
#include <graze/shape/sphere.hpp>

namespace graze::detail {

/// The feature of a box that a place lies on, by the axes along which it is at the end.
inline Feature feature_of_box(const Vec<3, double>& place, const std::array<bool, 3>& is_beyond) {
  const auto far = [&](Dim i) { return place[i] > 0 ? 1U : 0U; };
  const int count = (is_beyond[0] ? 1 : 0) + (is_beyond[1] ? 1 : 0) + (is_beyond[2] ? 1 : 0);
  if (count == 3) return {FeatureKind::vertex, far(0) | far(1) << 1U | far(2) << 2U};
  const Dim other = is_beyond[0] ? (is_beyond[1] ? 2 : 1) : 0;  // of an edge: along which it lies
  if (count == 2) {
    const Dim along = is_beyond[0] && is_beyond[2] ? 1 : other;
    return {FeatureKind::edge, static_cast<std::uint32_t>(4 * along) + far((along + 1) % 3) + 2 * far((along + 2) % 3)};
  }
  const Dim across = is_beyond[0] ? 0 : (is_beyond[1] ? 1 : 2);
  return {FeatureKind::face, BoxFaceNumbers{across, far(across) != 0}.face()};
}

/// The box as the sphere's center sees it; its axes are those of the coordinates if it is `along` them.
template <bool along>
class SphereContact {
 public:
  /// The center as it is, the box as it is seen from there. `turns` if the box is the first of both.
  SphereContact(const Vec<3, double>& center, double radius, const Obb<3, double>& box, bool turns)
      : origin_(center),
        radius_(radius),
        box_(box),
        size_(sum_abs(box_.center) + sum_abs(box_.half_extents)),
        turns_(turns) {}

  [[gnu::always_inline]] FastContact<3> run() const {
    PlaceInBox<3> nearest{Vec<3, double>(0.0), -box_.center};
    [[maybe_unused]] double moved = descend(nearest);
    const double reach = radius_ + (along ? coarse_doubt() : first_undecided());
    if (dot(nearest.off, nearest.off) > reach * reach) return known_apart();
    if constexpr (!along) {
      const double noise = tolerance::epsilon * sum_abs(box_.center);
      for (int round = 1; round < rounds && moved * shrinks_to > noise; ++round) moved = descend(nearest);
    }
    const double squared = dot(nearest.off, nearest.off);
    const double clear = tolerance::known_direction * size_;
    if (squared > clear * clear) return from_outside(nearest, std::sqrt(squared));
    return from_inside(nearest.place);
  }

 private:
  // place_in without divisions, because a round shrinks what is wrong as much if the axes are not of length 1. To
  // measure how far they are from that, mostly by rounding, spares one of two rounds, but not always: it takes longer.
  static constexpr int rounds = 5;
  static constexpr double shrinks_to = 4 * tolerance::orthonormal;

  /// A coordinate along an axis.
  double along_axis(const Vec<3, double>& v, Dim i) const { return along ? v[i] : dot(v, box_.axes[i]); }

  FastContact<3> known_apart() const {
    FastContact<3> result;
    result.is_known = true;
    result.found.error = error();
    return result;
  }

  /// How far the axes may put the point wrong in the first round, as filter_of_sphere has it.
  double first_undecided() const { return tolerance::box_filter * tolerance::orthonormal * (size_ + radius_); }

  double coarse_doubt() const { return tolerance::coarse * (size_ + radius_); }

  /// One round of it; by how much it has moved the place.
  [[gnu::always_inline]] double descend(PlaceInBox<3>& nearest) const {
    Vec<3, double> step;
    for (Dim i = 0; i < 3; ++i) {
      const double wanted = nearest.place[i] + along_axis(nearest.off, i);
      step[i] = std::min(std::max(wanted, -box_.half_extents[i]), box_.half_extents[i]) - nearest.place[i];
    }
    nearest.place += step;
    if constexpr (along) {
      nearest.off -= step;
    } else {
      for (Dim i = 0; i < 3; ++i) nearest.off -= box_.axes[i] * step[i];
    }
    return sum_abs(step);
  }

  /// The center is clearly out of the box: this far, if anything, along one, two or three axes, or between the faces
  /// across one by more than rounding.
  [[gnu::always_inline]] FastContact<3> from_outside(const PlaceInBox<3>& nearest, double distance) const {
    constexpr double least_cosine = 16 * tolerance::aligned;  // with a face or edge it would not be laid flat on
    FastContact<3> result;
    result.is_single = true;
    const double depth = radius_ - distance;
    const double doubt = coarse_doubt();
    result.meets = depth > doubt;
    result.found.error = error();
    if (depth < -doubt) {
      result.is_known = true;
      return result;
    }
    const double margin = tolerance::known_direction * size_;
    unsigned clear_axes = 0;  // without a branch, for which they are is not to be guessed
    std::array<bool, 3> is_beyond{};
    for (Dim i = 0; i < 3; ++i) {
      const double half = box_.half_extents[i];
      const double room = half - std::fabs(nearest.place[i]);
      const bool beyond = room <= 0;
      const bool is_steep = std::fabs(along_axis(nearest.off, i)) > least_cosine * distance;
      is_beyond[static_cast<std::size_t>(i)] = beyond;
      clear_axes +=
          static_cast<unsigned>(room > margin) |
          (static_cast<unsigned>(beyond) & static_cast<unsigned>(half > margin) & static_cast<unsigned>(is_steep));
    }
    result.is_known = result.meets && clear_axes == 3;
    result.set_features({FeatureKind::vertex, 0}, feature_of_box(nearest.place, is_beyond), turns_);
    const Vec<3, double> normal = nearest.off * (-1 / distance);
    result.set(normal, depth, origin_ + normal * radius_, origin_ - nearest.off, turns_);
    return result;
  }

  /// The center is in the box. Of faces that are as near, by more than the box is oblique, the careful way chooses.
  FastContact<3> from_inside(const Vec<3, double>& place) const {
    FastContact<3> result;
    result.is_single = true;
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
    result.set_features({FeatureKind::vertex, 0}, {FeatureKind::face, BoxFaceNumbers{axis, place[axis] > 0}.face()},
                        turns_);
    result.set(normal, radius_ - gap, origin_ + normal * radius_, origin_ + normal * gap, turns_);
    result.found.error = error();
    return result;
  }

  double error() const { return 2 * tolerance::rounding * (size_ + radius_); }

  Vec<3, double> origin_;
  double radius_;
  Obb<3, double> box_;
  double size_;
  bool turns_;
};

template <bool along, class T, class Box>
[[gnu::always_inline]] inline FastContact<3> look_at_sphere(const Sphere<3, T>& sphere, const Box& box, bool turns) {
  const Vec<3, double> center = wide<3, T>(sphere.center);
  return SphereContact<along>(center, static_cast<double>(sphere.radius), oriented_box_from(center, box), turns).run();
}

template <class T>
[[gnu::always_inline]] inline FastContact<3> find_fast_contact(const Sphere<3, T>& sphere, const Aabb<3, T>& box,
                                                               bool turns) {
  return look_at_sphere<true>(sphere, box, turns);
}
template <class T>
[[gnu::always_inline]] inline FastContact<3> find_fast_contact(const Sphere<3, T>& sphere, const Obb<3, T>& box,
                                                               bool turns) {
  return look_at_sphere<false>(sphere, box, turns);
}

}  // namespace graze::detail
