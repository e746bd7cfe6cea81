// SPDX-License-Identifier: MIT
// The manifolds of a batch are those of single calls: for every pair of types, on hard cases.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/contacts.hpp>
#include <graze/broad/executor.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/manifold.hpp>
#include <graze/query/relation.hpp>
#include <graze/shape/any_shape.hpp>

#include "catalogue.hpp"
#include "query/every_pair.hpp"
#include "query/grazing_rays.hpp"
#include "thread_executor.hpp"

namespace graze::contacts_test {
namespace {

/// The shapes of the cases in twos, and candidates: each two, and each with the next two, which rarely meet.
template <Dim N, class T>
struct Cases {
  std::vector<AnyShape<N, T>> shapes;
  std::vector<Pair> candidates;

  static Cases of(test::CaseKind kind) {
    Cases cases;
    test::for_each_case<N, T>(
        kind, test::number_of_cases(4, 4), [&cases](const auto& pair) { cases.add(pair.first, pair.second); },
        [] { return true; });
    cases.choose_candidates();
    return cases;
  }

  static Cases of_grazing_rays() {
    Cases cases;
    test::check_property([&cases] {
      test::for_rays_past_a_shape<N, T>([&cases](const AnyShape<N, T>& shape, const Ray<N, T>& ray) {
        cases.add(shape, ray);
        cases.add(shape, test::beginning_of(ray));
        cases.add(compound_of<N, T>({shape}), ray);
      });
    });
    cases.choose_candidates();
    return cases;
  }

  void add(const AnyShape<N, T>& a, const AnyShape<N, T>& b) {
    if (is_valid(a) && is_valid(b)) shapes.insert(shapes.end(), {a, b});
  }

  void choose_candidates() {
    for (std::uint32_t i = 0; i + 3 < shapes.size(); i += 2) {
      for (const std::uint32_t step : {1U, 2U, 3U}) candidates.push_back({i, i + step});
      candidates.push_back({i + 1, i});  // in the other order, too
    }
  }

  std::vector<PairContact<N, T>> by_single_calls() const {
    std::vector<PairContact<N, T>> result;
    for (const Pair& pair : candidates) {
      if (relation(shapes[pair.a], shapes[pair.b]) == Relation::apart) continue;
      result.push_back({pair, manifold(shapes[pair.a], shapes[pair.b])});
    }
    return result;
  }
};

template <class Space>
class Contacts : public testing::Test {};
TYPED_TEST_SUITE(Contacts, test::Spaces);

TYPED_TEST(Contacts, AreThoseOfSingleCallsForEveryTwoTypesWhoeverRunsThem) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  const test::ThreadExecutor threads(3);
  for (std::size_t kind = 0; kind < test::case_kind_count; ++kind) {
    SCOPED_TRACE(std::string(test::case_kind_names[kind]));
    const auto cases = Cases<N, T>::of(static_cast<test::CaseKind>(kind));
    const std::vector<PairContact<N, T>> expected = cases.by_single_calls();
    EXPECT_GT(expected.size(), 256U);  // several tasks
    EXPECT_LT(expected.size(), cases.candidates.size());
    EXPECT_TRUE(contacts(cases.shapes, cases.candidates, {.executor = &serial_executor()}) == expected);
    EXPECT_TRUE(contacts(cases.shapes, cases.candidates, {.executor = &threads}) == expected);
    EXPECT_TRUE(contacts(cases.shapes, cases.candidates) == expected);
    for (const PairContact<N, T>& each : expected) EXPECT_GT(each.manifold.size, 0U);
  }
}

TYPED_TEST(Contacts, OfGrazingRaysAndSegmentsAreThoseOfSingleCalls) {
  const auto cases = Cases<TypeParam::dimension, typename TypeParam::scalar>::of_grazing_rays();
  const auto expected = cases.by_single_calls();
  EXPECT_GT(expected.size(), 256U);
  EXPECT_TRUE(contacts(cases.shapes, cases.candidates) == expected);
}

TYPED_TEST(Contacts, OfShapesKnownToTouchAreThoseOfSingleCallsToo) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  for (std::size_t kind = 0; kind < test::case_kind_count; ++kind) {
    SCOPED_TRACE(std::string(test::case_kind_names[kind]));
    const auto cases = Cases<N, T>::of(static_cast<test::CaseKind>(kind));
    const std::vector<PairContact<N, T>> expected = cases.by_single_calls();
    std::vector<PairContact<N, T>> found(expected.size());
    std::vector<detail::ShapesToContact<N, T>> pairs(expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      found[i].pair = expected[i].pair;
      pairs[i] = {{&cases.shapes[found[i].pair.a], &cases.shapes[found[i].pair.b]}, &found[i].manifold};
    }
    EXPECT_GT(pairs.size(), 256U);  // more than a kernel's batch
    detail::contacts_of<N, T>(pairs);
    EXPECT_TRUE(found == expected);
  }
}

TEST(Contacts, SayHowDeepAndWhereFromTheFirstToTheSecond) {
  const std::vector<AnyShape<2, double>> shapes{HalfSpace<2, double>{{0, 1}, 0}, Sphere<2, double>{{9, 9}, 1},
                                                Aabb<2, double>{{1, -0.25}, {3, 2}}};
  const auto found = contacts(shapes, std::vector<Pair>{{0, 1}, {0, 2}, {2, 0}});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].pair, (Pair{0, 2}));
  EXPECT_EQ(found[0].manifold.normal, (Vec<2, double>(0, 1)));
  ASSERT_EQ(found[0].manifold.size, 2U);
  EXPECT_EQ(found[0].manifold.points[0].depth, 0.25);
  EXPECT_EQ(found[1].pair, (Pair{2, 0}));
  EXPECT_EQ(found[1].manifold.normal, (Vec<2, double>(0, -1)));
}

TEST(Contacts, OfNoCandidatesAreNone) {
  EXPECT_TRUE(contacts(std::vector<AnyShape<3>>(2), std::vector<Pair>{}).empty());
  EXPECT_TRUE(contacts(std::vector<AnyShape<2>>{}, std::vector<Pair>{}).empty());
}

TEST(Contacts, RefuseAPairWhoseShapeIsNotThere) {
  const std::vector<AnyShape<3>> spheres(3, Sphere<3>{});
  try {
    contacts(spheres, std::vector<Pair>{{0, 1}, {3, 1}});
    FAIL() << "nothing was thrown";
  } catch (const std::out_of_range& error) {
    EXPECT_STREQ(error.what(), "contacts: pair 1 names shape 3, but there are only 3");
  }
}

}  // namespace
}  // namespace graze::contacts_test
