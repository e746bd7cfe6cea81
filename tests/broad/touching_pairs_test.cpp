// SPDX-License-Identifier: MIT
// Batch verdicts equal those of single calls: for every pair of types, on hard cases, with every instruction set of
// this machine.
#include <cmath>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/executor.hpp>
#include <graze/broad/touching_pairs.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/relation.hpp>
#include <graze/shape/any_shape.hpp>

#include "catalogue.hpp"
#include "query/every_pair.hpp"
#include "query/grazing_rays.hpp"
#include "simd_targets.hpp"
#include "thread_executor.hpp"

namespace graze::touching_pairs_test {
namespace {

/// Shapes in twos, and their pairs.
template <Dim N, class T>
struct Cases {
  std::vector<AnyShape<N, T>> shapes;
  std::vector<Pair> pairs;

  void add(const AnyShape<N, T>& a, const AnyShape<N, T>& b) {
    if (!is_valid(a) || !is_valid(b)) return;
    const auto at = static_cast<std::uint32_t>(shapes.size());
    shapes.insert(shapes.end(), {a, b});
    pairs.push_back({at, at + 1});
    pairs.push_back({at + 1, at});
  }
};

template <Dim N, class T>
Cases<N, T> cases_of(test::CaseKind kind, double usual) {
  Cases<N, T> cases;
  test::for_each_case<N, T>(
      kind, test::number_of_cases(usual), [&cases](const auto& pair) { cases.add(pair.first, pair.second); },
      [] { return true; });
  return cases;
}

template <Dim N, class T>
std::vector<Relation> single_calls(const std::vector<AnyShape<N, T>>& shapes, const std::vector<Pair>& pairs) {
  std::vector<Relation> result;
  for (const Pair& pair : pairs) result.push_back(relation(shapes[pair.a], shapes[pair.b]));
  return result;
}

template <class Space>
class TouchingPairs : public testing::Test {
 protected:
  static constexpr Dim dimension = Space::dimension;
  using scalar = typename Space::scalar;

  /// By every set of vector instructions that this machine has.
  static void expect_relations_of_single_calls(const Cases<dimension, scalar>& cases) {
    const std::vector<Relation> expected = single_calls(cases.shapes, cases.pairs);
    for (const std::int64_t target : test::simd_targets()) {
      const test::ForcedTarget forced(target);
      const std::vector<Relation> found =
          relations(std::span<const AnyShape<dimension, scalar>>(cases.shapes), std::span<const Pair>(cases.pairs));
      ASSERT_EQ(found.size(), expected.size());
      for (std::size_t i = 0; i < found.size(); ++i) {
        ASSERT_EQ(name_of(found[i]), name_of(expected[i]))
            << hwy::TargetName(target) << ": " << test::to_source(cases.shapes[cases.pairs[i].a]) << ", "
            << test::to_source(cases.shapes[cases.pairs[i].b]);
      }
    }
  }
};
TYPED_TEST_SUITE(TouchingPairs, test::Spaces);

TYPED_TEST(TouchingPairs, AreThoseOfSingleCallsForEveryTwoTypesAndInstructionSet) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  for (std::size_t kind = 0; kind < test::case_kind_count; ++kind) {
    SCOPED_TRACE(std::string(test::case_kind_names[kind]));
    TestFixture::expect_relations_of_single_calls(cases_of<N, T>(static_cast<test::CaseKind>(kind), 12));
  }
}

TYPED_TEST(TouchingPairs, OfGrazingRaysAndSegmentsAreThoseOfSingleCalls) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  Cases<N, T> cases;
  test::check_property([&cases] {
    test::for_rays_past_a_shape<N, T>([&cases](const AnyShape<N, T>& shape, const Ray<N, T>& ray) {
      cases.add(shape, ray);
      cases.add(shape, test::beginning_of(ray));
      cases.add(compound_of<N, T>({shape}), ray);
    });
  });
  TestFixture::expect_relations_of_single_calls(cases);
}

/// Shapes of one type from the cases, each paired with the next.
template <class S, Dim N, class T>
void expect_those_of_single_calls(const Cases<N, T>& cases) {
  std::vector<S> shapes;
  for (const AnyShape<N, T>& shape : cases.shapes) {
    if (const S* held = std::get_if<S>(&shape)) shapes.push_back(*held);
  }
  std::vector<Pair> candidates;
  std::vector<Pair> expected;
  for (std::uint32_t i = 0; i < shapes.size(); ++i) {
    for (std::uint32_t j = i + 1; j < shapes.size() && j < i + 9; ++j) {
      candidates.push_back({i, j});
      if (relation(shapes[i], shapes[j]) != Relation::apart) expected.push_back({i, j});
    }
  }
  EXPECT_GT(expected.size(), 0U);
  for (const std::int64_t target : test::simd_targets()) {
    const test::ForcedTarget forced(target);
    EXPECT_EQ(touching_pairs(shapes, candidates), expected) << hwy::TargetName(target);
  }
}

