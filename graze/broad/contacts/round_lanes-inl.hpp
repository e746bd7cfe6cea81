// SPDX-License-Identifier: MIT
// How spheres and capsules touch each other, a lane for each pair: the find_fast_contact of
// query/fast_contact/spheres_and_capsules.hpp, to the bit. Included once for each instruction set, hence no ordinary
// guard.
#if defined(GRAZE_BROAD_CONTACTS_ROUND_LANES_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BROAD_CONTACTS_ROUND_LANES_INL_HPP
#undef GRAZE_BROAD_CONTACTS_ROUND_LANES_INL_HPP
#else
#define GRAZE_BROAD_CONTACTS_ROUND_LANES_INL_HPP
#endif

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <hwy/highway.h>

#include <graze/broad/contacts/manifold_lanes-inl.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/query/fast_contact/sphere_box.hpp>
#include <graze/query/patch/clipped.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {
#if HWY_TARGET != HWY_SCALAR  // which has no vectors of two groups of pairs

/// The features that a point may lie on, by place: of what is round those of feature_on_axis, and of a sphere the
/// first; then, by three bits for the axes along which it is at the box' end and three for on which side, those of
/// feature_of_box; then the corners of a box in the plane, and its sides.
inline constexpr std::size_t first_of_box = 3;
inline constexpr std::size_t first_of_2d = first_of_box + 64;
using TouchedFeatures = std::array<Feature, first_of_2d + 8>;
inline const TouchedFeatures& touched_features() {
  static const auto features = [] {
    TouchedFeatures all{{{FeatureKind::vertex, 0}, {FeatureKind::vertex, 1}, {FeatureKind::edge, 0}}};
    for (std::size_t bits = 0; bits < 64; ++bits) {
      const auto side = [bits](std::size_t i) { return (bits >> (3 + i) & 1U) != 0 ? 1.0 : -1.0; };
      const std::array<bool, 3> is_beyond{(bits & 1U) != 0, (bits & 2U) != 0, (bits & 4U) != 0};
      all[first_of_box + bits] = feature_of_box({side(0), side(1), side(2)}, is_beyond);
    }
    for (std::uint32_t number = 0; number < 4; ++number) {
      all[first_of_2d + number] = {FeatureKind::vertex, number};
      all[first_of_2d + 4 + number] = {FeatureKind::edge, number};
    }
    return all;
  }();
  return features;
}

/// The first numbers of the struct of each lane, in double.
template <class T, std::size_t count>
HWY_INLINE void load_wide(const T* const* rows, Doubles (&numbers)[count]) {
  if constexpr (std::is_same_v<T, double>) {
    load_struct<double>(rows, numbers);
  } else {
    for (std::size_t k = 0; k < count; ++k) {
      Row<double> column;
      for (std::size_t lane = 0; lane < pairs_at_once; ++lane) column.of[lane] = static_cast<double>(rows[lane][k]);
      numbers[k] = hn::Load(Tag<double>(), column.of);
    }
  }
}

/// A place whose coordinates begin there; one in the plane with a zero more, which changes no sum.
template <Dim N>
HWY_INLINE Point place_at(const Doubles* numbers) {
  return {{numbers[0], numbers[1], N == 3 ? numbers[2] : both(0)}};
}

/// Balls around centers.
struct SphereLanes {
  Point center;
  Doubles radius;

  template <Dim N, class T>
  HWY_INLINE static SphereLanes load(const T* const* rows) {
    Doubles numbers[N + 1];
    load_wide(rows, numbers);
    return {place_at<N>(numbers), numbers[N]};
  }
};

struct CapsuleLanes {
  Point start;
  Point end;
  Doubles radius;

  template <Dim N, class T>
  HWY_INLINE static CapsuleLanes load(const T* const* rows) {
    Doubles numbers[2 * N + 1];
    load_wide(rows, numbers);
    return {place_at<N>(numbers), place_at<N>(numbers + N), numbers[2 * N]};
  }
};

HWY_INLINE Doubles sum_abs(const Point& v) { return sum(hn::Abs(v.at[0]), hn::Abs(v.at[1]), hn::Abs(v.at[2])); }

HWY_INLINE Doubles clamped_to_one(Doubles v) {
  return hn::IfThenElse(hn::Lt(v, both(0)), both(0), hn::IfThenElse(hn::Lt(both(1), v), both(1), v));
}

HWY_INLINE Doubles one_of(const DoublesMask& mask, Doubles yes, Doubles no) { return hn::IfThenElse(mask, yes, no); }

/// Where products of four such lengths stay in the range of double: others are left to the single query, which scales.
HWY_INLINE DoublesMask is_usual_size(Doubles size) {
  return hn::And(hn::Gt(size, both(0x1p-200)), hn::Lt(size, both(0x1p200)));
}

HWY_INLINE Point zero_point() { return {{both(0), both(0), both(0)}}; }

/// As feature_on_axis: which feature of a capsule, by its place in `touched_features`, and where it is known.
struct AxisFeatures {
  Doubles feature;
  DoublesMask is_known;

  HWY_INLINE explicit AxisFeatures(Doubles place) {
    constexpr double margin = 1e-9;
    const DoublesMask is_start = hn::Le(place, both(0));
    const DoublesMask is_end = hn::Ge(place, both(1));
    feature = hn::IfThenElse(is_start, both(0), hn::IfThenElse(is_end, both(1), both(2)));
    is_known = hn::Or(hn::Or(is_start, is_end), hn::And(hn::Gt(place, both(margin)), hn::Lt(place, both(1 - margin))));
  }

  /// The ends.
  HWY_INLINE DoublesMask is_between() const { return hn::Eq(feature, both(2)); }
};

