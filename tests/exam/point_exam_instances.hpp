// SPDX-License-Identifier: MIT
// The definition of examine_points, for the files that instantiate it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <type_traits>

#include <graze/math/vec.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/visit.hpp>

#include "catalogue.hpp"
#include "exact/kinds.hpp"
#include "exam/pair_exam.hpp"
#include "exam/stopwatch.hpp"
#include "query/case_maker.hpp"
#include "query/point_answers.hpp"
#include "query/point_judgement.hpp"
#include "query/points.hpp"
#include "query/regressions.hpp"

namespace graze::exam {

template <Dim N, class T>
class PointExam {
 public:
  using Answers = test::PointAnswers<N, T>;

  PointExam(std::size_t type, RegressionLog& regressions) : regressions_(regressions) {
    tally_.space = space_name<N, T>();
    tally_.shape = std::string(shape_type_names[type]);
  }

  template <class S>
  void put(const S& shape, const AnyShape<N, T>& any, const Vec<N, T>& point) {
    const Answers given = test::answers<N, T>(any, point);
    const test::PointErrors errors = test::point_errors(shape, point, given);
    ++tally_.cases;
    if (given.contained) ++tally_.held;
    if (!holds_its_answers(any, given) || !errors.are_within_bounds<T>()) {
      ++tally_.wrong;
      regressions_.add_failure(row(any, point, errors));
    }
    const double worst_closest = std::max(tally_.closest, errors.closest / errors.slenderness);
    if (worst_closest > tally_.closest) hardest_ = row(any, point, errors);
    tally_.forgiven = std::max(tally_.forgiven, errors.forgiven);
    tally_.distance = std::max(tally_.distance, errors.distance);
    tally_.closest = worst_closest;
    tally_.boundary = std::max(tally_.boundary, errors.boundary / errors.slenderness);
    if (errors.slenderness > 1) tally_.needle = std::max({tally_.needle, errors.closest, errors.boundary});
  }

  const PointTally& tally() const { return tally_; }

  /// The row of the case with the largest error of closest_point; empty if there was none.
  const std::string& hardest() const { return hardest_; }

 private:
  static bool holds_its_answers(const AnyShape<N, T>& shape, const Answers& given) {
    return test::answers<N, T>(shape, given.closest).contained && test::answers<N, T>(shape, given.boundary).contained;
  }

  static std::string row(const AnyShape<N, T>& shape, const Vec<N, T>& point, const test::PointErrors& errors) {
    return test::regression_row<N, T>("point", shape, point, test::number_text(errors.truth));
  }

  RegressionLog& regressions_;
  PointTally tally_;
  std::string hardest_;
};

template <Dim N, class T>
PointTally examine_points(std::size_t type, const Settings& settings, RegressionLog& regressions) {
  PointExam<N, T> exam(type, regressions);
  rc::Random random(settings.seed);
  const rc::Gen<test::ShapeAndPoint<N, T>> any = test::shape_and_point<N, T>(type);
  const Stopwatch watch;
  while (exam.tally().cases < settings.points && watch.is_within(settings.seconds)) {
    const auto [shape, point] = test::value_from(any, random.split());
    detail::visit(
        [&, &any_shape = shape, &place = point](const auto& held) {
          if constexpr (!test::has_parts<std::decay_t<decltype(held)>>) exam.put(held, any_shape, place);
        },
        shape);
  }
  if (settings.keeps_hardest && !exam.hardest().empty()) regressions.add(exam.hardest());
  return exam.tally();
}

}  // namespace graze::exam
