// SPDX-License-Identifier: MIT
// The manifolds that kernels write are bit-identical to those of single calls, with every instruction set; and the
// kernels leave few pairs, so that the comparison is meaningful.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <graze/broad/contacts.hpp>
#include <graze/broad/contacts/obb/obb_kernels.hpp>
#include <graze/broad/executor.hpp>
#include <graze/math/pose.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/manifold.hpp>
#include <graze/query/relation.hpp>
#include <graze/shape/any_shape.hpp>

#include "broad/same_manifolds.hpp"
#include "broad/simd_targets.hpp"

namespace graze::detail::manifold_kernels_test {
namespace {

template <class T>
using Boxes = std::vector<std::pair<Obb<3, T>, Obb<3, T>>>;

template <class T>
std::string text_of(const Obb<3, T>& box) {
  std::string text;
  for (const Vec<3, T>& v : {box.center, box.half_extents, box.axes[0], box.axes[1], box.axes[2]}) {
    for (Dim i = 0; i < 3; ++i) {
      char number[40];
      std::snprintf(number, sizeof(number), "%a, ", static_cast<double>(v[i]));
      text += number;
    }
  }
  return text;
}

/// Whether there is a kernel for this instruction set: it must have vectors of at least four doubles.
bool has_kernel([[maybe_unused]] std::int64_t target) {
#if defined(GRAZE_HAS_LANES) && HWY_ARCH_X86
  return target <= HWY_AVX2;  // better sets have lower bits
#else
  return false;
#endif
}

template <class T>
std::vector<ObbAxisTest> looks_at(std::span<const std::pair<Obb<3, T>, Obb<3, T>>> boxes) {
  std::vector<TwoObbs<T>> pairs;
  for (const auto& [a, b] : boxes) pairs.push_back({&a, &b});
  std::vector<ObbAxisTest> looks(boxes.size(), ObbAxisTest{~0U});  // a value that marks entries as unwritten
  obb_kernels<T>().look(pairs, FirstBox::in_order, looks.data());
  return looks;
}

/// Compares everything that a kernel writes with single calls. Returns the number of pairs it leaves.
template <class T>
std::size_t left_of(const Boxes<T>& boxes, const std::string& where) {
  std::size_t left_count = 0;
  for (std::size_t first = 0; first < boxes.size(); first += most_obbs_to_contact) {
    const std::size_t count = std::min(most_obbs_to_contact, boxes.size() - first);
    std::vector<Manifold<3, T>> found(count);
    const std::vector<ObbAxisTest> looks = looks_at<T>(std::span(boxes).subspan(first, count));
    std::vector<ObbsToContact<T>> pairs(count);
    for (std::size_t i = 0; i < count; ++i) {
      pairs[i] = {{&boxes[first + i].first, &boxes[first + i].second}, looks[i], &found[i]};
      EXPECT_FALSE(looks[i].is_apart()) << where;
    }
    std::vector<std::uint32_t> left(count);
    left.resize(obb_kernels<T>().contact(pairs, left.data()));
    left_count += left.size();
    std::vector<bool> is_left(count);
    for (const std::uint32_t place : left) {
      EXPECT_FALSE(is_left.at(place)) << where;
      is_left[place] = true;
    }
    for (std::size_t i = 0; i < count; ++i) {
      const auto& [a, b] = boxes[first + i];
      EXPECT_TRUE(is_left[i] || test::same_manifolds(found[i], manifold(a, b))) << where << '\n'
                                                                                << text_of(a) << '\n'
                                                                                << text_of(b);
    }
  }
  return left_count;
}

/// With every instruction set; at most this share may be left, if there is a kernel.
template <class T>
void expect_single_calls(const Boxes<T>& boxes, double most_left) {
  for (const std::int64_t target : test::simd_targets()) {
    const test::ForcedTarget forced(target);
    const std::size_t left = left_of<T>(boxes, hwy::TargetName(target));
    if (!has_kernel(target)) continue;
    EXPECT_LE(static_cast<double>(left), most_left * static_cast<double>(boxes.size())) << hwy::TargetName(target);
  }
}

/// Draws pairs of boxes that meet.
class Pairs {
 public:
  using V3 = Vec<3, double>;
  using Box = Obb<3, double>;
  using Two = std::pair<Box, Box>;

