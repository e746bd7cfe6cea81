// SPDX-License-Identifier: MIT
// Compares the quadtree with the usual textbook one, without its errors, at its usual limits (15 boxes, depth 5) and as
// deep as the number of boxes requires; and with a flat one that stores boxes in every leaf that they touch. Drifting
// squares: insert all, query the neighbourhood of each, move all. Answers are compared before timing, and the number of
// hits in the timed run. At the end, the ratio of the faster textbook tree's time to that of graze with bulk insertion
// is printed.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include <graze/broad/orthtree.hpp>
#include <graze/broad/pairs.hpp>
#include <graze/broad/scene_generators.hpp>

#include "several_leaves.hpp"
#include "textbook_quad_tree.hpp"

namespace {

using Box = graze::Aabb<2, float>;

/// Two frames of a scene that is cyclic, so that everything can move back and forth.
struct Frames {
  explicit Frames(std::size_t count) {
    graze::MovingBoxes<2, float> boxes(graze::World::brownian, count, 1);
    world = boxes.bounds();
    first.assign(boxes.boxes().begin(), boxes.boxes().end());
    boxes.step();
    second.assign(boxes.boxes().begin(), boxes.boxes().end());
  }

  const std::vector<Box>& at(std::size_t frame) const { return frame % 2 == 0 ? first : second; }

  Box world;
  std::vector<Box> first;
  std::vector<Box> second;
};

/// The region around a box: one unit more on each side.
Box around(const Box& box) { return {box.min - 1.0F, box.max + 1.0F}; }

// ---- The contestants: insert(), move(frame), query(region, visit)

class Graze {
 public:
  static constexpr const char* name = "graze";
  explicit Graze(const Frames& frames) : frames_(frames) {}

  void insert() {
    tree_ = graze::QuadTree<>(options);
    keys_ = tree_.assign(frames_.first);
  }
  void insert_one_by_one() {
    tree_ = graze::QuadTree<>(options);
    keys_.clear();
    for (const Box& box : frames_.first) keys_.push_back(tree_.insert(box));
  }
  void move(std::size_t frame) {
    const std::vector<Box>& boxes = frames_.at(frame);
    for (std::size_t k = 0; k < boxes.size(); ++k) tree_.update(keys_[k], boxes[k]);
  }
  template <class Visit>
  void query(const Box& region, const Visit& visit) const {
    tree_.query(region, [&visit](graze::Key key) { visit(std::size_t{key.index}); });
  }

  static graze::OrthtreeOptions options;

 private:
  const Frames& frames_;
  graze::QuadTree<> tree_;
  std::vector<graze::Key> keys_;
};
graze::OrthtreeOptions Graze::options;

/// Boxes are inserted one by one.
class OneByOne : public Graze {
 public:
  static constexpr const char* name = "graze, one by one";
  using Graze::Graze;

  void insert() { insert_one_by_one(); }
};

/// A depth with about as many leaves as boxes.
int depth_for(std::size_t count) {
  int depth = 1;
  for (std::size_t leaves = 4; leaves < count; leaves *= 4) ++depth;
  return depth;
}

class Textbook {
 public:
  static constexpr const char* name = "textbook, depth 5";
  explicit Textbook(const Frames& frames, int depth = 5) : frames_(frames), depth_(depth) {}

  void insert() {
    tree_ = std::make_unique<bench::TextbookQuadTree>(frames_.world, 15, depth_);
    objects_.clear();
    objects_.reserve(frames_.first.size());
    for (const Box& box : frames_.first) {
      objects_.push_back({box, objects_.size()});
      tree_->insert(&objects_.back());
    }
  }
  void move(std::size_t frame) {
    const std::vector<Box>& boxes = frames_.at(frame);
    for (std::size_t k = 0; k < boxes.size(); ++k) tree_->update(&objects_[k], boxes[k]);
  }
  template <class Visit>
  void query(const Box& region, const Visit& visit) const {
    for (const auto* object : tree_->query(region)) visit(object->id);
  }

 private:
  const Frames& frames_;
  int depth_;
  std::unique_ptr<bench::TextbookQuadTree> tree_;
  std::vector<bench::TextbookQuadTree::Object> objects_;
};

class DeepTextbook : public Textbook {
 public:
  static constexpr const char* name = "textbook, deep";
  explicit DeepTextbook(const Frames& frames) : Textbook(frames, depth_for(frames.first.size())) {}
};

class InSeveralLeaves {
 public:
  static constexpr const char* name = "in several leaves";
  explicit InSeveralLeaves(const Frames& frames) : frames_(frames) {}

  void insert() {
    tree_ = std::make_unique<bench::SeveralLeaves>(frames_.world, 16, depth_for(frames_.first.size()));
    for (std::size_t k = 0; k < frames_.first.size(); ++k) {
      tree_->insert(static_cast<std::uint32_t>(k), frames_.first[k]);
    }
  }
  void move(std::size_t frame) {
    for (std::size_t k = 0; k < frames_.first.size(); ++k) {
      tree_->update(static_cast<std::uint32_t>(k), frames_.at(frame + 1)[k], frames_.at(frame)[k]);
    }
  }
  template <class Visit>
  void query(const Box& region, const Visit& visit) const {
    tree_->query(region, [&visit](std::uint32_t id) { visit(std::size_t{id}); });
  }

