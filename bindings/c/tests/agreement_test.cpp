// SPDX-License-Identifier: MIT
// The answers of the C interface are those of C++, bit for bit, for random shapes of every two types in every world.
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <graze.h>
#include <gtest/gtest.h>

#include <graze/broad/touching_pairs.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/closest_boundary_point.hpp>
#include <graze/query/closest_point.hpp>
#include <graze/query/closest_points.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/contains.hpp>
#include <graze/query/distance.hpp>
#include <graze/query/intersects.hpp>
#include <graze/query/manifold.hpp>
#include <graze/query/mass_properties.hpp>
#include <graze/query/ray_cast.hpp>
#include <graze/query/relation.hpp>
#include <graze/query/separation.hpp>
#include <graze/query/shape_cast.hpp>
#include <graze/query/signed_distance.hpp>
#include <graze/query/time_of_impact.hpp>
#include <graze/scene/scene.hpp>

#include "catalogue.hpp"
#include "in_c.hpp"
#include "numbers.hpp"

namespace graze::test::agreement_test {
namespace {

/// Calls check(a, b, a and b in C, point, direction) for shapes of every two types.
template <class Space, class Check>
void for_random_pairs(int rounds, const Check& check) {
  constexpr Dim N = Space::dimension;
  using T = typename Space::scalar;
  constexpr std::size_t types = number_of_types<N, T>;
  struct Case {
    AnyShape<N, T> a, b;
    Vec<N, T> point, direction;
  };
  rc::Random random(20261129 + static_cast<std::uint64_t>(N));
  for (std::size_t k = 0; k < types * types * static_cast<std::size_t>(rounds); ++k) {
    const auto gen = rc::gen::exec([k] {
      const Source<N, T> from = draw_source<N, T>();
      return Case{draw_shape_at<N, T>(k % types, from), draw_shape_at<N, T>(k / types % types, from), *from.point,
                  *from.direction};
    });
    const Case drawn = gen(random.split(), 50).value();
    const ShapeOfC<N, T> a(drawn.a);
    const ShapeOfC<N, T> b(drawn.b);
    check(drawn, *a, *b);
    if (testing::Test::HasFailure()) {
      FAIL() << "case " << k << ": " << type_name(drawn.a) << " and " << type_name(drawn.b);
    }
  }
}

/// The numbers of an answer in C, if there is one.
template <class Answer>
std::optional<Numbers> answer_of(graze_status status, const Answer& answer) {
  EXPECT_TRUE(status == GRAZE_OK || status == GRAZE_NONE) << graze_error_message();
  if (status == GRAZE_NONE) return std::nullopt;
  return numbers_of(answer);
}

template <class Answer>
std::optional<Numbers> answer_of(const std::optional<Answer>& answer) {
  if (!answer) return std::nullopt;
  return numbers_of(*answer);
}

template <class Space>
class CInterface : public testing::Test {};
TYPED_TEST_SUITE(CInterface, Spaces);

TYPED_TEST(CInterface, AnswersAboutTwoShapes) {
  for_random_pairs<TypeParam>(30, [](const auto& drawn, const graze_shape& a, const graze_shape& b) {
    graze_relation verdict = -1;
    ASSERT_EQ(graze_relation_of(&a, &b, &verdict), GRAZE_OK) << graze_error_message();
    EXPECT_EQ(verdict, static_cast<graze_relation>(relation(drawn.a, drawn.b)));
    bool is_touching = false;
    ASSERT_EQ(graze_intersects(&a, &b, &is_touching), GRAZE_OK);
    EXPECT_EQ(is_touching, intersects(drawn.a, drawn.b));
    double gap = -1;
    ASSERT_EQ(graze_distance(&a, &b, &gap), GRAZE_OK);
    EXPECT_EQ(gap, distance(drawn.a, drawn.b));
    graze_proximity near{};
    EXPECT_EQ(answer_of(graze_closest_points(&a, &b, &near), near), numbers_of(closest_points(drawn.a, drawn.b)));
    EXPECT_EQ(answer_of(graze_separation(&a, &b, &near), near), numbers_of(separation(drawn.a, drawn.b)));
    for (const double margin : {0.0, 0.5}) {
      const ContactOptions options{.margin = margin};
      graze_contact met{};
      EXPECT_EQ(answer_of(graze_contact_of(&a, &b, margin, &met), met), answer_of(contact(drawn.a, drawn.b, options)));
      graze_manifold rest{};
      const auto wanted = manifold(drawn.a, drawn.b, options);
      EXPECT_EQ(graze_manifold_of(&a, &b, margin, &rest), wanted.size > 0 ? GRAZE_OK : GRAZE_NONE);
      EXPECT_EQ(numbers_of(rest), numbers_of(wanted));
    }
  });
}

TYPED_TEST(CInterface, AnswersAboutMotions) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  for_random_pairs<TypeParam>(15, [](const auto& drawn, const graze_shape& a, const graze_shape& b) {
    const graze_vec way = vec_of_c<N, T>(drawn.direction);
    graze_impact impact{};
    EXPECT_EQ(answer_of(graze_shape_cast(&a, way, &b, nullptr, &impact), impact),
              answer_of(shape_cast(drawn.a, drawn.direction, drawn.b)));
    const graze_cast_options options{true, 0.25};
    EXPECT_EQ(answer_of(graze_shape_cast(&a, way, &b, &options, &impact), impact),
              answer_of(shape_cast(drawn.a, drawn.direction, drawn.b,
                                   {.ignore_initial_touch = true, .target_distance = 0.25})));
    Motion<N, T> motion{.linear = drawn.direction, .center = drawn.point};
    graze_motion motion_of_c{way, {0, 0, 0.5}, vec_of_c<N, T>(drawn.point)};
    if constexpr (N == 2) {
      motion.angular = T(0.5);
    } else {
      motion.angular = {0, 0, T(0.5)};
    }
    EXPECT_EQ(answer_of(graze_time_of_impact(&a, &motion_of_c, &b, nullptr, &impact), impact),
              answer_of(time_of_impact(drawn.a, motion, drawn.b, Motion<N, T>())));
  });
}

TYPED_TEST(CInterface, AnswersAboutOneShape) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  for_random_pairs<TypeParam>(30, [](const auto& drawn, const graze_shape& a, const graze_shape&) {
    const graze_vec point = vec_of_c<N, T>(drawn.point);
    bool is_inside = false;
    ASSERT_EQ(graze_contains(&a, point, &is_inside), GRAZE_OK) << graze_error_message();
    EXPECT_EQ(is_inside, contains(drawn.a, drawn.point));
    graze_vec near{};
    EXPECT_EQ(answer_of(graze_closest_point(&a, point, &near), near),
              numbers_of(vec_of_c<N, T>(closest_point(drawn.a, drawn.point))));
    EXPECT_EQ(answer_of(graze_closest_boundary_point(&a, point, &near), near),
              numbers_of(vec_of_c<N, T>(closest_boundary_point(drawn.a, drawn.point))));
    double depth = 0;
    ASSERT_EQ(graze_signed_distance(&a, point, &depth), GRAZE_OK);
    EXPECT_EQ(bits(depth), bits(signed_distance(drawn.a, drawn.point)));
    graze_box box{};
    EXPECT_EQ(answer_of(graze_bounds(&a, &box), box), numbers_of(bounds(drawn.a)));
    graze_mass mass{};
    EXPECT_EQ(answer_of(graze_mass_properties(&a, &mass), mass), numbers_of(mass_properties(drawn.a)));

    const Ray<N, T> ray{drawn.point, drawn.direction};
    const graze_ray ray_of_c{point, vec_of_c<N, T>(drawn.direction)};
    for (const bool is_exit : {false, true}) {
      const graze_ray_options options{true, is_exit, 2};
      const RayOptions side{is_exit ? RaySide::exit : RaySide::entry};
      graze_ray_hit hit{};
      const auto found = answer_of(graze_ray_cast(&a, &ray_of_c, &options, &hit), hit);
      if (const auto* const mesh = std::get_if<Mesh<N, T>>(&drawn.a)) {
        EXPECT_EQ(found, answer_of(ray_cast(*mesh, ray, T(2), side)));
      } else {
        EXPECT_EQ(found, answer_of(ray_cast(drawn.a, ray, T(2), side)));
      }
    }
  });
}