  explicit Pairs(std::uint32_t seed) : random_(seed) {}

  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
  V3 vector(double size) { return {number(-size, size), number(-size, size), number(-size, size)}; }
  V3 extents(double least) { return abs(vector(0.8)) + least; }

  Mat<3, double> rotation() {
    V3 axis = vector(1);
    while (dot(axis, axis) > 1 || dot(axis, axis) < 0.01) axis = vector(1);
    return rotation_matrix(axis, number(0, 360));
  }
  /// By multiples of 90 degrees, so that all numbers are 0, 1 or -1, like boxes in a warehouse.
  Mat<3, double> quarter_turn() {
    const int first = whole(0, 2);
    Mat<3, double> axes(0.0);
    axes[0][first] = whole(0, 1) == 0 ? 1 : -1;
    axes[1][(first + 1) % 3] = whole(0, 1) == 0 ? 1 : -1;
    axes[2] = cross(axes[0], axes[1]);
    return axes;
  }

  Two random() { return {{vector(0.6), extents(0.01), rotation()}, {vector(0.6), extents(0.01), rotation()}}; }

  /// One on the other, rotated by this about the vertical axis and slightly penetrating; then the stack is rotated as a
  /// whole.
  Two stack(const Mat<3, double>& turn, double sunk) {
    const Mat<3, double> all = rotation();
    const V3 half = extents(0.1);
    const V3 other = extents(0.1);
    const V3 off(number(-0.5, 0.5) * half.x, number(-0.5, 0.5) * half.y, half.z + other.z - sunk);
    const V3 place = vector(1);
    return {{place, half, all}, {place + all * off, other, all * turn}};
  }
  Two stack(double sunk) { return stack(rotation_matrix(V3(0, 0, 1), number(0, 360)), sunk); }
  Two leaning() { return stack(rotation_matrix(vector(1), number(-0.01, 0.01)), number(0, 0.02)); }
  /// Slightly tilted, with a depth smaller than the effect of the tilt.
  Two resting() {
    const double tilt = std::pow(10.0, number(-15, -4));
    const double yaw = whole(0, 2) == 0 ? 90 * whole(0, 3) : number(0, 360);
    const V3 about(number(-1, 1), number(-1, 1) + 0.01, 0);
    return stack(rotation_matrix(about, 57 * tilt) * rotation_matrix(V3(0, 0, 1), yaw), number(-0.5, 1) * tilt);
  }
  /// Bricks whose sides are coplanar up to rounding: one overlaps half of the other, or is larger, or rotated by 90
  /// degrees.
  Two flush() {
    const Mat<3, double> all = whole(0, 1) == 0 ? Mat<3, double>(1.0) : rotation();
    const V3 half = extents(0.1);
    const V3 other(half.x * whole(1, 3), half.y * whole(1, 2), half.z);
    const V3 off(half.x * whole(0, 1), half.y * whole(0, 1), half.z + other.z - 0.01);
    const V3 place = vector(1);
    return {{place, half, all}, {place + all * off, other, all * rotation_matrix(V3(0, 0, 1), 90 * whole(0, 3))}};
  }
  Two not_turned() { return stack(Mat<3, double>(1.0), number(0, 0.02)); }

  /// Axis-aligned, with equal sizes, so that nearly everything is a tie.
  Two in_grid() {
    const auto place = [this] { return V3(whole(-2, 2), whole(-2, 2), whole(-2, 2)) * 0.5; };
    const auto size = [this] { return V3(whole(1, 3), whole(1, 3), whole(1, 3)) * 0.5; };
    return {{place(), size(), quarter_turn()}, {place(), size(), quarter_turn()}};
  }

  /// Two crossing edges; each box is rotated by 45 degrees.
  Two edge_on_edge() {
    const Mat<3, double> all = rotation();
    const Mat<3, double> roof = rotation_matrix(V3(1, 0, 0), 45 + number(-10, 10));
    const Mat<3, double> across = rotation_matrix(V3(0, 0, 1), number(20, 160)) * roof;
    const double size = number(0.2, 1);
    const double other = number(0.2, 1);
    const V3 off(number(-0.1, 0.1), number(-0.1, 0.1), (size + other) * std::sqrt(2.0) * 0.98);
    return {{V3(0.0), V3(2, size, size), all * roof}, {all * off, V3(2, other, other), all * across}};
  }