 private:
  const Frames& frames_;
  std::unique_ptr<bench::SeveralLeaves> tree_;
};

// ---- What is compared, and what is timed

template <class Contestant>
std::vector<std::size_t> answers(const Frames& frames) {
  Contestant contestant(frames);
  contestant.insert();
  contestant.move(1);
  std::vector<std::size_t> all;
  for (const Box& box : frames.second) {
    const auto first = static_cast<std::ptrdiff_t>(all.size());
    contestant.query(around(box), [&all](std::size_t id) { all.push_back(id); });
    std::sort(all.begin() + first, all.end());
  }
  return all;
}

template <class Contestant>
void require_the_same(const Frames& frames, const std::vector<std::size_t>& expected) {
  if (answers<Contestant>(frames) == expected) return;
  std::fprintf(stderr, "orthtree: %s gives other answers\n", Contestant::name);
  std::exit(1);
}

/// Compares the number of hits with the batch method, for scenes too large to store each answer.
void require_all_hits(const Frames& frames, std::size_t hits, const char* name) {
  std::vector<Box> regions;
  for (const Box& box : frames.second) regions.push_back(around(box));
  const std::size_t expected =
      graze::overlapping_pairs(std::span<const Box>(frames.second), std::span<const Box>(regions)).size();
  if (hits == expected) return;
  std::fprintf(stderr, "orthtree: %s finds %zu boxes in all regions, not %zu\n", name, hits, expected);
  std::exit(1);
}

template <class Contestant>
void add(std::size_t count) {
  const std::string name = std::string("/") + Contestant::name + "/" + std::to_string(count);
  const auto add_one = [&name](const char* work, auto run) {
    benchmark::RegisterBenchmark((work + name).c_str(), run)->Unit(benchmark::kMillisecond);
  };
  add_one("insert_all", [count](benchmark::State& state) {
    const Frames frames(count);
    Contestant contestant(frames);
    for (auto _ : state) contestant.insert();
  });
  add_one("query_all", [count](benchmark::State& state) {
    const Frames frames(count);
    Contestant contestant(frames);
    contestant.insert();
    contestant.move(1);
    std::size_t hits = 0;
    for (auto _ : state) {
      for (const Box& box : frames.second) contestant.query(around(box), [&hits](std::size_t) { ++hits; });
    }
    require_all_hits(frames, hits / static_cast<std::size_t>(state.iterations()), Contestant::name);
    state.counters["hits_per_query"] =
        static_cast<double>(hits) / static_cast<double>(count * static_cast<std::size_t>(state.iterations()));
  });
  add_one("move_all", [count](benchmark::State& state) {
    const Frames frames(count);
    Contestant contestant(frames);
    contestant.insert();
    std::size_t frame = 0;
    for (auto _ : state) contestant.move(++frame);
  });
}

/// Prints like the base class without colours, and stores the times.
class Ratios : public benchmark::ConsoleReporter {
 public:
  Ratios() : ConsoleReporter(OO_None) {}

  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) {
      if (!run.error_occurred) times_[run.benchmark_name()] = run.GetAdjustedCPUTime();
    }
  }

  void print(const std::string& work, std::size_t count) const {
    const auto time_of = [&](const char* contestant) {
      const auto found = times_.find(work + "/" + contestant + "/" + std::to_string(count));
      return found == times_.end() ? std::numeric_limits<double>::infinity() : found->second;
    };
    const double ratio = std::min(time_of(Textbook::name), time_of(DeepTextbook::name)) / time_of(Graze::name);
    if (!(ratio > 0) || std::isinf(ratio)) return;  // not all were run
    std::printf("%s of %zu boxes: %.1f times as fast as the faster textbook quad tree\n", work.c_str(), count, ratio);
  }

 private:
  std::map<std::string, double> times_;
};

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  const Frames small(1'000);
  const std::vector<std::size_t> expected = answers<Graze>(small);
  require_the_same<Textbook>(small, expected);
  require_the_same<DeepTextbook>(small, expected);
  require_the_same<InSeveralLeaves>(small, expected);
  require_the_same<OneByOne>(small, expected);
  constexpr std::size_t counts[] = {10'000, 100'000, 1'000'000};
  for (const std::size_t count : counts) {
    add<Graze>(count);
    add<OneByOne>(count);
    add<InSeveralLeaves>(count);
    if (count < 1'000'000) add<Textbook>(count);  // a thousand boxes in each of its leaves take minutes
    add<DeepTextbook>(count);
  }
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  Ratios ratios;
  benchmark::RunSpecifiedBenchmarks(&ratios);
  for (const std::size_t count : counts) {
    for (const char* work : {"insert_all", "query_all", "move_all"}) ratios.print(work, count);
  }
}
