// SPDX-License-Identifier: MIT
// The movements in a scene, and the required answer for each frame.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include <graze/broad/pair.hpp>
#include <graze/broad/scene_generators.hpp>
#include <graze/shape/aabb.hpp>

namespace bench {

using graze::Dim;
using graze::Pair;
template <Dim N>
using Box = graze::Aabb<N, float>;

/// A scene in which every `step`-th box moves, others in each frame: a walk of some steps, back and forth.
template <Dim N>
class Frames {
 public:
  Frames(std::size_t count, std::size_t step) : step_(step) {
    graze::MovingBoxes<N, float> boxes(graze::World::brownian, count, 1);
    for (std::vector<Box<N>>& place : places_) {
      place.assign(boxes.boxes().begin(), boxes.boxes().end());
      boxes.step();
    }
    for (const std::vector<Box<N>>& place : places_) read_once(place);
  }

  const std::vector<Box<N>>& start() const { return places_[0]; }

  bool all_move() const { return step_ == 1; }

  /// The boxes after this frame, if they move in it.
  const std::vector<Box<N>>& places(std::size_t frame) const {
    const std::size_t way = (frame / step_ + 1) % (2 * places_.size() - 2);
    return places_[std::min(way, 2 * places_.size() - 2 - way)];
  }

  /// Calls move(box number, box) for the boxes that move in this frame.
  template <class Move>
  void each_move(std::size_t frame, const Move& move) const {
    const std::vector<Box<N>>& boxes = places(frame);
    for (std::size_t k = frame % step_; k < boxes.size(); k += step_) move(k, boxes[k]);
  }

  /// The boxes after this frame, including those that moved earlier.
  std::vector<Box<N>> all_places(std::size_t frame) const {
    std::vector<Box<N>> boxes = start();
    for (std::size_t k = frame + 1 - std::min(frame + 1, step_); k <= frame; ++k) {
      each_move(k, [&boxes](std::size_t box, const Box<N>& place) { boxes[box] = place; });
    }
    return boxes;
  }

 private:
  /// The first read of memory that was written and never read may cost microseconds per page, which should not count:
  /// in a simulation, boxes that move have just been calculated.
  static void read_once(const std::vector<Box<N>>& place) {
    for (const Box<N>& box : place) benchmark::DoNotOptimize(box.min.x);
  }

  std::size_t step_;
  std::array<std::vector<Box<N>>, 16> places_;
};

/// The pairs that touch after a frame, and those that began and ended; in any order.
struct Outcome {
  std::vector<Pair> touching;
  std::vector<Pair> began;
  std::vector<Pair> ended;

  void clear() {
    touching.clear();
    began.clear();
    ended.clear();
  }

  friend bool operator==(const Outcome&, const Outcome&) = default;
};

inline Outcome sorted(Outcome outcome) {
  for (std::vector<Pair>* pairs : {&outcome.touching, &outcome.began, &outcome.ended}) {
    std::sort(pairs->begin(), pairs->end());
  }
  return outcome;
}

inline Pair ascending(std::size_t i, std::size_t j) {
  return {static_cast<std::uint32_t>(std::min(i, j)), static_cast<std::uint32_t>(std::max(i, j))};
}

/// For contestants that know all pairs of a frame, but not those of the last: makes the next outcome of them.
inline void go_on(Outcome& outcome, std::vector<Pair>& found) {
  std::sort(found.begin(), found.end());
  outcome.began.clear();
  outcome.ended.clear();
  const std::vector<Pair>& before = outcome.touching;
  std::set_difference(found.begin(), found.end(), before.begin(), before.end(), std::back_inserter(outcome.began));
  std::set_difference(before.begin(), before.end(), found.begin(), found.end(), std::back_inserter(outcome.ended));
  std::swap(outcome.touching, found);
}

}  // namespace bench
