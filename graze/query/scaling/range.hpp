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
#include <graze/query/scaling/mapped.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/description.hpp>
#include <graze/shape/fields/visit.hpp>
#include <graze/shape/posed.hpp>
#include <graze/shape/shape.hpp>

namespace graze::detail {

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
void visit_lengths(const Mesh<N, double>& mesh, F& f) {
  if constexpr (F::wants_largest) {
    const Aabb<N, double>& box = placed(mesh).box();
    if (!is_nothing(box)) f(std::max(max_abs(box.min), max_abs(box.max)));
  } else {
    for (const Vec<N, double>& vertex : mesh.vertices()) mapped(vertex, f);
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
