// SPDX-License-Identifier: MIT
// Functions shared by the indexes. Their common contract is tested in spatial_index_laws.hpp.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/broad/brute_force.hpp>
#include <graze/broad/spatial_index.hpp>
#include <graze/query/relation.hpp>

#include "catalogue.hpp"

namespace graze::spatial_index_test {
namespace {

using detail::entry_of;

struct NoIndex {
  using Box = Aabb<2, float>;
  Key insert(const Box&) { return {}; }
};

TEST(SpatialIndex, IsAConcept) {
  EXPECT_TRUE((SpatialIndex<BruteForce<3, double>>));
  EXPECT_FALSE(SpatialIndex<NoIndex>);
  EXPECT_FALSE(SpatialIndex<int>);
}

TEST(SpatialIndex, VisitorsReturnNothingOrABool) {
  const auto nothing = [](Key) {};
  const auto boolean = [](Key) { return true; };
  const auto number = [](Key) { return 1; };
  EXPECT_TRUE((VisitorOf<decltype(nothing), Key>));
  EXPECT_TRUE((VisitorOf<decltype(boolean), Key>));
  EXPECT_FALSE((VisitorOf<decltype(number), Key>));
  EXPECT_FALSE((VisitorOf<decltype(nothing), Key, double>));
}

std::optional<double> enter(const Ray<2>& ray, const Aabb<2>& box) { return entry_of(ray, box); }

TEST(EntryOf, IsTheFirstPointOfTheBoxOnTheRay) {
  const Aabb<2> box{{1, 1}, {3, 2}};
  EXPECT_EQ(enter({{0, 0}, {1, 1}}, box), 1);
  EXPECT_EQ(enter({{0, 1.5F}, {0.25F, 0}}, box), 4);
  EXPECT_EQ(enter({{2, 1.5F}, {0, 7}}, box), 0);               // from inside
  EXPECT_EQ(enter({{3, 5}, {0, -1}}, box), 3);                 // along a side
  EXPECT_EQ(enter({{0, 0}, {3, 1}}, box), 1);                  // at a corner: (3, 1)
  EXPECT_EQ(enter({{0, 0}, {3, 0.999F}}, box), std::nullopt);  // just past it
  EXPECT_EQ(enter({{0, 1.5F}, {-1, 0}}, box), std::nullopt);   // behind
  EXPECT_EQ(enter({{3, 2}, {1, 1}}, box), 0);                  // leaves from a corner
  EXPECT_EQ(enter({{0, 3}, {1, 0}}, box), std::nullopt);       // beside
}

TEST(EntryOf, HasNoTroubleWithInfinity) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(enter({{0, 0}, {1, 0}}, {{2, -infinity}, {infinity, infinity}}), 2);
  EXPECT_EQ(enter({{0, 0}, {1, 0}}, Aabb<2>::everything()), 0);
  EXPECT_EQ(enter({{0, 0}, {1, 0}}, Aabb<2>::nothing()), std::nullopt);
  const Ray<2, double> steep{{0, 0}, {5e-324, 1}};
  EXPECT_EQ(entry_of(steep, Aabb<2, double>{{1, -1}, {2, 1}}), std::nullopt);  // t = 2e323
}

template <Dim N, class T>
void check_entry() {
  EXPECT_TRUE(rc::check([] {
    const auto [ray, box] = *test::any_pair<Ray<N, T>, Aabb<N, T>>();
    const std::optional<double> entry = entry_of<N, T>(ray, box);
    const Relation verdict = relation<Ray<N, T>, Aabb<N, T>>(ray, box);
    if (verdict == Relation::overlapping) RC_ASSERT(entry.has_value());
    if (verdict == Relation::apart) RC_ASSERT(!entry.has_value());
    if (!entry) return;
    Aabb<N, T> larger = box;
    larger.grow(*test::any<Vec<N, T>>());
    const std::optional<double> sooner = entry_of<N, T>(ray, larger);
    RC_ASSERT(sooner.has_value());
    RC_ASSERT(*sooner <= *entry);
  }));
}

TEST(EntryOf, AgreesWithIntersectsAndNeverComesLaterForALargerBox) {
  check_entry<2, float>();
  check_entry<3, float>();
  check_entry<2, double>();
  check_entry<3, double>();
}

TEST(NearestKeys, KeepsTheFirstOfAll) {
  detail::NearestKeys nearest(3);
  const auto key = [](std::uint32_t index) { return Key{index, 1, 1}; };
  EXPECT_EQ(nearest.reach(), std::numeric_limits<double>::infinity());
  for (const std::uint32_t index : {5U, 2U, 9U, 7U, 1U}) nearest.offer({key(index), index == 9 ? 1.0 : 4.0});
  EXPECT_EQ(nearest.reach(), 4);
  EXPECT_EQ(nearest.sorted(), (std::vector<Neighbour>{{key(9), 1}, {key(1), 4}, {key(2), 4}}));
}

TEST(NearestKeys, KeepsOthersInstead) {
  detail::NearestKeys nearest(2);
  EXPECT_EQ(nearest.wanted(), 2U);
  nearest.offer({{5, 1, 0}, 4});
  ASSERT_EQ(nearest.kept().size(), 1U);
  EXPECT_EQ(nearest.kept()[0], (Neighbour{{5, 1, 0}, 4}));
  const std::vector<Neighbour> others = {{{7, 1, 0}, 1}, {{6, 1, 0}, 3}};
  nearest.replace({others.data(), others.size()});
  EXPECT_EQ(nearest.reach(), 3);
  nearest.offer({{4, 1, 0}, 2});
  EXPECT_EQ(nearest.sorted(), (std::vector<Neighbour>{{{7, 1, 0}, 1}, {{4, 1, 0}, 2}}));
}

TEST(NearestKeys, OfFewAndOfManyAreTheFirstOfAllThatAreSorted) {
  std::vector<Neighbour> all;
  for (std::uint32_t k = 0; k < 200; ++k) all.push_back({{k * 77 % 200, 1, 1}, static_cast<double>(k * 31 % 40)});
  std::vector<Neighbour> sorted = all;
  std::sort(sorted.begin(), sorted.end(), [](const Neighbour& a, const Neighbour& b) {
    return a.distance_squared != b.distance_squared ? a.distance_squared < b.distance_squared : a.key < b.key;
  });
  for (const std::size_t k : {1U, 2U, 31U, 32U, 33U, 150U, 200U, 300U}) {
    detail::NearestKeys nearest(k);
    for (const Neighbour& neighbour : all) nearest.offer(neighbour);
    const std::size_t kept = std::min(k, all.size());
    EXPECT_EQ(nearest.reach(),
              k <= all.size() ? sorted[k - 1].distance_squared : std::numeric_limits<double>::infinity());
    EXPECT_EQ(nearest.sorted(),
              std::vector<Neighbour>(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(kept)))
        << k;
  }
}

}  // namespace
}  // namespace graze::spatial_index_test
