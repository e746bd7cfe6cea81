// SPDX-License-Identifier: MIT
// The nearest points of two 3D convex polytopes, with or without poses, for most pairs: those that are clearly apart,
// and those that clearly overlap. GJK as in gjk.hpp, but with indexed corners, so that a run can start where the last
// one ended and detects its end, and with faces by hull_simplex.hpp. Its answers are proved by a plane and two points,
// or by four corners; if the proof fails, nothing is returned, and convex.hpp decides.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>

#include <graze/math/platform/has_lanes.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/closest/convex.hpp>
#include <graze/query/closest/few_corners.hpp>
#include <graze/query/closest/fitting_face.hpp>
#include <graze/query/closest/hull_simplex.hpp>
#include <graze/query/closest/unbounded.hpp>
#include <graze/query/proximity.hpp>
#include <graze/query/simplex_cache.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/polytope.hpp>
#include <graze/shape/posed.hpp>

namespace graze::detail {

/// An upper bound of the coordinates of a hull.
template <class T>
double size_of_hull(const Polytope<3, T>& hull) {
  return rows_of(hull).largest();
}
template <class T>
double size_of_hull(const Posed<Polytope<3, T>>& posed) {
  return rows_of(posed.shape).largest() + static_cast<double>(max_abs(posed.pose.position));
}

/// A polytope relative to a point.
template <class T>
class StillHull {
 public:
  StillHull(const Polytope<3, T>& hull, const Vec<3, double>& origin) : hull_(hull), origin_(origin) {}

  std::size_t size() const { return hull_.vertices().size(); }
  Vec<3, double> middle() const { return rows_of(hull_).middle() - origin_; }
  template <std::size_t lanes>
  std::uint32_t farthest(const Vec<3, double>& direction) const {
    return rows_of(hull_).template farthest_by<lanes>(direction);
  }
  Vec<3, double> corner(std::uint32_t i) const { return wide<3, T>(hull_.vertices()[i]) - origin_; }
  template <std::size_t lanes, class Few>
  [[gnu::always_inline]] void put_in(Few& corners) const {
    corners.template put<lanes>(rows_of(hull_), origin_);
  }
  /// An upper bound of all coordinates used.
  double reach() const { return rows_of(hull_).largest() + max_abs(origin_); }
  /// The relative error of the height of the farthest corner.
  static constexpr double search_error = 0;

 private:
  const Polytope<3, T>& hull_;
  Vec<3, double> origin_;
};

/// The same for a polytope with a pose.
template <class T>
class PosedHull {
 public:
  PosedHull(const Posed<Polytope<3, T>>& posed, const Vec<3, double>& origin)
      : hull_(posed.shape),
        rotation_(wide_matrix<3, T>(posed.pose.rotation)),
        shift_(wide<3, T>(posed.pose.position) - origin) {}

  std::size_t size() const { return hull_.vertices().size(); }
  Vec<3, double> middle() const { return rotation_ * rows_of(hull_).middle() + shift_; }
  template <std::size_t lanes>
  std::uint32_t farthest(const Vec<3, double>& direction) const {
    return rows_of(hull_).template farthest_by<lanes>(
        {dot(rotation_[0], direction), dot(rotation_[1], direction), dot(rotation_[2], direction)});
  }
  Vec<3, double> corner(std::uint32_t i) const { return rotation_ * wide<3, T>(hull_.vertices()[i]) + shift_; }
  template <std::size_t lanes, class Few>
  [[gnu::always_inline]] void put_in(Few& corners) const {
    corners.template put<lanes>(rows_of(hull_), rotation_, shift_);
  }
  double reach() const { return 2 * rows_of(hull_).largest() + max_abs(shift_); }
  static constexpr double search_error = 0;

 private:
  const Polytope<3, T>& hull_;
  Mat<3, double> rotation_;
  Vec<3, double> shift_;
};

#ifdef GRAZE_HAS_LANES
/// One of them with its transformed corners.
template <class Seen>
class FewHull {
 public:
  explicit FewHull(const Seen& seen) : seen_(seen) {}

  std::size_t size() const { return seen_.size(); }
  Vec<3, double> middle() const { return seen_.middle(); }
  double reach() const { return seen_.reach(); }
  // a corner's magnitude is up to 1.8 times that
  static constexpr double search_error = 2 * FewCorners::farthest_error;
  Vec<3, double> corner(std::uint32_t i) const { return corners_[i]; }
  /// Must be called before any corner is requested.
  template <std::size_t lanes>
  [[gnu::always_inline]] void get_ready() {
    seen_.template put_in<lanes>(corners_);
  }
  template <std::size_t lanes>
  [[gnu::always_inline]] std::uint32_t farthest(const Vec<3, double>& direction) const {
    return corners_.farthest<lanes>(direction);
  }

