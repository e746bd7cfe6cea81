// SPDX-License-Identifier: MIT
// Random numbers, points, directions and rotations for tests: one kind at a time, so that shapes made from them often
// meet, touch, coincide and degenerate. All of them shrink to few and short decimals.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include <rapidcheck.h>

#include <graze/math/vec.hpp>

namespace graze::test {

/// Numbers simpler than x, the simplest first: zero, fewer decimals, smaller, positive. None is longer or larger than
/// x, so shrinking terminates.
template <class T>
std::vector<T> simpler(T x) {
  std::vector<T> candidates;
  if (x == T(0)) return candidates;
  candidates.push_back(T(0));
  const auto offer = [&candidates, x](double value) {
    const T candidate = static_cast<T>(value);
    if (candidate != x && candidate != T(0)) candidates.push_back(candidate);
  };
  const double value = static_cast<double>(x);
  for (const double step : {1.0, 10.0, 100.0, 1000.0}) offer(std::trunc(value * step) / step);
  if (value == std::trunc(value)) {
    offer(std::trunc(value / 2));
    offer(value - std::copysign(1.0, value));
  }
  if (value < 0) offer(-value);
  return candidates;
}

template <class T>
rc::Shrinkable<T> shrinking_to_simpler(T value) {
  return rc::shrinkable::shrinkRecur(value, [](T x) { return rc::seq::fromContainer(simpler(x)); });
}

/// A generator of whatever `draw(random)` returns, regardless of RapidCheck's size, shrinking to simpler numbers.
template <class T, class Draw>
rc::Gen<T> drawn(Draw draw) {
  return [draw](const rc::Random& random, int) {
    rc::Random engine(random);
    return shrinking_to_simpler(static_cast<T>(draw(engine)));
  };
}

/// A uniform number in [low, high).
inline double between(rc::Random& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random.next() >> 11U) * 0x1p-53);
}

/// A uniform integer in [low, high].
inline double whole(rc::Random& random, int low, int high) { return std::floor(between(random, low, high + 1.0)); }

/// A number from 2^low to 2^(high + 1), with every power of two equally likely. Power functions are avoided: their last
/// bits differ between machines, and so would the cases of a seed.
inline double of_any_magnitude(rc::Random& random, int low, int high) {
  const double exponent = whole(random, low, high);
  return std::ldexp(between(random, 1, 2), static_cast<int>(exponent));
}

/// 1e-6 to 2e6.
inline double of_any_magnitude(rc::Random& random) { return of_any_magnitude(random, -20, 20); }

/// A uniform index below `count`, which shrinks to the first.
inline rc::Gen<std::size_t> choice(std::size_t count) {
  return drawn<std::size_t>([count](rc::Random& random) { return static_cast<std::size_t>(random.next() % count); });
}

/// The kinds of numbers in a test case; one case uses one kind throughout.
enum class Kind {
  grid,     ///< Small integers: exact touching, many coincidences.
  nudged,   ///< The same, some of them off by a few ulp: almost touching.
  uniform,  ///< -10 to 10.
  scales,   ///< 1e-6 to 2e6, both signs.
  far,      ///< Within 10 of 1e6: small shapes far from the origin.
};
inline constexpr std::array<Kind, 5> kinds = {Kind::grid, Kind::nudged, Kind::uniform, Kind::scales, Kind::far};

/// An integer in [low, high], in about half of the cases off by up to three ulp; zero by an ulp of one, because
/// denormal numbers are a separate matter.
template <class T>
T nudged(rc::Random& random, int low, int high) {
  const T x = static_cast<T>(whole(random, low, high));
  const auto ulps = static_cast<T>(whole(random, -3, 3));
  const bool off = whole(random, 0, 1) == 1;
  const T ulp = std::numeric_limits<T>::epsilon() * (x == T(0) ? T(1) : std::exp2(std::floor(std::log2(std::fabs(x)))));
  return off ? x + ulps * ulp : x;
}

template <class T>
T draw_coordinate(Kind kind, rc::Random& random) {
  switch (kind) {
    case Kind::grid:
      return static_cast<T>(whole(random, -4, 4));
    case Kind::nudged:
      return nudged<T>(random, -4, 4);
    case Kind::uniform:
      return static_cast<T>(between(random, -10, 10));
    case Kind::scales:
      return static_cast<T>(whole(random, 0, 1) == 0 ? of_any_magnitude(random) : -of_any_magnitude(random));
    case Kind::far:
      return static_cast<T>(1e6 + between(random, -10, 10));
  }
  return T(0);
}

/// Zero in at least one case in five.
template <class T>
T draw_size(Kind kind, rc::Random& random) {
  if (whole(random, 1, 5) == 1) return T(0);
  switch (kind) {
    case Kind::grid:
      return static_cast<T>(whole(random, 0, 3));
    case Kind::nudged:
      return nudged<T>(random, 1, 3);
    case Kind::scales:
      return static_cast<T>(of_any_magnitude(random));
    default:
      return static_cast<T>(between(random, 0, 5));
  }
}

/// One coordinate of a direction: zero in one case in three, so that directions along axes are common.
template <class T>
T draw_slope(Kind kind, rc::Random& random) {
  if (whole(random, 1, 3) == 1) return T(0);
  switch (kind) {
    case Kind::grid:
      return static_cast<T>(whole(random, -2, 2));
    case Kind::far:
      return static_cast<T>(between(random, -1, 1));
    default:
      return draw_coordinate<T>(kind, random);
  }
}

