// SPDX-License-Identifier: MIT
// Every finite number is supported. Queries calculate with products of a few lengths, which are in the range of double
// if the lengths are of `usual` size, 2^-100 to 2^100. Floats never exceed that; doubles may. So a query checks a
// number that it calculates anyway and that is as large as its lengths, their squares or its rounding. If that is out
// of range, it evaluates the same shapes again, 2^k times as large, which is exact, and divides the answer. Usually
// that costs a single comparison.
//
// One k brings numbers whose sizes differ by 2^900 at most into the range in which squares are precise enough. If they
// differ by more, the smallest count as zero: they are less than 2^-900 of the largest.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include <graze/math/platform/bit_cast.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/convex/wide_support.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/description.hpp>
#include <graze/shape/fields/visit.hpp>
#include <graze/shape/posed.hpp>
#include <graze/shape/shape.hpp>

namespace graze::detail {

/// The exponents of usual sizes.
inline constexpr int most_usual_exponent = 100;

/// Whether a positive number is between 2^-most and 2^most: zero and NaN are not. By its bits, in one comparison.
constexpr bool is_between_powers(double number, std::uint64_t most) {
  return (bit_cast<std::uint64_t>(number) >> 52U) - (1023 - most) < 2 * most;
}

/// Whether a length of shapes of T is of usual size.
template <class T>
constexpr bool is_usual_size(double size) {
  return std::is_same_v<T, float> || is_between_powers(size, most_usual_exponent);
}

/// Whether products of a few lengths are in range, from a number that is as large as the lengths or as their squares
/// and is calculated anyway.
template <class T>
constexpr bool is_usual_measure(double measure) {
  return std::is_same_v<T, float> || is_between_powers(measure, 128);
}

/// The same for a rounding error, which is epsilon to some thousand epsilon of a size.
template <class T>
constexpr bool is_usual_error(double error) {
  if constexpr (std::is_same_v<T, float>) return true;
  return error > 0x1p-150 && error < 0x1p60;
}

/// Whether the normal of a plane or half-space can be squared; other shapes have none.
template <class S>
constexpr bool has_usual_normal(const S& shape) {
  if constexpr (requires { shape.normal; }) {
    return is_usual_size<scalar_of<S>>(static_cast<double>(max_abs(shape.normal)));
  }
  return true;
}

/// Whether a squared distance is greater than the square of another distance; false if squares underflow.
inline bool is_farther(double squared, double distance) { return squared > distance * distance && squared > 0x1p-960; }

/// Multiplies by 2^exponent: in two steps, since one factor might exceed the range of double. Exact, except for
/// overflow and underflow.
class PowerOfTwo {
 public:
  explicit PowerOfTwo(int exponent)
      : exponent_(exponent), first_(factor(exponent / 2)), second_(factor(exponent - exponent / 2)) {}

  int exponent() const { return exponent_; }
  PowerOfTwo inverse() const { return PowerOfTwo(-exponent_); }

  double operator()(double x) const { return x * first_ * second_; }
  template <Dim N>
  Vec<N, double> operator()(const Vec<N, double>& v) const {
    return v * first_ * second_;
  }

 private:
  /// Never infinite, because zero times infinity is NaN: a number multiplied by two such factors is too large anyway.
  static double factor(int exponent) {
    const int most = std::min(exponent, 1023);
    if (most < -1022) return std::ldexp(1.0, most);
    return bit_cast<double>(static_cast<std::uint64_t>(most + 1023) << 52U);
  }

