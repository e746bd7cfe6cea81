// SPDX-License-Identifier: MIT
// All overlapping pairs of n boxes, from boxes to pairs: graze's methods beside Boost.Geometry's R-tree (bulk-loaded),
// on the same boxes. The scene is that of the Broadmark framework (Serpa, Rodrigues 2020): unit cubes in random
// orientations, seen as their axis-aligned boxes, which fill a tenth of space. All answers are compared before anything
// is timed.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <random>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <graze/broad/pairs.hpp>

namespace {

using Box = graze::Aabb<3, float>;

std::vector<Box> random_boxes(std::size_t count) {
  std::mt19937 random(20);
  const float side = std::cbrt(static_cast<float>(count) / 0.1F);
  std::uniform_real_distribution<float> coordinate(0, side);
  std::uniform_real_distribution<float> half(0.5F, 0.5F * std::sqrt(3.0F));  // of a unit cube, however it is turned
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    const graze::Vec<3> center(coordinate(random), coordinate(random), coordinate(random));
    boxes.push_back(Box::from_center(center, graze::Vec<3>(half(random), half(random), half(random))));
  }
  return boxes;
}

std::vector<graze::Pair> boost_pairs(const std::vector<Box>& boxes) {
  namespace geometry = boost::geometry;
  using Point = geometry::model::point<float, 3, geometry::cs::cartesian>;
  using Entry = std::pair<geometry::model::box<Point>, std::uint32_t>;
  std::vector<Entry> entries;
  entries.reserve(boxes.size());
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    const auto corner = [](const graze::Vec<3>& v) { return Point(v.x, v.y, v.z); };
    entries.push_back({{corner(boxes[i].min), corner(boxes[i].max)}, i});
  }
  const geometry::index::rtree<Entry, geometry::index::quadratic<16>> tree(entries);
  std::vector<graze::Pair> pairs;
  std::vector<Entry> hits;
  for (const Entry& entry : entries) {
    hits.clear();
    tree.query(geometry::index::intersects(entry.first), std::back_inserter(hits));
    for (const Entry& hit : hits) {
      if (entry.second < hit.second) pairs.push_back({entry.second, hit.second});
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

void report(benchmark::State& state, std::size_t pairs) {
  state.counters["pairs"] = static_cast<double>(pairs);
  state.counters["boxes/s"] =
      benchmark::Counter(static_cast<double>(state.range(0)), benchmark::Counter::kIsIterationInvariantRate);
}

void graze_tree(benchmark::State& state) {
  const auto boxes = random_boxes(static_cast<std::size_t>(state.range(0)));
  std::size_t pairs = 0;
  for (auto _ : state) pairs = graze::overlapping_pairs(boxes, {graze::PairMethod::tree}).size();
  report(state, pairs);
}

void graze_brute_force(benchmark::State& state) {
  const auto boxes = random_boxes(static_cast<std::size_t>(state.range(0)));
  std::size_t pairs = 0;
  for (auto _ : state) pairs = graze::overlapping_pairs(boxes, {graze::PairMethod::brute_force}).size();
  report(state, pairs);
}

void boost_rtree(benchmark::State& state) {
  const auto boxes = random_boxes(static_cast<std::size_t>(state.range(0)));
  std::size_t pairs = 0;
  for (auto _ : state) pairs = boost_pairs(boxes).size();
  report(state, pairs);
}

void require_equal_answers() {
  for (const std::size_t count : {100U, 10'000U, 100'000U}) {
    const auto boxes = random_boxes(count);
    const auto tree = graze::overlapping_pairs(boxes, {graze::PairMethod::tree});
    const bool equal = tree == boost_pairs(boxes) &&
                       (count > 10'000U || tree == graze::overlapping_pairs(boxes, {graze::PairMethod::brute_force}));
    if (equal) continue;
    std::fprintf(stderr, "pairs: the methods disagree on %zu boxes\n", count);
    std::exit(1);
  }
}

BENCHMARK(graze_brute_force)->Arg(100)->Arg(10'000)->Unit(benchmark::kMillisecond);
BENCHMARK(graze_tree)->Arg(100)->Arg(10'000)->Arg(100'000)->Unit(benchmark::kMillisecond);
BENCHMARK(boost_rtree)->Arg(100)->Arg(10'000)->Arg(100'000)->Unit(benchmark::kMillisecond);

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  require_equal_answers();
  benchmark::RunSpecifiedBenchmarks();
}