/// Shapes in a scene of each language.
template <Dim N, class T>
struct TwoScenes {
  explicit TwoScenes(std::size_t count) {
    EXPECT_EQ(graze_create_scene(world_of_c<N, T>, &in_c), GRAZE_OK);
    rc::Random random(20261130 + static_cast<std::uint64_t>(N));
    for (std::size_t i = 0; i < count; ++i) {
      const auto gen =
          rc::gen::exec([i] { return draw_shape_at<N, T>(i % number_of_types<N, T>, draw_source<N, T>()); });
      shapes.push_back(gen(random.split(), 50).value());
      ids.push_back(in_cpp.add(shapes.back()));
      ids_of_c.emplace_back();
      const ShapeOfC<N, T> shape(shapes.back());
      EXPECT_EQ(graze_scene_add(in_c, &*shape, nullptr, &ids_of_c.back()), GRAZE_OK) << graze_error_message();
    }
  }
  TwoScenes(const TwoScenes&) = delete;
  TwoScenes& operator=(const TwoScenes&) = delete;
  ~TwoScenes() { EXPECT_EQ(graze_destroy_scene(in_c), GRAZE_OK); }

  Scene<N, T> in_cpp;
  graze_scene in_c{};
  std::vector<AnyShape<N, T>> shapes;
  std::vector<ObjectId> ids;
  std::vector<graze_id> ids_of_c;
};

