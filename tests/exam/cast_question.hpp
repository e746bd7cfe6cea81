// SPDX-License-Identifier: MIT
// shape_cast(a, motion, b).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rapidcheck.h>

#include <graze/query/bounds.hpp>
#include <graze/query/impact.hpp>

#include "exact.hpp"
#include "exact/sweep.hpp"
#include "exam/pair_question.hpp"
#include "query/cast_judgement.hpp"
#include "query/placement.hpp"
#include "query/shape_casts.hpp"

namespace graze::exam {

/// Whether the oracle can decide when shapes of these types meet: bounded convex ones, one of which may be a plane or a
/// half-space.
constexpr bool can_examine_casts(std::size_t a, std::size_t b) {
  constexpr std::array<bool, type_count> is_solid = {true,  true, false, true, true,  true, false,
                                                     false, true, true,  true, false, false};
  constexpr std::size_t plane = 6;
  constexpr std::size_t half_space = 7;
  return is_solid[a] && (b == plane || b == half_space || (is_solid[b] && a <= b));
}

/// The longest side of the shape's bounds, if bounded.
template <Dim N, class T>
double side_of(const AnyShape<N, T>& shape) {
  const Aabb<N, T> box = bounds(shape);
  const auto side = static_cast<double>(max_abs(box.max - box.min));
  return std::isfinite(side) ? side : 0;
}

/// The longest side of either, 1 if there is none: a reasonable distance to move.
template <Dim N, class T>
double extent_of(const test::AnyPair<N, T>& pair) {
  const double extent = std::max(side_of<N, T>(pair.first), side_of<N, T>(pair.second));
  return extent > 0 ? extent : 1;
}

/// A motion that is fair to rivals, and the truth about it.
template <Dim N, class T>
struct AskedCast {
  const test::Cast<N, T>& cast;
  test::ExactVerdict whole;  ///< On the region swept by the shape.
  double own_size;
  double size;

  bool hits() const { return whole.relation == Relation::overlapping; }
  bool is_clear() const { return whole.relation != Relation::touching && std::fabs(whole.gap) > fair_gap<T> * size; }
  double given(double share) const { return share * own_size + fair_gap<T> * size; }
};

template <Dim N, class T>
class CastQuestion {
 public:
  using Case = test::Cast<N, T>;
  using Truth = test::ExactVerdict;  // before anything moves
  using Asked = AskedCast<N, T>;
  static constexpr std::string_view name = "shape_cast";
  static constexpr SpaceName space = space_name<N, T>();
  static constexpr std::size_t Settings::*limit = &Settings::casts;
  static constexpr std::uint64_t seeds_apart = 6000;
  static constexpr std::size_t variations = 0;
  static constexpr bool has_rivals = N == 3;
  static constexpr auto& rivals = cast_rivals<T>;

  static std::vector<Subject> subjects() { return pair_subjects(" in motion", can_examine_casts); }

  CastQuestion(const Subject& subject, std::uint64_t seed) : maker_(subject.a, subject.b, seed), random_(seed) {}

  std::vector<Case> draw(std::size_t turn) {
    std::vector<Case> casts;
    for (const test::AnyPair<N, T>& pair : maker_.make(kind_of(turn))) casts.push_back(cast_at(pair));
    return casts;
  }

  static Judged<Truth> judge(const Case& cast, Figures& figures) {
    const Truth start = test::exact_verdict<N, T>(cast.a, cast.b);
    const test::CastErrors errors = test::cast_errors<N, T>(cast, start);
    figures.share("hits", test::impact_of<N, T>(cast.a, cast.motion, cast.b).has_value());
    figures.keep("gap", errors.gap, By::space);
    figures.keep("claimed", errors.claimed);
    return {start, errors.judgement};
  }

  static std::string row(const Case& cast, const Truth&) {
    return test::cast_row<N, T>(cast, name_of(whole_way(cast).relation));
  }

  /// Shapes that are well apart before they move.
  static std::optional<Asked> asked(const Case& cast, const Truth& start) {
    if (!is_rigid<N, T>(cast.a) || !is_rigid<N, T>(cast.b) || start.is_nearly_parallel) return std::nullopt;
    const auto way = static_cast<double>(sum_abs(cast.motion));
    const double size = std::max(start.own_size, start.largest) + way;
    if (!(start.gap > fair_gap<T> * size) || !(size < 1e100)) return std::nullopt;
    return Asked{cast, whole_way(cast), std::max(start.own_size, way), size};
  }

  template <class Function>
  static auto ask(const Rival<Function>& rival, const Asked& asked) {
    return rival.answer(asked.cast.a, asked.cast.motion, asked.cast.b);
  }

  static Meeting own_answer(const Asked& asked) {
    const auto own = test::impact_of<N, T>(asked.cast.a, asked.cast.motion, asked.cast.b);
    return own ? Meeting{true, static_cast<double>(own->t)} : Meeting{};
  }

  static void mark(const Asked& asked, const Meeting& answer, Figures& figures) {
    const bool is_clear = asked.is_clear();
    const bool is_measured = is_clear && asked.hits() && answer.hits;
    const double error = is_measured ? error_at(asked.cast, answer.t) : 0;
    count_verdict(is_clear && asked.hits(), is_clear && answer.hits, figures);
    figures.count("measured", is_measured);
    figures.count("slightly_off", !(error <= asked.given(fine_share)));
    count_error(error, asked.given(fair_share), asked.size, figures);
  }

 private:
  /// Starts so far back that after half, all or some of its motion, `a` is where it is: in contact with b, or just
  /// beside it. The direction is often along an axis.
  Case cast_at(const test::AnyPair<N, T>& pair) {
    const double length = extent_of<N, T>(pair) * test::between(random_, 0.5, 3);
    const Vec<N, T> motion(test::any_way<N>(random_) * length);
    const auto done = static_cast<T>(test::share(random_, 0.0, 1.0));
    return {test::moved<N, T>(pair.first, motion * -done), motion, pair.second};
  }

  static test::ExactVerdict whole_way(const Case& cast) {
    return test::exact_passage<N, T>(cast.a, cast.motion, 1.0, cast.b)->so_far;
  }

  /// The distance of the shapes at t if a has not come close before; otherwise its previous depth.
  static double error_at(const Case& cast, double t) {
    if (!std::isfinite(t)) return std::numeric_limits<double>::infinity();
    const test::ExactPassage passage = *test::exact_passage<N, T>(cast.a, cast.motion, t, cast.b);
    return std::max(passage.there.gap, -passage.so_far.gap);
  }

  test::CaseMaker<N, T> maker_;
  rc::Random random_;
};

}  // namespace graze::exam