/// A vector whose coordinates come from one generator.
template <Dim N, class T>
rc::Gen<Vec<N, T>> vector_of(const rc::Gen<T>& coordinate) {
  return rc::gen::exec([coordinate] {
    Vec<N, T> vector;
    for (Dim i = 0; i < N; ++i) vector[i] = *coordinate;
    return vector;
  });
}

/// One to `count` values.
template <class S>
rc::Gen<std::vector<S>> some(std::size_t count, const rc::Gen<S>& any) {
  return rc::gen::exec([count, any] {
    const std::size_t more = *choice(count);
    std::vector<S> values;
    for (std::size_t i = 0; i <= more; ++i) values.push_back(*any);
    return values;
  });
}

/// The source of a test case's shapes.
template <Dim N, class T>
struct Source {
  rc::Gen<Vec<N, T>> point;
  rc::Gen<T> size;               ///< Zero or more.
  rc::Gen<Vec<N, T>> direction;  ///< Not zero, of any length.
};

/// Numbers of one kind, each drawn on its own.
template <Dim N, class T>
Source<N, T> source_of(Kind kind) {
  return {
      vector_of<N, T>(drawn<T>([kind](rc::Random& random) { return draw_coordinate<T>(kind, random); })),
      drawn<T>([kind](rc::Random& random) { return draw_size<T>(kind, random); }),
      rc::gen::suchThat(vector_of<N, T>(drawn<T>([kind](rc::Random& random) { return draw_slope<T>(kind, random); })),
                        [](const Vec<N, T>& direction) { return max_abs(direction) > T(0); })};
}

/// A source whose points are, in half of the cases, one of two points or their midpoint: corners, centers and ends
/// coincide, and three of them are collinear.
template <Dim N, class T>
Source<N, T> sharing(const Source<N, T>& source, const Vec<N, T>& p, const Vec<N, T>& q) {
  const Vec<N, T> middle = p * T(0.5) + q * T(0.5);
  Source<N, T> shared = source;
  shared.point = rc::gen::weightedOneOf<Vec<N, T>>(
      {{4, source.point}, {2, rc::gen::just(p)}, {1, rc::gen::just(q)}, {1, rc::gen::just(middle)}});
  return shared;
}

/// A source for one test case: its shapes share a kind of numbers, and often points. Call it where `*generator` is
/// allowed.
template <Dim N, class T>
Source<N, T> draw_source() {
  const Source<N, T> source = source_of<N, T>(kinds[*choice(kinds.size())]);
  const Vec<N, T> p = *source.point;
  return sharing<N, T>(source, p, *source.point);
}

/// The matrix rounded to T, without negative zeros.
template <Dim N, class T>
Mat<N, T> rounded(const Mat<N, double>& matrix) {
  Mat<N, T> result;
  for (Dim j = 0; j < N; ++j) result[j] = Vec<N, T>(matrix[j]) + T(0);
  return result;
}

/// Quarter turns, almost quarter turns (off by 1e-8 to 4e-6 radians), and any turn. Integers count quarter turns.
inline rc::Gen<double> any_turn() {
  return drawn<double>([](rc::Random& random) {
    const double quarters = whole(random, -1, 2);
    const double kind = whole(random, 0, 2);
    if (kind == 0) return quarters;
    if (kind == 1) return between(random, -2, 2);
    const double off = of_any_magnitude(random, -27, -20);
    return quarters + off * whole(random, -1, 1);
  });
}

/// Cosine and sine of a turn, with operations that every machine rounds alike. Between quarter turns, the angle is
/// approximate.
inline Vec<2, double> direction_of(double turn) {
  const double quarters = std::floor(turn + 0.5);
  const double half_tangent = (turn - quarters) * 0.828125;  // of an eighth of a turn: 0.414
  const double scale = 1 / (1 + half_tangent * half_tangent);
  Vec<2, double> direction((1 - half_tangent * half_tangent) * scale, 2 * half_tangent * scale);
  for (int k = 0; k < (static_cast<int>(quarters) + 4) % 4; ++k) direction = {-direction.y, direction.x};
  return direction;
}

/// A proper rotation: exact at quarter turns about the axes, otherwise orthonormal up to rounding. In 3D by Euler
/// angles about z, x, z: their quarter turns reach all 24 rotations of the cube.
template <Dim N, class T>
rc::Gen<Mat<N, T>> any_rotation() {
  return rc::gen::exec([] {
    const rc::Gen<double> turns = any_turn();
    if constexpr (N == 2) {
      const Vec<2, double> turn = direction_of(*turns);
      return rounded<2, T>(Mat<2, double>(turn, Vec<2, double>(-turn.y, turn.x)));
    } else {
      Mat<3, double> rotation(1.0);
      for (const Dim axis : {2, 0, 2}) {
        const Vec<2, double> turn = direction_of(*turns);
        const Dim next = (axis + 1) % 3;
        const Dim last = (axis + 2) % 3;
        Mat<3, double> step(1.0);
        step[next][next] = step[last][last] = turn.x;
        step[next][last] = turn.y;
        step[last][next] = -turn.y;
        rotation = step * rotation;
      }
      return rounded<3, T>(rotation);
    }
  });
}

}  // namespace graze::test
