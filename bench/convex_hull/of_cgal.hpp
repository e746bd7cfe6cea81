// SPDX-License-Identifier: MIT
// CGAL's convex_hull_2, which decides exactly, as graze does: a method of Akl and Toussaint.
#pragma once

#include <cstddef>
#include <memory>

#include "../bench/convex_hull/crowds.hpp"

namespace graze::hull_bench {

class CgalHull {
 public:
  /// Copies the points, as CGAL has them.
  explicit CgalHull(const Points<2>& points);
  CgalHull(const CgalHull&) = delete;
  CgalHull& operator=(const CgalHull&) = delete;
  ~CgalHull();

  /// Makes the hull; how many corners it has.
  std::size_t find();

  /// Of what was found, in lexicographic order.
  Points<2> corners() const;

 private:
  struct Lists;
  std::unique_ptr<Lists> lists_;
};

}  // namespace graze::hull_bench
