// SPDX-License-Identifier: MIT
// CGAL's convex_hull_2, which decides exactly, like graze: the method of Akl and Toussaint.
#pragma once

#include <cstddef>
#include <memory>

#include "../bench/convex_hull/point_clouds.hpp"

namespace graze::hull_bench {

class CgalHull {
 public:
  /// Copies the points into CGAL's form.
  explicit CgalHull(const Points<2>& points);
  CgalHull(const CgalHull&) = delete;
  CgalHull& operator=(const CgalHull&) = delete;
  ~CgalHull();

  /// Calculates the hull; returns its number of corners.
  std::size_t find();

  /// The corners of the hull, in lexicographic order.
  Points<2> corners() const;

 private:
  struct Lists;
  std::unique_ptr<Lists> lists_;
};

}  // namespace graze::hull_bench
