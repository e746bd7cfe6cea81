// SPDX-License-Identifier: MIT
// BruteForce is the reference for the other indexes, so it is compared with answers calculated by hand;
// spatial_index_laws.hpp has the rest.
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/brute_force.hpp>
#include <graze/shape/sphere.hpp>

namespace graze::brute_force_test {
namespace {

using Index = BruteForce<2, double>;

struct Row {
  Index index;
  Key a = index.insert({{0, 0}, {1, 1}});
  Key b = index.insert({{1, 1}, {2, 2}});  // touches a
  Key c = index.insert({{4, 0}, {5, 3}});
  Key d = index.insert({{4.5, 1}, {4.5, 1}});  // a point inside c
};

template <class R>
std::vector<Key> found(const Index& index, const R& region) {
  std::vector<Key> keys;
  index.query(region, [&keys](Key key) { keys.push_back(key); });
  return keys;
}

TEST(BruteForce, VisitsWhatMeetsTheRegionByKey) {
  const Row row;
  EXPECT_EQ(found(row.index, Aabb<2, double>{{2, 2}, {4, 3}}), (std::vector{row.b, row.c}));
  EXPECT_EQ(found(row.index, Vec<2, double>(4.5, 1)), (std::vector{row.c, row.d}));
  EXPECT_EQ(found(row.index, Sphere<2, double>{{3, 3}, 1.4}), (std::vector{row.c}));  // b's corner is at 1.414
  EXPECT_EQ(found(row.index, Sphere<2, double>{{3, 3}, 1.42}), (std::vector{row.b, row.c}));
  EXPECT_EQ(count(row.index, Aabb<2, double>::everything()), 4U);
  EXPECT_EQ(count(row.index, Aabb<2, double>::nothing()), 0U);
}

TEST(BruteForce, VisitsEveryPairOnce) {
  const Row row;
  std::vector<std::pair<Key, Key>> pairs;
  row.index.pairs([&pairs](Key a, Key b) { pairs.emplace_back(a, b); });
  EXPECT_EQ(pairs, (std::vector{std::pair{row.a, row.b}, std::pair{row.c, row.d}}));
}

TEST(BruteForce, HitsByTheRaysEntry) {
  const Row row;
  std::vector<std::pair<Key, double>> hits;
  const auto note = [&hits](Key key, double t) { hits.emplace_back(key, t); };
  row.index.ray_cast({{9, 1}, {-2, 0}}, note);  // meets a and b at their shared corner
  EXPECT_EQ(hits, (std::vector<std::pair<Key, double>>{{row.c, 2}, {row.d, 2.25}, {row.b, 3.5}, {row.a, 4}}));
}

TEST(BruteForce, UpdatesAndErases) {
  Row row;
  row.index.update(row.a, {{9, 9}, {9, 9}});
  row.index.erase(row.c);
  EXPECT_EQ(row.index.box(row.a), (Aabb<2, double>{{9, 9}, {9, 9}}));
  EXPECT_EQ(found(row.index, Aabb<2, double>::everything()), (std::vector{row.a, row.b, row.d}));
  EXPECT_EQ(row.index.nearest({9, 0}, 2), (std::vector<Neighbour>{{row.d, 21.25}, {row.b, 50}}));
  EXPECT_GT(row.index.bytes(), 0U);
}

}  // namespace
}  // namespace graze::brute_force_test
