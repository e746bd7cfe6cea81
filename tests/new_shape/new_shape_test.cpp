// SPDX-License-Identifier: MIT
// What graze supports for a cone, which is added in three places: its header, the alternatives of AnyShape, and the
// entry of the catalogue below.
#include <limits>
#include <string>
#include <string_view>
#include <variant>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/io/input_error.hpp>
#include <graze/io/json/document.hpp>
#include <graze/io/json/fields.hpp>
#include <graze/io/json/shape_reader.hpp>
#include <graze/io/json/shape_writer.hpp>
#include <graze/io/shape_numbers.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/contains.hpp>
#include <graze/query/distance.hpp>
#include <graze/query/relation.hpp>
#include <graze/query/transformed.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/nan_check.hpp>
#include <graze/shape/fields/shape_order.hpp>

#include "catalogue.hpp"

namespace graze::test {

template <Dim N, class T>
struct Entry<Cone<N, T>> : Generated<Cone<N, T>, N, T> {
  static constexpr std::string_view name = "Cone";
  static Cone<N, T> draw(const Source<N, T>& from) { return {*from.point, *from.point, *from.size}; }
  static Vec<N, double> point_in(const Cone<N, T>& cone, const Vec<N, double>& w) {
    return Entry<Segment<N, T>>::point_in({cone.tip, cone.base}, w);
  }
};

namespace new_shape_test {
namespace {

using V = Vec<3, double>;
using Cone3 = Cone<3, double>;
using Any = AnyShape<3, double>;

/// Its tip at z = 4, its base a disc of radius 3 on the floor.
const Cone3 cone{V(0, 0, 4), V(0, 0, 0), 3};
const std::string cone_text = R"("type": "cone", "tip": [0, 0, 4], "base": [0, 0, 0], "radius": 3)";

Any read(const std::string& members) {
  const std::string text = "{" + members + "}";
  const io::JsonDocument document(text, "test");
  return io::read_json_shape<3>(document.root(), io::JsonPlace{document}, {});
}

std::string written(const Any& shape) {
  std::string text;
  io::append_json_shape<3>(text, shape);
  return text;
}

std::string error_of(const std::string& members) {
  try {
    read(members);
  } catch (const io::InputError& error) {
    return error.what();
  }
  return "";
}

TEST(NewShape, HasItsNameAtItsPlace) {
  EXPECT_EQ(type_name(Any(cone)), "cone");
  EXPECT_EQ(shape_type_names[Any(cone).index()], "cone");
  EXPECT_EQ(shape_type_names.size(), std::variant_size_v<Any>);
}

TEST(NewShape, IsWrittenAndReadByTheNamesOfItsFields) {
  EXPECT_EQ(written(cone), cone_text);
  EXPECT_EQ(written(read(cone_text)), cone_text);
  const std::string compound = R"("type": "compound", "parts": [{)" + cone_text + "}]";
  EXPECT_EQ(written(read(compound)), compound);
}

TEST(NewShape, IsReadWithTheErrorsOfTheOthers) {
  EXPECT_EQ(error_of(R"("type": "cone", "tip": [0, 0, 1], "base": [0, 0, 0])"),
            R"(test: line 1, column 1: a cone needs the field "radius")");
  EXPECT_EQ(error_of(R"("type": "cone", "tip": [0, 0, 1], "base": [0, 0, 0], "radius": -1)"),
            R"(test: line 1, column 65: "radius" is -1; it must not be negative)");
  EXPECT_EQ(error_of(R"("type": "con")"), R"(test: line 1, column 10: unknown type "con"; did you mean "cone"?)");
}

TEST(NewShape, EveryRandomShapeComesBackAsItWasWritten) {
  check_property([] {
    const Any shape = *any_shape<3, double>();
    RC_ASSERT(written(read(written(shape))) == written(shape));
    RC_ASSERT((detail::compare<3, double>(read(written(shape)), shape)) == 0);
  });
}

TEST(NewShape, HasTheDefectsOfItsFields) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(defect(Any(cone)), "");
  EXPECT_EQ(defect(Cone3{V(0, nan, 0), V(0), 1}), "has a tip that is not finite");
  EXPECT_EQ(defect(Cone3{V(1), V(nan), 1}), "has a base that is not finite");
  EXPECT_EQ(defect(Cone3{V(1), V(0), -1}), "has a negative radius");
  EXPECT_TRUE(detail::any_nan(cone, Cone3{V(1), V(0), nan}));
  EXPECT_FALSE(detail::any_nan(cone, Sphere<3, double>{}));
}

TEST(NewShape, HasAPlaceInTheOrderOfShapes) {
  EXPECT_EQ(detail::compare(cone, cone), 0);
  EXPECT_EQ(detail::compare(cone, Cone3{cone.tip, cone.base, 4}), -1);
  EXPECT_EQ((detail::compare<3, double>(Any(cone), Any(Polytope<3, double>()))), 1);
  EXPECT_EQ((detail::compare<3, double>(Any(cone), Any(Compound<3, double>()))), -1);
}

TEST(NewShape, IsConvertedScaledAndMoved) {
  const AnyShape<3, float> narrow = io::with_numbers<float, 3, double>(cone);
  EXPECT_EQ((std::get<Cone<3, float>>(narrow).radius), 3.0F);
  const Cone3 twice = detail::scaled(cone, detail::PowerOfTwo(1));
  EXPECT_EQ(twice.tip, V(0, 0, 8));
  EXPECT_EQ(twice.radius, 6);
  const Any moved = translated<3, double>(cone, V(1, 2, 3));
  EXPECT_EQ(std::get<Cone3>(moved).tip, V(1, 2, 7));
  EXPECT_EQ(std::get<Cone3>(moved).radius, 3);
}

TEST(NewShape, TouchesWhatItsSupportPointsTouch) {
  EXPECT_EQ(relation(cone, Sphere<3, double>{V(0, 0, 6), 1}), Relation::apart);
  EXPECT_EQ(relation(cone, Sphere<3, double>{V(0, 0, 5), 1}), Relation::touching);
  EXPECT_EQ(relation(Sphere<3, double>{V(0, 0, 4.5), 1}, cone), Relation::overlapping);
  EXPECT_EQ(relation(cone, HalfSpace<3, double>{V(0, 0, 1), 0}), Relation::touching);
  EXPECT_EQ(relation(cone, Ray<3, double>{V(-9, 0, 3), V(1, 0, 0)}), Relation::overlapping);
  EXPECT_EQ(relation(cone, Cone3{V(0, 0, 5), V(0, 0, 9), 3}), Relation::apart);
  EXPECT_TRUE(contains(Any(cone), V(1.4, 0, 2)));
  EXPECT_FALSE(contains(Any(cone), V(1.6, 0, 2)));
}

TEST(NewShape, HasDistancesAndContacts) {
  EXPECT_NEAR(distance(cone, Sphere<3, double>{V(0, 0, 7), 1}), 2, 1e-12);
  EXPECT_NEAR(distance(cone, Cone3{V(0, 0, 5), V(0, 0, 9), 3}), 1, 1e-12);
  // The slope has the normal (4, 0, 3) / 5, and the plane 4 x + 3 z = 12.
  EXPECT_NEAR(distance(cone, V(4, 0, 3)), 13.0 / 5, 1e-12);
  const auto contact_of_tip = contact(cone, HalfSpace<3, double>{V(0, 0, -1), -3.5});
  ASSERT_TRUE(contact_of_tip);
  EXPECT_NEAR(contact_of_tip->depth, 0.5, 1e-12);
  const auto contact_of_sphere = contact(cone, Sphere<3, double>{V(2, 0, 8.0 / 3), 2.5});
  ASSERT_TRUE(contact_of_sphere);
  EXPECT_NEAR(contact_of_sphere->depth, 2.5 - 4.0 / 5, 1e-3);
}

}  // namespace
}  // namespace new_shape_test
}  // namespace graze::test
