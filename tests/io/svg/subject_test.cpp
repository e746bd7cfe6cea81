// SPDX-License-Identifier: MIT
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <graze/io/svg/subject.hpp>

namespace graze::io::svg::svg_subject_test {
namespace {

/// Six spheres in a row, each of which overlaps the next and touches the one after: "a", "b", one without a name, "c",
/// "d", "e".
struct SvgSubject : ::testing::Test {
  SvgSubject() {
    for (const char* name : {"a", "b", "", "c", "d", "e"}) {
      ids.push_back(scene.add(Sphere<2, double>{{static_cast<double>(ids.size()), 0}, 1}, {.name = name}));
    }
  }

  Scene<2, double> scene;
  std::vector<ObjectId> ids;
};

TEST_F(SvgSubject, counts_partners_and_keeps_the_first_four) {
  std::vector<DrawnPair> pairs;
  for (std::uint32_t i = 1; i < ids.size(); ++i) pairs.push_back({0, i, Relation::touching});
  const std::vector<Touches> touches = touches_by_object(ids.size(), pairs);
  EXPECT_EQ(touches[0].count, 5U);
  EXPECT_EQ(touches[0].first, (std::array<std::uint32_t, 4>{1, 2, 3, 4}));
  EXPECT_EQ(touches[5].count, 1U);
  EXPECT_EQ(touches[5].first[0], 0U);
}

TEST_F(SvgSubject, knows_how_the_objects_of_a_pair_meet) {
  const std::vector<ObjectPair> pairs = {{ids[0], ids[1]}, {ids[1], ids[3]}, {ids[3], ids[5]}, {ids[4], ids[0]}};
  const Subject<2> subject = subject_of<2>(scene, pairs);
  EXPECT_EQ(subject.pairs, (std::vector<DrawnPair>{{0, 1, Relation::overlapping},
                                                   {1, 3, Relation::touching},
                                                   {3, 5, Relation::touching},
                                                   {4, 0, Relation::apart}}));
  std::vector<std::string> classes;
  for (const Touches& touches : subject.touches) classes.emplace_back(class_of(touches));
  EXPECT_EQ(classes, (std::vector<std::string>{"overlapping", "overlapping", "", "touching", "near", "touching"}));
  EXPECT_EQ(title(subject, 4), "d (sphere), is near a");
}

TEST_F(SvgSubject, speaks_of_positions_when_objects_were_removed) {
  scene.remove(ids[1]);
  const std::vector<ObjectPair> pairs = {{ids[2], ids[5]}};
  const Subject<2> subject = subject_of<2>(scene, pairs);
  ASSERT_EQ(subject.ids.size(), 5U);
  EXPECT_EQ(subject.names, (std::vector<std::string>{"a", "#2", "c", "d", "e"}));
  EXPECT_EQ(subject.touches[1].count, 1U);
  EXPECT_EQ(subject.touches[1].first[0], 4U);
  EXPECT_EQ(title(subject, 1), "#2 (sphere), is near e");
}

TEST_F(SvgSubject, titles_are_sentences) {
  const auto title_with = [&](std::size_t partners) {
    std::vector<ObjectPair> pairs;
    for (std::size_t i = 1; i <= partners; ++i) pairs.push_back({ids[0], ids[i]});
    scene.move(ids[0], Aabb<2, double>{{-1, -1}, {9, 1}});
    return title(subject_of<2>(scene, pairs), 0);
  };
  EXPECT_EQ(title_with(0), "a (aabb)");
  EXPECT_EQ(title_with(1), "a (aabb), touches b");
  EXPECT_EQ(title_with(2), "a (aabb), touches b and #2");
  EXPECT_EQ(title_with(4), "a (aabb), touches b, #2, c and d");
  EXPECT_EQ(title_with(5), "a (aabb), touches b, #2, c, d and 1 more");
}

TEST_F(SvgSubject, shortens_very_long_names) {
  scene.add(Vec<2, double>(0, 0), {.name = std::string(100'000, 'x')});
  EXPECT_EQ(subject_of<2>(scene, {}).names[6], std::string(79, 'x') + "…");
}

TEST_F(SvgSubject, refuses_pairs_of_objects_that_are_not_there) {
  scene.remove(ids[1]);
  const std::vector<ObjectPair> pairs = {{ids[0], ids[1]}};
  try {
    (void)subject_of<2>(scene, pairs);
    FAIL() << "nothing was thrown";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "write_svg: a touching pair names object 1 (generation 1), which is not in the scene");
  }
}

}  // namespace
}  // namespace graze::io::svg::svg_subject_test
