// SPDX-License-Identifier: MIT
// Compares touching_pairs with one call for each pair, with textbook tests in float if there are any, and, for oriented
// boxes, with those of FCL, Bullet and ODE. Candidates are the pairs of overlapping boxes of random shapes, of one type
// or mixed, in cache (1,000 shapes) and out of it (100,000). Before timing, all answers are compared: batch answers
// must equal those of single calls; where others differ, the shapes' depth or gap must be at most 1e-5. Otherwise the
// program fails.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <random>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include <graze/broad/pairs.hpp>
#include <graze/broad/touching_pairs.hpp>
#include <graze/math/pose.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/closest_points.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/intersects.hpp>
#include <graze/query/transformed.hpp>

#include "../tests/exam/textbook.hpp"
#include "ratios.hpp"
#include "touching/obb_tests.hpp"

namespace {

using graze::Dim;
using graze::Pair;
using graze::Vec;

using Any = graze::AnyShape<3, float>;
using Sphere = graze::Sphere<3, float>;
using Aabb = graze::Aabb<3, float>;
using Obb = graze::Obb<3, float>;
using Capsule = graze::Capsule<3, float>;

/// Shapes of about unit size, so dense that each has a few neighbours.
class Random {
 public:
  explicit Random(std::size_t count) : reach_(0.75 * std::cbrt(static_cast<double>(count))) {}

  template <class S>
  S shape();

 private:
  float number(double low, double high) {
    return static_cast<float>(std::uniform_real_distribution<double>(low, high)(engine_));
  }
  Vec<3, float> vector(double size) { return {number(-size, size), number(-size, size), number(-size, size)}; }
  Vec<3, float> place() { return vector(reach_); }
  Vec<3, float> half() { return {number(0.2, 1), number(0.2, 1), number(0.2, 1)}; }

  std::mt19937 engine_{20261122};
  double reach_;
};

template <>
Sphere Random::shape<Sphere>() {
  return {place(), number(0.3, 1)};
}
template <>
Aabb Random::shape<Aabb>() {
  const Vec<3, float> center = place();
  const Vec<3, float> size = half();
  return {center - size, center + size};
}
template <>
Obb Random::shape<Obb>() {
  const Vec<3, float> axis = vector(1) + Vec<3, float>(0, 0, 1.1F);
  return {place(), half(), graze::Mat<3, float>(graze::rotation_matrix(Vec<3, double>(axis), number(-180, 180)))};
}
template <>
Capsule Random::shape<Capsule>() {
  const Vec<3, float> start = place();
  return {start, start + vector(1), number(0.1, 0.5)};
}
template <>
Any Random::shape<Any>() {
  switch (engine_() % 4) {
    case 0:
      return shape<Sphere>();
    case 1:
      return shape<Aabb>();
    case 2:
      return shape<Obb>();
    default:
      return shape<Capsule>();
  }
}

// ---- Candidates, and which of them touch

template <class S>
struct World {
  std::vector<S> shapes;
  std::vector<Pair> candidates;
  std::vector<Pair> touching;

  explicit World(std::size_t count) {
    Random random(count);
    for (std::size_t i = 0; i < count; ++i) shapes.push_back(random.shape<S>());
    std::vector<Aabb> boxes;
    for (const S& shape : shapes) boxes.push_back(touching_bounds(bounds(shape)));
    candidates = overlapping_pairs(boxes);
    touching = by_single_calls([this](const Pair& pair) { return do_touch(pair); });
  }

  bool do_touch(const Pair& pair) const { return intersects(shapes[pair.a], shapes[pair.b]); }

  template <class Test>
  std::vector<Pair> by_single_calls(const Test& test) const {
    std::vector<Pair> found;
    found.reserve(candidates.size());
    for (const Pair& pair : candidates) {
      if (test(pair)) found.push_back(pair);
    }
    return found;
  }

