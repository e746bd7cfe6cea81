// SPDX-License-Identifier: MIT
// Volume, centroid and inertia of the convex hull of points, in rational numbers: every line or plane through some of
// the points with the others on one side contributes a fan of simplices. For up to a dozen points.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <vector>

#include <graze/math/vec.hpp>

#include "exact/numbers.hpp"

namespace graze::test {

/// The integrals of 1, x and x x^T over a solid.
template <Dim N>
struct ExactMoments {
  static constexpr std::size_t size = static_cast<std::size_t>(N);

  Rational volume = 0;
  RationalVec<N> first{};
  std::array<RationalVec<N>, size> second{};
};

/// Adds those of a simplex with one corner at the origin, whose `determinant` is N! times its volume. The mean of x
/// over it is the sum s of the other corners c over N + 1, and that of x x^T is (s s^T + sum of c c^T) / ((N + 1) (N +
/// 2)).
template <Dim N>
void add_simplex(ExactMoments<N>& moments, const Rational& determinant,
                 const std::array<RationalVec<N>, static_cast<std::size_t>(N)>& corners) {
  constexpr std::size_t size = static_cast<std::size_t>(N);
  const Rational volume = determinant / (N == 2 ? 2 : 6);
  RationalVec<N> sum = corners[0];
  for (std::size_t i = 1; i < size; ++i) sum = sum + corners[i];
  moments.volume += volume;
  for (std::size_t i = 0; i < size; ++i) {
    moments.first[i] += volume * sum[i] / (N + 1);
    for (std::size_t j = 0; j < size; ++j) {
      Rational squares = sum[i] * sum[j];
      for (const RationalVec<N>& corner : corners) squares += corner[i] * corner[j];
      moments.second[i][j] += volume * squares / ((N + 1) * (N + 2));
    }
  }
}

/// The same points in order around a face, seen against `normal`, without collinear ones. In two coordinates, by the
/// chain of A. M. Andrew 1979, once along the lower and once along the upper side.
inline std::vector<RationalVec<3>> around_face(std::vector<RationalVec<3>> points, const RationalVec<3>& normal) {
  const std::size_t drop = normal[2] != 0 ? 2 : normal[1] != 0 ? 1 : 0;
  const std::size_t u = (drop + 1) % 3;
  const std::size_t v = (drop + 2) % 3;
  const auto turn = [&](const RationalVec<3>& a, const RationalVec<3>& b, const RationalVec<3>& c) -> Rational {
    return (b[u] - a[u]) * (c[v] - a[v]) - (b[v] - a[v]) * (c[u] - a[u]);
  };
  std::sort(points.begin(), points.end(),
            [&](const RationalVec<3>& a, const RationalVec<3>& b) { return a[u] != b[u] ? a[u] < b[u] : a[v] < b[v]; });
  std::vector<RationalVec<3>> chain;
  for (int side = 0; side < 2; ++side) {
    const std::size_t start = chain.size();
    for (const RationalVec<3>& point : points) {
      while (chain.size() >= start + 2 && turn(chain[chain.size() - 2], chain.back(), point) <= 0) chain.pop_back();
      chain.push_back(point);
    }
    chain.pop_back();
    std::reverse(points.begin(), points.end());
  }
  if (normal[drop] < 0) std::reverse(chain.begin(), chain.end());
  return chain;
}

/// The moments of a 3D hull, relative to one of its points. Each face once, with the points on it.
inline ExactMoments<3> moments_of_hull(const std::vector<RationalVec<3>>& points) {
  ExactMoments<3> moments;
  std::set<std::vector<std::size_t>> seen;
  const auto add_face = [&](const RationalVec<3>& origin, const RationalVec<3>& normal) {
    std::vector<std::size_t> places;
    std::vector<RationalVec<3>> on_plane;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Rational height = dot(normal, points[i] - origin);
      if (height > 0) return;
      if (height < 0) continue;
      places.push_back(i);
      on_plane.push_back(points[i]);
    }
    if (places.size() == points.size() || !seen.insert(places).second) return;
    const std::vector<RationalVec<3>> face = around_face(on_plane, normal);
    for (std::size_t i = 2; i < face.size(); ++i)
      add_simplex<3>(moments, dot(face[0], cross(face[i - 1], face[i])), {face[0], face[i - 1], face[i]});
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      for (std::size_t k = j + 1; k < points.size(); ++k) {
        const RationalVec<3> normal = cross(points[j] - points[i], points[k] - points[i]);
        if (is_zero(normal)) continue;
        add_face(points[i], normal);
        add_face(points[i], normal * Rational(-1));
      }
    }
  }
  return moments;
}

/// The moments of a 2D hull.
inline ExactMoments<2> moments_of_hull(const std::vector<RationalVec<2>>& points) {
  std::vector<RationalVec<3>> lifted;
  for (const RationalVec<2>& point : points) lifted.push_back({point[0], point[1], 0});
  const std::vector<RationalVec<3>> chain = around_face(lifted, {0, 0, 1});
  ExactMoments<2> moments;
  for (std::size_t i = 1; i < chain.size(); ++i) {
    const RationalVec<2> a{chain[i - 1][0], chain[i - 1][1]};
    const RationalVec<2> b{chain[i][0], chain[i][1]};
    add_simplex<2>(moments, a[0] * b[1] - a[1] * b[0], {a, b});
  }
  if (chain.size() > 2) {
    const RationalVec<2> a{chain.back()[0], chain.back()[1]};
    const RationalVec<2> b{chain[0][0], chain[0][1]};
    add_simplex<2>(moments, a[0] * b[1] - a[1] * b[0], {a, b});
  }
  return moments;
}

/// Volume, centroid, and the integral of (x - centroid)(x - centroid)^T; none if there is no volume.
template <Dim N>
struct ExactMass {
  Rational volume = 0;
  RationalVec<N> centroid{};
  std::array<RationalVec<N>, static_cast<std::size_t>(N)> second{};
};

template <Dim N>
ExactMass<N> exact_mass(std::vector<RationalVec<N>> points) {
  const RationalVec<N> origin = points.front();
  for (RationalVec<N>& point : points) point = point - origin;
  const ExactMoments<N> moments = moments_of_hull(points);
  ExactMass<N> mass;
  mass.volume = moments.volume;
  if (mass.volume == 0) return mass;
  const RationalVec<N> centroid = moments.first * Rational(1 / moments.volume);
  mass.centroid = origin + centroid;
  for (std::size_t i = 0; i < mass.second.size(); ++i) {
    for (std::size_t j = 0; j < mass.second.size(); ++j)
      mass.second[i][j] = moments.second[i][j] - moments.volume * centroid[i] * centroid[j];
  }
  return mass;
}

}  // namespace graze::test