 private:
  const Seen& seen_;
  FewCorners corners_;
};
#endif

template <class T>
Vec<3, double> origin_of(const Polytope<3, T>& hull) {
  return wide<3, T>(hull.vertices().front());
}
template <class T>
Vec<3, double> origin_of(const Posed<Polytope<3, T>>& posed) {
  return wide<3, T>(posed.pose.position);
}
template <class T>
StillHull<T> local_hull(const Polytope<3, T>& hull, const Vec<3, double>& origin) {
  return {hull, origin};
}
template <class T>
PosedHull<T> local_hull(const Posed<Polytope<3, T>>& posed, const Vec<3, double>& origin) {
  return {posed, origin};
}

/// Types with indexed corners.
template <class S>
concept HullInSpace = requires(const S& shape) {
  origin_of(shape);
};

/// Cached corners of two hulls, in the order of the search.
struct KnownCorners {
  SimplexCache<3>* cache;  ///< None if nothing is to be cached.
  bool is_exchanged;       ///< The cache has corners of the second hull first.

  std::array<std::uint32_t, 4>& on_a() const { return is_exchanged ? cache->corners_b : cache->corners_a; }
  std::array<std::uint32_t, 4>& on_b() const { return is_exchanged ? cache->corners_a : cache->corners_b; }
};

/// The search for two hulls relative to one point, `far` from zero. Prepares them.
template <class A, class B>
class HullWalk {
 public:
  HullWalk(A& a, B& b, double far)
      : a_(a),
        b_(b),
        resolution_((tolerance::convex + A::search_error + B::search_error) * (far + std::max(a.reach(), b.reach()))) {}

  /// Starts from the cached corners, and caches the result if requested.
  void run(const KnownCorners& known) {
#ifdef GRAZE_HAS_WIDER_LANES
    if (__builtin_cpu_supports("avx512f")) return run_by_eight(known);
    if (__builtin_cpu_supports("avx2")) return run_by_four(known);
#endif
    run_by_two(known);
  }

  // The same with a given number of lanes, for processors that support it. Everything called is inlined, so that a
  // step's direction, corners and face stay in registers.

  [[gnu::flatten]] void run_by_two(const KnownCorners& known) { run_by<2>(known); }
#ifdef GRAZE_HAS_WIDER_LANES
  [[gnu::target("avx2"), gnu::flatten]] void run_by_four(const KnownCorners& known) { run_by<4>(known); }
  [[gnu::target("avx512f"), gnu::flatten]] void run_by_eight(const KnownCorners& known) { run_by<8>(known); }
#endif

  /// Apart, with a proved distance.
  bool is_apart() const {
    return lower_ > clearly * resolution_ &&
           distance_ - lower_ <= tolerance::gjk_relative_gap * distance_ + resolution_;
  }

  /// The origin is deeper inside four corners than rounding could move it.
  bool is_overlapping() const {
    if (face_.size < 4) return false;
    const auto edge = [this](std::size_t i, std::size_t from) {
      return differences_[face_.places[i]] - differences_[face_.places[from]];
    };
    const std::array<double, 4> shares = shares_of(differences_, face_);
    const double volume = std::fabs(dot(edge(1, 0), cross(edge(2, 0), edge(3, 0))));
    for (std::size_t k = 0; k < 4; ++k) {
      const Vec<3, double> normal = cross(edge((k + 2) % 4, (k + 1) % 4), edge((k + 3) % 4, (k + 1) % 4));
      const double depth = shares[k] * volume / std::sqrt(dot(normal, normal));
      if (!(depth > clearly * resolution_)) return false;
    }
    return true;
  }

  /// A point of a, and one of b.
  struct Points {
    Vec<3, double> on_a = Vec<3, double>(0.0);
    Vec<3, double> on_b = Vec<3, double>(0.0);
  };
  Points points() const { return points_of(shares_of(differences_, face_)); }

  /// The same with care: for long thin faces the coordinates above are off by more than their nearest point.
  Points careful_points() const {
    Simplex<3> simplex;
    for (std::size_t i = 0; i < face_.size; ++i) simplex.push(differences_[face_.places[i]]);
    const std::array<double, 3> others = SharesInSimplex<3>(simplex).of(separation_);
    return points_of({1 - others[0] - others[1] - others[2], others[0], others[1], others[2]});
  }

