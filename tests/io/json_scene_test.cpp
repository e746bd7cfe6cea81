// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/io/json_scene.hpp>

#include "catalogue.hpp"
#include "scene_text.hpp"
#include "shape_bits.hpp"

namespace graze::io::json_scene_test {
namespace {

template <Dim N>
Scene<N, double> read_back(const Scene<N, double>& scene) {
  std::ostringstream out;
  write_json_scene(out, {scene, "a.json", "test", YAxis::up, {}});
  return std::get<Scene<N, double>>(parse_json_scene(out.str(), "a.json").scene);
}

/// Any finite double: every exponent is as likely as every other, and the ends of the range are common.
double wild_number(rc::Random& random) {
  using Limits = std::numeric_limits<double>;
  constexpr std::array<double, 10> ends = {0.0,
                                           -0.0,
                                           Limits::denorm_min(),
                                           -Limits::denorm_min(),
                                           Limits::min(),
                                           Limits::max(),
                                           -Limits::max(),
                                           1e308,
                                           1 + Limits::epsilon(),
                                           -1.0 / 3};
  if (random.next() % 3 == 0) return ends[random.next() % ends.size()];
  const double number = std::bit_cast<double>(random.next());
  return std::isfinite(number) ? number : 0.1;
}

template <Dim N>
bool holds_polytope(const AnyShape<N, double>& shape) {
  if (std::holds_alternative<Polytope<N, double>>(shape)) return true;
  const auto* compound = std::get_if<Compound<N, double>>(&shape);
  if (compound == nullptr) return false;
  return std::any_of(compound->parts.begin(), compound->parts.end(),
                     [](const Part<N, double>& part) { return holds_polytope<N>(part.shape); });
}

/// Valid shapes with extreme numbers. Without polygons: if products of coordinates overflow, rebuilding a hull may give
/// fewer corners.
template <Dim N>
rc::Gen<AnyShape<N, double>> wild_shape() {
  const auto number = test::drawn<double>(wild_number);
  const auto point = test::vector_of<N, double>(number);
  const test::Source<N, double> source{
      point, rc::gen::map(number, [](double x) { return std::fabs(x); }),
      rc::gen::suchThat(point, [](const Vec<N, double>& direction) { return max_abs(direction) > 0; })};
  return rc::gen::suchThat(test::any_shape_from<N, double>(source), [](const AnyShape<N, double>& shape) {
    return defect(shape).empty() && !(N == 2 && holds_polytope<N>(shape));
  });
}

template <Dim N>
void expect_round_trip(const std::vector<AnyShape<N, double>>& shapes) {
  Scene<N, double> scene;
  for (const AnyShape<N, double>& shape : shapes) scene.add(shape);
  const Scene<N, double> again = read_back(scene);
  RC_ASSERT(again.size() == shapes.size());
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    RC_ASSERT(bits_of<N>(again.object(again.ids()[i]).shape) == bits_of<N>(shapes[i]));
  }
}

RC_GTEST_PROP(JsonScene, ShapesIn2dSurviveTheRoundTripBitForBit, ()) {
  expect_round_trip<2>(*test::some<AnyShape<2, double>>(5, test::any_shape<2, double>()));
}

RC_GTEST_PROP(JsonScene, ShapesIn3dSurviveTheRoundTripBitForBit, ()) {
  expect_round_trip<3>(*test::some<AnyShape<3, double>>(5, test::any_shape<3, double>()));
}

RC_GTEST_PROP(JsonScene, NumbersAtTheEndsOfTheRangeSurviveIn2d, ()) { expect_round_trip<2>({*wild_shape<2>()}); }

RC_GTEST_PROP(JsonScene, NumbersAtTheEndsOfTheRangeSurviveIn3d, ()) { expect_round_trip<3>({*wild_shape<3>()}); }

RC_GTEST_PROP(JsonScene, NamesLayersMasksAndUserNumbersSurvive, (std::vector<std::uint64_t> masks)) {
  Scene<2, double> scene;
  for (const std::uint64_t mask : masks) {
    ObjectOptions options;
    options.name = *rc::gen::container<std::string>(rc::gen::inRange<char>(0, 127));
    if (scene.find(options.name)) options.name.clear();
    options.layer = static_cast<Layer>(mask % max_layers);
    options.mask = mask;
    options.user = mask * 3;
    scene.add(Vec<2, double>(0, 0), options);
  }
  const Scene<2, double> again = read_back(scene);
  RC_ASSERT(again.size() == scene.size());
  const std::vector<ObjectId> ids = scene.ids();
  const std::vector<ObjectId> ids_again = again.ids();
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const Object<2, double>& before = scene.object(ids[i]);
    const Object<2, double>& after = again.object(ids_again[i]);
    if (!before.name.empty()) RC_ASSERT(after.name == before.name);
    RC_ASSERT(after.layer == before.layer);
    RC_ASSERT(after.mask == before.mask);
    RC_ASSERT(after.user == before.user);
  }
}

TEST(JsonScene, WritingWhatWasReadChangesNoByte) {
  const SceneFile workshop = parse_json_scene(text_of(project_file("data/workshop.json")), "workshop.json");
  std::ostringstream first;
  write_json_scene(first, workshop);
  std::ostringstream second;
  write_json_scene(second, parse_json_scene(first.str(), "again.json"));
  EXPECT_EQ(first.str(), second.str());
}

TEST(JsonScene, TheExampleOfTheDocumentationIsRead) {
  const std::string example = code_block(text_of(project_file("docs/scene_format.md")), "json");
  const SceneFile file = parse_json_scene(example, "example.json");
  const auto& scene = std::get<Scene<2, double>>(file.scene);
  EXPECT_EQ(scene.size(), 5U);
  EXPECT_EQ(scene.layer_names(), (std::vector<std::string>{"walls", "player", "sensors"}));
  std::vector<std::pair<std::string, std::string>> pairs;
  for (const ObjectPair& pair : scene.pairs()) pairs.emplace_back(scene.object(pair.a).name, scene.object(pair.b).name);
  EXPECT_EQ(pairs, (std::vector<std::pair<std::string, std::string>>{{"ground", "hero"}, {"crate", "hero"}}));
}

/// The time to read a scene of this many spheres.
double seconds_to_read(int count) {
  std::string objects;
  for (int i = 0; i < count; ++i) {
    objects += (i == 0 ? "" : ",\n") + (R"({"name": "o)" + std::to_string(i)) +
               R"(", "type": "sphere", "center": [0.1234567890123456, -12.34, 1e-3], "radius": 0.25, "mask": ["a"]})";
  }
  const std::string text = scene_3d(objects);
  const auto begin = std::chrono::steady_clock::now();
  const SceneFile file = parse_json_scene(text, "a.json");
  const std::chrono::duration<double> duration = std::chrono::steady_clock::now() - begin;
  EXPECT_EQ((std::get<Scene<3, double>>(file.scene).size()), static_cast<std::size_t>(count));
  return duration.count();
}

TEST(JsonScene, EightTimesAsManyObjectsTakeAboutEightTimesAsLong) {
  // If the time were quadratic, the large scene would take 64 times as long. It depends on the machine and on
  // sanitizers: 4 microseconds to 0.2 milliseconds per object.
  const double few = seconds_to_read(5'000);
  EXPECT_LT(seconds_to_read(40'000), 32 * few + 0.5);
}

}  // namespace
}  // namespace graze::io::json_scene_test
