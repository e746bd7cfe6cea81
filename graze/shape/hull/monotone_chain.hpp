// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>

#include <graze/math/orientation.hpp>
#include <graze/math/vec.hpp>

namespace graze::detail {

/// The corners of the 2D convex hull, counter-clockwise from the first. The things have positions `place(thing)`, which
/// must be distinct and sorted lexicographically. Andrew, "Another efficient algorithm for convex hulls in two
/// dimensions" (1979), with an exact orientation test: no corner is lost to rounding. `List` supports push_back and
/// pop_back; its size reaches at most the number of things plus one.
template <class List, class Place = std::identity>
List monotone_chain(const List& things, const Place& place = {}) {
  using Thing = typename List::value_type;
  if (things.size() < 3) return things;
  List hull;
  const auto extend = [&](const Thing& thing, std::size_t fixed) {
    while (hull.size() > fixed && orientation(std::invoke(place, hull[hull.size() - 2]),
                                              std::invoke(place, hull.back()), std::invoke(place, thing)) <= 0) {
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
