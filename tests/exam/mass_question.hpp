// SPDX-License-Identifier: MIT
// mass_properties(shape) of the solids that are hulls of a few corners, compared with rational arithmetic.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "exam/pair_question.hpp"
#include "query/mass_judgement.hpp"
#include "query/regressions.hpp"

namespace graze::exam {

template <Dim N, class T>
class MassQuestion {
 public:
  using Case = AnyShape<N, T>;
  using Truth = double;  // the volume
  static constexpr std::string_view name = "mass_properties";
  static constexpr SpaceName space = space_name<N, T>();
  static constexpr std::size_t Settings::*limit = &Settings::masses;
  static constexpr std::uint64_t seeds_apart = 8000;
  static constexpr std::size_t variations = 0;
  static constexpr bool has_rivals = false;

  /// Boxes and polytopes, and in 2D triangles.
  static std::vector<Subject> subjects() {
    constexpr std::size_t aabb = 4;
    constexpr std::size_t obb = 5;
    constexpr std::size_t triangle = 8;
    constexpr std::size_t polytope = 10;
    std::vector<Subject> solids = shape_subjects(" of mass", 0, [](std::size_t type) {
      return type == aabb || type == obb || type == polytope || (type == triangle && N == 2);
    });
    for (Subject& subject : solids) subject.name = label(space) + " " + subject.name;  // each space has its own row
    return solids;
  }

  MassQuestion(const Subject& subject, std::uint64_t seed) : maker_(subject.a, subject.b, seed) {}

  std::vector<Case> draw(std::size_t turn) { return {maker_.make(kind_of(turn)).front().first}; }

  /// The errors are in epsilon of double, relative to a box as large as the shape, or as far from the origin.
  static Judged<Truth> judge(const Case& shape, Figures& figures) {
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    const test::MassErrors errors = test::mass_errors<N, T>(shape);
    figures.count("with_volume", errors.true_volume > 0);
    figures.keep("volume", errors.volume / epsilon);
    figures.keep("centroid", errors.centroid / epsilon);
    figures.keep("inertia", errors.inertia / epsilon);
    const bool is_right = errors.are_within_bounds();
    return {errors.true_volume, is_right ? test::Judgement::right : test::Judgement::wrong};
  }

  static std::string row(const Case& shape, double volume) {
    return test::regression_row<N, T>("mass_properties", shape, Compound<N, T>{}, test::number_text(volume));
  }

 private:
  test::CaseMaker<N, T> maker_;
};

}  // namespace graze::exam
