// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <graze/scene/update/fat_boxes.hpp>

#include "spaces.hpp"

namespace graze::detail::rooms_test {
namespace {

/// Mostly ordinary numbers; all sizes if `is_wild`.
template <Dim N, class T>
std::vector<Aabb<N, T>> some_boxes(bool is_wild) {
  std::vector<Aabb<N, T>> boxes(*rc::gen::inRange<std::size_t>(0, 60));
  for (Aabb<N, T>& box : boxes) {
    for (Dim i = 0; i < N; ++i) {
      box.min[i] = static_cast<T>(*rc::gen::inRange(-1000, 1000)) / 8;
      if (is_wild) box.min[i] *= *rc::gen::element(T(0), T(1), T(1), T(1e-30), T(1e-44), T(1e30));
      box.max[i] = box.min[i] + static_cast<T>(*rc::gen::inRange(0, 100)) / 4;
    }
    if (is_wild && *rc::gen::inRange(0, 20) == 0) box.max[0] = std::numeric_limits<T>::infinity();
    if (is_wild && *rc::gen::inRange(0, 20) == 0) box = Aabb<N, T>::nothing();
  }
  return boxes;
}

template <class Space>
class Rooms : public testing::Test {};

TYPED_TEST_SUITE(Rooms, test::Spaces);

TYPED_TEST(Rooms, OfManyBoxesAreThoseOfEach) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  EXPECT_TRUE(rc::check([] {
    const std::vector<Aabb<N, T>> boxes = some_boxes<N, T>(*rc::gen::arbitrary<bool>());
    const T margin = *rc::gen::element(T(0), T(0.25), T(1e-3), T(1e10));
    std::vector<Aabb<N, T>> fat_boxes(boxes.size() + 1);
    std::vector<Aabb<N, T>> reaches(boxes.size() + 1);
    const T largest = make_fat_boxes(boxes.data(), boxes.size(), margin, fat_boxes.data(), reaches.data());
    T expected_largest = 0;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const Aabb<N, T> room{boxes[i].min - margin, boxes[i].max + margin};
      RC_ASSERT(fat_boxes[i] == room);
      RC_ASSERT(reaches[i] == touching_bounds(room));
      for (Dim k = 0; k < N; ++k) {
        expected_largest = std::max({expected_largest, finite_magnitude(room.min[k]), finite_magnitude(room.max[k])});
      }
    }
    RC_ASSERT(largest == expected_largest);
    RC_ASSERT(fat_boxes.back() == (Aabb<N, T>{}));
    RC_ASSERT(reaches.back() == (Aabb<N, T>{}));
  }));
}

}  // namespace
}  // namespace graze::detail::rooms_test
