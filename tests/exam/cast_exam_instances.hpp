// SPDX-License-Identifier: MIT
// The definition of examine_casts, for the files that instantiate it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include <rapidcheck.h>

#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/impact.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/any_shape.hpp>

#include "catalogue.hpp"
#include "exact.hpp"
#include "exact/sweep.hpp"
#include "exam/cast_exam.hpp"
#include "exam/cast_rival.hpp"
#include "exam/rigid.hpp"
#include "exam/stopwatch.hpp"
#include "query/case_maker.hpp"
#include "query/cast_judgement.hpp"
#include "query/placement.hpp"
#include "query/shape_casts.hpp"

namespace graze::exam {

template <Dim N, class T>
class CastExam {
 public:
  using Any = AnyShape<N, T>;
  using Cast = test::Cast<N, T>;

  CastExam(std::size_t a, std::size_t b, RegressionLog& regressions) : regressions_(regressions) {
    tally_.space = space_name<N, T>();
    tally_.pair = pair_name(a, b);
  }

  /// Puts a case to graze, and returns the truth before anything moves.
  test::ExactVerdict put(const Cast& cast) {
    const test::ExactVerdict start = test::exact_verdict<N, T>(cast.a, cast.b);
    const test::CastErrors errors = test::cast_errors<N, T>(cast, start);
    ++tally_.cases;
    if (errors.judgement == test::Judgement::outside_range) ++tally_.outside;
    if (test::impact_of<N, T>(cast.a, cast.motion, cast.b)) ++tally_.hits;
    if (errors.judgement == test::Judgement::wrong) {
      ++tally_.wrong;
      regressions_.add_failure(test::cast_row<N, T>(cast, name_of(whole_way(cast).relation)));
    }
    tally_.worst = std::max(tally_.worst, errors.gap);
    tally_.worst_second = std::max(tally_.worst_second, errors.claimed);
    return start;
  }

  /// The same for the rivals, in space, of shapes that are well apart before they move.
  void put_to_rivals(const Cast& cast, const test::ExactVerdict& start) {
    if constexpr (N == 3) {
      if (!is_rigid<T>(cast.a) || !is_rigid<T>(cast.b) || start.is_nearly_parallel) return;
      const Way way{cast, start, size_of(cast, start)};
      if (!(start.gap > fair_gap<T> * way.size) || !(way.size < 1e100)) return;
      bool is_asked = false;
      const test::ExactVerdict whole = whole_way(cast);
      for (const CastRival<T>& rival : cast_rivals<T>()) {
        const std::optional<Meeting> answer = rival.answer(cast.a, cast.motion, cast.b);
        if (!answer) continue;
        is_asked = true;
        count(tally_.rivals[rival.name], way, whole, *answer);
      }
      if (!is_asked) return;
      const std::optional<Impact<N, T>> own = test::impact_of<N, T>(cast.a, cast.motion, cast.b);
      count(tally_.rivals["graze"], way, whole, own ? Meeting{true, static_cast<double>(own->t)} : Meeting{});
    }
  }

  const MeasuredPair& tally() const { return tally_; }

 private:
  struct Way {
    const Cast& cast;
    const test::ExactVerdict& start;
    double size;
  };

  /// The verdict on all places that the shape comes by.
  static test::ExactVerdict whole_way(const Cast& cast) {
    return test::exact_passage<N, T>(cast.a, cast.motion, 1.0, cast.b)->so_far;
  }

  static double size_of(const Cast& cast, const test::ExactVerdict& start) {
    return std::max(start.own_size, start.largest) + static_cast<double>(sum_abs(cast.motion));
  }

  /// How far apart the shapes are at t, if a has come near nothing before; else how deep it has been.
  static double error_at(const Cast& cast, double t) {
    if (!std::isfinite(t)) return std::numeric_limits<double>::infinity();
    const test::ExactPassage passage = *test::exact_passage<N, T>(cast.a, cast.motion, t, cast.b);
    return std::max(passage.there.gap, -passage.so_far.gap);
  }

  /// `whole` is the verdict on all of the way.
  void count(MeasureTally& tally, const Way& way, const test::ExactVerdict& whole, const Meeting& answer) {
    ++tally.cases;
    if (whole.relation == Relation::touching || std::fabs(whole.gap) <= fair_gap<T> * way.size) return;
    const bool hits = whole.relation == Relation::overlapping;
    if (answer.hits != hits) ++(answer.hits ? tally.false_yes : tally.false_no);
    if (!answer.hits || !hits) return;
    ++tally.measured;
    const double error = error_at(way.cast, answer.t);
    const double own_size = std::max(way.start.own_size, static_cast<double>(sum_abs(way.cast.motion)));
    const double given = fair_gap<T> * way.size;
    if (!(error <= fair_share * own_size + given)) ++tally.off;
    if (!(error <= fine_share * own_size + given)) ++tally.slightly_off;
    tally.worst = std::max(tally.worst, error / way.size);
  }

  RegressionLog& regressions_;
  MeasuredPair tally_;
};

/// Starts so far back that after half of its motion, or all of it, or some of it, `a` is where it is: together with b,
/// or just beside it. The way is often along an axis.
template <Dim N, class T>
test::Cast<N, T> cast_at(const test::AnyPair<N, T>& pair, rc::Random& random) {
  double extent = 0;
  for (const AnyShape<N, T>& shape : {pair.first, pair.second}) {
    const Aabb<N, T> box = bounds(shape);
    const auto side = static_cast<double>(max_abs(box.max - box.min));
    if (std::isfinite(side)) extent = std::max(extent, side);
  }
  const double length = (extent > 0 ? extent : 1.0) * test::between(random, 0.5, 3);
  const Vec<N, T> motion(test::any_way<N>(random) * length);
  const auto done = static_cast<T>(test::share(random, 0.0, 1.0));
  return {test::moved<N, T>(pair.first, motion * -done), motion, pair.second};
}

template <Dim N, class T>
MeasuredPair examine_casts(std::size_t a, std::size_t b, const Settings& settings, RegressionLog& regressions) {
  constexpr std::uint64_t seeds_apart = 6000;  // not those of the verdicts
  const std::uint64_t seed = settings.seed * seeds_apart + a * shape_type_names.size() + b;
  CastExam<N, T> exam(a, b, regressions);
  test::CaseMaker<N, T> maker(a, b, seed);
  rc::Random random(seed);
  const Stopwatch watch;
  for (std::size_t turn = 0; exam.tally().cases < settings.casts && watch.is_within(settings.seconds); ++turn) {
    const auto kind = static_cast<test::CaseKind>(turn % test::case_kind_count);
    for (const test::AnyPair<N, T>& pair : maker.make(kind)) {
      const test::Cast<N, T> cast = cast_at<N, T>(pair, random);
      exam.put_to_rivals(cast, exam.put(cast));
    }
  }
  return exam.tally();
}

}  // namespace graze::exam