  int exponent_;
  double first_;
  double second_;
};

/// A distance times 2^exponent, which is zero only if the distance is.
inline double resized_distance(double distance, const PowerOfTwo& power) {
  const double result = power(distance);
  return distance > 0 && result == 0 ? std::numeric_limits<double>::denorm_min() : result;
}

/// 2^n, the largest power of two in any coordinate.
template <Dim N>
int exponent_of(const Vec<N, double>& v) {
  const double size = max_abs(v);
  const int biased = static_cast<int>(bit_cast<std::uint64_t>(size) >> 52U);
  if (biased > 0 && biased < 2047) return biased - 1023;
  return size > 0 && std::isfinite(size) ? std::ilogb(size) : 0;
}

/// The same for a direction that is too long or too short for its length to be squared; 0 for others.
template <Dim N>
int unusual_exponent_of(const Vec<N, double>& direction) {
  const int exponent = exponent_of(direction);
  return exponent < -most_usual_exponent || exponent >= most_usual_exponent ? exponent : 0;
}

/// Whether numbers of a shape can be out of range.
template <class S>
inline constexpr bool can_leave_range = std::is_same_v<scalar_of<S>, double>;

// ---- mapped(shape, f): every length of a shape replaced by f(length), every direction of any length by
// f.direction(direction). Axes of boxes and rotations are unchanged: their lengths are about 1.

template <Dim N, class F>
Vec<N, double> mapped(const Vec<N, double>& point, F& f) {
  Vec<N, double> result;
  for (Dim i = 0; i < N; ++i) result[i] = f(point[i]);
  return result;
}
template <FieldKind kind, class S, class Value, class F>
Value mapped_field([[maybe_unused]] const S& shape, const Value& value, F& f) {
  if constexpr (kind == FieldKind::point || kind == FieldKind::half_extents) {
    return mapped(value, f);
  } else if constexpr (kind == FieldKind::direction) {
    return f.direction(value);
  } else if constexpr (kind == FieldKind::length) {
    return f(value);
  } else if constexpr (kind == FieldKind::offset) {
    return f.along(shape.normal, value);
  } else if constexpr (kind == FieldKind::corners) {
    Value result;
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = mapped(value[i], f);
    return result;
  } else {
    return value;
  }
}
template <Described S, class F>
requires can_leave_range<S> S mapped(const S& shape, F& f) {
  return with_fields_changed(
      shape, [&]<class Field>(const Field&, const auto& value) { return mapped_field<Field::kind>(shape, value, f); });
}
template <Dim N, class F>
Polytope<N, double> mapped(const Polytope<N, double>& polytope, F& f) {
  return with_corners_mapped(polytope, [&f](const Vec<N, double>& corner) { return mapped(corner, f); });
}
template <Dim N, class F>
AnyShape<N, double> mapped(const AnyShape<N, double>& shape, F& f);
template <Dim N, class F>
Compound<N, double> mapped(const Compound<N, double>& compound, F& f) {
  Compound<N, double> result;
  result.parts.reserve(compound.parts.size());
  for (const Part<N, double>& part : compound.parts) {
    result.parts.push_back({mapped(part.shape, f), mapped(part.box, f)});
  }
  return result;
}
template <Dim N, class F>
AnyShape<N, double> mapped(const AnyShape<N, double>& shape, F& f) {
  return detail::visit([&f](const auto& held) -> AnyShape<N, double> { return mapped(held, f); }, shape);
}

/// A user's convex shape 2^k times as large; it must outlive this.
template <Convex S>
struct Scaled {
  const S* shape;
  PowerOfTwo power;
};

}  // namespace graze::detail

namespace graze {
template <Convex S>
struct ShapeTraits<detail::Scaled<S>> : Space<dimension_of<S>, double> {};
}  // namespace graze

namespace graze::detail {

template <Convex S>
Vec<dimension_of<S>, double> support(const Scaled<S>& scaled,
                                     const std::type_identity_t<Vec<dimension_of<S>, double>>& direction) {
  return scaled.power(wide_support(*scaled.shape, direction));
}

template <Convex S>
inline constexpr double support_error<Scaled<S>> = support_error<S>;

// ---- The sizes of the numbers of shapes

/// The exponents of the least and the greatest length that is not zero.
class LengthRange {
 public:
  static constexpr bool wants_largest = false;

  double operator()(double length) { return put(length, 0); }

  template <Dim N>
  Vec<N, double> direction(const Vec<N, double>& direction) {
    is_odd_ = is_odd_ || unusual_exponent_of(direction) != 0;
    return direction;
  }
  template <Dim N>
  double along(const Vec<N, double>& normal, double offset) {
    return put(offset, unusual_exponent_of(normal));
  }

  /// The power of two that brings everything into range; none if it is in range. The largest number becomes about 1
  /// unless the smallest would then be too small to square.
  std::optional<PowerOfTwo> scale() const {
    if (least_ > greatest_) return is_odd_ ? std::optional(PowerOfTwo(0)) : std::nullopt;
    if (!is_odd_ && (!is_finite_ || (least_ >= -most_usual_exponent && greatest_ < most_usual_exponent)))
      return std::nullopt;
    const int target = std::clamp(greatest_ - least_ - most_to_square, 0, most_to_square);
    if (!is_odd_ && target == greatest_) return std::nullopt;
    return PowerOfTwo(target - greatest_);
  }

