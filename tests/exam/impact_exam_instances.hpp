// SPDX-License-Identifier: MIT
// The definition of examine_impacts, for the files that instantiate it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include <rapidcheck.h>

#include <graze/math/motion.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/impact.hpp>
#include <graze/shape/any_shape.hpp>

#include "catalogue.hpp"
#include "exam/impact_exam.hpp"
#include "exam/impact_rival.hpp"
#include "exam/rigid.hpp"
#include "exam/stopwatch.hpp"
#include "query/case_maker.hpp"
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

/// The longest side of the shape's bounds that has an end.
template <Dim N, class T>
double side_of(const AnyShape<N, T>& shape) {
  const Aabb<N, T> box = bounds(shape);
  const auto side = static_cast<double>(max_abs(box.max - box.min));
  return std::isfinite(side) ? side : 0;
}

template <Dim N, class T>
class ImpactExam {
 public:
  using Moving = test::Moving<N, T>;

  ImpactExam(std::size_t a, std::size_t b, RegressionLog& regressions) : regressions_(regressions) {
    tally_.space = space_name<N, T>();
    tally_.pair = pair_name(a, b);
  }

  /// Puts a case to graze.
  test::ImpactErrors put(const Moving& moving) {
    const test::ImpactErrors errors = test::impact_errors<N, T>(moving);
    ++tally_.cases;
    if (errors.judgement == test::Judgement::outside_range) ++tally_.outside;
    if (errors.hits) ++tally_.hits;
    if (errors.is_unfinished) ++tally_.unfinished;
    if (errors.judgement == test::Judgement::wrong) {
      ++tally_.wrong;
      regressions_.add_failure(test::impact_row<N, T>(moving, errors.hits ? "touch" : "miss"));
    }
    tally_.worst = std::max(tally_.worst, errors.gap);
    tally_.worst_second = std::max(tally_.worst_second, errors.claimed);
    return errors;
  }

  /// The same for the rivals, in space, of shapes that are well apart before they move.
  void put_to_rivals(const Moving& moving, const test::ImpactErrors& own) {
    if constexpr (N == 3) {
      if (own.judgement != test::Judgement::right || !is_tame(moving.a, moving.motion_a) ||
          !is_tame(moving.b, moving.motion_b) || !is_rigid<T>(moving.a) || !is_rigid<T>(moving.b))
        return;
      const Way way = way_of(moving);
      if (!(test::gap_at(moving, 0) > fair_gap<T> * way.size) || !(way.size < 1e100)) return;
      bool is_asked = false;
      for (const ImpactRival<T>& rival : impact_rivals<T>()) {
        const std::optional<Meeting> answer = rival.answer(moving);
        if (!answer) continue;
        is_asked = true;
        count(tally_.rivals[rival.name], way, own, *answer);
      }
      if (is_asked) count(tally_.rivals["graze"], way, own, {own.hits, own.t});
    }
  }

  const MeasuredPair& tally() const { return tally_; }

 private:
  /// Whether it turns as rivals can.
  static bool is_tame(const AnyShape<N, T>& shape, const Motion<N, T>& motion) {
    return dot(motion.angular, motion.angular) <= T(most_turn * most_turn) && motion.center == middle_of<N, T>(shape);
  }

  struct Way {
    const Moving& moving;
    double size;
    double own_size;  ///< Of the shapes and their motions, wherever they are.
    double least;     ///< The gap where they are nearest to each other or deepest.
  };

  static Way way_of(const Moving& moving) {
    double own_size = static_cast<double>(sum_abs(moving.motion_a.linear) + sum_abs(moving.motion_b.linear));
    own_size = std::max({own_size, side_of<N, T>(moving.a), side_of<N, T>(moving.b)});
    return {moving, test::size_of_way(moving), own_size, test::least_gap(moving, 0, 1)};
  }

  /// How far apart the shapes are at t, if they have not met before; else how deep they have been in each other.
  static double error_at(const Way& way, const test::ImpactErrors& own, double t) {
    if (!(t >= 0 && t <= 1)) return std::numeric_limits<double>::infinity();
    const double gap = std::fabs(test::gap_at(way.moving, t));
    return t > own.t ? std::max(gap, -test::least_gap(way.moving, own.t, t)) : gap;
  }

  /// graze's answer is known to be right, up to its error.
  static void count(MeasureTally& tally, const Way& way, const test::ImpactErrors& own, const Meeting& answer) {
    const double given = fair_gap<T> * way.size;
    ++tally.cases;
    if (std::fabs(way.least) <= given) return;
    const bool hits = own.hits && way.least < 0;
    if (own.hits && !hits) return;  // just beside each other, or deeper than was found
    if (answer.hits != hits) ++(answer.hits ? tally.false_yes : tally.false_no);
    if (!answer.hits || !hits) return;
    ++tally.measured;
    const double error = error_at(way, own, answer.t);
    if (!(error <= fair_share * way.own_size + given)) ++tally.off;
    if (!(error <= fine_share * way.own_size + given)) ++tally.slightly_off;
    tally.worst = std::max(tally.worst, error / way.size);
  }

  RegressionLog& regressions_;
  MeasuredPair tally_;
};

/// Where two shapes are together, or just beside each other, and how they come there.
template <Dim N, class T>
class MotionMaker {
 public:
  MotionMaker(const test::AnyPair<N, T>& pair, rc::Random& random)
      : random_(random), extent_(std::max(side_of<N, T>(pair.first), side_of<N, T>(pair.second))) {
    if (!(extent_ > 0)) extent_ = 1;
  }

  /// The first shape is where it is after some of its way, or all of it. In one case of four nothing turns; in every
  /// second one both turn as rivals can: by little, about their middles.
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

template <Dim N, class T>
MeasuredPair examine_impacts(std::size_t a, std::size_t b, const Settings& settings, RegressionLog& regressions) {
  constexpr std::uint64_t seeds_apart = 7000;  // not those of the verdicts
  const std::uint64_t seed = settings.seed * seeds_apart + a * shape_type_names.size() + b;
  ImpactExam<N, T> exam(a, b, regressions);
  test::CaseMaker<N, T> maker(a, b, seed);
  rc::Random random(seed);
  const Stopwatch watch;
  for (std::size_t turn = 0; exam.tally().cases < settings.impacts && watch.is_within(settings.seconds); ++turn) {
    const auto kind = static_cast<test::CaseKind>(turn % test::case_kind_count);
    for (const test::AnyPair<N, T>& pair : maker.make(kind)) {
      const test::Moving<N, T> moving = MotionMaker<N, T>(pair, random).make(pair);
      exam.put_to_rivals(moving, exam.put(moving));
    }
  }
  return exam.tally();
}

}  // namespace graze::exam