  /// One box is nearly flat, or a needle, or very large compared with the other.
  Two uneven() {
    Two two = random();
    two.first.half_extents[whole(0, 2)] *= std::pow(10.0, number(-9, 0));
    two.second.half_extents *= std::pow(10.0, number(-5, 5));
    return two;
  }
  Two scaled() {
    Two two = whole(0, 1) == 0 ? random() : stack(0.01);
    const double scale = std::pow(2.0, whole(-40, 40));
    for (Box* box : {&two.first, &two.second}) *box = {box->center * scale, box->half_extents * scale, box->axes};
    return two;
  }
  Two same() {
    Two two = random();
    if (whole(0, 1) == 0) two.second = two.first;
    two.second.center = two.first.center;
    return two;
  }

  /// Pairs that meet.
  template <class T, class Draw>
  Boxes<T> many(std::size_t count, const Draw& draw) {
    Boxes<T> boxes;
    for (std::size_t tried = 0; boxes.size() < count && tried < 20 * count; ++tried) {
      const auto [a, b] = one<T>(draw);
      if (relation(a, b) != Relation::apart) boxes.push_back({a, b});
    }
    return boxes;
  }

  /// In either order.
  template <class T, class Draw>
  std::pair<Obb<3, T>, Obb<3, T>> one(const Draw& draw) {
    const auto stored = [](const Box& box) {
      return Obb<3, T>{Vec<3, T>(box.center), Vec<3, T>(box.half_extents), Mat<3, T>(box.axes)};
    };
    Two two = draw();
    if (whole(0, 1) == 0) std::swap(two.first, two.second);
    return {stored(two.first), stored(two.second)};
  }

