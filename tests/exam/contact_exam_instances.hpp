// SPDX-License-Identifier: MIT
// The definition of examine_contacts, for the files that instantiate it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include <graze/math/vec.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/any_shape.hpp>

#include "catalogue.hpp"
#include "exact.hpp"
#include "exact/parting.hpp"
#include "exam/contact_exam.hpp"
#include "exam/contact_rival.hpp"
#include "exam/rigid.hpp"
#include "exam/stopwatch.hpp"
#include "query/case_maker.hpp"
#include "query/case_variations.hpp"
#include "query/contact_judgement.hpp"
#include "query/contacts.hpp"
#include "query/regressions.hpp"

namespace graze::exam {

template <Dim N, class T>
class ContactExam {
 public:
  using Pair = test::AnyPair<N, T>;

  ContactExam(std::size_t a, std::size_t b, RegressionLog& regressions) : regressions_(regressions) {
    tally_.space = space_name<N, T>();
    tally_.pair = pair_name(a, b);
  }

  /// Puts a case to graze, and returns the truth.
  test::ExactVerdict put(const Pair& pair) {
    const auto& [a, b] = pair;
    const std::optional<Contact<N, T>> found = test::contact_of<N, T>(a, b);
    const test::ExactVerdict truth = test::exact_verdict<N, T>(a, b);
    const test::ContactErrors errors = test::contact_errors<N, T>(a, b, truth, found);
    ++tally_.cases;
    if (truth.relation != Relation::apart) ++tally_.hits;
    if (errors.judgement == test::Judgement::outside_range) ++tally_.outside;
    if (errors.judgement == test::Judgement::wrong) {
      ++tally_.wrong;
      regressions_.add_failure(test::regression_row<N, T>("contact", a, b, test::number_text(truth.gap)));
    }
    tally_.worst = std::max(tally_.worst, errors.depth);
    tally_.worst_second = std::max(tally_.worst_second, errors.left);
    return truth;
  }

  /// The same for the rivals, in space.
  void put_to_rivals(const Pair& pair, const test::ExactVerdict& truth) {
    if constexpr (N == 3) {
      const auto& [a, b] = pair;
      if (!is_rigid<T>(a) || !is_rigid<T>(b)) return;
      if (truth.is_nearly_parallel || !(truth.own_size < 1e100) || std::isinf(truth.gap)) return;
      bool is_asked = false;
      for (const ContactRival<T>& rival : contact_rivals<T>()) {
        const std::optional<Parting> answer = rival.answer(a, b);
        if (!answer) continue;
        is_asked = true;
        count(tally_.rivals[rival.name], pair, truth, *answer);
      }
      if (!is_asked) return;
      const std::optional<Contact<N, T>> own = test::contact_of<N, T>(a, b);
      const Parting answer =
          own ? Parting{true, static_cast<double>(own->depth), Vec<3, double>(own->normal)} : Parting{};
      count(tally_.rivals["graze"], pair, truth, answer);
    }
  }

  const MeasuredPair& tally() const { return tally_; }

 private:
  /// The error of an answer is that of the depth, or what is left of the overlap after the move if that is more.
  static double error_of(const Pair& pair, double depth, const Parting& answer) {
    if (!std::isfinite(answer.depth)) return std::numeric_limits<double>::infinity();
    const double off = std::fabs(answer.depth - depth);
    if (!is_finite(answer.normal)) return std::numeric_limits<double>::infinity();
    const auto left_after = [&](const Vec<N, double>& way) {
      return test::overlap_after<N, T>(pair.first, pair.second, way, off).value_or(0);
    };
    const Vec<N, double> way = answer.normal * answer.depth;
    const double left = left_after(way);
    return std::max(off, answer.is_either_way ? std::min(left, left_after(-way)) : left);
  }

  void count(MeasureTally& tally, const Pair& pair, const test::ExactVerdict& truth, const Parting& answer) {
    ++tally.cases;
    const double size = std::max(truth.own_size, truth.largest);
    if (truth.relation == Relation::touching || std::fabs(truth.gap) <= fair_gap<T> * size) return;
    const bool is_deep = truth.relation == Relation::overlapping;
    if (answer.meets != is_deep) ++(answer.meets ? tally.false_yes : tally.false_no);
    if (!answer.meets || !is_deep) return;
    ++tally.measured;
    const double error = error_of(pair, -truth.gap, answer);
    const double own_size = truth.own_size > 0 ? truth.own_size : truth.largest;  // levels have none
    if (!(error <= fair_share * own_size + fair_gap<T> * size)) ++tally.off;
    tally.worst = std::max(tally.worst, error / size);
  }

  RegressionLog& regressions_;
  MeasuredPair tally_;
};

/// A case that was made with care is worth as many cheap relatives, for graze alone.
inline constexpr std::size_t contact_variations_of_each = 1;

template <Dim N, class T>
MeasuredPair examine_contacts(std::size_t a, std::size_t b, const Settings& settings, RegressionLog& regressions) {
  constexpr std::uint64_t seeds_apart = 2000;  // not those of the verdicts
  const std::uint64_t seed = settings.seed * seeds_apart + a * shape_type_names.size() + b;
  ContactExam<N, T> exam(a, b, regressions);
  test::CaseMaker<N, T> maker(a, b, seed);
  test::CaseVariations<N, T> variations(seed);
  const Stopwatch watch;
  for (std::size_t turn = 0; exam.tally().cases < settings.contacts && watch.is_within(settings.seconds); ++turn) {
    const auto kind = static_cast<test::CaseKind>(turn % test::case_kind_count);
    for (const test::AnyPair<N, T>& pair : maker.make(kind)) {
      exam.put_to_rivals(pair, exam.put(pair));
      for (std::size_t i = 0; i < contact_variations_of_each; ++i) exam.put(variations.vary(pair));
    }
  }
  return exam.tally();
}

}  // namespace graze::exam
