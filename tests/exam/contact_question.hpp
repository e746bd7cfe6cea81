// SPDX-License-Identifier: MIT
// contact(a, b).
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

#include <graze/query/contact.hpp>

#include "exact.hpp"
#include "exact/parting.hpp"
#include "exam/pair_question.hpp"
#include "query/contact_judgement.hpp"
#include "query/contacts.hpp"
#include "query/regressions.hpp"

namespace graze::exam {

template <Dim N, class T>
class ContactQuestion : public PairQuestion<N, T> {
 public:
  using Case = test::AnyPair<N, T>;
  using Truth = test::ExactVerdict;
  using Asked = AskedPair<N, T>;
  static constexpr std::string_view name = "contact";
  static constexpr std::size_t Settings::*limit = &Settings::contacts;
  static constexpr std::uint64_t seeds_apart = 2000;
  static constexpr auto& rivals = contact_rivals<T>;

  using PairQuestion<N, T>::PairQuestion;
  static std::vector<Subject> subjects() { return pair_subjects(" in contact"); }

  static Judged<Truth> judge(const Case& pair, Figures& figures) {
    const auto& [a, b] = pair;
    const Truth truth = test::exact_verdict<N, T>(a, b);
    const test::ContactErrors errors = test::contact_errors<N, T>(a, b, truth, test::contact_of<N, T>(a, b));
    figures.share("meet", truth.relation != Relation::apart);
    figures.keep("depth", errors.depth, By::space);
    figures.keep("left", errors.left);
    return {truth, errors.judgement};
  }

  static std::string row(const Case& pair, const Truth& truth) {
    return test::regression_row<N, T>("contact", pair.first, pair.second, test::number_text(truth.gap));
  }

  static Proximity own_answer(const Asked& asked) {
    const std::optional<Contact<N, T>> own = test::contact_of<N, T>(asked.pair.first, asked.pair.second);
    return own ? Proximity{true, static_cast<double>(own->depth), Vec<3, double>(own->normal)} : Proximity{};
  }

  static void mark(const Asked& asked, const Proximity& answer, Figures& figures) {
    const bool is_measured = asked.is_clear() && asked.overlaps() && answer.meets;
    asked.count_verdict(answer.meets, figures);
    figures.count("measured", is_measured);
    asked.count_error(is_measured ? error_of(asked, answer) : 0, figures);
  }

 private:
  /// The error of the depth, or what is left of the overlap after the move if that is more.
  static double error_of(const Asked& asked, const Proximity& answer) {
    if (!std::isfinite(answer.depth) || !is_finite(answer.normal)) return std::numeric_limits<double>::infinity();
    const double off = std::fabs(answer.depth + asked.truth.gap);
    const auto left_after = [&](const Vec<N, double>& way) {
      return test::overlap_after<N, T>(asked.pair.first, asked.pair.second, way, off).value_or(0);
    };
    const Vec<N, double> way = answer.normal * answer.depth;
    const double left = left_after(way);
    return std::max(off, answer.is_either_way ? std::min(left, left_after(-way)) : left);
  }
};

}  // namespace graze::exam
