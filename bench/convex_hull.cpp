// SPDX-License-Identifier: MIT
// Compares convex hulls of points in double: convex_hull, which returns corners, and in 3D convex_mesh, which also
// returns faces and edges, with qhull, which returns facets, with its default options, and in 2D with CGAL. All on one
// thread.
//
// Before timing, all answers are compared, and the program fails if they differ: CGAL, which also decides exactly, must
// find the same corners, and so must qhull unless three or four points are nearly collinear or coplanar. In those cases
// qhull drops points that stick out by no more than its rounding error and keeps some that are not corners; such a
// point may be no farther than 1e-12 from the other hull's surface. Areas and volumes must always agree up to that.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <iterator>
#include <memory>
#include <span>
#include <string>

#include <benchmark/benchmark.h>

#include <graze/query/distance.hpp>
#include <graze/query/mass_properties.hpp>
#include <graze/query/signed_distance.hpp>
#include <graze/shape/convex_mesh.hpp>
#include <graze/shape/hull/lexicographic.hpp>
#include <graze/shape/polytope.hpp>
#include <graze/shape/segment.hpp>

#include "convex_hull/of_cgal.hpp"
#include "convex_hull/of_qhull.hpp"
#include "convex_hull/point_clouds.hpp"
#include "ratios.hpp"

