// SPDX-License-Identifier: MIT
// The definition of examine_rays, for the files that instantiate it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <variant>

#include <graze/math/vec.hpp>
#include <graze/query/ray_hit.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/any_shape.hpp>

#include "catalogue.hpp"
#include "exact.hpp"
#include "exact/ray_entry.hpp"
#include "exam/ray_exam.hpp"
#include "exam/ray_rival.hpp"
#include "exam/rigid.hpp"
#include "exam/stopwatch.hpp"
#include "query/case_maker.hpp"
#include "query/case_variations.hpp"
#include "query/placement.hpp"
#include "query/ray_casts.hpp"
#include "query/ray_judgement.hpp"
#include "query/regressions.hpp"

namespace graze::exam {

template <Dim N, class T>
class RayExam {
 public:
  using Any = AnyShape<N, T>;

  RayExam(std::size_t type, RegressionLog& regressions) : regressions_(regressions) {
    tally_.space = space_name<N, T>();
    tally_.pair = std::string(shape_type_names[type]);
  }

  /// Puts a case to graze, and returns the truth.
  test::ExactVerdict put(const Any& shape, const Ray<N, T>& ray) {
    const auto hit = test::hit_of<N, T>(shape, ray, std::numeric_limits<T>::infinity());
    const test::ExactVerdict truth = test::exact_verdict<N, T>(shape, Any(ray));
    const test::RayErrors errors = test::ray_errors<N, T>(shape, ray, truth, size_of(shape, ray), hit);
    ++tally_.cases;
    if (truth.relation != Relation::apart) ++tally_.hits;
    if (errors.judgement == test::Judgement::outside_range) ++tally_.outside;
    if (errors.judgement == test::Judgement::wrong) {
      ++tally_.wrong;
      const std::optional<double> entry = test::exact_entry<N, T>(shape, ray);
      regressions_.add_failure(
          test::regression_row<N, T>("ray_cast", shape, Any(ray), entry ? test::number_text(*entry) : "none"));
    }
    tally_.worst = std::max(tally_.worst, errors.entry);
    return truth;
  }

  /// The same for the rivals, in space: rays that start well outside, because customs differ for the others, and that
  /// hit, if they do, within a thousand times the largest coordinate, because some have to have an end.
  void put_to_rivals(const Any& shape, const Ray<N, T>& ray, const test::ExactVerdict& truth) {
    if constexpr (N == 3) {
      if (!is_rigid<T>(shape) || truth.is_nearly_parallel) return;
      const double size = size_of(shape, ray);
      const test::ExactVerdict start = test::exact_verdict<N, T>(Any(ray.origin), shape);
      if (!(start.gap > fair_gap<T> * size) || !(size > test::least_size)) return;
      const std::optional<double> entry = test::exact_entry<N, T>(shape, ray);
      const double reach = far_away * size;
      if (entry && !(*entry * length(wide<N, T>(ray.direction)) < reach)) return;
      bool is_asked = false;
      for (const RayRival<T>& rival : ray_rivals<T>()) {
        const std::optional<RayVerdict> answer = rival.answer(shape, ray, reach);
        if (!answer) continue;
        is_asked = true;
        count(tally_.rivals[rival.name], {shape, ray, truth, entry, size}, *answer);
      }
      if (!is_asked) return;
      const auto own = test::hit_of<N, T>(shape, ray, std::numeric_limits<T>::infinity());
      const double way = length(wide<N, T>(ray.direction));
      const RayVerdict answer = own ? RayVerdict{true, static_cast<double>(own->t) * way} : RayVerdict{};
      count(tally_.rivals["graze"], {shape, ray, truth, entry, size}, answer);
    }
  }

  const MeasuredPair& tally() const { return tally_; }

 private:
  static constexpr double far_away = 1000;

  struct Case {
    const Any& shape;
    const Ray<N, T>& ray;
    const test::ExactVerdict& truth;
    std::optional<double> entry;
    double size;
  };

  static double size_of(const Any& shape, const Ray<N, T>& ray) { return test::size_of<N, T>({shape, Any(ray)}); }

  void count(MeasureTally& tally, const Case& put, const RayVerdict& answer) {
    ++tally.cases;
    const bool is_hit = put.truth.relation != Relation::apart;
    const double margin = std::fabs(put.truth.gap);
    const bool is_fair = put.truth.relation != Relation::touching && margin > fair_gap<T> * put.size;
    if (answer.hits != is_hit) {
      if (is_fair) ++(answer.hits ? tally.false_yes : tally.false_no);
      return;
    }
    if (!is_hit || !is_fair || !put.entry) return;
    ++tally.measured;
    const double way = length(wide<N, T>(put.ray.direction));
    const double error = std::isfinite(answer.distance)
                             ? test::entry_error<N, T>(put.shape, put.ray, answer.distance / way, *put.entry)
                             : std::numeric_limits<double>::infinity();
    if (!(error <= fair_share * (*put.entry * way) + fair_gap<T> * put.size)) ++tally.off;
    tally.worst = std::max(tally.worst, error / put.size);
  }

  RegressionLog& regressions_;
  MeasuredPair tally_;
};

/// A case that was made with care is worth as many cheap relatives, for graze alone.
inline constexpr std::size_t ray_variations_of_each = 3;

template <Dim N, class T>
MeasuredPair examine_rays(std::size_t type, const Settings& settings, RegressionLog& regressions) {
  constexpr std::uint64_t seeds_apart = 3000;  // not those of the verdicts
  const std::uint64_t seed = settings.seed * seeds_apart + type;
  RayExam<N, T> exam(type, regressions);
  test::CaseMaker<N, T> maker(type, test::ray_type, seed);
  test::CaseVariations<N, T> variations(seed);
  const auto ray_of = [](const test::AnyPair<N, T>& pair) { return std::get<Ray<N, T>>(pair.second); };
  const Stopwatch watch;
  for (std::size_t turn = 0; exam.tally().cases < settings.rays && watch.is_within(settings.seconds); ++turn) {
    const auto kind = static_cast<test::CaseKind>(turn % test::case_kind_count);
    for (const test::AnyPair<N, T>& pair : maker.make(kind)) {
      exam.put_to_rivals(pair.first, ray_of(pair), exam.put(pair.first, ray_of(pair)));
      for (std::size_t i = 0; i < ray_variations_of_each; ++i) {
        const test::AnyPair<N, T> varied = variations.vary(pair);
        exam.put(varied.first, ray_of(varied));
      }
    }
  }
  return exam.tally();
}

}  // namespace graze::exam
