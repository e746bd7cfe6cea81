// SPDX-License-Identifier: MIT
// Long-running indexes: random boxes are inserted, moved and erased for a number of operations (multiplied by
// GRAZE_TEST_SCALE), while every answer is compared with BruteForce's. Nothing is lost, and nothing is left over.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/brute_force.hpp>
#include <graze/broad/bvh.hpp>
#include <graze/broad/grid.hpp>
#include <graze/broad/orthtree.hpp>
#include <graze/shape/capsule.hpp>

#include "box_worlds.hpp"
#include "soak.hpp"

namespace graze::index_soak_test {
namespace {

constexpr std::size_t most_boxes = 1'200;
constexpr double world_size = 40;

bool same_key(const Key& a, const Key& b) { return a.index == b.index && a.generation == b.generation; }

template <SpatialIndex I>
class Soak {
 public:
  using Box = typename I::Box;
  static constexpr Dim N = dimension_of<Box>;
  using T = scalar_of<Box>;

  void run(std::size_t operations) {
    breath_ = test::soak_cycle(operations);
    for (std::size_t operation = 0; operation < operations; ++operation) {
      step(operation);
      ASSERT_TRUE(is_right_) << "at operation " << operation << ", " << judge_.size() << " boxes";
    }
    empty_all();
    ASSERT_TRUE(is_right_) << "when all boxes were erased";
    EXPECT_GE(breaths_, 4U);
  }

 private:
  struct Held {
    Key key;
    Key judged;
    Box box;
  };

  void require(bool holds) { is_right_ = is_right_ && holds; }
  double chance() { return numbers_.between(0, 1); }
  Vec<N, T> place() { return numbers_.point<N, T>(0, world_size); }
  std::size_t pick() { return static_cast<std::size_t>(numbers_.between(0, static_cast<double>(held_.size()))); }

  void step(std::size_t operation) {
    const double kind = chance();
    if (kind < 0.15) {
      compare_some();
    } else if (kind < 0.5 && !held_.empty()) {
      update();
    } else if (const bool grows = held_.size() < test::soak_target(operation, breath_, most_boxes);
               held_.empty() || (grows == (chance() < 0.9))) {
      insert();
    } else {
      erase(pick());
    }
    if (operation % breath_ == breath_ / 2) compare_whole();
    if (operation % breath_ == breath_ - 1) end_breath();
  }

  /// Mostly small; sometimes a point, long, on top of others, or with an infinite side.
  Box any_box() {
    const double kind = chance();
    if (kind < 0.05 && !held_.empty()) return held_[pick()].box;
    Box box{place(), {}};
    box.max = box.min + numbers_.point<N, T>(0, 1.5);
    if (kind < 0.10) box.max = box.min;
    if (kind > 0.98) box.max[0] += T(30);
    if (kind > 0.997) box.max[N - 1] = std::numeric_limits<T>::infinity();
    return box;
  }

  void insert() {
    const Box box = any_box();
    held_.push_back({index_.insert(box), judge_.insert(box), box});
    require(same_key(held_.back().key, held_.back().judged));
  }

  /// Most boxes only drift.
  void update() {
    Held& held = held_[pick()];
    const Vec<N, T> way = numbers_.point<N, T>(-0.2, 0.2);
    held.box = chance() < 0.1 ? any_box() : Box{held.box.min + way, held.box.max + way};
    index_.update(held.key, held.box);
    judge_.update(held.judged, held.box);
    require(index_.box(held.key) == held.box);
    if (chance() < 0.2) compare(any_corner(held.box));  // where a change may be overlooked
  }

  /// A finite corner of a box.
  Vec<N, T> any_corner(const Box& box) {
    Vec<N, T> corner = box.min;
    for (Dim i = 0; i < N; ++i) {
      if (chance() < 0.5 && box.max[i] < std::numeric_limits<T>::infinity()) corner[i] = box.max[i];
    }
    return corner;
  }

  void erase(std::size_t number) {
    const Held held = held_[number];
    index_.erase(held.key);
    judge_.erase(held.judged);
    require(!index_.contains(held.key));
    held_[number] = held_.back();
    held_.pop_back();
    require(index_.size() == held_.size());
  }

