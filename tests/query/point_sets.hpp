// SPDX-License-Identifier: MIT
// Sets of points that are difficult to bound, and an exact "contains" for them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <rapidcheck.h>

#include <graze/math/vec.hpp>

#include "catalogue.hpp"
#include "exact/holds.hpp"

namespace graze::test {

/// How the points of a set are arranged.
enum class Arrangement {
  any,          ///< Points of one kind of numbers, some of them equal or midpoints of two.
  line,         ///< Steps along a line, up to the rounding of the coordinates.
  cospherical,  ///< All at one distance from a lattice point, exactly.
  cluster,      ///< A few steps of the number type around one point.
  offset,       ///< A set of size 1, ten million from the origin.
};

/// Steps of the number type around x, which is not zero.
template <class T>
T stepped(T x, double steps) {
  return x + static_cast<T>(steps) * std::numeric_limits<T>::epsilon() * std::exp2(std::floor(std::log2(std::fabs(x))));
}

template <Dim N, class T>
Vec<N, T> draw_cospherical(rc::Random& random) {
  // 7^2 = 2^2 + 3^2 + 6^2, 25^2 = 7^2 + 24^2 = 15^2 + 20^2.
  const std::array<std::array<T, 3>, 3> corners = {{{2, 3, 6}, {7, 0, 0}, {-7, 0, 0}}};
  const std::array<std::array<T, 3>, 3> flat_corners = {{{7, 24, 0}, {15, 20, 0}, {25, 0, 0}}};
  std::array<T, 3> corner = (N == 3 ? corners : flat_corners)[static_cast<std::size_t>(whole(random, 0, 2))];
  std::rotate(corner.begin(), corner.begin() + static_cast<std::ptrdiff_t>(whole(random, 0, N - 1)),
              corner.begin() + N);
  Vec<N, T> point;
  for (Dim i = 0; i < N; ++i) {
    const T sign = whole(random, 0, 1) == 0 ? T(1) : T(-1);
    point[i] = T(3) + sign * corner[static_cast<std::size_t>(i)];
  }
  return point;
}

/// A uniform number in [0, 1) that does not shrink.
inline rc::Gen<double> any_fraction() {
  return rc::gen::noShrink(drawn<double>([](rc::Random& random) { return between(random, 0, 1); }));
}

/// One to `most` points of one arrangement, often with duplicates. Call it where `*generator` is allowed.
template <Dim N, class T>
std::vector<Vec<N, T>> draw_points(std::size_t most) {
  const auto arrangement = static_cast<Arrangement>(*choice(5));
  const Source<N, T> source = draw_source<N, T>();
  if (arrangement == Arrangement::any) return *some<Vec<N, T>>(most, source.point);
  const Vec<N, T> start = *source.point;
  const Vec<N, T> step = *source.direction;
  return *some<Vec<N, T>>(most, rc::gen::exec([=] {
                            const auto number = [](int low, int high) {
                              return *drawn<double>([=](rc::Random& random) { return whole(random, low, high); });
                            };
                            Vec<N, T> point = start;
                            switch (arrangement) {
                              case Arrangement::line:
                                return start + step * static_cast<T>(number(-5, 5));
                              case Arrangement::cospherical:
                                return *rc::gen::noShrink(rc::Gen<Vec<N, T>>([](const rc::Random& random, int) {
                                  rc::Random engine(random);
                                  return rc::shrinkable::just(draw_cospherical<N, T>(engine));
                                }));
                              case Arrangement::cluster:
                                for (Dim i = 0; i < N; ++i)
                                  point[i] = stepped<T>(start[i] == T(0) ? T(1) : start[i], number(-3, 3));
                                return point;
                              default:
                                for (Dim i = 0; i < N; ++i) point[i] = static_cast<T>(1e7 + *any_fraction());
                                return point;
                            }
                          }));
}

template <class Volume, Dim N, class T>
bool contains_all(const Volume& volume, const std::vector<Vec<N, T>>& points) {
  return std::all_of(points.begin(), points.end(), [&](const Vec<N, T>& p) { return contains_exactly(volume, p); });
}

/// The largest magnitude of a coordinate.
template <Dim N, class T>
double largest_coordinate(const std::vector<Vec<N, T>>& points) {
  double largest = 0;
  for (const Vec<N, T>& point : points) largest = std::max(largest, static_cast<double>(max_abs(point)));
  return largest;
}

}  // namespace graze::test
