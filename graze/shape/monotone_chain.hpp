// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include <graze/math/orientation.hpp>
#include <graze/math/vec.hpp>

namespace graze::detail {

/// The corners, counter-clockwise from the first, of the hull of things that are distinct points of the plane, or lie
/// at such, `place(thing)`, and are sorted lexicographically by these. Andrew, "Another efficient algorithm for convex
/// hulls in two dimensions" (1979), with an exact orientation test: no corner is lost to rounding.
template <class Thing, class Place = std::identity>
std::vector<Thing> monotone_chain(const std::vector<Thing>& things, const Place& place = {}) {
  if (things.size() < 3) return things;
  std::vector<Thing> hull;
  const auto extend = [&](const Thing& thing, std::size_t fixed) {
    while (hull.size() > fixed && orientation(place(hull[hull.size() - 2]), place(hull.back()), place(thing)) <= 0) {
      hull.pop_back();
    }
    hull.push_back(thing);
  };
  for (const Thing& thing : things) extend(thing, 1);
  const std::size_t lower = hull.size();
  for (auto thing = things.rbegin() + 1; thing != things.rend(); ++thing) extend(*thing, lower);
  hull.pop_back();
  return hull;
}

}  // namespace graze::detail
