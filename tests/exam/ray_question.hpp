// SPDX-License-Identifier: MIT
// ray_cast(shape, ray).
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <graze/query/ray_hit.hpp>

#include "exact.hpp"
#include "exact/ray_entry.hpp"
#include "exam/pair_question.hpp"
#include "query/placement.hpp"
#include "query/ray_casts.hpp"
#include "query/ray_judgement.hpp"
#include "query/regressions.hpp"

namespace graze::exam {

/// A shape and a ray that are fair to rivals, and the truth about them.
template <Dim N, class T>
struct AskedRay {
  const AnyShape<N, T>& shape;
  const Ray<N, T>& ray;
  const test::ExactVerdict& truth;
  std::optional<double> entry;
  double size;
  double way;    ///< The length of the ray's direction.
  double reach;  ///< The length of the ray for programs that need a finite one.

  bool hits() const { return truth.relation != Relation::apart; }
  bool is_clear() const { return truth.relation != Relation::touching && std::fabs(truth.gap) > fair_gap<T> * size; }
};

/// The second shape of a case is the ray.
template <Dim N, class T>
class RayQuestion : public PairQuestion<N, T> {
 public:
  using Any = AnyShape<N, T>;
  using Case = test::AnyPair<N, T>;
  using Truth = test::ExactVerdict;
  using Asked = AskedRay<N, T>;
  static constexpr std::string_view name = "ray_cast";
  static constexpr std::size_t Settings::*limit = &Settings::rays;
  static constexpr std::uint64_t seeds_apart = 3000;
  static constexpr std::size_t variations = 3;
  static constexpr auto& rivals = ray_rivals<T>;

  using PairQuestion<N, T>::PairQuestion;
  static std::vector<Subject> subjects() {
    return shape_subjects(" and rays", test::ray_type, [](std::size_t) { return true; });
  }

  static Judged<Truth> judge(const Case& pair, Figures& figures) {
    const auto& [shape, ray] = pair;
    const Truth truth = test::exact_verdict<N, T>(shape, ray);
    const test::RayErrors errors =
        test::ray_errors<N, T>(shape, ray_of(pair), truth, test::size_of<N, T>(pair), hit_of(pair));
    figures.share("hits", truth.relation != Relation::apart);
    figures.keep("entry", errors.entry, By::space);
    return {truth, errors.judgement};
  }

  static std::string row(const Case& pair, const Truth&) {
    const std::optional<double> entry = test::exact_entry<N, T>(pair.first, ray_of(pair));
    return test::regression_row<N, T>("ray_cast", pair.first, pair.second, entry ? test::number_text(*entry) : "none");
  }

  /// Rays that start well outside, because conventions differ otherwise, and that hit, if at all, within a thousand
  /// times the largest coordinate, because some programs need a finite ray.
  static std::optional<Asked> asked(const Case& pair, const Truth& truth) {
    constexpr double far_away = 1000;
    const auto& shape = pair.first;
    const Ray<N, T>& ray = ray_of(pair);
    if (!is_rigid<N, T>(shape) || truth.is_nearly_parallel) return std::nullopt;
    const double size = test::size_of<N, T>(pair);
    const test::ExactVerdict start = test::exact_verdict<N, T>(Any(ray.origin), shape);
    if (!(start.gap > fair_gap<T> * size) || !(size > test::least_size)) return std::nullopt;
    const std::optional<double> entry = test::exact_entry<N, T>(shape, ray);
    const double way = length(wide<N, T>(ray.direction));
    const double reach = far_away * size;
    if (entry && !(*entry * way < reach)) return std::nullopt;
    return Asked{shape, ray, truth, entry, size, way, reach};
  }

  template <class Function>
  static auto ask(const Rival<Function>& rival, const Asked& asked) {
    return rival.answer(asked.shape, asked.ray, asked.reach);
  }

  static RayVerdict own_answer(const Asked& asked) {
    const auto own = test::hit_of<N, T>(asked.shape, asked.ray, std::numeric_limits<T>::infinity());
    return own ? RayVerdict{true, static_cast<double>(own->t) * asked.way} : RayVerdict{};
  }

  static void mark(const Asked& asked, const RayVerdict& answer, Figures& figures) {
    const bool is_clear = asked.is_clear();
    const bool is_measured = is_clear && asked.hits() && answer.hits && asked.entry;
    const double given = is_measured ? fair_share * (*asked.entry * asked.way) + fair_gap<T> * asked.size : 0;
    count_verdict(is_clear && asked.hits(), is_clear && answer.hits, figures);
    figures.count("measured", is_measured);
    count_error(is_measured ? error_of(asked, answer) : 0, given, asked.size, figures);
  }

 private:
  static const Ray<N, T>& ray_of(const Case& pair) { return std::get<Ray<N, T>>(pair.second); }

  static auto hit_of(const Case& pair) {
    return test::hit_of<N, T>(pair.first, ray_of(pair), std::numeric_limits<T>::infinity());
  }

  static double error_of(const Asked& asked, const RayVerdict& answer) {
    if (!std::isfinite(answer.distance)) return std::numeric_limits<double>::infinity();
    return test::entry_error<N, T>(asked.shape, asked.ray, answer.distance / asked.way, *asked.entry);
  }
};

}  // namespace graze::exam
