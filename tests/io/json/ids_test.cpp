// SPDX-License-Identifier: MIT
#include <array>
#include <cstddef>
#include <sstream>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/io/json/ids.hpp>
#include <graze/io/json_scene.hpp>

#include "io/scene_text.hpp"

namespace graze::io::json_ids_test {
namespace {

using World = Scene<2, double>;

std::string saved(const World& scene) {
  std::ostringstream out;
  write_json_scene(out, {scene, "a.json", "test", YAxis::up, {}});
  return out.str();
}

World loaded(const std::string& text) { return std::get<World>(parse_json_scene(text, "a.json").scene); }

/// A scene with these fields in addition to the usual ones, and points with these ids.
std::string with_ids(const std::string& fields, const std::vector<std::string>& ids) {
  std::string objects;
  for (const std::string& id : ids) {
    objects += (objects.empty() ? "{" : ", {") + id + R"("type": "point", "position": [0, 0]})";
  }
  return R"({"schema": "graze.scene/1", "dimension": 2, )" + fields + R"("objects": [)" + objects + "]}";
}

TEST(JsonIds, TheExampleOfTheDocumentationGoesOnAsItSays) {
  const std::string page = text_of(project_file("docs/scene_format.md"));
  const std::string from_ids = page.substr(page.find("## Ids"));
  World scene = loaded(code_block(from_ids, "json"));
  EXPECT_EQ(scene.object(scene.find(3, 5).value()).name, "ball");
  EXPECT_EQ(scene.find("crate"), scene.find(1, 1));
  EXPECT_FALSE(scene.find(2, 3).has_value());
  EXPECT_FALSE(scene.find(3, 3).has_value());
  const ObjectId next = scene.add(Vec<2, double>(0, 0));
  EXPECT_EQ(next.index, 0U);
  EXPECT_EQ(next.generation, 3U);
  const ObjectId last = scene.add(Vec<2, double>(0, 0));
  EXPECT_EQ(last.index, 2U);
  EXPECT_EQ(last.generation, 5U);
  EXPECT_EQ(scene.add(Vec<2, double>(0, 0)).index, 4U);
}

TEST(JsonIds, ObjectsMayStandInAnyOrder) {
  const World scene = loaded(with_ids("", {R"("id": [1, 7], "name": "b", )", R"("id": [0, 1], "name": "a", )"}));
  EXPECT_EQ(scene.object(scene.ids()[0]).name, "a");
  EXPECT_EQ(scene.find(1, 7), scene.find("b"));
  EXPECT_EQ(scene.pairs().size(), 1U);
}

TEST(JsonIds, AreNotWrittenWhereReadingGivesTheSameAnyway) {
  World scene;
  const ObjectId a = scene.add(Vec<2, double>(0, 0), {.name = "a"});
  scene.add(Vec<2, double>(0, 0), {.name = "b", .mobility = Mobility::fixed});
  EXPECT_EQ(saved(scene).find("\"id\""), std::string::npos);
  EXPECT_NE(saved(scene).find("\"fixed\": true}"), std::string::npos);
  scene.remove(a);
  EXPECT_NE(saved(scene).find("  \"vacant_ids\": [[0, 2]],\n"), std::string::npos);
  EXPECT_NE(saved(scene).find("{\"id\": [1, 1], \"name\": \"b\", "), std::string::npos);
  scene.add(Vec<2, double>(0, 0));
  EXPECT_EQ(saved(scene).find("vacant_ids"), std::string::npos);
  EXPECT_NE(saved(scene).find("{\"id\": [0, 3], "), std::string::npos);
}

TEST(JsonIds, ThatCannotBeAreRefusedWithTheirPlace) {
  struct Row {
    std::string text;
    std::string says;
  };
  const std::string one = R"("id": [0, 1], )";
  const std::array<Row, 10> table = {{
      {with_ids("", {one, ""}), R"(object 1: there is no "id"; in a scene with saved ids every object has one)"},
      {with_ids(R"("vacant_ids": [], )", {""}), R"(object 0: there is no "id"; in a scene with saved ids every)"},
      {with_ids("", {one, one}), "object 1: the index 0 appears twice; ids must be unique"},
      {with_ids("", {R"("id": [1, 1], )"}), "object 0: the index 1 is too high; objects and vacant ids are 1 together"},
      {with_ids("", {R"("id": [0, 2], )"}), R"(object 0: "id" has the generation 2; that of an object is odd)"},
      {with_ids("", {R"("id": [0, 4294967295], )"}),
       R"(object 0: "id" has the generation 4294967295; the last of an object is 4294967293)"},
      {with_ids(R"("vacant_ids": [[1, 1]], )", {one}),
       R"("vacant_ids" has the generation 1; that of a vacant id is even)"},
      {with_ids("", {R"("id": [0, 1, 2], )"}), R"(object 0: "id" has 3 numbers; an id has two)"},
      {with_ids("", {R"("id": [0, 4294967297], )"}), R"(object 0: "id" has a number above 4294967295)"},
      {with_ids("", {R"("id": 5, )"}), R"(object 0: "id" must be an array, not a number)"},
  }};
  for (const Row& row : table) {
    const std::string message = error_of([&] { loaded(row.text); });
    EXPECT_NE(message.find(row.says), std::string::npos) << message;
    EXPECT_EQ(message.find("a.json: line 1, column "), 0U) << message;
  }
}

TEST(JsonIds, ThatArePlannedAndNotTakenYetArePlannedStillInASceneThatWasSaved) {
  const std::vector<ObjectId> next{{3, 1, 0}, {1, 5, 0}, {0, 1, 0}};
  const std::vector<ObjectId> vacant{{2, 4, 0}};
  for (std::size_t taken = 0; taken <= next.size(); ++taken) {
    World scene;
    scene.plan_ids(next, vacant);
    for (std::size_t k = 0; k < taken; ++k) scene.add(Vec<2, double>(0, 0), {.name = std::to_string(k)});
    World copy = loaded(saved(scene));
    EXPECT_EQ(saved(copy), saved(scene));
    for (std::size_t k = taken; k < next.size(); ++k) {
      const ObjectId id = copy.add(Vec<2, double>(0, 0));
      EXPECT_EQ(id, (ObjectId{next[k].index, next[k].generation, id.owner}));
    }
    const ObjectId again = copy.add(Vec<2, double>(0, 0));
    EXPECT_EQ(again, (ObjectId{2, 5, again.owner}));
    const ObjectId first = copy.add(Vec<2, double>(0, 0));
    EXPECT_EQ(first, (ObjectId{4, 1, first.owner}));
  }
}

TEST(JsonIds, APlaceIsUsedUpAtTheLastEvenGeneration) {
  World scene = loaded(with_ids(R"("vacant_ids": [[1, 4294967294], [2, 0]], )", {R"("id": [0, 4294967293], )"}));
  scene.remove(scene.find(0, 4294967293).value());
  EXPECT_NE(saved(scene).find(R"("vacant_ids": [[0, 4294967294], [1, 4294967294], [2, 0]])"), std::string::npos);
  EXPECT_EQ(scene.add(Vec<2, double>(0, 0)).index, 2U);
  EXPECT_EQ(scene.add(Vec<2, double>(0, 0)).index, 3U);
}

// After any sequence of calls: the same ids are alive, those of removed objects are not, and new objects get the same
// ids.
RC_GTEST_PROP(JsonIds, LiveOnInASceneThatWasSaved, ()) {
  World scene;
  if (*rc::gen::inRange(0, 2) > 0) {
    scene.plan_ids(std::vector<ObjectId>{{1, 3, 0}, {4, 1, 0}, {0, 1, 0}}, std::vector<ObjectId>{{3, 0, 0}, {2, 6, 0}});
  }
  std::vector<ObjectId> given;
  for (int step = *rc::gen::inRange(0, 40); step > 0; --step) {
    const std::vector<ObjectId> ids = scene.ids();
    if (ids.empty() || *rc::gen::inRange(0, 3) > 0) {
      given.push_back(scene.add(Vec<2, double>(step, 0), {.name = std::to_string(given.size()), .user = given.size()}));
    } else {
      scene.remove(ids[*rc::gen::inRange<std::size_t>(0, 1000) % ids.size()]);
    }
  }
  World copy = loaded(saved(scene));
  RC_ASSERT(saved(copy) == saved(scene));
  RC_ASSERT(copy.size() == scene.size());
  for (const ObjectId& id : given) {
    const auto same = copy.find(id.index, id.generation);
    RC_ASSERT(same.has_value() == scene.contains(id));
    if (same) RC_ASSERT(copy.object(*same).user == scene.object(id).user);
  }
  for (int k = 0; k < 9; ++k) {
    const ObjectId next = scene.add(Vec<2, double>(0, 0));
    const ObjectId same = copy.add(Vec<2, double>(0, 0));
    RC_ASSERT(same.index == next.index);
    RC_ASSERT(same.generation == next.generation);
  }
}

}  // namespace
}  // namespace graze::io::json_ids_test