 private:
  std::mt19937 random_;
};

template <class T>
void expect_most_taken() {
  Pairs pairs(20261121);
  const auto check = [&](const auto& draw, double most_left) {
    const Boxes<T> boxes = pairs.many<T>(1000, draw);
    ASSERT_EQ(boxes.size(), 1000U);
    expect_single_calls<T>(boxes, most_left);
  };
  check([&] { return pairs.random(); }, 0.02);
  check([&] { return pairs.stack(0.01); }, 0.02);
  check([&] { return pairs.not_turned(); }, 0.02);
  check([&] { return pairs.flush(); }, 0.02);
  check([&] { return pairs.leaning(); }, 0.1);
  check([&] { return pairs.resting(); }, 0.1);
  check([&] { return pairs.edge_on_edge(); }, 0.02);
}

TEST(ObbKernels, LeaveHardlyAnyPairs) {
  expect_most_taken<float>();
  expect_most_taken<double>();
}

/// The last group of a list may be incomplete, and a list may be empty.
TEST(ObbKernels, TakeAnyNumberOfPairs) {
  Pairs pairs(3);
  for (std::size_t count = 0; count < 20; ++count) {
    expect_single_calls<double>(pairs.many<double>(count, [&] { return pairs.random(); }), 1);
  }
}

template <class T>
void expect_single_calls_of_all_sorts() {
  Pairs pairs(*rc::gen::arbitrary<std::uint32_t>());
  const Boxes<T> boxes = pairs.many<T>(64, [&] {
    switch (pairs.whole(0, 8)) {
      case 0:
        return pairs.stack(pairs.number(0, 0.5));
      case 1:
        return pairs.stack(0);
      case 2:
        return pairs.leaning();
      case 3:
        return pairs.not_turned();
      case 4:
        return pairs.in_grid();
      case 5:
        return pairs.edge_on_edge();
      case 6:
        return pairs.uneven();
      case 7:
        return pairs.scaled();
      default:
        return pairs.same();
    }
  });
  expect_single_calls<T>(boxes, 1);
}

RC_GTEST_PROP(ObbKernels, SayOfAnyBoxesWhatSingleCallsDo, ()) {
  expect_single_calls_of_all_sorts<float>();
  expect_single_calls_of_all_sorts<double>();
}

/// Boxes whose distance or depth is at most this share of their size, or that are next to each other.
Pairs::Two about_to_touch(Pairs& pairs, double share) {
  const double gap = std::pow(pairs.number(0, 1), 4) * (pairs.whole(0, 1) == 0 ? share : -share);
  switch (pairs.whole(0, 4)) {
    case 0:
      return pairs.stack(gap);
    case 1:
      return pairs.in_grid();
    case 2:
      return pairs.scaled();
    case 3: {
      Pairs::Two two = pairs.edge_on_edge();
      two.second.center = two.first.center + (two.second.center - two.first.center) * (1 / 0.98 - gap);
      return two;
    }
    default: {
      Pairs::Two two = pairs.random();
      two.second.center += two.second.center - two.first.center;
      return two;
    }
  }
}

/// Some of them far from the origin.
template <class T>
Boxes<T> boxes_about_to_touch(Pairs& pairs, std::size_t count, double share) {
  Boxes<T> boxes;
  while (boxes.size() < count) {
    boxes.push_back(pairs.one<T>([&] {
      Pairs::Two two = about_to_touch(pairs, share);
      const Pairs::V3 away = pairs.vector(pairs.whole(0, 7) == 0 ? 1e6 : 0);
      for (Pairs::Box* box : {&two.first, &two.second}) box->center += away;
      return two;
    }));
  }
  return boxes;
}

/// Verdicts that an axis test calls certain agree with `relation`, for most boxes: returns the number of boxes for
/// which they are not certain.
template <class T>
std::size_t open_looks(const Boxes<T>& boxes, const std::string& where) {
  const std::vector<ObbAxisTest> looks = looks_at<T>(boxes);
  std::size_t open = 0;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const auto& [a, b] = boxes[i];
    const Relation said = relation(a, b);
    const bool is_right =
        (!looks[i].is_apart() || said == Relation::apart) && (!looks[i].is_overlapping() || said != Relation::apart);
    EXPECT_TRUE(is_right) << where << '\n' << text_of(a) << '\n' << text_of(b);
    EXPECT_LE(looks[i].axis(), ObbAxisTest::no_axis);
    open += looks[i].is_apart() || looks[i].is_overlapping() ? 0 : 1;
  }
  return open;
}

template <class T>
void expect_right_looks() {
  Pairs pairs(*rc::gen::arbitrary<std::uint32_t>());
  const double share = std::pow(10.0, pairs.number(-17, 0));
  const Boxes<T> boxes = boxes_about_to_touch<T>(pairs, 64, share);
  for (const std::int64_t target : test::simd_targets()) {
    const test::ForcedTarget forced(target);
    open_looks<T>(boxes, hwy::TargetName(target));
  }
}

RC_GTEST_PROP(ObbKernels, TakeForCertainOnlyWhatIsSo, ()) {
  expect_right_looks<float>();
  expect_right_looks<double>();
}

TEST(ObbKernels, KnowOfNearlyAllBoxesWhetherTheyMeet) {
  Pairs pairs(7);
  const Boxes<double> boxes = boxes_about_to_touch<double>(pairs, 1000, 1e-3);
  for (const std::int64_t target : test::simd_targets()) {
    const test::ForcedTarget forced(target);
    const std::size_t open = open_looks<double>(boxes, hwy::TargetName(target));
    EXPECT_LE(open, has_kernel(target) ? 400U : 1000U) << hwy::TargetName(target);
  }
}

/// Through `contacts`, which passes what a kernel leaves to the single call, together with pairs of other shapes.
template <class T>
void expect_contacts() {
  Pairs pairs(5);
  std::vector<AnyShape<3, T>> shapes;
  std::vector<Pair> candidates;
  const auto add = [&](const Boxes<T>& boxes) {
    for (const auto& [a, b] : boxes) {
      const auto place = static_cast<std::uint32_t>(shapes.size());
      shapes.insert(shapes.end(), {a, b, Sphere<3, T>{a.center, T(0.5)}});
      candidates.insert(candidates.end(), {{place, place + 1}, {place + 2, place}, {place + 1, place}});
    }
  };
  add(pairs.many<T>(150, [&] { return pairs.random(); }));
  add(pairs.many<T>(100, [&] { return pairs.in_grid(); }));
  for (const std::int64_t target : test::simd_targets()) {
    const test::ForcedTarget forced(target);
    const auto found = contacts(shapes, candidates, {.executor = &serial_executor()});
    ASSERT_EQ(found.size(), candidates.size());
    for (const PairContact<3, T>& contact : found) {
      EXPECT_TRUE(test::same_manifolds(contact.manifold, manifold(shapes[contact.pair.a], shapes[contact.pair.b])))
          << hwy::TargetName(target);
    }
  }
}

TEST(ObbKernels, ServeContacts) {
  expect_contacts<float>();
  expect_contacts<double>();
}

}  // namespace
}  // namespace graze::detail::manifold_kernels_test
