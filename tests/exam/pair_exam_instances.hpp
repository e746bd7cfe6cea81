// SPDX-License-Identifier: MIT
// The definition of examine_pair, for the files that instantiate it.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <variant>

#include <graze/math/vec.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/any_shape.hpp>

#include "catalogue.hpp"
#include "exam/pair_exam.hpp"
#include "exam/rival.hpp"
#include "exam/stopwatch.hpp"
#include "query/case_maker.hpp"
#include "query/pairs.hpp"
#include "query/verdict_band.hpp"

namespace graze::exam {

/// Whether a rival means the same set by it: an oriented box whose axes are orthonormal up to 4 epsilon. graze takes
/// the stored axes as exact.
template <class T>
bool is_rigid(const AnyShape<3, T>& shape) {
  const auto* box = std::get_if<Obb<3, T>>(&shape);
  if (box == nullptr) return true;
  const Mat<3, double> axes = wide_matrix<3, T>(box->axes);
  double skew = 0;
  for (Dim i = 0; i < 3; ++i) {
    for (Dim j = 0; j < 3; ++j) skew = std::max(skew, std::fabs(dot(axes[i], axes[j]) - (i == j ? 1 : 0)));
  }
  return skew <= 4 * static_cast<double>(std::numeric_limits<T>::epsilon());
}

template <Dim N, class T>
class PairExam {
 public:
  using Pair = test::AnyPair<N, T>;

  PairExam(std::size_t a, std::size_t b, FailureLog& failures) : a_(a), b_(b), failures_(failures) {
    tally_.space = space_name<N, T>();
    tally_.pair = pair_name(a, b);
  }

  void put(const Pair& pair, test::CaseKind kind) {
    const auto& [a, b] = pair;
    const Relation claim = test::relation_of<N, T>(a, b);
    const test::ExactVerdict truth = test::true_verdict<N, T>(a, b, claim);
    ++tally_.cases;
    if (truth.relation != Relation::apart) ++tally_.hits;
    judge(pair, claim, truth);
    if (test::relation_of<N, T>(b, a) != claim) fail(pair, claim, truth, "not so in the other order");
    if constexpr (N == 3) {
      if (is_rigid<T>(a) && is_rigid<T>(b)) ask_rivals(pair, kind, truth.relation, claim != Relation::apart);
    }
  }

  const PairTally& tally() const { return tally_; }

 private:
  void judge(const Pair& pair, Relation claim, const test::ExactVerdict& truth) {
    switch (test::judge(claim, truth, a_, b_)) {
      case test::Judgement::right:
        return;
      case test::Judgement::outside_range:
        ++tally_.outside;
        return;
      case test::Judgement::within_band:
        ++tally_.in_band;
        tally_.worst =
            std::max(tally_.worst, test::relative_gap(truth, a_, b_) / std::numeric_limits<double>::epsilon());
        return;
      case test::Judgement::wrong:
        fail(pair, claim, truth, "beyond the band");
    }
  }

  /// One row: the true relation, the shapes, and what graze said.
  void fail(const Pair& pair, Relation claim, const test::ExactVerdict& truth, const std::string& why) {
    ++tally_.wrong;
    failures_.add("{Relation::" + std::string(name_of(truth.relation)) + ", " + test::to_source<N, T>(pair.first) +
                  ", " + test::to_source<N, T>(pair.second) + "},  // by " + test::literal(truth.gap) + ", said " +
                  std::string(name_of(claim)) + ": " + why);
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
  FailureLog& failures_;
  PairTally tally_;
};

template <Dim N, class T>
PairTally examine_pair(std::size_t a, std::size_t b, const Settings& settings, FailureLog& failures) {
  constexpr std::uint64_t seeds_apart = 1000;
  PairExam<N, T> exam(a, b, failures);
  test::CaseMaker<N, T> maker(a, b, settings.seed * seeds_apart + a * shape_type_names.size() + b);
  const Stopwatch watch;
  for (std::size_t turn = 0; exam.tally().cases < settings.cases && watch.is_within(settings.seconds); ++turn) {
    const auto kind = static_cast<test::CaseKind>(turn % test::case_kind_count);
    for (const test::AnyPair<N, T>& pair : maker.make(kind)) exam.put(pair, kind);
  }
  return exam.tally();
}

}  // namespace graze::exam