  Points points_of(const std::array<double, 4>& shares) const {
    Points points;
    for (std::size_t i = 0; i < face_.size; ++i) {
      const std::uint32_t place = face_.places[i];
      points.on_a += a_.corner(corners_[place].on_a) * shares[i];
      points.on_b += b_.corner(corners_[place].on_b) * shares[i];
    }
    return points;
  }

  /// From b to a.
  const Vec<3, double>& separation() const { return separation_; }
  double distance() const { return distance_; }
  double error() const { return std::max(0.0, distance_ - lower_) + resolution_; }
  double resolution() const { return resolution_; }

 private:
  static constexpr int step_limit = 64;
  static constexpr double clearly = 16;  ///< So much farther than rounding that no other method can disagree.

  template <std::size_t lanes>
  [[gnu::always_inline]] void run_by(const KnownCorners& known) {
    if constexpr (requires { a_.template get_ready<lanes>(); }) {
      a_.template get_ready<lanes>();
      b_.template get_ready<lanes>();
    }
    NearFace face;
    if (known.cache != nullptr) face = begin_at(known);
    if (face.size == 0) face = near_corner({0, put(0, support<lanes>(a_.middle() - b_.middle()))});
    least_squared_ = face.squared;
    bool is_nearest = false;
    for (int step = 0; step < step_limit && !is_nearest && face.size < 4 && face.squared > 0; ++step) {
      is_nearest = !go_on<lanes>(face);
    }
    face_ = face;
    if (known.cache != nullptr) remember(known);
    const double scale = face.height / dot(face.toward, face.toward);
    separation_ = face.toward * scale;
    distance_ = std::sqrt(dot(separation_, separation_));
    if (is_nearest) lower_ = height_ * scale / distance_;
  }

  /// Of both hulls, as indices.
  struct Corner {
    std::uint32_t on_a;
    std::uint32_t on_b;
  };

  /// The difference that is stored there.
  Vec<3, double> put(std::uint32_t place, const Corner& corner) {
    corners_[place] = corner;
    return differences_[place] = a_.corner(corner.on_a) - b_.corner(corner.on_b);
  }

  template <std::size_t lanes>
  [[gnu::always_inline]] Corner support(const Vec<3, double>& against) const {
    return {a_.template farthest<lanes>(-against), b_.template farthest<lanes>(against)};
  }

  NearFace begin_at(const KnownCorners& known) {
    const std::uint32_t size = std::min(known.cache->size, 4U);
    for (std::uint32_t i = 0; i < size; ++i) {
      if (known.on_a()[i] >= a_.size() || known.on_b()[i] >= b_.size()) return {};
      put(i, {known.on_a()[i], known.on_b()[i]});
    }
    if (size == 0) return {};
    NearFace face;
    face.size = size - 1;
    face.places = HullPlaces(0, 1, 2, 3);
    return near_face(differences_, {face.size, differences_[face.size]}, face);
  }

  void remember(const KnownCorners& known) const {
    known.cache->size = face_.size;
    for (std::size_t i = 0; i < face_.size; ++i) {
      known.on_a()[i] = corners_[face_.places[i]].on_a;
      known.on_b()[i] = corners_[face_.places[i]].on_b;
    }
  }

  bool has(const NearFace& face, const Corner& corner) const {
    for (std::size_t i = 0; i < face.size; ++i) {
      const Corner& known = corners_[face.places[i]];
      if (known.on_a == corner.on_a && known.on_b == corner.on_b) return true;
    }
    return false;
  }

  /// An index that the face, which has up to three corners, does not use.
  static std::uint32_t free_place(const NearFace& face) {
    std::uint32_t taken = 0;
    for (std::size_t i = 0; i < face.size; ++i) taken |= 1U << face.places[i];
    return static_cast<std::uint32_t>(std::countr_one(taken));
  }

  /// False if nothing is nearer.
  template <std::size_t lanes>
  [[gnu::always_inline]] bool go_on(NearFace& face) {
    const Corner next = support<lanes>(face.toward);
    const std::uint32_t place = free_place(face);
    const Vec<3, double> difference = put(place, next);
    height_ = dot(face.toward, difference);
    const double noise = tolerance::epsilon * dot(abs(face.toward), abs(difference));
    if (!(face.height - height_ > noise) || has(face, next)) return false;
    const NearFace found = near_face(differences_, {place, difference}, face);
    if (!(found.squared < least_squared_)) return turn(face, place);
    least_squared_ = found.squared;
    face = found;
    return true;
  }

