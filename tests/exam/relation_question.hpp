// SPDX-License-Identifier: MIT
// relation(a, b) in both orders, judged by a certificate if possible, otherwise by the oracle.
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

#include "exact/certificate.hpp"
#include "exam/pair_question.hpp"
#include "query/pairs.hpp"
#include "query/regressions.hpp"
#include "query/verdict_band.hpp"

namespace graze::exam {

/// A pair as passed to rivals, for a yes or no.
template <Dim N, class T>
struct AskedVerdict {
  const test::AnyPair<N, T>& pair;
  Relation truth;
  test::CaseKind kind;
};

template <Dim N, class T>
class RelationQuestion : public PairQuestion<N, T> {
 public:
  using Case = test::AnyPair<N, T>;
  using Truth = Relation;
  using Asked = AskedVerdict<N, T>;
  static constexpr std::string_view name = "relation";
  static constexpr std::size_t Settings::*limit = &Settings::cases;
  static constexpr std::uint64_t seeds_apart = 1000;
  static constexpr std::size_t variations = 19;  // a carefully constructed case is worth this many cheap variations
  static constexpr auto& rivals = verdict_rivals<T>;

  static std::vector<Subject> subjects() { return pair_subjects(""); }

  RelationQuestion(const Subject& subject, std::uint64_t seed)
      : PairQuestion<N, T>(subject, seed), a_(subject.a), b_(subject.b) {}

  std::vector<Case> draw(std::size_t turn) {
    kind_ = kind_of(turn);
    return PairQuestion<N, T>::draw(turn);
  }

  Judged<Truth> judge(const Case& pair, Figures& figures) const {
    const Relation claim = test::relation_of<N, T>(pair.first, pair.second);
    const test::Finding found = finding(pair, claim, figures);
    const bool is_symmetrical = test::relation_of<N, T>(pair.second, pair.first) == claim;
    const test::Judgement judgement = is_symmetrical ? found.judgement : test::Judgement::wrong;
    const bool is_in_band = judgement == test::Judgement::within_band;
    const double error = is_in_band ? found.relative_gap / std::numeric_limits<double>::epsilon() : 0;
    figures.share("hits", found.truth != Relation::apart);
    figures.share("in_band", is_in_band);
    figures.keep("gap", error, By::space);
    return {found.truth, judgement, error};
  }

  static std::string row(const Case& pair, Relation truth) {
    return test::regression_row<N, T>("relation", pair.first, pair.second, name_of(truth));
  }

  std::optional<Asked> asked(const Case& pair, Relation truth) const {
    if (!is_rigid<N, T>(pair.first) || !is_rigid<N, T>(pair.second)) return std::nullopt;
    return Asked{pair, truth, kind_};
  }

  template <class Function>
  static auto ask(const Rival<Function>& rival, const Asked& asked) {
    return rival.answer(asked.pair.first, asked.pair.second);
  }

  static bool own_answer(const Asked& asked) {
    return test::relation_of<N, T>(asked.pair.first, asked.pair.second) != Relation::apart;
  }

  static void mark(const Asked& asked, bool answer, Figures& figures) {
    const bool touches = asked.truth == Relation::touching;
    const bool meets = asked.truth != Relation::apart;
    const bool is_wrong = !touches && answer != meets && is_clear(asked.pair);
    figures.count("touching", touches);
    figures.count("touching_missed", touches && !answer);
    count_verdict(meets, is_wrong ? answer : meets, figures);
    figures.wrong_of_kind[test::case_kind_names[static_cast<std::size_t>(asked.kind)]].add({is_wrong, 1});
  }

 private:
  test::Finding finding(const Case& pair, Relation claim, Figures& figures) const {
    const test::GapBounds proved = test::gap_bounds<N, T>(pair.first, pair.second, claim);
    const std::optional<test::Finding> certified = test::finding(claim, proved, a_, b_);
    figures.share("certified", certified.has_value());
    if (certified) return *certified;
    const test::ExactVerdict truth = test::true_verdict<N, T>(pair.first, pair.second, claim);
    const test::Judgement judgement = test::judge(claim, truth, a_, b_);
    const bool has_gap = judgement == test::Judgement::within_band;
    return {judgement, truth.relation, has_gap ? test::relative_gap(truth, a_, b_) : 0};
  }

  /// Whether every program must see the gap or depth. The oracle calculates gap and sizes only if the claim differs
  /// from the truth.
  static bool is_clear(const Case& pair) {
    const test::ExactVerdict truth = test::true_verdict<N, T>(pair.first, pair.second, Relation::touching);
    const double size = std::max(truth.own_size, truth.largest);
    const double gap = std::fabs(truth.gap);
    return gap > fair_gap<T> * size && gap >= test::least_size && !truth.is_nearly_parallel;
  }

  std::size_t a_;
  std::size_t b_;
  test::CaseKind kind_{};
};

}  // namespace graze::exam
