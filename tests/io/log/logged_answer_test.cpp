// SPDX-License-Identifier: MIT
#include <limits>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include <graze/io/log/logged_answer.hpp>
#include <graze/io/log/logged_call.hpp>

namespace graze::io::logged_answer_test {
namespace {

constexpr ObjectId a{0, 1, logged_scene};
constexpr ObjectId b{7, 3, logged_scene};

TEST(LoggedAnswer, IsALineOfJson) {
  EXPECT_EQ(answer_line({}), R"({"answer": []})");
  EXPECT_EQ(answer_line(logged(a)), R"({"answer": [[0, 1]]})");
  EXPECT_EQ(answer_line(logged(std::optional<ObjectId>())), R"({"answer": []})");
  EXPECT_EQ(answer_line(logged(Layer{3})), R"({"answer": [3]})");
  EXPECT_EQ(answer_line(logged(std::vector<ObjectId>{a, b})), R"({"answer": [[0, 1], [7, 3]]})");
  EXPECT_EQ(answer_line(logged(std::vector<ObjectPair>{{a, b}})), R"({"answer": [[[0, 1], [7, 3]]]})");
  EXPECT_EQ(answer_line(logged(std::vector<NearObject<float>>{{a, 0.5F}})), R"({"answer": [[[0, 1], 0.5]]})");
  EXPECT_EQ(answer_line(logged(SceneEvents{{{a, b}}, {}, {{a, a}}})),
            R"({"answer": [["began", [0, 1], [7, 3]], ["ended", [0, 1], [0, 1]]]})");
  EXPECT_EQ(answer_line({.refusal = "no \"b\""}), R"({"refused": "no \"b\""})");
}

TEST(LoggedAnswer, TellsWhereARayHitsAndWhereShapesTouch) {
  const std::vector<ObjectHit<2, double>> hits{{a, {{0.5, {1, 2}, {-1, 0}}}}};
  EXPECT_EQ(answer_line(logged(hits)), R"({"answer": [[[0, 1], 0.5, 1, 2, -1, 0]]})");
  EXPECT_EQ(answer_line(logged(std::optional<ObjectHit<2, double>>(hits.front()))), answer_line(logged(hits)));
  ObjectContact<2, double> contact{{a, b}, {}};
  contact.manifold.normal = {0, 1};
  contact.manifold.size = 1;
  contact.manifold.points[0].point_a = {3, 4};
  contact.manifold.points[0].point_b = {3, 2};
  contact.manifold.points[0].depth = std::numeric_limits<double>::infinity();
  EXPECT_EQ(answer_line(logged(std::vector<ObjectContact<2, double>>{contact})),
            R"({"answer": [[[0, 1], [7, 3], 0, 1, 3, 4, 3, 2, "inf"]]})");
}

TEST(LoggedAnswer, WritesIdsOfNobodyAndOfOtherScenes) {
  EXPECT_EQ(id_text({}), "null");
  EXPECT_EQ(id_text({0, 0, logged_scene}), "[0, 0]");
  EXPECT_EQ(id_text({4, 1, other_scene}), R"({"other_scene": [4, 1]})");
}

TEST(LoggedAnswer, SaysTheSameToTheBit) {
  const auto near = [](double distance) { return logged(std::vector<NearObject<double>>{{a, distance}}); };
  EXPECT_TRUE(say_the_same(near(0.1), near(0.1)));
  EXPECT_FALSE(say_the_same(near(0.0), near(-0.0)));
  EXPECT_FALSE(say_the_same(near(0.1), logged(a)));
  EXPECT_FALSE(say_the_same(logged(a), logged(b)));
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(say_the_same(near(nan), near(nan)));
  EXPECT_FALSE(say_the_same(logged(SceneEvents{{{a, b}}, {}, {}}), logged(SceneEvents{{}, {{a, b}}, {}})));
}

TEST(LoggedAnswer, OfRefusalsAsksNoMessage) {
  EXPECT_TRUE(say_the_same({.refusal = "one"}, {.refusal = "two"}));
  EXPECT_FALSE(say_the_same({.refusal = "one"}, {}));
}

TEST(LoggedAnswer, IsADigestWhereItIsLong) {
  EXPECT_EQ(digest_of({}), (AnswerDigest{0, 0xcbf29ce484222325U}));
  EXPECT_EQ(digest_of(logged(a).rows), (AnswerDigest{1, 0x580335a0c30570c2U}));  // of "[0, 1]\n", calculated elsewhere
  const LoggedAnswer many = logged(std::vector<ObjectId>(most_rows + 1, a));
  const AnswerDigest digest = digest_of(many.rows);
  EXPECT_EQ(answer_line(many).substr(0, 25), R"({"count": 65, "digest": ")");
  EXPECT_EQ(answer_line({.digest = digest}), answer_line(many));
  EXPECT_TRUE(say_the_same(many, {.digest = digest}));
  EXPECT_FALSE(say_the_same(logged(std::vector<ObjectId>(most_rows + 2, a)), {.digest = digest}));
  EXPECT_FALSE(say_the_same(logged(std::vector<ObjectId>(most_rows + 1, b)), {.digest = digest}));
  EXPECT_NE(answer_line(logged(std::vector<ObjectId>(most_rows, a))).find("[0, 1], [0, 1]"), std::string::npos);
}

}  // namespace
}  // namespace graze::io::logged_answer_test
