// SPDX-License-Identifier: MIT
// WideManifold: the contact points of two shapes in double, as manifold.hpp finds them before it rounds them.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include <graze/math/vec.hpp>
#include <graze/query/cores/penetration.hpp>
#include <graze/query/patch/clipped.hpp>
#include <graze/query/patch/manifold_points.hpp>
#include <graze/query/scaling/range.hpp>

namespace graze::detail {

/// A manifold in double.
template <Dim N>
struct WideManifold {
  Penetration<N> found;
  std::array<SurfacePair<N>, N == 2 ? 2 : 4> pairs;
  std::size_t size = 0;
  std::uint32_t part_a = 0;
  std::uint32_t part_b = 0;
};

/// Converts it to that of (b, a).
template <Dim N>
void exchange(WideManifold<N>& manifold) {
  manifold.found = exchanged(manifold.found);
  for (std::size_t i = 0; i < manifold.size; ++i) {
    SurfacePair<N>& pair = manifold.pairs[i];
    std::swap(pair.point_a, pair.point_b);
    std::swap(pair.feature_a, pair.feature_b);
  }
  std::swap(manifold.part_a, manifold.part_b);
}

template <Dim N>
void choose_points(const SurfacePairs<N>& from, WideManifold<N>& manifold) {
  manifold.size = std::min(from.size(), manifold.pairs.size());
  for (std::size_t i = 0; i < manifold.size; ++i) manifold.pairs[i] = from[i];
  if constexpr (N == 3) {
    if (from.size() <= manifold.pairs.size()) return;
    auto places = SpanningChoice(from, manifold.found.normal).run();
    std::sort(places.begin(), places.end());
    manifold.size = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (i == 0 || places[i] != places[i - 1]) manifold.pairs[manifold.size++] = from[places[i]];
    }
  }
}

template <Dim N>
void move_points(WideManifold<N>& manifold, const Vec<N, double>& origin) {
  for (std::size_t i = 0; i < manifold.size; ++i) {
    manifold.pairs[i].point_a += origin;
    manifold.pairs[i].point_b += origin;
  }
}

/// Only the contact point: for some pairs there is no other, and for shapes whose sizes differ too much for faces to be
/// clipped.
template <Dim N>
WideManifold<N> manifold_of_one_point(const Penetration<N>& found) {
  WideManifold<N> result;
  result.found = found;
  result.size = 1;
  result.pairs[0] = {found.point_a, found.point_b, found.depth, {}, {}};
  return result;
}

/// Scales it to shapes 2^k times as large.
template <Dim N>
void resize(WideManifold<N>& manifold, const PowerOfTwo& power) {
  manifold.found = resized(manifold.found, power);
  for (SurfacePair<N>& pair : std::span(manifold.pairs).first(manifold.size)) {
    pair.point_a = power(pair.point_a);
    pair.point_b = power(pair.point_b);
    pair.depth = power(pair.depth);
  }
}

}  // namespace graze::detail
