// SPDX-License-Identifier: MIT
// The definition of examine_pair, for the files that instantiate it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include <graze/math/vec.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/any_shape.hpp>

#include "catalogue.hpp"
#include "exact/certificate.hpp"
#include "exam/pair_exam.hpp"
#include "exam/rigid.hpp"
#include "exam/rival.hpp"
#include "exam/stopwatch.hpp"
#include "query/case_maker.hpp"
#include "query/case_variations.hpp"
#include "query/pairs.hpp"
#include "query/regressions.hpp"
#include "query/verdict_band.hpp"

namespace graze::exam {

template <Dim N, class T>
class PairExam {
 public:
  using Pair = test::AnyPair<N, T>;

  PairExam(std::size_t a, std::size_t b, RegressionLog& regressions) : a_(a), b_(b), regressions_(regressions) {
    tally_.space = space_name<N, T>();
    tally_.pair = pair_name(a, b);
  }

  /// Puts a case to graze, and returns what graze and the judge say.
  test::Finding put(const Pair& pair) {
    const auto& [a, b] = pair;
    const Relation claim = test::relation_of<N, T>(a, b);
    const test::Finding finding = judge(pair, claim);
    ++tally_.cases;
    if (finding.truth != Relation::apart) ++tally_.hits;
    const bool is_symmetrical = test::relation_of<N, T>(b, a) == claim;
    if (finding.judgement == test::Judgement::wrong || !is_symmetrical) {
      ++tally_.wrong;
      regressions_.add_failure(row(pair, finding.truth));
    } else if (finding.judgement == test::Judgement::outside_range) {
      ++tally_.outside;
    } else if (finding.judgement == test::Judgement::within_band) {
      ++tally_.in_band;
      const double error = finding.relative_gap / std::numeric_limits<double>::epsilon();
      if (error > tally_.worst) hardest_ = row(pair, finding.truth);
      tally_.worst = std::max(tally_.worst, error);
    }
    return finding;
  }

  /// The same for the rivals, in space.
  void put_to_rivals(const Pair& pair, test::CaseKind kind, Relation truth) {
    if constexpr (N == 3) {
      if (!is_rigid<T>(pair.first) || !is_rigid<T>(pair.second)) return;
      ask_rivals(pair, kind, truth, test::relation_of<N, T>(pair.first, pair.second) != Relation::apart);
    }
  }

  const PairTally& tally() const { return tally_; }

  /// The row of the case with the largest error within the band; empty if there was none.
  const std::string& hardest() const { return hardest_; }

 private:
  /// By a certificate if there is one.
  test::Finding judge(const Pair& pair, Relation claim) {
    const test::GapBounds proved = test::gap_bounds<N, T>(pair.first, pair.second, claim);
    if (const std::optional<test::Finding> finding = test::finding(claim, proved, a_, b_)) {
      ++tally_.certified;
      return *finding;
    }
    const test::ExactVerdict truth = test::true_verdict<N, T>(pair.first, pair.second, claim);
    const test::Judgement judgement = test::judge(claim, truth, a_, b_);
    const bool has_gap = judgement == test::Judgement::within_band;
    return {judgement, truth.relation, has_gap ? test::relative_gap(truth, a_, b_) : 0};
  }

  static std::string row(const Pair& pair, Relation truth) {
    return test::regression_row<N, T>("relation", pair.first, pair.second, name_of(truth));
  }

  /// graze, too, is asked for no more than yes or no here.
  void ask_rivals(const Pair& pair, test::CaseKind kind, Relation truth, bool claim) {
    bool is_asked = false;
    for (const Rival<T>& rival : rivals<T>()) {
      const std::optional<bool> answer = rival.answer(pair.first, pair.second);
      if (!answer) continue;
      is_asked = true;
      count(tally_.rivals[rival.name], pair, kind, truth, *answer);
    }
    if (is_asked) count(tally_.rivals["graze"], pair, kind, truth, claim);
  }

  void count(RivalTally& tally, const Pair& pair, test::CaseKind kind, Relation truth, bool answer) {
    const auto place = static_cast<std::size_t>(kind);
    ++tally.cases;
    ++tally.cases_of_kind[place];
    if (truth == Relation::touching) {
      ++tally.touching;
      if (!answer) ++tally.touching_missed;
      return;
    }
    if (answer == (truth != Relation::apart)) return;
    // With another claim than the truth the oracle gives gap and sizes.
    const test::ExactVerdict verdict = test::true_verdict<N, T>(pair.first, pair.second, Relation::touching);
    const double size = std::max(verdict.own_size, verdict.largest);
    const bool is_fair = std::fabs(verdict.gap) > fair_gap<T> * size && std::fabs(verdict.gap) >= test::least_size;
    if (!is_fair || verdict.is_nearly_parallel) return;
    ++(answer ? tally.false_yes : tally.false_no);
    ++tally.wrong_of_kind[place];
  }

  std::size_t a_;
  std::size_t b_;
  RegressionLog& regressions_;
  PairTally tally_;
  std::string hardest_;
};

/// A case that was made with care is worth as many cheap relatives. Only it is put to the rivals.
inline constexpr std::size_t variations_of_each = 19;

template <Dim N, class T>
PairTally examine_pair(std::size_t a, std::size_t b, const Settings& settings, RegressionLog& regressions) {
  constexpr std::uint64_t seeds_apart = 1000;
  const std::uint64_t seed = settings.seed * seeds_apart + a * shape_type_names.size() + b;
  PairExam<N, T> exam(a, b, regressions);
  test::CaseMaker<N, T> maker(a, b, seed);
  test::CaseVariations<N, T> variations(seed);
  const Stopwatch watch;
  for (std::size_t turn = 0; exam.tally().cases < settings.cases && watch.is_within(settings.seconds); ++turn) {
    const auto kind = static_cast<test::CaseKind>(turn % test::case_kind_count);
    for (const test::AnyPair<N, T>& pair : maker.make(kind)) {
      exam.put_to_rivals(pair, kind, exam.put(pair).truth);
      for (std::size_t i = 0; i < variations_of_each; ++i) exam.put(variations.vary(pair));
    }
  }
  if (settings.keeps_hardest && !exam.hardest().empty()) regressions.add(exam.hardest());
  return exam.tally();
}

}  // namespace graze::exam