  std::vector<Pair> at_once(const graze::Executor& executor) const {
    return touching_pairs(std::span<const S>(shapes), candidates, {.executor = &executor});
  }
};

// ---- Comparison

constexpr double tolerance = 1e-5;

/// Whether all answers so far are within the tolerance.
bool do_all_agree = true;

void report(const std::string& name, std::size_t differing, double worst) {
  if (differing > 0) std::printf("%s: differs on %zu pairs, by up to %.1e\n", name.c_str(), differing, worst);
  if (worst <= tolerance) return;
  std::fprintf(stderr, "%s: the answers differ by more than %.1e\n", name.c_str(), tolerance);
  do_all_agree = false;
}

/// How far two shapes would have to move to change the answer.
template <class S>
double room_of(const S& a, const S& b) {
  if (const auto touch = contact(a, b)) return static_cast<double>(touch->depth);
  return static_cast<double>(closest_points(a, b).distance);
}

template <class S, class Test>
void compare(const std::string& name, const World<S>& world, const Test& test) {
  std::size_t differing = 0;
  double worst = 0;
  for (const Pair& pair : world.candidates) {
    if (test(pair) == world.do_touch(pair)) continue;
    ++differing;
    worst = std::max(worst, room_of(world.shapes[pair.a], world.shapes[pair.b]));
  }
  report(name, differing, worst);
}

// ---- Timing

benchmark::internal::Benchmark* time(const std::string& name, std::size_t pairs,
                                     std::function<std::vector<Pair>()> find) {
  return benchmark::RegisterBenchmark(name.c_str(),
                                      [pairs, find = std::move(find)](benchmark::State& state) {
                                        for (auto _ : state) benchmark::DoNotOptimize(find());
                                        graze::bench::count_things(state, pairs);
                                      })
      ->Unit(benchmark::kMicrosecond);
}

/// Compares a test of single pairs with graze's, and times it on all of them.
template <class S, class Test>
void add_test(const std::string& name, const std::shared_ptr<const World<S>>& world, const Test& test) {
  compare(name, *world, test);
  time(name, world->candidates.size(), [world, test] { return world->by_single_calls(test); });
}

template <class Boxes>
void add_library(const std::string& title, const std::shared_ptr<const World<Obb>>& world) {
  const auto boxes = std::make_shared<const Boxes>(world->shapes);
  add_test(title + Boxes::name, world, [boxes](const Pair& pair) { return boxes->do_meet(pair); });
}

template <class S>
void register_world(const std::string& type, std::size_t count) {
  const auto world = std::make_shared<const World<S>>(count);
  const std::string title = type + ", " + std::to_string(count) + " shapes, " +
                            std::to_string(world->candidates.size()) + " candidates, " +
                            std::to_string(world->touching.size()) + " touch/";
  const std::size_t pairs = world->candidates.size();
  if (world->at_once(graze::serial_executor()) != world->touching ||
      world->at_once(graze::default_executor()) != world->touching) {
    report(title + "graze at once", 1, HUGE_VAL);
  }
  time(title + "graze at once", pairs, [world] { return world->at_once(graze::serial_executor()); });
  time(title + "graze at once, all threads", pairs, [world] {
    return world->at_once(graze::default_executor());
  })->UseRealTime();
  time(title + "single calls of graze", pairs,
       [world] { return world->by_single_calls([&](const Pair& pair) { return world->do_touch(pair); }); });
  if constexpr (requires { graze::exam::textbook::meet(world->shapes[0], world->shapes[0]); }) {
    add_test(title + "textbook", world, [world](const Pair& pair) {
      return graze::exam::textbook::meet(world->shapes[pair.a], world->shapes[pair.b]);
    });
  }
  if constexpr (std::is_same_v<S, Obb>) {
    add_library<graze::touching_bench::FclBoxes>(title, world);
    add_library<graze::touching_bench::BulletBoxes>(title, world);
    add_library<graze::touching_bench::OdeBoxes>(title, world);
  }
}

}  // namespace

int main(int argc, char** argv) {
  dInitODE2(0);
  dAllocateODEDataForThread(dAllocateMaskAll);
  for (const std::size_t count : {std::size_t{1000}, std::size_t{100'000}}) {
    register_world<Sphere>("sphere", count);
    register_world<Aabb>("aabb", count);
    register_world<Obb>("obb", count);
    register_world<Capsule>("capsule", count);
    register_world<Any>("mixed", count);
  }
  return do_all_agree ? graze::bench::run_races(argc, argv) : 1;
}
