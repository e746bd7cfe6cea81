// SPDX-License-Identifier: MIT
// The common parts of questions about pairs of types, or one type: subjects, cases, and which are fair to rivals.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <graze/math/vec.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/any_shape.hpp>

#include "exact/verdict.hpp"
#include "exam/exam.hpp"
#include "exam/rival.hpp"
#include "query/case_maker.hpp"
#include "query/case_variations.hpp"

namespace graze::exam {

inline constexpr std::size_t type_count = shape_type_names.size();

/// Pairs of types for which `is_asked(a, b)`; `suffix` distinguishes the tasks from those of other questions.
template <class IsAsked>
std::vector<Subject> pair_subjects(std::string_view suffix, IsAsked is_asked) {
  std::vector<Subject> subjects;
  for (std::size_t a = 0; a < type_count; ++a) {
    for (std::size_t b = 0; b < type_count; ++b) {
      const std::string name = std::string(shape_type_names[a]) + ", " + std::string(shape_type_names[b]);
      if (is_asked(a, b)) subjects.push_back({a, b, name, name + std::string(suffix), a * type_count + b});
    }
  }
  return subjects;
}

/// All pairs, each once.
inline std::vector<Subject> pair_subjects(std::string_view suffix) {
  return pair_subjects(suffix, [](std::size_t a, std::size_t b) { return a <= b; });
}

/// Types for which `is_asked(type)`; `b` is the type that is drawn beside it.
template <class IsAsked>
std::vector<Subject> shape_subjects(std::string_view suffix, std::size_t b, IsAsked is_asked) {
  std::vector<Subject> subjects;
  for (std::size_t type = 0; type < type_count; ++type) {
    const std::string name(shape_type_names[type]);
    if (is_asked(type)) subjects.push_back({type, b, name, name + std::string(suffix), type});
  }
  return subjects;
}

/// Kinds of cases take turns.
inline test::CaseKind kind_of(std::size_t turn) { return static_cast<test::CaseKind>(turn % test::case_kind_count); }

/// Whether a rival takes it for the same set: an oriented box whose axes are orthonormal up to 4 epsilon. graze takes
/// the stored axes as exact.
template <Dim N, class T>
bool is_rigid(const AnyShape<N, T>& shape) {
  const auto* box = std::get_if<Obb<N, T>>(&shape);
  if (box == nullptr) return true;
  const Mat<N, double> axes = wide_matrix<N, T>(box->axes);
  double orthonormality_error = 0;
  for (Dim i = 0; i < N; ++i) {
    for (Dim j = 0; j < N; ++j)
      orthonormality_error = std::max(orthonormality_error, std::fabs(dot(axes[i], axes[j]) - (i == j ? 1 : 0)));
  }
  return orthonormality_error <= 4 * static_cast<double>(std::numeric_limits<T>::epsilon());
}

/// The tolerance for all programs: a thousandth of a length, plus the rounding of the coordinates.
inline constexpr double fair_share = 1e-3;

/// The tolerance of an additional count: a millionth.
inline constexpr double fine_share = 1e-6;

/// Counts an answer that is not the truth.
inline void count_verdict(bool truth, bool answer, Figures& figures) {
  figures.count("false_yes", answer && !truth);
  figures.count("false_no", truth && !answer);
}

/// Counts the error of a number: whether it exceeds `given`, and its share of `size`. An answer without a number, or
/// one that is not judged because the truth is not clear, has the error 0.
inline void count_error(double error, double given, double size, Figures& figures) {
  figures.count("off", !(error <= given));
  figures.keep("worst", error == 0 ? 0 : error / size);
}

/// A pair that is fair to rivals, and the truth about it.
template <Dim N, class T>
struct AskedPair {
  const test::AnyPair<N, T>& pair;
  const test::ExactVerdict& truth;

  double size() const { return std::max(truth.own_size, truth.largest); }
  bool overlaps() const { return truth.relation == Relation::overlapping; }

  /// Gap or depth are so large that every program must see them.
  bool is_clear() const { return truth.relation != Relation::touching && std::fabs(truth.gap) > fair_gap<T> * size(); }

  /// The tolerance of an answer: a share of the pair's own size, which excludes planes and half-spaces.
  double given(double share) const {
    const double own_size = truth.own_size > 0 ? truth.own_size : truth.largest;
    return share * own_size + fair_gap<T> * size();
  }

  void count_verdict(bool meets, Figures& figures) const {
    exam::count_verdict(is_clear() && overlaps(), is_clear() && meets, figures);
  }

  void count_error(double error, Figures& figures) const {
    exam::count_error(error, given(fair_share), size(), figures);
  }
};

/// Pairs of two types as cases, each of which is passed to the oracle, with as many variations.
template <Dim N, class T>
class PairQuestion {
 public:
  using Any = AnyShape<N, T>;
  using Case = test::AnyPair<N, T>;
  using Truth = test::ExactVerdict;
  using Asked = AskedPair<N, T>;
  static constexpr SpaceName space = space_name<N, T>();
  static constexpr std::size_t variations = 1;
  static constexpr bool has_rivals = N == 3;

  PairQuestion(const Subject& subject, std::uint64_t seed) : maker_(subject.a, subject.b, seed), variations_(seed) {}

  std::vector<Case> draw(std::size_t turn) { return maker_.make(kind_of(turn)); }
  Case vary(const Case& pair) { return variations_.vary(pair); }

  static std::optional<Asked> asked(const Case& pair, const Truth& truth) {
    if (!is_rigid<N, T>(pair.first) || !is_rigid<N, T>(pair.second)) return std::nullopt;
    if (truth.is_nearly_parallel || !(truth.own_size < 1e100) || std::isinf(truth.gap)) return std::nullopt;
    return Asked{pair, truth};
  }

  template <class Function>
  static auto ask(const Rival<Function>& rival, const Asked& asked) {
    return rival.answer(asked.pair.first, asked.pair.second);
  }

 private:
  test::CaseMaker<N, T> maker_;
  test::CaseVariations<N, T> variations_;
};

}  // namespace graze::exam
