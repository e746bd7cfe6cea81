// SPDX-License-Identifier: MIT
// time_of_impact(a, motion_a, b, motion_b).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rapidcheck.h>

#include <graze/math/motion.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/impact.hpp>

#include "exam/cast_question.hpp"
#include "exam/pair_question.hpp"
#include "query/impact_judgement.hpp"
#include "query/moving_gap.hpp"
#include "query/placement.hpp"
#include "query/times_of_impact.hpp"

namespace graze::exam {

/// Of the shape's bounds; not finite if they are not.
template <Dim N, class T>
Vec<N, T> middle_of(const AnyShape<N, T>& shape) {
  const Aabb<N, T> box = bounds(shape);
  return box.min * T(0.5) + box.max * T(0.5);
}

/// Two shapes in contact, or just beside each other, and motions that bring them there.
template <Dim N, class T>
class MotionMaker {
 public:
  MotionMaker(const test::AnyPair<N, T>& pair, rc::Random& random) : random_(random), extent_(extent_of<N, T>(pair)) {}

  /// The first shape is at its given place after some or all of its motion. In one case in four nothing rotates; in
  /// every second one both rotate as rivals support: by little, about their centers.
  test::Moving<N, T> make(const test::AnyPair<N, T>& pair) {
    const bool is_tame = test::whole(random_, 0, 1) == 0;
    most_turn_ = test::whole(random_, 0, 3) == 0 ? 0 : is_tame ? most_turn : 3;
    const Vec<N, T> way = way_of_length(0.5, 3);
    const auto done = static_cast<T>(test::share(random_, 0.0, 1.0));
    test::Moving<N, T> moving{test::moved<N, T>(pair.first, way * -done), {}, pair.second, {}};
    moving.motion_a = motion(moving.a, way, is_tame);
    if (test::whole(random_, 0, 3) > 0) moving.motion_b = motion(moving.b, way_of_length(0, 0.3), is_tame);
    return moving;
  }

 private:
  Vec<N, T> way_of_length(double least, double most) {
    return Vec<N, T>(test::any_way<N>(random_) * (extent_ * test::between(random_, least, most)));
  }

  Motion<N, T> motion(const AnyShape<N, T>& shape, const Vec<N, T>& way, bool is_tame) {
    const Vec<N, T> middle = middle_of<N, T>(shape);
    const bool has_middle = std::isfinite(static_cast<double>(sum_abs(middle)));
    const Vec<N, T> center = is_tame && has_middle ? middle : Vec<N, T>(test::point_of(shape, random_));
    return {way, turn(), center};
  }

  Turn<N, T> turn() {
    const double size = test::share(random_, 0, most_turn_);
    if constexpr (N == 2) {
      return static_cast<T>(test::whole(random_, 0, 1) == 0 ? -size : size);
    } else {
      return Vec<3, T>(test::any_way<3>(random_) * size);
    }
  }

  rc::Random& random_;
  double extent_;
  double most_turn_ = 0;
};

/// Motions that are fair to rivals, and the truth about them: graze's answer, which is known to be right up to its
/// error.
template <Dim N, class T>
struct AskedImpact {
  const test::Moving<N, T>& moving;
  const test::ImpactErrors& own;
  double own_size;  ///< Of the shapes and their motions, independent of position.
  double size;
  double least;  ///< The gap where they are nearest to each other or deepest.

  bool hits() const { return own.hits && least < 0; }
  /// Neither just beside each other, nor deeper than was found.
  bool is_clear() const { return std::fabs(least) > given(0) && (hits() || !own.hits); }
  double given(double share) const { return share * own_size + fair_gap<T> * size; }
};

template <Dim N, class T>
class ImpactQuestion {
 public:
  using Case = test::Moving<N, T>;
  using Truth = test::ImpactErrors;
  using Asked = AskedImpact<N, T>;
  static constexpr std::string_view name = "time_of_impact";
  static constexpr SpaceName space = space_name<N, T>();
  static constexpr std::size_t Settings::*limit = &Settings::impacts;
  static constexpr std::uint64_t seeds_apart = 7000;
  static constexpr std::size_t variations = 0;
  static constexpr bool has_rivals = N == 3;
  static constexpr auto& rivals = impact_rivals<T>;

