// SPDX-License-Identifier: MIT
// Pairs of 2D shapes are collected for the kernels of their kinds, in any order, and others are rejected.
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/contacts.hpp>
#include <graze/broad/contacts/2d/contacts.hpp>
#include <graze/math/pose.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/manifold.hpp>
#include <graze/query/relation.hpp>
#include <graze/shape/any_shape.hpp>

#include "broad/same_manifolds.hpp"

namespace graze::detail::flat_contacts_test {
namespace {

using Any = AnyShape<2, double>;

/// One shape of each type around a position, all of them overlapping.
std::vector<Any> some_shapes(const Vec<2, double>& place, double turn) {
  const Vec<2, double> x(1, 0);
  return {Sphere<2, double>{place, 0.5},
          Obb<2, double>{place + x * 0.3, {0.4, 0.7}, rotation_matrix(turn)},
          Aabb<2, double>{place - 0.35, place + 0.6},
          Capsule<2, double>{place - x * 0.2, place + Vec<2, double>(0.5, 0.3), 0.25},
          Triangle<2, double>{place, place + x, place + Vec<2, double>(0, 1)},
          Segment<2, double>{place - x, place + x}};
}

TEST(Pairs2d, TakeSpheresCapsulesAndBoxes) {
  const std::vector<Any> shapes = some_shapes({1, 2}, 30);
  constexpr std::size_t simple = 4;
  Pairs2d<double, 64> pairs;
  Manifold<2, double> manifold;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    for (std::size_t j = 0; j < shapes.size(); ++j) {
      EXPECT_EQ(pairs.add({&shapes[i], &shapes[j]}, &manifold, 0), i < simple && j < simple) << i << ", " << j;
    }
  }
}

/// All pairs in both orders, and more of a kind than a kernel's batch.
TEST(Pairs2d, ServeContacts) {
  std::vector<Any> shapes;
  for (int i = 0; i < 40; ++i) {
    const auto some = some_shapes(Vec<2, double>(0.01 * i, -0.003 * i), 11.0 * i);
    shapes.insert(shapes.end(), some.begin(), some.end());
  }
  std::vector<Pair> candidates;
  for (std::uint32_t a = 0; a < shapes.size(); ++a) {
    for (std::uint32_t b = a + 1; b < shapes.size(); ++b)
      candidates.push_back((a + b) % 2 == 0 ? Pair{a, b} : Pair{b, a});
  }
  const auto found = contacts(std::span<const Any>(shapes), candidates, {});
  ASSERT_GT(found.size(), candidates.size() / 2);
  for (const auto& one : found) {
    EXPECT_TRUE(test::same_manifolds(one.manifold, manifold(shapes[one.pair.a], shapes[one.pair.b])))
        << one.pair.a << ", " << one.pair.b;
  }
}

}  // namespace
}  // namespace graze::detail::flat_contacts_test
