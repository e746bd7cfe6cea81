// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <graze/io/log/logged_ids.hpp>

namespace graze::io::logged_ids_test {
namespace {

TEST(LoggedIds, TellTheScenesOwnFromOthersAndDefaults) {
  LoggedIds ids;
  ids.learn_from({0, 1, 77});
  EXPECT_EQ(ids.logged({4, 3, 77}), (ObjectId{4, 3, logged_scene}));
  EXPECT_EQ(ids.logged({4, 3, 76}), (ObjectId{4, 3, other_scene}));
  EXPECT_EQ(ids.logged(ObjectId{}), ObjectId{});
  EXPECT_EQ(ids.real({4, 3, logged_scene}), (ObjectId{4, 3, 77}));
  EXPECT_NE(ids.real({4, 3, other_scene}).owner, 77U);
  EXPECT_EQ(ids.real(ObjectId{}), ObjectId{});
}

TEST(LoggedIds, BeforeTheFirstOneAllAreOthers) {
  EXPECT_EQ(LoggedIds().logged({4, 3, 76}), (ObjectId{4, 3, other_scene}));
}

TEST(LoggedIds, AreTurnedInAllRowsOfAnAnswer) {
  LoggedIds ids;
  ids.learn_from({0, 1, 77});
  const LoggedAnswer answer = ids.logged(logged(std::vector<ObjectPair>{{{0, 1, 77}, {1, 1, 77}}}));
  EXPECT_EQ(answer.rows.front().ids, (std::vector<ObjectId>{{0, 1, logged_scene}, {1, 1, logged_scene}}));
}

}  // namespace
}  // namespace graze::io::logged_ids_test