  /// If no nearer face is found, but the plane of this one does not prove its distance: switches to the fitting face
  /// among those of this face's corners and the newest. False if no such plane is needed, or none is found, or the
  /// distance is not clear at all.
  [[gnu::noinline]] bool turn(NearFace& face, std::uint32_t newest) const {
    const double distance = std::sqrt(least_squared_);
    const bool is_proved = !(face.height - height_ > resolution_ / 2 * std::sqrt(dot(face.toward, face.toward)));
    if (is_proved || !(distance > clearly * resolution_)) return false;
    Simplex<3> extended;
    for (std::size_t i = 0; i < face.size; ++i) extended.push(differences_[face.places[i]]);
    extended.push(differences_[newest]);
    const FittingFace<3> fitting = FittingFaceSearch<3>(extended).run();
    const double found = std::sqrt(fitting.nearest.distance_squared);
    if (!(fitting.misfit <= resolution_ && std::fabs(found - distance) <= resolution_)) return false;
    face = placed(fitting, face, newest);
    return true;
  }

  /// Converts to the indices of its corners.
  NearFace placed(const FittingFace<3>& fitting, const NearFace& before, std::uint32_t newest) const {
    const Simplex<3>& corners = fitting.nearest.face;
    std::uint32_t places[4] = {newest, newest, newest, newest};
    for (std::size_t i = 0; i < corners.size; ++i) {
      for (std::size_t k = 0; k < before.size; ++k) {
        if (differences_[before.places[k]] == corners.points[i]) places[i] = before.places[k];
      }
    }
    NearFace face;
    face.toward = fitting.toward;
    face.height = dot(fitting.toward, corners.points[0]);
    face.squared = fitting.nearest.distance_squared;
    face.places = HullPlaces(places[0], places[1], places[2], places[3]);
    face.size = static_cast<std::uint32_t>(corners.size);
    return face;
  }

  A& a_;
  B& b_;
  double resolution_;
  double height_ = 0;  ///< The height of the farthest corner opposite the vector to the face, along that vector.
  Vec<3, double> separation_ = Vec<3, double>(0.0);
  double distance_ = 0;
  double least_squared_ = 0;  ///< Of all faces so far.
  double lower_ = 0;          ///< Proved by the final supporting plane.
  std::array<Corner, 4> corners_;
  HullSimplex differences_;
  NearFace face_;
};

/// How far the nearest points may be off the normal and their distance, in units of the resolution.
inline constexpr double most_beside = 0.25;

/// As `find_proximity_of_hulls`, for hulls relative to `origin`.
template <class A, class B>
bool find_between(A& a, B& b, const Vec<3, double>& origin, const KnownCorners& known, Proximity<3, double>& result) {
  HullWalk walk(a, b, max_abs(origin));
  walk.run(known);
  if (walk.is_apart()) {
    auto points = walk.points();
    const auto beside = [&walk, &points] { return max_abs((points.on_b - points.on_a) + walk.separation()); };
    const double most = most_beside * walk.resolution();
    if (!(beside() <= most)) points = walk.careful_points();
    if (!(beside() <= most)) return false;
    result.distance = walk.distance();
    (known.is_exchanged ? result.point_b : result.point_a) = origin + points.on_a;
    (known.is_exchanged ? result.point_a : result.point_b) = origin + points.on_b;
    result.normal = walk.separation() * ((known.is_exchanged ? 1.0 : -1.0) / walk.distance());
    result.error = walk.error();
    return true;
  }
  if (!walk.is_overlapping()) return false;
  result = meeting_at<3>(origin + walk.points().on_a, Relation::overlapping);
  return true;
}

/// False for pairs that this leaves open. The search starts at a, whatever the order of the results and the cache.
template <HullInSpace A, HullInSpace B>
bool find_proximity_of_hulls(const A& a, const B& b, const KnownCorners& known, Proximity<3, double>& result) {
  const Vec<3, double> origin = origin_of(a);
  const auto local_a = local_hull(a, origin);
  const auto local_b = local_hull(b, origin);
#ifdef GRAZE_HAS_LANES
  if (std::max(local_a.size(), local_b.size()) <= FewCorners::room) {
    FewHull few_a(local_a);
    FewHull few_b(local_b);
    return find_between(few_a, few_b, origin, known, result);
  }
#endif
  return find_between(local_a, local_b, origin, known, result);
}

}  // namespace graze::detail