  template <class R>
  void compare(const R& region) {
    found_.clear();
    expected_.clear();
    index_.query(region, [this](const Key& key) { found_.push_back(key); });
    judge_.query(region, [this](const Key& key) { expected_.push_back(key); });
    std::sort(found_.begin(), found_.end());
    require(std::equal(found_.begin(), found_.end(), expected_.begin(), expected_.end(), same_key));
  }

  void compare_nearest() {
    const Vec<N, T> point = place();
    const auto count = static_cast<std::size_t>(numbers_.between(1, 12));
    const std::vector<Neighbour> found = index_.nearest(point, count);
    const std::vector<Neighbour> expected = judge_.nearest(point, count);
    require(std::equal(found.begin(), found.end(), expected.begin(), expected.end(),
                       [](const Neighbour& a, const Neighbour& b) {
                         return same_key(a.key, b.key) && a.distance_squared == b.distance_squared;
                       }));
  }

  template <class Index>
  static std::vector<std::pair<Key, double>> hits(const Index& index, const Ray<N, T>& ray, std::size_t most) {
    std::vector<std::pair<Key, double>> all;
    index.ray_cast(ray, [&all, most](const Key& key, double t) {
      all.emplace_back(key, t);
      return all.size() < most;
    });
    return all;
  }

  void compare_rays() {
    const Ray<N, T> ray{place(), numbers_.point<N, T>(-1, 1)};
    const std::size_t most = chance() < 0.5 ? 1 : held_.size() + 1;
    const auto found = hits(index_, ray, most);
    const auto expected = hits(judge_, ray, most);
    require(std::equal(found.begin(), found.end(), expected.begin(), expected.end(), [](const auto& a, const auto& b) {
      return same_key(a.first, b.first) && a.second == b.second;
    }));
  }

  void compare_some() {
    const double kind = chance();
    const Vec<N, T> point = place();
    const auto size = static_cast<T>(numbers_.between(0, 6));
    if (kind < 0.4) return compare(Box{point, point + size});
    if (kind < 0.5) return compare(Sphere<N, T>{point, size});
    if (kind < 0.6) return compare(Capsule<N, T>{point, place(), size * T(0.1)});
    if (kind < 0.8) return compare_nearest();
    compare_rays();
  }

  /// Compares every box, every pair, and the memory.
  void compare_whole() {
    compare(Box::everything());
    require(found_.size() == held_.size());
    std::vector<std::pair<Key, Key>> found;
    std::size_t next = 0;
    index_.pairs([&found](const Key& a, const Key& b) { found.emplace_back(a, b); });
    judge_.pairs([&](const Key& a, const Key& b) {
      require(next < found.size() && same_key(found[next].first, a) && same_key(found[next].second, b));
      ++next;
    });
    require(next == found.size());
    check_memory();
  }

  void empty_all() {
    while (!held_.empty()) erase(held_.size() / 2);
    require(index_.size() == 0 && judge_.size() == 0);
    compare(Box::everything());
    require(found_.empty() && index_.nearest(place(), 1).empty());
  }

  void end_breath() {
    empty_all();
    check_memory();
    ++breaths_;
  }

  /// Whether full or empty, an index never holds more memory than in its first cycle, apart from doubled capacity: each
  /// cycle has as many boxes as the first, or slightly more.
  void check_memory() {
    if (breaths_ == 0) first_bytes_ = std::max(first_bytes_, index_.bytes());
    require(index_.bytes() <= 2 * first_bytes_);
  }

  I index_;
  BruteForce<N, T> judge_;
  test::Numbers numbers_{20'261'122};
  std::vector<Held> held_;
  std::vector<Key> found_;
  std::vector<Key> expected_;
  std::size_t breath_ = 0;
  std::size_t breaths_ = 0;
  std::size_t first_bytes_ = 0;  // the maximum in the first cycle
  bool is_right_ = true;
};

template <class I>
class IndexSoak : public testing::Test {};

using Indexes = testing::Types<Bvh<2>, Bvh<3, double>, QuadTree<double>, Octree<>, Grid<2>, Grid<3, double>>;
TYPED_TEST_SUITE(IndexSoak, Indexes);

TYPED_TEST(IndexSoak, LosesNothingAndIsEmptyAtTheEnd) { Soak<TypeParam>().run(test::soak_operations()); }

}  // namespace
}  // namespace graze::index_soak_test