/// The nearest points of the cores, as NearCores, each from an origin.
struct NearLanes {
  Point origin_first;
  Point first;
  Point origin_second;
  Point second;
  Point between;
  Doubles size;
};

/// What a FastContact says of pairs that meet in one point.
struct RoundTouch {
  Point normal;  ///< From the first to the second.
  Doubles depth;
  Point on_first;
  Point on_second;
  Doubles error;
  Doubles feature_first;  ///< By their places in `touched_features`.
  Doubles feature_second;
  DoublesMask is_clear;
};

/// As touch_of_cores.
HWY_INLINE RoundTouch touch_of_near(const NearLanes& near, Doubles radius_first, Doubles radius_second) {
  const Doubles squared = dot(near.between, near.between);
  const Doubles distance = hn::Sqrt(squared);
  const Doubles reach = hn::Add(radius_first, radius_second);
  const Doubles size = hn::Add(near.size, reach);
  RoundTouch touch;
  touch.feature_first = both(0);
  touch.feature_second = both(0);
  touch.depth = hn::Sub(reach, distance);
  touch.is_clear = hn::And(
      hn::Gt(touch.depth, hn::Mul(both(tolerance::coarse), size)),
      hn::And(hn::Gt(distance, hn::Mul(both(tolerance::known_direction), near.size)), hn::Gt(squared, both(0x1p-900))));
  touch.normal = near.between * hn::Div(both(1), distance);
  touch.on_first = near.origin_first + (near.first + touch.normal * radius_first);
  touch.on_second = near.origin_second + (near.second - touch.normal * radius_second);
  touch.error = hn::Mul(both(2 * tolerance::rounding), size);
  return touch;
}

HWY_INLINE RoundTouch touch_lanes(const SphereLanes& first, const SphereLanes& second) {
  const Point between = second.center - first.center;
  return touch_of_near({first.center, zero_point(), second.center, zero_point(), between, sum_abs(between)},
                       first.radius, second.radius);
}

template <Dim N>
HWY_INLINE RoundTouch touch_lanes(const SphereLanes& sphere, const CapsuleLanes& capsule) {
  const Point start = capsule.start - sphere.center;
  const Point end = capsule.end - sphere.center;
  const Point way = end - start;
  const Doubles whole = dot(way, way);
  const Doubles place = clamped_to_one(hn::Div(hn::Neg(dot(start, way)), whole));
  const Point on_axis = one_of(hn::Lt(place, both(1)), start + way * place, end);
  RoundTouch touch = touch_of_near(
      {sphere.center, zero_point(), sphere.center, on_axis, on_axis, hn::Add(sum_abs(start), sum_abs(end))},
      sphere.radius, capsule.radius);
  const AxisFeatures feature(place);
  touch.feature_second = feature.feature;
  touch.is_clear = hn::And(touch.is_clear, hn::And(feature.is_known, hn::Gt(whole, both(0x1p-900))));
  if constexpr (N == 2) {
    constexpr double least_cosine = 16 * tolerance::aligned;
    const Doubles along = dot(way, touch.normal);
    const DoublesMask is_off_sides = hn::Gt(hn::Mul(along, along), hn::Mul(both(least_cosine * least_cosine), whole));
    touch.is_clear = hn::And(touch.is_clear, hn::Or(feature.is_between(), is_off_sides));
  }
  return touch;
}

HWY_INLINE RoundTouch touch_lanes(const CapsuleLanes& first, const CapsuleLanes& second) {
  constexpr double least_sine_squared = 1.0 / 64;
  const Point u = first.end - first.start;
  const Point start = second.start - first.start;
  const Point end = second.end - first.start;
  const Point v = end - start;
  const Doubles uu = dot(u, u);
  const Doubles vv = dot(v, v);
  const Doubles uv = dot(u, v);
  const Doubles uw = dot(u, start);
  const Doubles vw = dot(v, start);
  const Doubles det = hn::Sub(hn::Mul(uu, vv), hn::Mul(uv, uv));
  const Doubles free_on_first = clamped_to_one(hn::Div(hn::Sub(hn::Mul(uw, vv), hn::Mul(vw, uv)), det));
  const Doubles wanted = hn::Div(hn::Sub(hn::Mul(uv, free_on_first), vw), vv);
  const Doubles on_second = clamped_to_one(wanted);
  const Doubles held_on_first = clamped_to_one(hn::Div(hn::Add(hn::Mul(uv, on_second), uw), uu));
  const Doubles on_first = hn::IfThenElse(hn::Eq(on_second, wanted), free_on_first, held_on_first);
  const Point at_first = u * on_first;
  const Point at_second = one_of(hn::Lt(on_second, both(1)), start + v * on_second, end);
  const Doubles size = sum(sum_abs(u), sum_abs(start), sum_abs(end));
  RoundTouch touch = touch_of_near({first.start, at_first, first.start, at_second, at_second - at_first, size},
                                   first.radius, second.radius);
  const Doubles distance = hn::Sub(hn::Add(first.radius, second.radius), touch.depth);
  const DoublesMask are_crossed =
      hn::And(hn::Gt(det, hn::Mul(both(least_sine_squared), hn::Mul(uu, vv))), hn::Gt(det, both(0x1p-900)));
  const DoublesMask are_apart = hn::Gt(distance, hn::Mul(both(64 * tolerance::known_direction), size));
  const AxisFeatures of_first(on_first);
  const AxisFeatures of_second(on_second);
  touch.feature_first = of_first.feature;
  touch.feature_second = of_second.feature;
  touch.is_clear =
      hn::And(hn::And(touch.is_clear, hn::And(are_crossed, are_apart)), hn::And(of_first.is_known, of_second.is_known));
  return touch;
}

#endif
}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
