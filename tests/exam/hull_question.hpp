// SPDX-License-Identifier: MIT
// convex_hull(points): which points are corners, for sets of up to twenty points of one kind, compared with integer
// arithmetic.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rapidcheck.h>

#include <graze/shape/hull/lexicographic.hpp>
#include <graze/shape/polytope.hpp>

#include "exact/extreme.hpp"
#include "exact/solid.hpp"
#include "exact/verdict_instances.hpp"
#include "exam/exam.hpp"
#include "exam/rival.hpp"
#include "query/placement.hpp"
#include "query/regressions.hpp"

namespace graze::exam {

/// How the points of a set are arranged.
enum class HullKind {
  uniform,          ///< -10 to 10.
  lattice,          ///< Integers from 0 to 3: many points on faces and edges, some of them twice.
  nearly_coplanar,  ///< Lattice points in one or two planes of any orientation, up to the rounding of the coordinates.
  sphere,           ///< At equal distances from the origin, up to rounding: all are corners.
  far,              ///< A lattice with steps of 0.1, up to rounding, a million units from the origin.
  cube,             ///< A cube and points on its faces, all moved by up to three ulp.
};
inline constexpr std::array<std::string_view, 6> hull_kind_names = {"uniform", "lattice", "nearly coplanar",
                                                                    "sphere",  "far",     "cube"};

/// Generates sets of one kind, the same ones for the same seed.
template <Dim N, class T>
class SetMaker {
 public:
  using Point = Vec<N, T>;

  SetMaker(HullKind kind, std::uint64_t seed) : kind_(kind), random_(seed) {}

  std::vector<Point> make() {
    const Vec<N, double> along = test::any_way<N>(random_);
    const Vec<N, double> across = test::any_way<N>(random_);
    const Vec<N, double> up = test::any_way<N>(random_) * 3.0;
    const double layers = test::whole(random_, 0, 1);
    const auto count = static_cast<std::size_t>(test::whole(random_, 4, 20));
    std::vector<Point> points;
    for (std::size_t i = 0; i < count; ++i) {
      if (kind_ == HullKind::nearly_coplanar) {
        const Vec<N, double> on_plane = along * steps(-3, 3) + across * steps(-3, 3);
        points.emplace_back(on_plane + up * steps(0, layers));
      } else {
        points.push_back(draw());
      }
    }
    return points;
  }

 private:
  double steps(double low, double high) { return test::whole(random_, static_cast<int>(low), static_cast<int>(high)); }

  /// Up to three ulp more or less.
  T nudged(T x) {
    const double ulp = static_cast<double>(std::numeric_limits<T>::epsilon()) * std::fabs(static_cast<double>(x));
    return x + static_cast<T>(steps(-3, 3) * ulp);
  }

  Point draw() {
    Vec<N, double> point;
    for (Dim i = 0; i < N; ++i) {
      switch (kind_) {
        case HullKind::lattice:
          point[i] = steps(0, 3);
          break;
        case HullKind::far:
          point[i] = 1e6 + 0.1 * steps(0, 9);
          break;
        case HullKind::cube:
          point[i] = steps(1, 3);
          break;
        default:
          point[i] = test::between(random_, -10, 10);
      }
    }
    if (kind_ == HullKind::sphere && max_abs(point) > 0) point /= std::sqrt(dot(point, point));
    if (kind_ != HullKind::cube) return Point(point);
    const auto face = static_cast<Dim>(test::whole(random_, 0, static_cast<int>(N) - 1));
    point[face] = steps(0, 1) * 2 + 1;
    Point rounded(point);
    for (Dim i = 0; i < N; ++i) rounded[i] = nudged(rounded[i]);
    return rounded;
  }

  HullKind kind_;
  rc::Random random_;
};

/// Sets of points in lexicographic order, without duplicates.
template <Dim N>
class PointSet {
 public:
  using Point = Vec<N, double>;

  PointSet() = default;
  explicit PointSet(std::vector<Point> points) : points_(std::move(points)) {
    std::sort(points_.begin(), points_.end(), is_before);
    points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
  }

  const std::vector<Point>& points() const { return points_; }
  bool operator==(const PointSet& other) const { return points_ == other.points_; }

  /// The points that are not in the other set.
  std::vector<Point> without(const PointSet& other) const {
    std::vector<Point> rest;
    std::set_difference(points_.begin(), points_.end(), other.points_.begin(), other.points_.end(),
                        std::back_inserter(rest), is_before);
    return rest;
  }

 private:
  static bool is_before(const Point& a, const Point& b) { return detail::lexicographically_less<N, double>(a, b); }

