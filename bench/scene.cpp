// SPDX-License-Identifier: MIT
// A living world from frame to frame: boxes that move, all of them or one in a hundred, and after each frame which
// pairs touch, which began to and which no longer do. Beside Bullet's broad phase, which keeps pairs of enlarged boxes;
// what touches and what changed is made of them in the quickest way found. Answers are compared before anything is
// timed.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <benchmark/benchmark.h>

#include <graze/broad/worlds.hpp>
#include <graze/scene/scene.hpp>

namespace {

using Box = graze::Aabb<3, float>;
using graze::Pair;

/// A world in which every `step`-th box moves, others in each frame: a walk of some steps, to and fro.
class Frames {
 public:
  Frames(std::size_t count, std::size_t step) : step_(step) {
    graze::MovingBoxes<3, float> boxes(graze::World::brownian, count, 1);
    for (std::vector<Box>& place : places_) {
      place.assign(boxes.boxes().begin(), boxes.boxes().end());
      boxes.step();
    }
  }

  const std::vector<Box>& start() const { return places_[0]; }

  /// Calls move(box number, box) for what moves in this frame.
  template <class Move>
  void each_move(std::size_t frame, const Move& move) const {
    const std::size_t way = (frame / step_ + 1) % (2 * places_.size() - 2);
    const std::vector<Box>& boxes = places_[std::min(way, 2 * places_.size() - 2 - way)];
    for (std::size_t k = frame % step_; k < boxes.size(); k += step_) move(k, boxes[k]);
  }

 private:
  std::size_t step_;
  std::array<std::vector<Box>, 16> places_;
};

/// What touches after a frame, and what is new and what is over.
struct Outcome {
  std::vector<Pair> touching;
  std::vector<Pair> began;
  std::vector<Pair> ended;

  friend bool operator==(const Outcome&, const Outcome&) = default;
};

// ---- The contestants: step(frame), outcome()

class Graze {
 public:
  static constexpr const char* name = "graze Scene";

  explicit Graze(const Frames& frames) : frames_(frames) {
    for (const Box& box : frames.start()) moves_.push_back({scene_.add(box), box});
    scene_.update();
  }

  void step(std::size_t frame) {
    chosen_.clear();
    frames_.each_move(frame, [this](std::size_t k, const Box& box) { chosen_.push_back({moves_[k].id, box}); });
    scene_.move(chosen_);
    scene_.update(graze::serial_executor());
  }

  Outcome outcome() const {
    return {plain(scene_.pairs()), plain(scene_.events().began), plain(scene_.events().ended)};
  }

 private:
  static std::vector<Pair> plain(const std::vector<graze::ObjectPair>& pairs) {
    std::vector<Pair> result;
    for (const graze::ObjectPair& pair : pairs) result.push_back({pair.a.index, pair.b.index});
    return result;
  }

  const Frames& frames_;
  graze::Scene<3> scene_;
  std::vector<graze::ObjectMove<3>> moves_;
  std::vector<graze::ObjectMove<3>> chosen_;
};

class Bullet {
 public:
  static constexpr const char* name = "Bullet btDbvtBroadphase";

  explicit Bullet(const Frames& frames) : frames_(frames), boxes_(frames.start()) {
    gDbvtMargin = 0.2F;
    for (const Box& box : boxes_) {
      proxies_.push_back(broadphase_.createProxy(corner(box.min), corner(box.max), 0, nullptr, 1, 1, nullptr));
    }
    find();
  }

  void step(std::size_t frame) {
    frames_.each_move(frame, [this](std::size_t k, const Box& box) {
      boxes_[k] = box;
      broadphase_.setAabb(proxies_[k], corner(box.min), corner(box.max), nullptr);
    });
    find();
  }

  const Outcome& outcome() const { return outcome_; }

 private:
  static btVector3 corner(const graze::Vec<3, float>& v) { return {v.x, v.y, v.z}; }
  static std::uint32_t index_of(const btBroadphaseProxy* proxy) {
    return static_cast<std::uint32_t>(proxy->m_uniqueId - 1);
  }

  void find() {
    broadphase_.calculateOverlappingPairs(nullptr);
    std::vector<Pair> touching;
    const btBroadphasePairArray& kept = broadphase_.getOverlappingPairCache()->getOverlappingPairArray();
    for (int i = 0; i < kept.size(); ++i) {
      const std::uint32_t a = index_of(kept[i].m_pProxy0);
      const std::uint32_t b = index_of(kept[i].m_pProxy1);
      if (boxes_overlap(boxes_[a], boxes_[b])) touching.push_back({std::min(a, b), std::max(a, b)});
    }
    std::sort(touching.begin(), touching.end());
    outcome_.began.clear();
    outcome_.ended.clear();
    const std::vector<Pair>& before = outcome_.touching;
    std::set_difference(touching.begin(), touching.end(), before.begin(), before.end(),
                        std::back_inserter(outcome_.began));
    std::set_difference(before.begin(), before.end(), touching.begin(), touching.end(),
                        std::back_inserter(outcome_.ended));
    outcome_.touching = std::move(touching);
  }

  const Frames& frames_;
  std::vector<Box> boxes_;
  btDbvtBroadphase broadphase_;
  std::vector<btBroadphaseProxy*> proxies_;
  Outcome outcome_;
};

// ---- What is compared, and what is timed

void require_the_same(std::size_t step) {
  const Frames frames(2'000, step);
  Graze graze(frames);
  Bullet bullet(frames);
  for (std::size_t frame = 0; frame < 12; ++frame) {
    graze.step(frame);
    bullet.step(frame);
    if (graze.outcome() == bullet.outcome()) continue;
    std::fprintf(stderr, "scene: the contestants differ in frame %zu, one box in %zu moving\n", frame, step);
    std::exit(1);
  }
}

template <class Contestant>
void add(const char* work, std::size_t count, std::size_t step) {
  const std::string name = std::string(work) + "/" + Contestant::name + "/" + std::to_string(count);
  benchmark::RegisterBenchmark(name.c_str(), [count, step](benchmark::State& state) {
    const Frames frames(count, step);
    Contestant contestant(frames);
    std::size_t frame = 0;
    for (auto _ : state) contestant.step(frame++);
  })->Unit(benchmark::kMillisecond);
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  for (const std::size_t step : {std::size_t{1}, std::size_t{100}}) require_the_same(step);
  for (const std::size_t count : {std::size_t{10'000}, std::size_t{100'000}}) {
    add<Graze>("all_move", count, 1);
    add<Bullet>("all_move", count, 1);
    add<Graze>("1%_move", count, 100);
    add<Bullet>("1%_move", count, 100);
  }
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
}