/// The places of objects, by which ids of different scenes are compared.
std::vector<std::uint32_t> places(const std::vector<ObjectId>& ids) {
  std::vector<std::uint32_t> result;
  for (const ObjectId& id : ids) result.push_back(id.index);
  return result;
}
std::vector<std::uint32_t> places(const std::vector<graze_id>& ids) {
  std::vector<std::uint32_t> result;
  for (const graze_id& id : ids) result.push_back(id.index);
  return result;
}

TYPED_TEST(CInterface, AnswersAboutScenes) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  const TwoScenes<N, T> scenes(65);
  const auto wanted = scenes.in_cpp.contacts();
  std::vector<graze_object_contact> found(wanted.size());
  std::size_t count = 0;
  ASSERT_EQ(graze_scene_contacts(scenes.in_c, found.data(), found.size(), &count), GRAZE_OK) << graze_error_message();
  ASSERT_EQ(count, wanted.size());
  ASSERT_GT(count, 20U);
  for (std::size_t i = 0; i < count; ++i) {
    EXPECT_EQ(found[i].pair.a.index, wanted[i].pair.a.index);
    EXPECT_EQ(found[i].pair.b.index, wanted[i].pair.b.index);
    EXPECT_EQ(numbers_of(found[i].manifold), numbers_of(wanted[i].manifold));
  }
  for (std::size_t i = 0; i < scenes.shapes.size(); ++i) {
    const AnyShape<N, T>& shape = scenes.shapes[i];
    const ShapeOfC<N, T> shape_of_c(shape);
    const graze_query query{0, &scenes.ids_of_c[i], 1, false};
    const SceneQuery others{.except = std::span<const ObjectId>(&scenes.ids[i], 1)};
    std::vector<graze_id> met(scenes.shapes.size());
    ASSERT_EQ(graze_scene_overlapping(scenes.in_c, &*shape_of_c, &query, met.data(), met.size(), &count), GRAZE_OK);
    met.resize(count);
    EXPECT_EQ(places(met), places(scenes.in_cpp.overlapping(shape, others)));
    graze_object_impact impact{};
    const auto first = scenes.in_cpp.shape_cast(shape, Vec<N, T>(T(1)), others);
    const graze_status status = graze_scene_shape_cast(scenes.in_c, &*shape_of_c, {1, 1, 1}, &query, &impact);
    ASSERT_EQ(status, first ? GRAZE_OK : GRAZE_NONE) << graze_error_message();
    if (!first) continue;
    EXPECT_EQ(impact.id.index, first->id.index);
    EXPECT_EQ(numbers_of(impact.impact), numbers_of(first->impact));
  }
}

TYPED_TEST(CInterface, GivesShapesBack) {
  for_random_pairs<TypeParam>(5, [](const auto& drawn, const graze_shape& a, const graze_shape& b) {
    constexpr Dim N = TypeParam::dimension;
    using T = typename TypeParam::scalar;
    graze_scene scene{};
    ASSERT_EQ(graze_create_scene(world_of_c<N, T>, &scene), GRAZE_OK);
    graze_id id{};
    ASSERT_EQ(graze_scene_add(scene, &a, nullptr, &id), GRAZE_OK) << graze_error_message();
    graze_shape back{};
    ASSERT_EQ(graze_scene_shape(scene, id, &back), GRAZE_OK);
    EXPECT_EQ(back.kind, a.kind);
    graze_proximity near{};
    EXPECT_EQ(answer_of(graze_closest_points(&back, &b, &near), near), numbers_of(closest_points(drawn.a, drawn.b)));
    if (back.kind >= GRAZE_POLYTOPE) {
      EXPECT_EQ(graze_destroy_geometry(back.as.geometry), GRAZE_OK);
    }
    EXPECT_EQ(graze_destroy_scene(scene), GRAZE_OK);
  });
}

}  // namespace
}  // namespace graze::test::agreement_test
