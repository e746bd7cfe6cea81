// SPDX-License-Identifier: MIT
/// @file
/// signed_distance(shape, point): the distance of a point from a shape's surface, negative inside.
///
///     sphere, capsule, aabb, obb, half-space     closed form; negative inside
///     triangle, polytope, in 2D                  closed form; negative inside
///     polytope in 3D, user's convex shape        GJK outside; EPA inside: minus the depth
///     point, segment, ray, triangle in 3D        closed form; zero or more, for they have no inside
///     plane                                      closed form; positive on the side that the normal points to
///     compound                                   the least over its parts, planes positive on both sides
///     mesh                                       that of the nearest face; in 3D negative inside a solid
///
/// A length, whatever the length of a normal. Calculated in double and rounded to T. The error before rounding is a few
/// epsilon of double of the pair's own size; for half-spaces, 3D polytopes and users' shapes a few epsilon of the
/// largest coordinate (of T if `support` calculates in T); for points, boxes and, up to epsilon squared, planes a few
/// epsilon of the distance itself. GJK and EPA may stop 1e-12 of the distance early; inside a curved user's shape EPA
/// may reach its step limit with a larger error (a cone in float: 4e-4 of the depth). For shapes with an inside,
/// signed_distance(shape, point) <= 0 if and only if contains(shape, point).
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <variant>

#include <graze/math/vec.hpp>
#include <graze/query/closest/surface_point_convex.hpp>
#include <graze/query/compiled/instances.hpp>
#include <graze/query/contains.hpp>
#include <graze/query/cores/surface_point.hpp>
#include <graze/query/cores/surface_point_box.hpp>
#include <graze/query/distance_squared.hpp>
#include <graze/query/parts/visit.hpp>
#include <graze/query/scaling/range.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/visit.hpp>
#include <graze/shape/shape.hpp>

namespace graze {

namespace detail {

/// The distance of a shape with an inside: at most zero if the point is inside, else positive.
inline double with_sign(double distance, bool is_inside) {
  return is_inside ? std::min(distance, 0.0) : std::max(distance, std::numeric_limits<double>::denorm_min());
}

template <Shape S>
double signed_distance_of(const S& shape, const PointOf<S>& point);

/// The result of rescaled shapes if a number is out of range, otherwise `found`.
template <Shape S>
[[gnu::noinline, gnu::cold]] double signed_distance_in_range_or(double found, const S& shape, const PointOf<S>& point) {
  const auto answer = answer_in_range<double>(
      [](const auto& power, const auto& scaled_shape, const auto& scaled_point) {
        const double distance = signed_distance_of(scaled_shape, scaled_point);
        const double result = power.inverse()(distance);
        return has_inside<S> ? with_sign(result, distance <= 0) : result;
      },
      shape, point);
  return answer.value_or(found);
}

/// The signed distance in double, consistent with `contains`.
template <Shape S>
[[gnu::always_inline]] inline double signed_distance_of(const S& shape, const PointOf<S>& point) {
  const SurfacePoint<dimension_of<S>> at = surface_point(shape, wide<dimension_of<S>, scalar_of<S>>(point));
  double distance = at.distance;
  if constexpr (has_inside<S>) distance = with_sign(distance, distance < 0 || holds(shape, point));
  if (is_usual_measure<scalar_of<S>>(at.measure)) return distance;
  return signed_distance_in_range_or(distance, shape, point);
}

template <Dim N, class T>
double signed_distance_of(const Compound<N, T>& compound, const Vec<N, T>& point);
template <Dim N, class T>
double signed_distance_of(const Mesh<N, T>& mesh, const Vec<N, T>& point);

template <Dim N, class T>
double signed_distance_of(const AnyShape<N, T>& shape, const Vec<N, T>& point) {
  return detail::visit([&point](const auto& held) { return signed_distance_of(held, point); }, shape);
}

/// As a part of a compound, a plane has no negative side, because it contains nothing there.
template <Dim N, class T>
double distance_of_part(const AnyShape<N, T>& shape, const Vec<N, T>& point) {
  const double distance = signed_distance_of(shape, point);
  return std::holds_alternative<Plane<N, T>>(shape) ? std::fabs(distance) : distance;
}

template <Dim N, class T>
double distance_of_part(const Triangle<N, T>& face, const Vec<N, T>& point) {
  return signed_distance_of(face, point);
}

/// Of a shape without parts: `no_part`, infinitely far away.
struct DecidingPart {
  static constexpr std::size_t no_part = std::numeric_limits<std::size_t>::max();

  std::size_t index = no_part;
  double distance = std::numeric_limits<double>::infinity();
};

/// Looks for the part with the least signed distance, of several the first.
template <Dim N, class T>
class PartSearch {
 public:
  explicit PartSearch(const Vec<N, T>& point) : near_{point, std::numeric_limits<double>::infinity()} {}

  const DecidingPart& best() const { return best_; }
  MayBeNear<N, T>& near() { return near_; }

