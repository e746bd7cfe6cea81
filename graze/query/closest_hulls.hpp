// SPDX-License-Identifier: MIT
// The nearest points of two convex polytopes in space, each where it is or seen through a pose, for most pairs: those
// that are clearly apart, and those that clearly overlap. GJK as in gjk.hpp, but with corners by their places, so that
// a walk may begin where the last one ended and knows its end when it sees it, and with faces by hull_simplex.hpp. What
// it answers is proved by a plane or by four corners; if that fails, nothing is said, and closest_convex.hpp is asked.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/closest_unbounded.hpp>
#include <graze/query/hull_simplex.hpp>
#include <graze/query/proximity.hpp>
#include <graze/query/simplex_cache.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/polytope.hpp>
#include <graze/shape/posed.hpp>

namespace graze::detail {

/// A polytope as it is seen from a point.
template <class T>
class StillHull {
 public:
  StillHull(const Polytope<3, T>& hull, const Vec<3, double>& origin) : hull_(hull), origin_(origin) {}

  std::size_t size() const { return hull_.vertices().size(); }
  Vec<3, double> middle() const { return rows_of(hull_).middle() - origin_; }
  std::uint32_t farthest(const Vec<3, double>& direction) const { return rows_of(hull_).farthest(direction); }
  Vec<3, double> corner(std::uint32_t i) const { return wide<3, T>(hull_.vertices()[i]) - origin_; }
  /// No coordinate that is calculated with is larger.
  double reach() const { return rows_of(hull_).largest() + max_abs(origin_); }

 private:
  const Polytope<3, T>& hull_;
  Vec<3, double> origin_;
};

/// The same of one that is seen through a pose.
template <class T>
class PosedHull {
 public:
  PosedHull(const Posed<Polytope<3, T>>& posed, const Vec<3, double>& origin)
      : hull_(posed.shape),
        rotation_(wide_matrix<3, T>(posed.pose.rotation)),
        shift_(wide<3, T>(posed.pose.position) - origin) {}

  std::size_t size() const { return hull_.vertices().size(); }
  Vec<3, double> middle() const { return rotation_ * rows_of(hull_).middle() + shift_; }
  std::uint32_t farthest(const Vec<3, double>& direction) const {
    return rows_of(hull_).farthest(
        {dot(rotation_[0], direction), dot(rotation_[1], direction), dot(rotation_[2], direction)});
  }
  Vec<3, double> corner(std::uint32_t i) const { return rotation_ * wide<3, T>(hull_.vertices()[i]) + shift_; }
  double reach() const { return 2 * rows_of(hull_).largest() + max_abs(shift_); }

 private:
  const Polytope<3, T>& hull_;
  Mat<3, double> rotation_;
  Vec<3, double> shift_;
};

template <class T>
Vec<3, double> origin_of(const Polytope<3, T>& hull) {
  return wide<3, T>(hull.vertices().front());
}
template <class T>
Vec<3, double> origin_of(const Posed<Polytope<3, T>>& posed) {
  return wide<3, T>(posed.pose.position);
}
template <class T>
StillHull<T> seen_hull(const Polytope<3, T>& hull, const Vec<3, double>& origin) {
  return {hull, origin};
}
template <class T>
PosedHull<T> seen_hull(const Posed<Polytope<3, T>>& posed, const Vec<3, double>& origin) {
  return {posed, origin};
}

/// What has corners by their places.
template <class S>
concept HullInSpace = requires(const S& shape) {
  origin_of(shape);
};

/// The walk for two hulls that are seen from one point, `far` from zero.
template <class A, class B>
class HullWalk {
 public:
  HullWalk(const A& a, const B& b, double far)
      : a_(a), b_(b), resolution_(tolerance::convex * (far + std::max(a.reach(), b.reach()))) {}

  /// From what is known of the pair, which is then what this has found, if it is to be remembered.
  void run(SimplexCache<3>* cache) {
    if (cache != nullptr) begin_at(*cache);
    if (face_.size == 0) {
      put(0, support(a_.middle() - b_.middle()));
      face_ = near_corner(differences_, 0);
    }
    for (int step = 0; step < step_limit && face_.size < 4 && face_.squared > 0; ++step) {
      if (!go_on()) break;
    }
    if (cache != nullptr) remember(*cache);
    distance_ = std::sqrt(face_.squared);
    lower_ = height_ / distance_;
  }

  /// Apart, and how far is proved.
  bool is_apart() const {
    return lower_ > clearly * resolution_ &&
           distance_ - lower_ <= tolerance::gjk_relative_gap * distance_ + resolution_;
  }

  /// The origin is deeper in four corners than rounding could move it.
  bool is_overlapping() const {
    if (face_.size < 4) return false;
    const auto edge = [this](std::size_t i, std::size_t from) {
      return differences_[face_.places[i]] - differences_[face_.places[from]];
    };
    const double volume = std::fabs(dot(edge(1, 0), cross(edge(2, 0), edge(3, 0))));
    for (std::size_t k = 0; k < 4; ++k) {
      const Vec<3, double> normal = cross(edge((k + 2) % 4, (k + 1) % 4), edge((k + 3) % 4, (k + 1) % 4));
      const double depth = face_.shares[k] * volume / std::sqrt(dot(normal, normal));
      if (!(depth > clearly * resolution_)) return false;
    }
    return true;
  }

