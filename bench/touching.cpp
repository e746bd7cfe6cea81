// SPDX-License-Identifier: MIT
// touching_pairs beside one call for each pair, and beside the textbook's tests in float where it has them: candidates
// are the pairs of overlapping boxes of random shapes, of one type or mixed, in cache (1,000 shapes) and out of it
// (100,000). All answers are compared before anything is timed; the textbook's wrong ones are counted in the name.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <random>
#include <span>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include <graze/broad/pairs.hpp>
#include <graze/broad/touching_pairs.hpp>
#include <graze/math/pose.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/intersects.hpp>
#include <graze/query/transformed.hpp>

#include "../tests/exam/textbook.hpp"

namespace {

using graze::Dim;
using graze::Pair;
using graze::Vec;

using Any = graze::AnyShape<3, float>;
using Sphere = graze::Sphere<3, float>;
using Aabb = graze::Aabb<3, float>;
using Obb = graze::Obb<3, float>;
using Capsule = graze::Capsule<3, float>;

/// Shapes of about unit size, so dense that each has a handful of neighbours.
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
    touching = by_single_calls([](const S& a, const S& b) { return intersects(a, b); });
  }

  template <class Test>
  std::vector<Pair> by_single_calls(const Test& test) const {
    std::vector<Pair> found;
    found.reserve(candidates.size());
    for (const Pair& pair : candidates) {
      if (test(shapes[pair.a], shapes[pair.b])) found.push_back(pair);
    }
    return found;
  }

  std::vector<Pair> at_once(const graze::Executor& executor) const {
    return touching_pairs(std::span<const S>(shapes), candidates, {.executor = &executor});
  }
};

void time(const std::string& name, std::size_t pairs, std::function<std::vector<Pair>()> find) {
  benchmark::RegisterBenchmark(name.c_str(),
                               [pairs, find = std::move(find)](benchmark::State& state) {
                                 for (auto _ : state) benchmark::DoNotOptimize(find());
                                 state.counters["per_pair"] = benchmark::Counter(
                                     static_cast<double>(pairs),
                                     benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
                               })
      ->Unit(benchmark::kMicrosecond)
      ->UseRealTime();
}

template <class S>
void register_world(const std::string& type, std::size_t count) {
  const auto world = std::make_shared<const World<S>>(count);
  const std::string name = type + ", " + std::to_string(count) + " shapes, " +
                           std::to_string(world->candidates.size()) + " candidates, " +
                           std::to_string(world->touching.size()) + " touch/";
  const std::size_t pairs = world->candidates.size();
  if (world->at_once(graze::serial_executor()) != world->touching) {
    std::fprintf(stderr, "%s the answers at once are not those of single calls\n", name.c_str());
    std::exit(1);
  }
  time(name + "at once, 1 thread", pairs, [world] { return world->at_once(graze::serial_executor()); });
  time(name + "at once, all threads", pairs, [world] { return world->at_once(graze::default_executor()); });
  time(name + "single calls", pairs,
       [world] { return world->by_single_calls([](const S& a, const S& b) { return intersects(a, b); }); });
  if constexpr (requires { graze::exam::textbook::meet(world->shapes[0], world->shapes[0]); }) {
    const auto textbook = [](const S& a, const S& b) { return graze::exam::textbook::meet(a, b); };
    std::size_t wrong = 0;
    for (const Pair& pair : world->candidates) {
      const S& a = world->shapes[pair.a];
      const S& b = world->shapes[pair.b];
      wrong += textbook(a, b) != intersects(a, b) ? 1U : 0U;
    }
    time(name + "textbook (" + std::to_string(wrong) + " wrong)", pairs,
         [world, textbook] { return world->by_single_calls(textbook); });
  }
}

}  // namespace

int main(int argc, char** argv) {
  for (const std::size_t count : {std::size_t{1000}, std::size_t{100'000}}) {
    register_world<Sphere>("sphere", count);
    register_world<Aabb>("aabb", count);
    register_world<Obb>("obb", count);
    register_world<Capsule>("capsule", count);
    register_world<Any>("mixed", count);
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
