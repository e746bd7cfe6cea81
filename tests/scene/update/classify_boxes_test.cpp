// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <graze/scene/update/classify_boxes.hpp>

#include "spaces.hpp"

namespace graze::detail {
namespace {

/// The verdicts on pairs of boxes, one of which may not be a valid box.
struct Verdicts {
  std::vector<char> touches;
  std::vector<std::size_t> open;

  friend bool operator==(const Verdicts&, const Verdicts&) = default;
};

/// Scalar code with branches, one axis after the other.
template <Dim N, class T>
Verdicts plain_verdicts(const std::vector<Aabb<N, T>>& boxes, const std::vector<Pair>& pairs, T certain) {
  Verdicts verdicts;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const Aabb<N, T>& a = boxes[pairs[i].a];
    const Aabb<N, T>& b = boxes[pairs[i].b];
    bool is_deep = true;
    bool is_apart = false;
    for (Dim k = 0; k < N; ++k) {
      for (const T depth : {a.max[k] - b.min[k], b.max[k] - a.min[k]}) {
        is_deep = is_deep && depth > certain;
        is_apart = is_apart || !(depth >= -certain);
      }
    }
    verdicts.touches.push_back(is_deep ? 1 : 0);
    if (!is_deep && !is_apart) verdicts.open.push_back(i);
  }
  return verdicts;
}

template <Dim N, class T>
Verdicts verdicts_of(const std::vector<Aabb<N, T>>& boxes, const std::vector<Pair>& pairs, T certain) {
  Verdicts verdicts;
  verdicts.touches.resize(pairs.size());
  verdicts.open.resize(pairs.size() + 1);
  verdicts.open.resize(
      classify_boxes(boxes.data(), boxes.size() - 1, pairs, certain, verdicts.touches.data(), verdicts.open.data()));
  return verdicts;
}

/// Small integers, so that boxes often only touch; one more box than pairs name.
template <Dim N, class T>
std::vector<Aabb<N, T>> some_boxes() {
  const auto count = *rc::gen::inRange<std::size_t>(1, 40);
  std::vector<Aabb<N, T>> boxes(count + 1);
  for (Aabb<N, T>& box : boxes) {
    for (Dim i = 0; i < N; ++i) {
      box.min[i] = static_cast<T>(*rc::gen::inRange(-4, 5));
      box.max[i] = box.min[i] + static_cast<T>(*rc::gen::inRange(0, 4));
    }
    if (*rc::gen::inRange(0, 12) == 0) box = Aabb<N, T>::nothing();
    if (*rc::gen::inRange(0, 12) == 0) box.max[0] = std::numeric_limits<T>::infinity();
  }
  return boxes;
}

std::vector<Pair> some_pairs(std::size_t boxes) {
  const auto count = *rc::gen::inRange<std::size_t>(0, 80);
  std::vector<Pair> pairs(count);
  for (Pair& pair : pairs) {
    pair.a = static_cast<std::uint32_t>(*rc::gen::inRange<std::size_t>(0, boxes));
    pair.b = static_cast<std::uint32_t>(*rc::gen::inRange<std::size_t>(0, boxes));
  }
  return pairs;
}

template <class Space>
class JudgeBoxes : public testing::Test {};

TYPED_TEST_SUITE(JudgeBoxes, test::Spaces);

TYPED_TEST(JudgeBoxes, SaysOfEachPairWhatAPlainLoopSays) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  EXPECT_TRUE(rc::check([] {
    const std::vector<Aabb<N, T>> boxes = some_boxes<N, T>();
    const std::vector<Pair> pairs = some_pairs(boxes.size() - 1);
    const T certain = *rc::gen::element(T(0.5), T(1.5), T(1e-6));
    RC_ASSERT(verdicts_of(boxes, pairs, certain) == plain_verdicts(boxes, pairs, certain));
  }));
}

TYPED_TEST(JudgeBoxes, LeavesOpenWhatOnlyTouches) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  std::vector<Aabb<N, T>> boxes;
  for (int k = 0; k < 3; ++k) {
    const Vec<N, T> corner(static_cast<T>(k));
    boxes.push_back({corner, corner + T(1)});
  }
  boxes.push_back(boxes.back());
  const std::vector<Pair> pairs = {{0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 0}};
  const Verdicts verdicts = verdicts_of(boxes, pairs, T(1e-3));
  EXPECT_EQ(verdicts.touches, (std::vector<char>{0, 0, 1, 0, 0}));
  EXPECT_EQ(verdicts.open, (std::vector<std::size_t>{0, 3}));
}

TYPED_TEST(JudgeBoxes, LeavesOpenWhatIsNotItsBox) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  const std::vector<Aabb<N, T>> boxes(3, {Vec<N, T>(T(0)), Vec<N, T>(T(1))});
  const std::vector<Pair> pairs = {{0, 1}, {1, 1}};
  std::vector<char> touches(2);
  std::vector<std::size_t> open(3);
  const auto are_boxes = [](const Pair& pair) { return pair.a == 1 && pair.b == 1; };
  const std::size_t count =
      classify_bounds(boxes.data(), std::span<const Pair>(pairs), T(0.1), are_boxes, touches.data(), open.data());
  ASSERT_EQ(count, 1U);
  EXPECT_EQ(open[0], 0U);
  EXPECT_EQ(touches, (std::vector<char>{0, 1}));
}

}  // namespace
}  // namespace graze::detail
