// SPDX-License-Identifier: MIT
// Compares a scene from frame to frame: all boxes move, or one in a hundred, and after each frame the pairs that touch,
// begin to and end are needed. Compared with the broad phases of Bullet and FCL, and in 2D of Box2D, each used in the
// fastest way found. Before timing, answers are compared in small scenes, including events, and in the timed scenes
// after the last frame; a wrong answer ends the program. The contestants are in the folder beside this file.
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include <graze/broad/executor.hpp>
#include <graze/broad/pairs.hpp>

#include "scene/frames.hpp"
#include "scene/of_box2d.hpp"
#include "scene/of_bullet.hpp"
#include "scene/of_fcl.hpp"
#include "scene/of_graze.hpp"

namespace {

using bench::Box;
using bench::Dim;
using bench::Frames;
using bench::Pair;

template <class Contestant, Dim N>
void require_the_same(std::size_t step) {
  const Frames<N> frames(2'000, step);
  bench::OfGraze<N> graze(frames);
  Contestant contestant(frames);
  for (std::size_t frame = 0; frame < 40; ++frame) {
    graze.step(frame);
    contestant.step(frame);
    if (graze.outcome() == sorted(contestant.outcome())) continue;
    std::fprintf(stderr, "scene: %s differs from graze in frame %zu, one box in %zu moving\n", Contestant::name, frame,
                 step);
    std::exit(1);
  }
}

template <class Contestant, Dim N>
void require_all_pairs(const Contestant& contestant, const Frames<N>& frames, std::size_t frame) {
  const std::vector<Box<N>> boxes = frames.all_places(frame);
  const std::vector<Pair> pairs = graze::overlapping_pairs<N, float>(boxes, {.executor = &graze::serial_executor()});
  if (sorted(contestant.outcome()).touching == pairs) return;
  std::fprintf(stderr, "scene: %s has not all pairs of %zu boxes in frame %zu\n", Contestant::name, boxes.size(),
               frame);
  std::exit(1);
}

template <class Contestant, Dim N>
void add(std::size_t count, std::size_t step) {
  const std::string work = step == 1 ? "all_move" : "1_in_" + std::to_string(step) + "_moves";
  const std::string name = work + "/" + std::to_string(N) + "D/" + std::to_string(count) + "/" + Contestant::name;
  benchmark::RegisterBenchmark(name.c_str(), [count, step](benchmark::State& state) {
    const Frames<N> frames(count, step);
    Contestant contestant(frames);
    constexpr std::size_t warm_up = 3;  // the first frames allocate lists
    for (std::size_t frame = 0; frame < warm_up; ++frame) contestant.step(frame);
    std::size_t frame = warm_up;
    for (auto _ : state) contestant.step(frame++);
    require_all_pairs<Contestant, N>(contestant, frames, frame - 1);
  })->Unit(benchmark::kMillisecond);
}

template <Dim N, class... Peers>
void enter() {
  for (const std::size_t step : {std::size_t{1}, std::size_t{100}}) {
    (require_the_same<Peers, N>(step), ...);
    for (const std::size_t count : {std::size_t{10'000}, std::size_t{100'000}, std::size_t{1'000'000}}) {
      add<bench::OfGraze<N>, N>(count, step);
      add<bench::OfGrazeRead<N>, N>(count, step);
      (add<Peers, N>(count, step), ...);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  enter<3, bench::OfBullet<3>, bench::OfFcl>();
  enter<2, bench::OfBullet<2>, bench::OfBox2d>();
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
}
