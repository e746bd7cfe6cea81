// SPDX-License-Identifier: MIT
// The Minkowski difference of a moving convex shape and another: GJK's result at one time is the starting point at
// another.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>

#include <graze/math/pose.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/cast/minkowski_difference.hpp>
#include <graze/query/closest_points.hpp>
#include <graze/query/convex/simplex.hpp>
#include <graze/shape/shape.hpp>

namespace graze::detail {

/// A point of a shape a, before it is moved, and one of b.
template <Dim N>
struct CornerOfDifference {
  Vec<N, double> on_a;
  Vec<N, double> on_b;
};

/// The points of a simplex; none initially.
template <Dim N>
struct CornersOfDifference {
  std::array<CornerOfDifference<N>, static_cast<std::size_t>(N) + 1> corners;
  std::size_t size = 0;
};

/// The differences moved a - b, which remember the points that they were made from. `Number` is the supports' number
/// type. It must not outlive the shapes.
template <Dim N, Scalar Number>
class MovingDifference final : public AnyDifference<N> {
 public:
  static constexpr Dim dimension = N;
  using Point = Vec<N, double>;

  MovingDifference(const ConvexView<N>& a, const ConvexView<N>& b, const Pose<N, double>& pose)
      : a_(a), b_(b), pose_(pose), back_(transpose(pose.rotation)) {}

  Point support(const Point& direction) override {
    return add({a_.support(back_ * direction), b_.support(-direction)});
  }

  double resolution() const override {
    return largest_ * (std::is_same_v<Number, float> ? tolerance::convex_in<float> : tolerance::convex);
  }

  /// The simplex of the same points of both shapes, at their current positions.
  Simplex<N> simplex_of(const CornersOfDifference<N>& known) {
    Simplex<N> simplex;
    for (std::size_t i = 0; i < known.size; ++i) simplex.push(add(known.corners[i]));
    return simplex;
  }

  /// For differences created here.
  CornersOfDifference<N> corners_of(const Simplex<N>& simplex) const {
    CornersOfDifference<N> known;
    for (std::size_t i = 0; i < simplex.size; ++i) known.corners[known.size++] = made(simplex.points[i]).corner;
    return known;
  }

  /// The points that a difference was made from: the moved point of a, and that of b.
  CornerOfDifference<N> witness(const Point& difference) const {
    const CornerOfDifference<N>& corner = made(difference).corner;
    return {moved(corner.on_a), corner.on_b};
  }

 private:
  struct Made {
    Point difference;
    CornerOfDifference<N> corner;
  };

  Point moved(const Point& on_a) const { return pose_.rotation * on_a + pose_.position; }

  Point add(const CornerOfDifference<N>& corner) {
    const Point on_a = moved(corner.on_a);
    largest_ = std::max({largest_, max_abs(on_a), max_abs(corner.on_b)});
    const Point difference = on_a - corner.on_b;
    if (count_ < made_.size()) made_[count_++] = {difference, corner};
    return difference;
  }

  const Made& made(const Point& difference) const {
    const auto* const end = made_.begin() + count_;
    return *std::find_if(made_.begin(), end, [&](const Made& each) { return each.difference == difference; });
  }

  const ConvexView<N>& a_;
  const ConvexView<N>& b_;
  const Pose<N, double>& pose_;
  Mat<N, double> back_;
  double largest_ = 0;
  std::size_t count_ = 0;
  std::array<Made, most_supports + static_cast<std::size_t>(N) + 1> made_;
};

}  // namespace graze::detail
