// SPDX-License-Identifier: MIT
// Powers of two that bring numbers into range, and shapes with their lengths replaced. See range.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

#include <graze/math/platform/bit_cast.hpp>
#include <graze/math/rounding.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/convex/wide_support.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/description.hpp>
#include <graze/shape/fields/visit.hpp>
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

/// The greatest squared distance that is not farther than a distance; more if squares underflow.
inline double most_not_farther(double distance) { return std::max(distance * distance, 0x1p-960); }

/// The same for squares of T, which underflow earlier.
template <class T>
T most_squared(double distance) {
  constexpr double least = std::is_same_v<T, float> ? 0x1p-120 : 0x1p-960;
  return round_up<T>(std::max(distance * distance, least));
}

/// Whether a squared distance is greater than the square of another distance; false if squares underflow.
inline bool is_farther(double squared, double distance) { return squared > most_not_farther(distance); }

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
Mesh<N, double> mapped(const Mesh<N, double>& mesh, F& f) {
  std::vector<Vec<N, double>> vertices;
  vertices.reserve(mesh.vertices().size());
  for (const Vec<N, double>& vertex : mesh.vertices()) vertices.push_back(mapped(vertex, f));
  return mesh_of<N, double>(vertices, mesh.faces(), mesh.kind());
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

}  // namespace graze::detail