TYPED_TEST(TouchingPairs, OfShapesOfOneTypeAreTheSame) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  for (const test::CaseKind kind : {test::CaseKind::uniform, test::CaseKind::grid, test::CaseKind::nearly_parallel}) {
    const Cases<N, T> cases = cases_of<N, T>(kind, 12);
    expect_those_of_single_calls<Sphere<N, T>>(cases);
    expect_those_of_single_calls<Aabb<N, T>>(cases);
    expect_those_of_single_calls<Obb<N, T>>(cases);
    expect_those_of_single_calls<Capsule<N, T>>(cases);
  }
}

TYPED_TEST(TouchingPairs, DoNotDependOnTheExecutor) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  const Cases<N, T> cases = cases_of<N, T>(test::CaseKind::uniform, 12);
  std::vector<Pair> candidates;  // enough for several tasks
  for (std::uint32_t step = 1; step < 12; ++step) {
    for (std::uint32_t i = 0; i + step < cases.shapes.size(); ++i) candidates.push_back({i, i + step});
  }
  const std::vector<Pair> alone = touching_pairs(cases.shapes, candidates, {.executor = &serial_executor()});
  EXPECT_GT(alone.size(), 100U);
  EXPECT_LT(alone.size(), candidates.size());
  const test::ThreadExecutor threads(3);
  EXPECT_EQ(touching_pairs(cases.shapes, candidates, {.executor = &threads}), alone);
  EXPECT_EQ(touching_pairs(cases.shapes, candidates), alone);
}

/// From some number on, shapes are prefetched, also for pairs after the last whole group.
TEST(TouchingPairs, DoNotDependOnHowManyShapesThereAre) {
  std::vector<Obb<3>> boxes(40'000);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    boxes[i].center = {static_cast<float>(i % 200), static_cast<float>(i / 200), 0};
    boxes[i].half_extents = {0.3F + 0.4F * static_cast<float>(i % 3), 0.2F, 0.2F};
  }
  std::vector<Pair> candidates;
  std::vector<Pair> expected;
  for (std::uint32_t i = 0; i + 777 < boxes.size(); i += 777) {
    for (const std::uint32_t step : {1U, 2U, 777U}) candidates.push_back({i, i + step});
  }
  for (const Pair& pair : candidates) {
    if (relation(boxes[pair.a], boxes[pair.b]) != Relation::apart) expected.push_back(pair);
  }
  EXPECT_NE(candidates.size() % 16, 0U);
  EXPECT_GT(expected.size(), 20U);
  EXPECT_LT(expected.size(), candidates.size());
  EXPECT_EQ(touching_pairs(boxes, candidates), expected);
  EXPECT_EQ(touching_pairs(std::vector<AnyShape<3>>(boxes.begin(), boxes.end()), candidates), expected);
}

/// More pairs than a task takes, and more undecided ones than are retried in one batch.
TEST(TouchingPairs, AreThoseOfSingleCallsWhereManyNearlyTouch) {
  std::vector<Obb<3>> boxes(6000);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const float gap = 1e-3F * static_cast<float>(static_cast<int>(i % 7) - 3);
    boxes[i] = {{static_cast<float>(i), 0, 0}, {0.5F - gap, 1, 1}, Obb<3>().axes};
  }
  std::vector<Pair> candidates;
  std::vector<Pair> expected;
  for (std::uint32_t i = 0; i + 1 < boxes.size(); ++i) {
    candidates.push_back({i, i + 1});
    if (relation(boxes[i], boxes[i + 1]) != Relation::apart) expected.push_back({i, i + 1});
  }
  EXPECT_GT(expected.size(), 2000U);
  EXPECT_LT(expected.size(), 4000U);
  for (const std::int64_t target : test::simd_targets()) {
    const test::ForcedTarget forced(target);
    EXPECT_EQ(touching_pairs(boxes, candidates), expected) << hwy::TargetName(target);
  }
}

TEST(TouchingPairs, OfNoCandidatesAreNone) {
  EXPECT_TRUE(touching_pairs(std::vector<Sphere<3>>(2), std::vector<Pair>{}).empty());
  EXPECT_TRUE(touching_pairs(std::vector<AnyShape<2>>{}, std::vector<Pair>{}).empty());
}

TEST(TouchingPairs, RefuseAPairWhoseShapeIsNotThere) {
  const std::vector<Obb<3>> boxes(3);
  const std::vector<Pair> pairs{{0, 1}, {1, 3}};
  try {
    touching_pairs(boxes, pairs);
    FAIL() << "nothing was thrown";
  } catch (const std::out_of_range& error) {
    EXPECT_STREQ(error.what(), "touching_pairs: pair 1 names shape 3, but there are only 3");
  }
  for (const std::uint32_t absent : {3U, 0x7FFFFFFFU, 0x80000000U, 0x80000002U, 0x80000003U, 0xFFFFFFFFU}) {
    EXPECT_THROW(touching_pairs(boxes, std::vector<Pair>{{0, absent}}), std::out_of_range) << absent;
    EXPECT_THROW(touching_pairs(boxes, std::vector<Pair>{{absent, 0}}), std::out_of_range) << absent;
  }
  EXPECT_THROW(touching_pairs(std::vector<Obb<3>>(), std::vector<Pair>{{0, 0}}), std::out_of_range);
  EXPECT_EQ(touching_pairs(boxes, std::vector<Pair>{{0, 2}}).size(), 1U);
}

}  // namespace
}  // namespace graze::touching_pairs_test