  template <class Part>
  void add(const Part& part, std::size_t index) {
    const double distance = distance_of_part(part, near_.point);
    if (distance < best_.distance || (distance == best_.distance && index < best_.index)) best_ = {index, distance};
    near_.distance = std::min(near_.distance, std::max(best_.distance, 0.0));
  }

 private:
  DecidingPart best_;
  MayBeNear<N, T> near_;
};

template <Dim N, class T>
DecidingPart deciding_part(const Compound<N, T>& compound, const Vec<N, T>& point) {
  PartSearch<N, T> search(point);
  visit_parts(compound, search.near(), ByKey(), [&](const Part<N, T>& part, std::size_t index) {
    search.add(part.shape, index);
    return true;
  });
  return search.best();
}

/// Looks for the face nearest to a point. Candidates are collected with their keys; their distances are calculated
/// last, when that of the nearest is known up to the rounding errors of T, or earlier if there are many.
template <Dim N, class T>
class FaceSearch {
 public:
  FaceSearch(const PlacedMesh<N, T>& faces, const Vec<N, T>& point)
      : faces_(faces),
        search_(point),
        forgiven_(forgiven_outside(faces.at_place(faces.data()->tree().around()), point)) {}

  void add(std::size_t face) { search_.add(faces_.triangle(face), face); }

  DecidingPart find() {
    for (const std::uint32_t face : faces_.data()->tree().unbounded()) add(face);
    visit_faces(faces_, MayBeNearestFace<N, T>{search_.near()}, ByKey(), Visit{*this});
    decide();
    return search_.best();
  }

 private:
  struct Candidate {
    std::uint32_t face;
    std::size_t place;  ///< In the tree.
    T key;
  };

  struct Visit {
    bool operator()(std::uint32_t face, std::size_t place) const {
      search.search_.add(search.faces_.triangle_in_tree(place), face);
      return true;
    }
    bool operator()(std::uint32_t face, std::size_t place, T key) const {
      if (search.count_ == search.candidates_.size()) search.decide();
      search.candidates_[search.count_++] = {face, place, key};
      return true;
    }

    FaceSearch& search;
  };

  /// The last first, which are the nearest.
  void decide() {
    while (count_ > 0) {
      const Candidate& last = candidates_[--count_];
      if (last.key > most_squared<T>(search_.near().distance + forgiven_)) continue;
      search_.add(faces_.triangle_in_tree(last.place), last.face);
    }
  }

  const PlacedMesh<N, T>& faces_;
  PartSearch<N, T> search_;
  double forgiven_;
  std::array<Candidate, 32> candidates_;
  std::size_t count_ = 0;
};

/// Faster with a `guess`, the index of a face that may be near.
template <Dim N, class T>
DecidingPart deciding_part(const Mesh<N, T>& mesh, const Vec<N, T>& point, std::size_t guess = DecidingPart::no_part) {
  FaceSearch<N, T> search(placed(mesh), point);
  if (guess != DecidingPart::no_part) search.add(guess);
  return search.find();
}

template <Dim N, class T>
double signed_distance_of(const Compound<N, T>& compound, const Vec<N, T>& point) {
  return deciding_part(compound, point).distance;
}

/// That of the nearest face, which is faster to find with a `guess`, and becomes the next one. Only a solid in 3D has
/// more inside than its faces.
template <Dim N, class T>
double signed_distance_of_mesh(const Mesh<N, T>& mesh, const Vec<N, T>& point, std::size_t& guess) {
  const DecidingPart nearest = deciding_part(mesh, point, guess);
  guess = nearest.index;
  const double distance = nearest.distance;
  if (N == 2 || mesh.kind() == MeshKind::surface) return distance;
  if (is_inside(mesh, point)) return -distance;
  return with_sign(distance, distance <= 0 || is_on_face(mesh, point, distance));
}

template <Dim N, class T>
double signed_distance_of(const Mesh<N, T>& mesh, const Vec<N, T>& point) {
  std::size_t guess = DecidingPart::no_part;
  return signed_distance_of_mesh(mesh, point, guess);
}

/// In T: never minus zero, and zero only for zero.
template <class T>
T rounded_distance(double distance) {
  const T rounded = static_cast<T>(distance) + T(0);
  return distance > 0 && rounded == T(0) ? std::numeric_limits<T>::denorm_min() : rounded;
}

}  // namespace detail

/// The distance of a point from the surface of a valid shape (asserted), with the sign of the table at the top of this
/// file. For a compound: exact outside; inside, minus the depth in the part where the point is deepest, which may be
/// less than the way out of all parts if they overlap; +infinity without parts. `contains` is cheaper if only the sign
/// matters.
template <Shape S, PointIn<S> P = PointOf<S>>
scalar_of<S> signed_distance(const S& shape, const P& point) {
  assert(detail::is_accepted(shape));
  using T = scalar_of<S>;
  return detail::rounded_distance<T>(detail::signed_distance_of(shape, point));
}

GRAZE_DECLARE_INSTANCES(GRAZE_SIGNED_DISTANCE_INSTANCES)

}  // namespace graze