  /// Where a lies, and b.
  struct Points {
    Vec<3, double> on_a = Vec<3, double>(0.0);
    Vec<3, double> on_b = Vec<3, double>(0.0);
  };
  Points points() const {
    Points points;
    for (std::size_t i = 0; i < face_.size; ++i) {
      const std::uint8_t place = face_.places[i];
      points.on_a += corners_[place].at_a * face_.shares[i];
      points.on_b += (corners_[place].at_a - differences_[place]) * face_.shares[i];
    }
    return points;
  }

  /// From b to a.
  const Vec<3, double>& separation() const { return face_.nearest; }
  double distance() const { return distance_; }
  double error() const { return std::max(0.0, distance_ - lower_) + resolution_; }

 private:
  static constexpr int step_limit = 64;
  static constexpr double clearly = 16;  ///< So much farther than rounding that no other way can see it otherwise.

  /// Of both hulls, by their places; and where that of a lies.
  struct Corner {
    std::uint32_t on_a;
    std::uint32_t on_b;
    Vec<3, double> at_a;
  };

  void put(std::uint8_t place, const Corner& corner) {
    corners_[place] = corner;
    differences_[place] = corner.at_a - b_.corner(corner.on_b);
  }

  Corner support(const Vec<3, double>& against) const {
    const std::uint32_t on_a = a_.farthest(-against);
    return {on_a, b_.farthest(against), a_.corner(on_a)};
  }

  void begin_at(const SimplexCache<3>& cache) {
    const auto size = static_cast<std::uint8_t>(std::min(cache.size, 4U));
    for (std::uint8_t i = 0; i < size; ++i) {
      if (cache.corners_a[i] >= a_.size() || cache.corners_b[i] >= b_.size()) return;
      put(i, {cache.corners_a[i], cache.corners_b[i], a_.corner(cache.corners_a[i])});
    }
    if (size == 0) return;
    NearFace known;
    known.size = static_cast<std::uint8_t>(size - 1);
    known.places = {0, 1, 2, 3};
    face_ = near_face(differences_, known.size, known);
  }

  void remember(SimplexCache<3>& cache) const {
    cache.size = face_.size;
    for (std::size_t i = 0; i < face_.size; ++i) {
      cache.corners_a[i] = corners_[face_.places[i]].on_a;
      cache.corners_b[i] = corners_[face_.places[i]].on_b;
    }
  }

  bool has(const Corner& corner) const {
    for (std::size_t i = 0; i < face_.size; ++i) {
      const Corner& known = corners_[face_.places[i]];
      if (known.on_a == corner.on_a && known.on_b == corner.on_b) return true;
    }
    return false;
  }

  /// A place that the face, which has up to three corners, does not need.
  std::uint8_t free_place() const {
    std::uint32_t taken = 0;
    for (std::size_t i = 0; i < face_.size; ++i) taken |= 1U << face_.places[i];
    return static_cast<std::uint8_t>(std::countr_one(taken));
  }

  /// False when there is nothing nearer.
  bool go_on() {
    const Corner next = support(face_.nearest);
    const std::uint8_t place = free_place();
    put(place, next);
    const Vec<3, double>& difference = differences_[place];
    height_ = dot(face_.nearest, difference);
    const double noise = tolerance::epsilon * dot(abs(face_.nearest), abs(difference));
    if (!(face_.squared - height_ > noise) || has(next)) return false;
    const NearFace found = near_face(differences_, place, face_);
    if (!(found.squared < face_.squared)) return false;
    face_ = found;
    return true;
  }

  const A& a_;
  const B& b_;
  double resolution_;
  double height_ = 0;  ///< Of what is farthest against the nearest point, along the way to it.
  double distance_ = 0;
  double lower_ = 0;  ///< Proved by a plane across that way, when the walk has ended there.
  std::array<Corner, 4> corners_;
  HullSimplex differences_;
  NearFace face_;
};

/// None for pairs that this leaves open.
template <HullInSpace A, HullInSpace B>
std::optional<Proximity<3, double>> proximity_of_hulls(const A& a, const B& b, SimplexCache<3>* cache) {
  const Vec<3, double> origin = origin_of(a);
  const auto seen_a = seen_hull(a, origin);
  const auto seen_b = seen_hull(b, origin);
  HullWalk walk(seen_a, seen_b, max_abs(origin));
  walk.run(cache);
  if (walk.is_apart()) {
    const auto points = walk.points();
    return Proximity<3, double>{
        walk.distance(), origin + points.on_a, origin + points.on_b, walk.separation() * (-1 / walk.distance()),
        Relation::apart, Status::converged,    walk.error()};
  }
  if (walk.is_overlapping()) return meeting_at<3>(origin + walk.points().on_a, Relation::overlapping);
  return std::nullopt;
}

}  // namespace graze::detail
