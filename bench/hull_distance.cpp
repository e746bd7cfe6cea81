// SPDX-License-Identifier: MIT
// Compares the distance and the nearest points of two convex hulls of 8 to 256 corners, each with a pose, with Bullet
// (float) and both of FCL's solvers (double); each library has a file in bench/hull_distance. ODE has no distance
// query, and libccd has none of its own. Pairs are apart. "Cold": all pairs in turn, frame after frame, without cached
// data. "Cold, by heart": only the first frame of each pair, so few queries that the branch predictor learns them.
// "Followed": frame after frame and back, each with the library's cached data of the previous frame. Before timing,
// graze's answers are proved by separating planes, and the others' distances are compared with them: the number of
// those that are off by more than a library's precision and tolerance explain is printed.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include <graze/query/closest_points.hpp>

#include "hull_distance/of_bullet.hpp"
#include "hull_distance/of_fcl.hpp"
#include "hull_distance/pairs.hpp"

namespace {

using graze::hull_bench::BulletDetector;
using graze::hull_bench::BulletSolver;
using graze::hull_bench::FclOfLibccd;
using graze::hull_bench::FclOwn;
using graze::hull_bench::Hull;
using graze::hull_bench::MovingPair;

constexpr std::size_t pair_count = 64;
constexpr std::size_t frame_count = 32;

class Graze {
 public:
  static constexpr const char* name = "graze";

  explicit Graze(const MovingPair& pair) {
    for (const auto& places : pair.frames) {
      frames_.push_back({Posed{pair.hulls[0], places[0]}, Posed{pair.hulls[1], places[1]}});
    }
  }

  double find(std::size_t i) { return closest(i).distance; }
  double follow(std::size_t i) { return closest_followed(i).distance; }

  graze::Proximity<3, double> closest(std::size_t i) { return closest_points(frames_[i][0], frames_[i][1]); }
  graze::Proximity<3, double> closest_followed(std::size_t i) {
    return closest_points(frames_[i][0], frames_[i][1], cache_);
  }
  const auto& shapes(std::size_t i) const { return frames_[i]; }

 private:
  using Posed = graze::Posed<Hull>;
  std::vector<std::array<Posed, 2>> frames_;
  graze::SimplexCache<3> cache_;
};

/// All pairs in a library's form.
template <class Library>
using Entrants = std::vector<std::unique_ptr<Library>>;

template <class Library>
std::shared_ptr<Entrants<Library>> entered(const std::vector<MovingPair>& pairs) {
  auto result = std::make_shared<Entrants<Library>>();
  for (const MovingPair& pair : pairs) result->push_back(std::make_unique<Library>(pair));
  return result;
}

/// Compares a library's distances in all frames with graze's. More than a few differences indicate that it is called
/// incorrectly.
template <class Library>
void compare(const std::string& title, const std::vector<MovingPair>& pairs, double tolerance) {
  const auto graze = entered<Graze>(pairs);
  const auto theirs = entered<Library>(pairs);
  double worst = 0;
  std::size_t off = 0;
  for (std::size_t frame = 0; frame < frame_count; ++frame) {
    for (std::size_t p = 0; p < pairs.size(); ++p) {
      const double right = (*graze)[p]->find(frame);
      for (const double found : {(*theirs)[p]->find(frame), (*theirs)[p]->follow(frame)}) {
        const double difference = std::fabs(found - right);
        worst = std::max(worst, difference);
        if (difference > tolerance) ++off;
      }
    }
  }
  const std::size_t answers = 2 * frame_count * pairs.size();
  std::printf("%s: %s: %zu of %zu distances off by more than %.0e, %.1e at most\n", title.c_str(), Library::name, off,
              answers, tolerance, worst);
  if (off * 50 <= answers) return;
  std::fprintf(stderr, "hull_distance: those are too many\n");
  std::exit(1);
}

/// Ends the program unless graze's points are as far apart as it says, and the planes through them, perpendicular to
/// its normal, separate the hulls: then no smaller distance exists.
void require_proof(const std::string& title, const std::vector<MovingPair>& pairs) {
  constexpr double slack = 1e-12;
  for (const MovingPair& pair : pairs) {
    Graze graze(pair);
    for (std::size_t frame = 0; frame < frame_count; ++frame) {
      for (const auto& found : {graze.closest(frame), graze.closest_followed(frame)}) {
        const auto [a, b] = graze.shapes(frame);
        const double gap = dot(found.normal, support(b, -found.normal) - support(a, found.normal));
        const auto way = found.point_b - found.point_a;
        if (std::fabs(gap - found.distance) <= slack && std::fabs(std::sqrt(dot(way, way)) - gap) <= slack) continue;
        std::fprintf(stderr, "%s: graze says %.17g, the planes %.17g\n", title.c_str(), found.distance, gap);
        std::exit(1);
      }
    }
  }
}

void count_pairs(benchmark::State& state, std::size_t per_iteration) {
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(per_iteration));
  state.counters["ns"] =
      benchmark::Counter(1e-9 * static_cast<double>(per_iteration),
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

template <class Library>
void enter(const std::string& title, const std::vector<MovingPair>& pairs, double tolerance) {
  compare<Library>(title, pairs, tolerance);
  const auto all = entered<Library>(pairs);
  benchmark::RegisterBenchmark((title + ", cold/" + Library::name).c_str(), [all](benchmark::State& state) {
    for (auto _ : state) {
      for (std::size_t frame = 0; frame < frame_count; ++frame) {
        for (const auto& pair : *all) benchmark::DoNotOptimize(pair->find(frame));
      }
    }
    count_pairs(state, frame_count * pair_count);
  });
  benchmark::RegisterBenchmark((title + ", cold, by heart/" + Library::name).c_str(), [all](benchmark::State& state) {
    for (auto _ : state) {
      for (const auto& pair : *all) benchmark::DoNotOptimize(pair->find(0));
    }
    count_pairs(state, pair_count);
  });
  benchmark::RegisterBenchmark((title + ", followed/" + Library::name).c_str(), [all](benchmark::State& state) {
    const auto find_all = [&](std::size_t frame) {
      for (const auto& pair : *all) benchmark::DoNotOptimize(pair->follow(frame));
    };
    for (auto _ : state) {
      for (std::size_t frame = 0; frame < frame_count; ++frame) find_all(frame);
      for (std::size_t frame = frame_count; frame-- > 0;) find_all(frame);
    }
    count_pairs(state, 2 * frame_count * pair_count);
  });
}

void enter_all(std::size_t corners) {
  graze::hull_bench::Random random;
  std::vector<MovingPair> pairs;
  while (pairs.size() < pair_count) pairs.push_back(draw_pair(random, corners, frame_count));
  const std::string title = "hulls of " + std::to_string(corners);
  require_proof(title, pairs);
  enter<Graze>(title, pairs, 0x1p-40);
  enter<BulletDetector>(title, pairs, 1e-3);
  enter<BulletSolver>(title, pairs, 1e-3);
  enter<FclOwn>(title, pairs, 1e-5);
  enter<FclOfLibccd>(title, pairs, 1e-5);
}

}  // namespace

int main(int argc, char** argv) {
  for (const std::size_t corners : {8U, 16U, 32U, 64U, 128U, 256U}) enter_all(corners);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
