// SPDX-License-Identifier: MIT
// The definition of examine_points, for the files that instantiate it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>
#include <variant>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/any_shape.hpp>

#include "catalogue.hpp"
#include "exact/point.hpp"
#include "exam/pair_exam.hpp"
#include "exam/stopwatch.hpp"
#include "query/case_maker.hpp"
#include "query/point_agreement.hpp"
#include "query/point_answers.hpp"
#include "query/points.hpp"

namespace graze::exam {

/// Corners sharper than this sine are those that closest_point.hpp excepts: about 20 degrees, rounded down.
inline constexpr double sharp_sine = 0.3;

/// How far outside a point may be that graze holds to be in a shape: contains.hpp's table, in ulp of T. Solids have a
/// band in double; thin shapes, and thin solids, the tolerance of T.
template <class T>
inline constexpr double forgiven_ulp = std::max(tolerance::surface<T>, 64 * tolerance::epsilon) /
                                       static_cast<double>(std::numeric_limits<T>::epsilon());

template <Dim N, class T>
class PointExam {
 public:
  using Answers = test::PointAnswers<N, T>;

  PointExam(std::size_t type, FailureLog& failures) : failures_(failures) {
    tally_.space = space_name<N, T>();
    tally_.shape = std::string(shape_type_names[type]);
  }

  template <class S>
  void put(const S& shape, const AnyShape<N, T>& any, const Vec<N, T>& point) {
    const Answers given = test::answers<N, T>(any, point);
    const double truth = test::exact_signed_distance(shape, point);
    const double ulp = test::unit_of(shape, point, given.boundary);
    ++tally_.cases;
    if (given.contained) ++tally_.held;
    if (!holds_its_answers(any, given) || !is_rightly_contained(shape, given, truth, ulp)) fail(any, point, truth);
    if (ulp == 0) return;
    const bool is_forgiven = given.distance == 0 && truth != 0;
    double& worst = is_forgiven ? tally_.forgiven : tally_.distance;
    worst = std::max(worst, std::fabs(static_cast<double>(given.distance) - truth) / ulp);
    if (test::sharpest_corner(shape) < sharp_sine) {
      ++tally_.sharp;
      return;
    }
    const double way = test::length_from<N>(test::wide_vector<N>(test::exact(point)), given.boundary);
    tally_.boundary = std::max(tally_.boundary, std::fabs(way - std::fabs(truth)) / ulp);
    if (truth <= 0 || given.closest == point) return;
    const double off = test::length_from<N>(test::exact_closest_point(shape, point), given.closest);
    tally_.closest = std::max(tally_.closest, off / ulp);
  }

  const PointTally& tally() const { return tally_; }

 private:
  static bool holds_its_answers(const AnyShape<N, T>& shape, const Answers& given) {
    return test::answers<N, T>(shape, given.closest).contained && test::answers<N, T>(shape, given.boundary).contained;
  }

  template <class S>
  static bool is_rightly_contained(const S&, const Answers& given, double truth, double ulp) {
    const double off = std::is_same_v<S, Plane<N, T>> ? std::fabs(truth) : truth;
    return given.contained ? off <= forgiven_ulp<T> * ulp : off > 0;
  }

  void fail(const AnyShape<N, T>& shape, const Vec<N, T>& point, double truth) {
    ++tally_.wrong;
    failures_.add("{" + test::to_source<N, T>(shape) + ", " + test::to_source(point) + "},  // signed distance " +
                  test::literal(truth));
  }

  FailureLog& failures_;
  PointTally tally_;
};

template <Dim N, class T>
PointTally examine_points(std::size_t type, const Settings& settings, FailureLog& failures) {
  PointExam<N, T> exam(type, failures);
  rc::Random random(settings.seed);
  const rc::Gen<test::ShapeAndPoint<N, T>> any = test::shape_and_point<N, T>(type);
  const Stopwatch watch;
  while (exam.tally().cases < settings.cases && watch.is_within(settings.seconds)) {
    const auto [shape, point] = test::value_from(any, random.split());
    std::visit(
        [&, &any_shape = shape, &place = point](const auto& held) {
          if constexpr (!test::has_parts<std::decay_t<decltype(held)>>) exam.put(held, any_shape, place);
        },
        shape);
  }
  return exam.tally();
}

}  // namespace graze::exam