  static std::vector<Subject> subjects() { return pair_subjects(" that turn"); }

  ImpactQuestion(const Subject& subject, std::uint64_t seed) : maker_(subject.a, subject.b, seed), random_(seed) {}

  std::vector<Case> draw(std::size_t turn) {
    std::vector<Case> motions;
    for (const test::AnyPair<N, T>& pair : maker_.make(kind_of(turn)))
      motions.push_back(MotionMaker<N, T>(pair, random_).make(pair));
    return motions;
  }

  static Judged<Truth> judge(const Case& moving, Figures& figures) {
    const Truth errors = test::impact_errors<N, T>(moving);
    figures.share("hits", errors.hits);
    figures.count("unfinished", errors.is_unfinished);
    figures.keep("gap", errors.gap, By::space);
    figures.keep("claimed", errors.claimed);
    return {errors, errors.judgement};
  }

  static std::string row(const Case& moving, const Truth& errors) {
    return test::impact_row<N, T>(moving, errors.hits ? "touch" : "miss");
  }

  /// Shapes that are well apart before they move.
  static std::optional<Asked> asked(const Case& moving, const Truth& own) {
    if (own.judgement != test::Judgement::right || !is_tame(moving.a, moving.motion_a) ||
        !is_tame(moving.b, moving.motion_b) || !is_rigid<N, T>(moving.a) || !is_rigid<N, T>(moving.b))
      return std::nullopt;
    const auto way = static_cast<double>(sum_abs(moving.motion_a.linear) + sum_abs(moving.motion_b.linear));
    const double own_size = std::max({way, side_of<N, T>(moving.a), side_of<N, T>(moving.b)});
    const double size = test::size_of_way(moving);
    const double least = test::least_gap(moving, 0, 1);
    if (!(test::gap_at(moving, 0) > fair_gap<T> * size) || !(size < 1e100)) return std::nullopt;
    return Asked{moving, own, own_size, size, least};
  }

  template <class Function>
  static auto ask(const Rival<Function>& rival, const Asked& asked) {
    return rival.answer(asked.moving);
  }

  static Meeting own_answer(const Asked& asked) { return {asked.own.hits, asked.own.t}; }

  static void mark(const Asked& asked, const Meeting& answer, Figures& figures) {
    const bool is_clear = asked.is_clear();
    const bool is_measured = is_clear && asked.hits() && answer.hits;
    const double error = is_measured ? error_at(asked, answer.t) : 0;
    count_verdict(is_clear && asked.hits(), is_clear && answer.hits, figures);
    figures.count("measured", is_measured);
    figures.count("slightly_off", !(error <= asked.given(fine_share)));
    count_error(error, asked.given(fair_share), asked.size, figures);
  }

 private:
  /// Whether it rotates as rivals support.
  static bool is_tame(const AnyShape<N, T>& shape, const Motion<N, T>& motion) {
    return dot(motion.angular, motion.angular) <= T(most_turn * most_turn) && motion.center == middle_of<N, T>(shape);
  }

  /// The distance of the shapes at t, if they have not met before; otherwise their previous depth.
  static double error_at(const Asked& asked, double t) {
    if (!(t >= 0 && t <= 1)) return std::numeric_limits<double>::infinity();
    const double gap = std::fabs(test::gap_at(asked.moving, t));
    return t > asked.own.t ? std::max(gap, -test::least_gap(asked.moving, asked.own.t, t)) : gap;
  }

  test::CaseMaker<N, T> maker_;
  rc::Random random_;
};

}  // namespace graze::exam
