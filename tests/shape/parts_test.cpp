// SPDX-License-Identifier: MIT
#include <cstddef>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <graze/query/bounds.hpp>
#include <graze/query/intersects.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/compound.hpp>
#include <graze/shape/parts.hpp>

namespace graze::parts_test {
namespace {

using Any = AnyShape<2, double>;
using PartIn = Part<2, double>;

const Circle<double> far_circle{{1000, 0}, 1};

PartIn part_of(const Any& shape) { return {shape, bounds(shape)}; }

/// Circles in a row, enough for a tree.
Compound<2, double> row_of_circles(std::size_t count = 100) {
  std::vector<Any> circles;
  for (std::size_t i = 0; i < count; ++i) circles.push_back(Circle<double>{{3.0 * static_cast<double>(i), 0}, 1});
  return compound_of<2, double>(circles);
}

bool has_tree(const Compound<2, double>& compound) { return detail::tree_of(compound.parts) != nullptr; }

TEST(Parts, AreReadAsAVectorIs) {
  const Compound<2, double> compound{{part_of(Circle<double>{{0, 0}, 1}), part_of(far_circle)}};
  EXPECT_EQ(compound.parts.size(), 2u);
  EXPECT_FALSE(compound.parts.empty());
  EXPECT_EQ(&compound.parts.front(), &compound.parts[0]);
  EXPECT_EQ(&compound.parts.back(), &compound.parts.at(1));
  EXPECT_EQ(compound.parts.data(), &*compound.parts.begin());
  EXPECT_EQ(compound.parts.end() - compound.parts.begin(), 2);
  const std::vector<PartIn>& list = compound.parts;
  EXPECT_EQ(list.size(), 2u);
  EXPECT_TRUE(intersects(Compound<2, double>{list}, far_circle));
}

TEST(Parts, HaveATreeIfThereAreMany) {
  EXPECT_FALSE(has_tree(Compound<2, double>{}));
  EXPECT_FALSE(has_tree(row_of_circles(detail::least_parts_of_tree - 1)));
  EXPECT_TRUE(has_tree(row_of_circles(detail::least_parts_of_tree)));
}

TEST(Parts, ShareTheTreeWithCopies) {
  const Compound<2, double> compound = row_of_circles();
  const auto* const tree = detail::tree_of(compound.parts);
  Compound<2, double> copy = compound;
  EXPECT_EQ(detail::tree_of(std::as_const(copy).parts), tree);
  const Compound<2, double> moved = std::move(copy);
  EXPECT_EQ(detail::tree_of(moved.parts), tree);
  Compound<2, double> assigned = row_of_circles(40);
  assigned = moved;
  EXPECT_EQ(detail::tree_of(assigned.parts), tree);
  EXPECT_EQ(assigned.parts.size(), 100u);
}

/// Calls change(compound) for each way in which a program may move the first circle far away.
template <class Check>
void for_each_change(const Check& check) {
  check([](Compound<2, double>& compound) { compound.parts[0] = part_of(far_circle); });
  check([](Compound<2, double>& compound) { compound.parts.at(0) = part_of(far_circle); });
  check([](Compound<2, double>& compound) { compound.parts.front() = part_of(far_circle); });
  check([](Compound<2, double>& compound) { compound.parts.back() = part_of(far_circle); });
  check([](Compound<2, double>& compound) { *compound.parts.begin() = part_of(far_circle); });
  check([](Compound<2, double>& compound) { *(compound.parts.end() - 1) = part_of(far_circle); });
  check([](Compound<2, double>& compound) { *compound.parts.data() = part_of(far_circle); });
  check([](Compound<2, double>& compound) { compound.parts.edit().back() = part_of(far_circle); });
  check([](Compound<2, double>& compound) { compound.parts.push_back(part_of(far_circle)); });
  check([](Compound<2, double>& compound) { compound.parts.insert(compound.parts.begin(), part_of(far_circle)); });
  check([](Compound<2, double>& compound) {
    for (PartIn& part : compound.parts) part = part_of(far_circle);
  });
  check([](Compound<2, double>& compound) { compound.parts = {part_of(far_circle)}; });
}

TEST(Parts, AreFoundAfterAnyChange) {
  for_each_change([](const auto& change) {
    const Compound<2, double> before = row_of_circles();
    Compound<2, double> after = before;
    ASSERT_TRUE(has_tree(after));
    change(after);
    EXPECT_FALSE(has_tree(after));
    EXPECT_TRUE(intersects(after, far_circle));
    EXPECT_TRUE(has_tree(before));
    EXPECT_FALSE(intersects(before, far_circle));
  });
}

TEST(Parts, AreGoneAfterTheyAreRemoved) {
  const Circle<double> on_last{{297, 0}, 0.5};
  Compound<2, double> popped = row_of_circles();
  Compound<2, double> erased = popped;
  Compound<2, double> resized = popped;
  Compound<2, double> cleared = popped;
  EXPECT_TRUE(intersects(popped, on_last));
  popped.parts.pop_back();
  erased.parts.erase(erased.parts.end() - 1);
  resized.parts.reserve(1000);
  resized.parts.resize(99);
  cleared.parts.clear();
  for (const Compound<2, double>& compound : {popped, erased, resized, cleared}) {
    EXPECT_FALSE(intersects(compound, on_last));
    EXPECT_FALSE(has_tree(compound));
  }
}

TEST(Parts, AreNoLargerThanTheLargestOtherShape) { EXPECT_LE(sizeof(Compound<2, float>), sizeof(Obb<2, float>)); }

}  // namespace
}  // namespace graze::parts_test