  std::vector<Point> points_;
};

template <Dim N>
test::Solid<N> solid_of(const std::vector<Vec<N, double>>& points) {
  std::vector<test::RationalVec<N>> corners;
  for (const Vec<N, double>& point : points) corners.push_back(test::exact(point));
  return {std::move(corners), {}, 0};
}

/// A set of points, its true corners, and graze's answer.
template <Dim N>
struct AskedHull {
  std::vector<Vec<N, double>> points;
  PointSet<N> corners;  ///< By brute force in integers.
  PointSet<N> own;      ///< graze's.
};

template <Dim N, class T>
class HullQuestion {
 public:
  using Case = std::vector<Vec<N, T>>;
  using Truth = AskedHull<N>;
  using Asked = AskedHull<N>;
  using Answer = std::optional<std::vector<std::size_t>>;  // their indices; none if there is none
  static constexpr std::string_view name = "convex_hull";
  static constexpr SpaceName space = space_name<N, T>();
  static constexpr std::size_t Settings::*limit = &Settings::hulls;
  static constexpr std::uint64_t seeds_apart = 7000;
  static constexpr std::size_t variations = 0;
  static constexpr bool has_rivals = true;
  static constexpr auto& rivals = hull_rivals<N>;

  static std::vector<Subject> subjects() {
    std::vector<Subject> kinds;
    for (std::size_t kind = 0; kind < hull_kind_names.size(); ++kind) {
      const std::string kind_name(hull_kind_names[kind]);
      kinds.push_back({kind, 0, kind_name, "hull " + kind_name, kind});
    }
    return kinds;
  }

  HullQuestion(const Subject& subject, std::uint64_t seed) : maker_(static_cast<HullKind>(subject.a), seed) {}

  std::vector<Case> draw(std::size_t) { return {maker_.make()}; }

  static Judged<Truth> judge(const Case& points, Figures&) {
    const Polytope<N, T> hull = convex_hull<N, T>(points);
    const std::vector<Vec<N, double>> given = wide_points(points);
    Truth truth{given, true_corners(given), PointSet<N>(wide_points(hull.vertices()))};
    const bool is_right = truth.own == truth.corners;
    return {std::move(truth), is_right ? test::Judgement::right : test::Judgement::wrong};
  }

  static std::string row(const Case& points, const Truth& truth) {
    return test::hull_row<N, T>(points, truth.corners.points().size());
  }

  static std::optional<Asked> asked(const Case&, const Truth& truth) { return truth; }

  template <class Function>
  static std::optional<Answer> ask(const Rival<Function>& rival, const Asked& asked) {
    return rival.answer(asked.points);
  }

  static PointSet<N> own_answer(const Asked& asked) { return asked.own; }

  static void mark(const Asked& asked, const Answer& answer, Figures& figures) {
    figures.count("given_up", !answer);
    if (!answer) return mark(asked, asked.corners, figures);
    std::vector<Vec<N, double>> chosen;
    for (const std::size_t place : *answer) chosen.push_back(asked.points[place]);
    mark(asked, PointSet<N>(std::move(chosen)), figures);
  }

  static void mark(const Asked& asked, const PointSet<N>& answer, Figures& figures) {
    const std::vector<Vec<N, double>> missing = asked.corners.without(answer);
    figures.count("points", asked.points.size());
    figures.count("corners", asked.corners.points().size());
    figures.count("given_up", 0);
    figures.count("missing", missing.size());
    figures.count("extra", answer.without(asked.corners).size());
    figures.keep("worst", 0);
    double size = 0;
    for (const Vec<N, double>& corner : asked.corners.points()) size = std::max(size, max_abs(corner));
    for (const Vec<N, double>& corner : missing) {
      const double gap =
          test::solid_verdict<N>(solid_of<N>({corner}), solid_of<N>(answer.points()), test::Measure::distance).gap;
      figures.keep("worst", gap / size);
    }
  }

 private:
  template <class Points>
  static std::vector<Vec<N, double>> wide_points(const Points& points) {
    std::vector<Vec<N, double>> result;
    for (const Vec<N, T>& point : points) result.push_back(wide<N, T>(point));
    return result;
  }

  /// In 2D, those of a flat set in 3D.
  static PointSet<N> true_corners(const std::vector<Vec<N, double>>& points) {
    if constexpr (N == 3) {
      return PointSet<N>(test::exact_corners(points));
    } else {
      std::vector<Vec<3, double>> lifted;
      for (const Vec<2, double>& point : points) lifted.emplace_back(point, 0.0);
      std::vector<Vec<2, double>> corners;
      for (const Vec<3, double>& corner : test::exact_corners(lifted)) corners.emplace_back(corner);
      return PointSet<N>(std::move(corners));
    }
  }

  SetMaker<N, T> maker_;
};

}  // namespace graze::exam
