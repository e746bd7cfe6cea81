// SPDX-License-Identifier: MIT
// contains, closest_point, closest_boundary_point and signed_distance of one shape and points.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <rapidcheck.h>

#include <graze/shape/fields/visit.hpp>

#include "exact/kinds.hpp"
#include "exam/pair_question.hpp"
#include "query/point_answers.hpp"
#include "query/point_judgement.hpp"
#include "query/points.hpp"
#include "query/regressions.hpp"

namespace graze::exam {

template <Dim N, class T>
class PointQuestion {
 public:
  using Any = AnyShape<N, T>;
  using Answers = test::PointAnswers<N, T>;
  using Case = test::ShapeAndPoint<N, T>;
  using Truth = double;  // the signed distance
  static constexpr std::string_view name = "point";
  static constexpr SpaceName space = space_name<N, T>();
  static constexpr std::size_t Settings::*limit = &Settings::points;
  static constexpr std::uint64_t seeds_apart = 1;
  static constexpr std::size_t variations = 0;
  static constexpr bool has_rivals = false;

  /// All types except compounds and meshes, the last, which are their parts.
  static std::vector<Subject> subjects() {
    std::vector<Subject> all = shape_subjects(" and points", 0, [](std::size_t type) { return type + 2 < type_count; });
    for (Subject& subject : all) subject.seed = 0;  // each type has its own generator
    return all;
  }

  PointQuestion(const Subject& subject, std::uint64_t seed)
      : random_(seed), any_(test::shape_and_point<N, T>(subject.a)) {}

  std::vector<Case> draw(std::size_t) { return {test::value_from(any_, random_.split())}; }

  static Judged<Truth> judge(const Case& drawn, Figures& figures) {
    const auto& [shape, point] = drawn;
    const Answers given = test::answers<N, T>(shape, point);
    const test::PointErrors errors = errors_of(shape, point, given);
    const bool is_right = holds_its_answers(shape, given) && errors.template are_within_bounds<T>();
    const double closest = errors.closest / errors.slenderness;
    figures.share("held", given.contained);
    figures.keep("forgiven", errors.forgiven, By::scalar);
    figures.keep("signed_distance", errors.distance, By::scalar);
    figures.keep("closest_point", closest, By::scalar);
    figures.keep("closest_boundary_point", errors.boundary / errors.slenderness, By::scalar);
    const bool is_needle = errors.slenderness > 1;
    figures.keep("needles", is_needle ? std::max(errors.closest, errors.boundary) : 0, By::scalar);
    return {errors.truth, is_right ? test::Judgement::right : test::Judgement::wrong, closest};
  }

  static std::string row(const Case& drawn, double truth) {
    return test::regression_row<N, T>("point", drawn.first, drawn.second, test::number_text(truth));
  }

 private:
  static test::PointErrors errors_of(const Any& shape, const Vec<N, T>& point, const Answers& given) {
    return detail::visit(
        [&](const auto& held) -> test::PointErrors {
          if constexpr (test::has_parts<std::decay_t<decltype(held)>>) {
            return {};
          } else {
            return test::point_errors(held, point, given);
          }
        },
        shape);
  }

  static bool holds_its_answers(const Any& shape, const Answers& given) {
    return test::answers<N, T>(shape, given.closest).contained && test::answers<N, T>(shape, given.boundary).contained;
  }

  rc::Random random_;
  rc::Gen<Case> any_;
};

}  // namespace graze::exam