  int greatest() const { return greatest_; }

  static constexpr int most_to_square = 450;

 private:
  double put(double length, int unit) {
    if (length == 0 || std::isnan(length)) return length;
    is_finite_ = is_finite_ && !std::isinf(length);
    if (std::isinf(length)) return length;
    const int exponent = std::ilogb(length) - unit;
    least_ = std::min(least_, exponent);
    greatest_ = std::max(greatest_, exponent);
    return length;
  }

  int least_ = std::numeric_limits<int>::max();
  int greatest_ = std::numeric_limits<int>::min();
  bool is_odd_ = false;  ///< A direction is.
  bool is_finite_ = true;
};

// ---- The lengths of a shape: f is called for each length, f.direction for each direction. For many corners, f may be
// called for the largest coordinate only.

template <class S, class F>
void visit_lengths(const S& shape, F& f) {
  mapped(shape, f);
}
template <Dim N, class F>
void visit_lengths(const Polytope<N, double>& polytope, F& f) {
  if constexpr (F::wants_largest) {
    f(rows_of(polytope).largest());
  } else {
    for (const Vec<N, double>& corner : polytope.vertices()) mapped(corner, f);
  }
}
template <Dim N, class F>
void visit_lengths(const AnyShape<N, double>& shape, F& f);
template <Dim N, class F>
void visit_lengths(const Compound<N, double>& compound, F& f) {
  for (const Part<N, double>& part : compound.parts) visit_lengths(part.shape, f);
}
template <Dim N, class F>
void visit_lengths(const AnyShape<N, double>& shape, F& f) {
  detail::visit([&f](const auto& held) { visit_lengths(held, f); }, shape);
}

/// Shapes that are only known by their support points.
template <class S>
inline constexpr bool is_known_by_support = Convex<S> && !requires(const S& shape, LengthRange& range) {
  mapped(shape, range);
};

template <class S, class F>
requires is_known_by_support<S>
void visit_lengths(const S& shape, F& f) {
  for (Dim i = 0; i < dimension_of<S>; ++i) {
    for (const double sign : {-1.0, 1.0}) {
      const auto corner = wide_support(shape, unit_axis<dimension_of<S>>(i) * sign);
      if constexpr (F::wants_largest) {
        f(max_abs(corner));
      } else {
        mapped(corner, f);
      }
    }
  }
}
template <Convex S, class F>
void visit_lengths(const Posed<S>& posed, F& f) {
  visit_lengths(posed.shape, f);
  mapped(posed.pose.position, f);
}

// ---- scaled(shape, power)

/// Lengths times a power of two; directions of unusual length with their largest coordinate between 1 and 2.
class Scaler {
 public:
  explicit Scaler(const PowerOfTwo& power) : power_(power) {}

  double operator()(double length) const { return without_least(power_(length)); }
  template <Dim N>
  Vec<N, double> direction(const Vec<N, double>& direction) const {
    Vec<N, double> result = PowerOfTwo(-unusual_exponent_of(direction))(direction);
    for (Dim i = 0; i < N; ++i) result[i] = without_least(result[i]);
    return result;
  }
  template <Dim N>
  double along(const Vec<N, double>& normal, double offset) const {
    return without_least(PowerOfTwo(power_.exponent() - unusual_exponent_of(normal))(offset));
  }

 private:
  static double without_least(double x) { return std::fabs(x) < 0x1p-460 ? 0.0 : x; }

