// SPDX-License-Identifier: MIT
#include "exam/hull_exam.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <rapidcheck.h>

#include <graze/shape/hull/lexicographic.hpp>
#include <graze/shape/polytope.hpp>

#include "catalogue.hpp"
#include "exact/extreme.hpp"
#include "exact/solid.hpp"
#include "exact/verdict_instances.hpp"
#include "exam/hull_rival.hpp"
#include "exam/stopwatch.hpp"
#include "query/placement.hpp"
#include "query/regressions.hpp"

namespace graze::exam {

CornerTally& CornerTally::operator+=(const CornerTally& other) {
  sets += other.sets;
  given_up += other.given_up;
  missing += other.missing;
  extra += other.extra;
  worst = std::max(worst, other.worst);
  return *this;
}

namespace {

/// Makes sets of one kind, the same ones for the same seed.
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

template <Dim N>
bool is_before(const Vec<N, double>& a, const Vec<N, double>& b) {
  return detail::lexicographically_less<N, double>(a, b);
}

/// Each point once, in lexicographic order.
template <Dim N>
std::vector<Vec<N, double>> as_set(std::vector<Vec<N, double>> points) {
  std::sort(points.begin(), points.end(), is_before<N>);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

/// The corners by brute force in whole numbers; in the plane those of a flat set in space.
template <Dim N>
std::vector<Vec<N, double>> true_corners(const std::vector<Vec<N, double>>& points) {
  if constexpr (N == 3) {
    return test::exact_corners(points);
  } else {
    std::vector<Vec<3, double>> lifted;
    for (const Vec<2, double>& point : points) lifted.emplace_back(point, 0.0);
    std::vector<Vec<2, double>> corners;
    for (const Vec<3, double>& corner : test::exact_corners(lifted)) corners.emplace_back(corner);
    return corners;
  }
}

template <Dim N>
test::Solid<N> solid_of(const std::vector<Vec<N, double>>& points) {
  std::vector<test::RationalVec<N>> corners;
  for (const Vec<N, double>& point : points) corners.push_back(test::exact(point));
  return {std::move(corners), {}, 0};
}

/// `answer` as a set, like `truth`.
template <Dim N>
void count(CornerTally& tally, const std::vector<Vec<N, double>>& truth, const std::vector<Vec<N, double>>& answer) {
  std::vector<Vec<N, double>> missing;
  std::vector<Vec<N, double>> extra;
  std::set_difference(truth.begin(), truth.end(), answer.begin(), answer.end(), std::back_inserter(missing),
                      is_before<N>);
  std::set_difference(answer.begin(), answer.end(), truth.begin(), truth.end(), std::back_inserter(extra),
                      is_before<N>);
  tally.missing += missing.size();
  tally.extra += extra.size();
  double size = 0;
  for (const Vec<N, double>& corner : truth) size = std::max(size, max_abs(corner));
  for (const Vec<N, double>& corner : missing) {
    const double gap = test::solid_verdict<N>(solid_of<N>({corner}), solid_of<N>(answer), test::Measure::distance).gap;
    tally.worst = std::max(tally.worst, gap / size);
  }
}

template <Dim N>
std::vector<Vec<N, double>> chosen_from(const std::vector<Vec<N, double>>& points,
                                        const std::vector<std::size_t>& places) {
  std::vector<Vec<N, double>> chosen;
  for (const std::size_t place : places) chosen.push_back(points[place]);
  return as_set<N>(std::move(chosen));
}

template <Dim N, class T>
void put(HullTally& tally, const std::vector<Vec<N, T>>& points, RegressionLog& regressions) {
  std::vector<Vec<N, double>> given;
  for (const Vec<N, T>& point : points) given.push_back(wide<N, T>(point));
  const std::vector<Vec<N, double>> truth = as_set<N>(true_corners<N>(given));
  tally.points += points.size();
  tally.corners += truth.size();
  std::vector<Vec<N, double>> own;
  const Polytope<N, T> hull = convex_hull<N, T>(points);
  for (const Vec<N, T>& vertex : hull.vertices()) own.push_back(wide<N, T>(vertex));
  own = as_set<N>(std::move(own));
  CornerTally& of_graze = tally.programs["graze"];
  ++of_graze.sets;
  count<N>(of_graze, truth, own);
  if (own != truth) regressions.add_failure(test::hull_row<N, T>(points, truth.size()));
  for (const HullRival<N>& rival : hull_rivals<N>()) {
    CornerTally& of_rival = tally.programs[rival.name];
    ++of_rival.sets;
    if (const auto places = rival.answer(given)) {
      count<N>(of_rival, truth, chosen_from<N>(given, *places));
    } else {
      ++of_rival.given_up;
    }
  }
}

}  // namespace

template <Dim N, class T>
HullTally examine_hulls(HullKind kind, const Settings& settings, RegressionLog& regressions) {
  constexpr std::uint64_t seeds_apart = 7000;  // not those of the verdicts
  SetMaker<N, T> maker(kind, settings.seed * seeds_apart + static_cast<std::uint64_t>(kind));
  HullTally tally;
  tally.space = space_name<N, T>();
  tally.kind = kind;
  const Stopwatch watch;
  for (std::size_t i = 0; i < settings.hulls && watch.is_within(settings.seconds); ++i)
    put<N, T>(tally, maker.make(), regressions);
  return tally;
}

template HullTally examine_hulls<2, float>(HullKind, const Settings&, RegressionLog&);
template HullTally examine_hulls<2, double>(HullKind, const Settings&, RegressionLog&);
template HullTally examine_hulls<3, float>(HullKind, const Settings&, RegressionLog&);
template HullTally examine_hulls<3, double>(HullKind, const Settings&, RegressionLog&);

}  // namespace graze::exam
