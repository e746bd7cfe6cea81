// SPDX-License-Identifier: MIT
#include "../bench/convex_hull/of_cgal.hpp"

#include <algorithm>
#include <iterator>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/convex_hull_2.h>

#include <graze/shape/hull/lexicographic.hpp>

namespace graze::hull_bench {

using CgalPoint = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;

struct CgalHull::Lists {
  std::vector<CgalPoint> points;
  std::vector<CgalPoint> hull;
};

CgalHull::CgalHull(const Points<2>& points) : lists_(std::make_unique<Lists>()) {
  for (const Vec<2, double>& point : points) lists_->points.emplace_back(point.x, point.y);
}

CgalHull::~CgalHull() = default;

std::size_t CgalHull::find() {
  lists_->hull.clear();
  CGAL::convex_hull_2(lists_->points.begin(), lists_->points.end(), std::back_inserter(lists_->hull));
  return lists_->hull.size();
}

Points<2> CgalHull::corners() const {
  Points<2> result;
  for (const CgalPoint& point : lists_->hull) result.push_back({point.x(), point.y()});
  std::sort(result.begin(), result.end(), detail::lexicographically_less<2, double>);
  return result;
}

}  // namespace graze::hull_bench