  PowerOfTwo power_;
};

template <class S>
auto scaled(const S& shape, const PowerOfTwo& power) {
  const Scaler scaler(power);
  return mapped(shape, scaler);
}
template <class S>
requires is_known_by_support<S>
auto scaled(const S& shape, const PowerOfTwo& power) { return Scaled<S>{&shape, power}; }
template <Convex S>
Scaled<S> scaled(const Scaled<S>& shape, const PowerOfTwo& power) {
  return {shape.shape, PowerOfTwo(shape.power.exponent() + power.exponent())};
}
template <Convex S>
auto scaled(const Posed<S>& posed, const PowerOfTwo& power) {
  using Inner = decltype(scaled(posed.shape, power));
  return Posed<Inner>{scaled(posed.shape, power), {posed.pose.rotation, scaled(posed.pose.position, power)}};
}

// ---- The interface for queries

/// For relation.hpp.
template <class A, class B>
Relation decide(const A& a, const B& b);

/// Collects whether a length is neither zero nor of usual size.
class UnusualLengths {
 public:
  static constexpr bool wants_largest = true;

  double operator()(double length) {
    constexpr std::uint64_t least = std::uint64_t{1023 - most_usual_exponent} << 53U;
    const std::uint64_t bits = bit_cast<std::uint64_t>(length) << 1U;  // ordered by magnitude
    farthest_ = std::max(farthest_, bits == 0 ? 0 : bits - least);
    return length;
  }
  template <Dim N>
  Vec<N, double> direction(const Vec<N, double>& direction) {
    (*this)(max_abs(direction));
    return direction;
  }
  template <Dim N>
  double along(const Vec<N, double>& /*normal*/, double offset) {
    return (*this)(offset);
  }

  bool are_any() const { return farthest_ >= std::uint64_t{most_usual_exponent} << 54U; }

 private:
  /// Counted from the smallest usual size; smaller lengths wrap around to the largest values.
  std::uint64_t farthest_ = 0;
};

/// A tree has asked all parts.
template <Dim N>
void visit_lengths(const Compound<N, double>& compound, UnusualLengths& lengths) {
  const PartTree<N, double>* const tree = tree_of(compound.parts);
  if (tree != nullptr && tree->has_usual_lengths()) return;
  for (const Part<N, double>& part : compound.parts) visit_lengths(part.shape, lengths);
}

/// False if a length of shapes is neither zero nor of usual size; for polytopes and users' shapes only the largest one
/// counts.
template <class... Shapes>
bool are_usual([[maybe_unused]] const Shapes&... shapes) {
  if constexpr ((can_leave_range<Shapes> && ...)) {
    UnusualLengths lengths;
    (visit_lengths(shapes, lengths), ...);
    return !lengths.are_any();
  }
  return true;
}

/// The power of two that brings shapes into range; none if they are in range. For shapes that a fast test has found out
/// of range: this one takes longer.
template <class... Shapes>
[[gnu::noinline, gnu::cold]] std::optional<PowerOfTwo> scale_for(const Shapes&... shapes) {
  if constexpr ((can_leave_range<Shapes> && ...)) {
    LengthRange range;
    (visit_lengths(shapes, range), ...);
    return range.scale();
  }
  return std::nullopt;
}

/// Whether shapes that have been scaled still have lengths of which more than two cannot be multiplied.
template <class... Shapes>
[[gnu::noinline, gnu::cold]] bool are_mixed([[maybe_unused]] const Shapes&... shapes) {
  LengthRange range;
  if constexpr ((can_leave_range<Shapes> && ...)) (visit_lengths(shapes, range), ...);
  return range.greatest() >= most_usual_exponent;
}

/// ask(power, scaled shapes ...) for shapes that are out of range; none for others.
template <class Answer, class Ask, class... Shapes>
std::optional<Answer> answer_in_range([[maybe_unused]] const Ask& ask, const Shapes&... shapes) {
  if constexpr ((can_leave_range<Shapes> && ...)) {
    if (const auto power = scale_for(shapes...)) return ask(*power, scaled(shapes, *power)...);
  }
  return std::nullopt;
}

/// The verdict on two shapes that are out of range; none for others.
template <class A, class B>
[[gnu::noinline, gnu::cold]] std::optional<Relation> verdict_in_range(const A& a, const B& b) {
  return answer_in_range<Relation>(
      [](const auto&, const auto& scaled_a, const auto& scaled_b) { return decide(scaled_a, scaled_b); }, a, b);
}

/// The same, or else the given verdict. As a tail call it costs pairs in range nothing.
template <class A, class B>
[[gnu::noinline, gnu::cold]] Relation verdict_in_range_or(Relation found, const A& a, const B& b) {
  return verdict_in_range(a, b).value_or(found);
}

}  // namespace graze::detail