namespace {

using graze::Dim;
using graze::Vec;
using graze::hull_bench::CgalHull;
using graze::hull_bench::PointCloud;
using graze::hull_bench::Points;
using graze::hull_bench::Qhull;

template <Dim N>
using Hull = graze::Polytope<N, double>;

/// Relative to the extent of the points.
constexpr double tolerance = 1e-12;

// ---- Comparison

template <Dim N>
Points<N> sorted(std::span<const Vec<N, double>> points) {
  Points<N> result(points.begin(), points.end());
  std::sort(result.begin(), result.end(), graze::detail::lexicographically_less<N, double>);
  return result;
}

/// The sorted points of one list that are not in another.
template <Dim N>
Points<N> only_in(const Points<N>& one, const Points<N>& other) {
  Points<N> result;
  std::set_difference(one.begin(), one.end(), other.begin(), other.end(), std::back_inserter(result),
                      graze::detail::lexicographically_less<N, double>);
  return result;
}

/// How far corners are outside of the polygon of the shared corners.
double farthest_dropped(const Hull<2>& hull, const Points<2>& dropped) {
  const auto corners = hull.vertices();
  const auto is_dropped = [&](std::size_t i) {
    return std::binary_search(dropped.begin(), dropped.end(), corners[i % corners.size()],
                              graze::detail::lexicographically_less<2, double>);
  };
  std::size_t first = 0;
  while (first < corners.size() && is_dropped(first)) ++first;
  double farthest = first < corners.size() ? 0 : INFINITY;
  for (std::size_t start = first, i = first + 1; i <= first + corners.size() && first < corners.size(); ++i) {
    if (is_dropped(i)) continue;
    const graze::Segment<2, double> edge{corners[start % corners.size()], corners[i % corners.size()]};
    for (std::size_t k = start + 1; k < i; ++k) {
      farthest = std::max(farthest, graze::distance(edge, corners[k % corners.size()]));
    }
    start = i;
  }
  return farthest;
}

double farthest_dropped(const Hull<3>& hull, const Points<3>& dropped) {
  if (dropped.empty()) return 0;
  const auto all = hull.vertices();
  const auto shared = graze::convex_hull(only_in<3>({all.begin(), all.end()}, dropped));
  double farthest = 0;
  for (const Vec<3, double>& point : dropped) farthest = std::max(farthest, graze::distance(shared, point));
  return farthest;
}

/// How deep points are inside, for at most a thousand of them.
template <Dim N>
double deepest(const Hull<N>& hull, const Points<N>& points) {
  double depth = 0;
  const std::size_t step = points.size() / 1000 + 1;
  for (std::size_t i = 0; i < points.size(); i += step) depth = std::max(depth, -signed_distance(hull, points[i]));
  return depth;
}

/// Prints how two hulls of the same points differ. Returns whether the differences are within the tolerance.
template <Dim N>
bool compare(const std::string& name, const Hull<N>& hull, const Points<N>& theirs, bool are_same_required) {
  const Points<N> ours = sorted<N>(hull.vertices());
  const Points<N> dropped = only_in<N>(ours, theirs);
  const Points<N> added = only_in<N>(theirs, ours);
  double size = 0;
  for (const Vec<N, double>& corner : ours) size = std::max(size, graze::max_abs(corner));
  const double out = farthest_dropped(hull, dropped) / size;
  const double in = deepest(hull, added) / size;
  std::printf("%s: %zu corners, graze %zu; drops %zu by up to %.1e, adds %zu by up to %.1e\n", name.c_str(),
              theirs.size(), ours.size(), dropped.size(), out, added.size(), in);
  const bool are_same = dropped.empty() && added.empty();
  return are_same_required ? are_same : out <= tolerance && in <= tolerance;
}

template <Dim N>
bool compare_with_qhull(const std::string& name, const Hull<N>& hull, const Points<N>& points, PointCloud cluster) {
  Qhull<N> qhull(points);
  const double volume = graze::mass_properties(hull).volume;
  const double off = std::fabs(qhull.volume() - volume) / volume;
  std::printf("%s/qhull: volumes differ by %.1e\n", name.c_str(), off);
  return compare<N>(name + "/qhull", hull, qhull.corners(), is_in_general_position(cluster, N)) && off <= tolerance;
}

// ---- Timing

template <Dim N, class Build>
void time_build(const std::string& name, const std::shared_ptr<const Points<N>>& points, Build build) {
  benchmark::RegisterBenchmark(name.c_str(), [points, build](benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(build(*points));
    graze::bench::count_things(state, points->size());
  })->Unit(benchmark::kMillisecond);
}

bool add_cgal(const std::string& name, const Hull<2>& hull, const std::shared_ptr<const Points<2>>& points) {
  const auto cgal = std::make_shared<CgalHull>(*points);
  cgal->find();
  time_build<2>(name + "/CGAL", points, [cgal](const Points<2>&) { return cgal->find(); });
  return compare<2>(name + "/CGAL", hull, cgal->corners(), true);
}

/// Whether all agree about the hull.
template <Dim N>
bool register_cloud(PointCloud cluster, std::size_t count) {
  const auto points = std::make_shared<const Points<N>>(graze::hull_bench::points_of<N>(cluster, count));
  const std::string name = std::string(name_of(cluster, N)) + ", " + std::to_string(count);
  const Hull<N> hull = graze::convex_hull(*points);
  time_build<N>(name + "/graze convex_hull", points, [](const Points<N>& p) { return graze::convex_hull(p); });
  if constexpr (N == 3) {
    time_build<N>(name + "/graze convex_mesh", points, [](const Points<N>& p) { return graze::convex_mesh(p); });
  }
  time_build<N>(name + "/qhull", points, [](const Points<N>& p) { return Qhull<N>(p).count(); });
  bool do_agree = compare_with_qhull<N>(name, hull, *points, cluster);
  if constexpr (N == 2) do_agree = add_cgal(name, hull, points) && do_agree;
  if (!do_agree) std::fprintf(stderr, "%s: the hulls differ, see above\n", name.c_str());
  return do_agree;
}

}  // namespace

int main(int argc, char** argv) {
  bool do_agree = true;
  for (const std::size_t count : {1000UL, 10000UL, 100000UL, 1000000UL}) {
    for (const PointCloud cluster : graze::hull_bench::all_clouds) {
      do_agree = register_cloud<2>(cluster, count) && do_agree;
      do_agree = register_cloud<3>(cluster, count) && do_agree;
    }
    for (const PointCloud cluster : graze::hull_bench::clouds_of_3d)
      do_agree = register_cloud<3>(cluster, count) && do_agree;
  }
  if (!do_agree) return 1;
  return graze::bench::run_races(argc, argv);
}
