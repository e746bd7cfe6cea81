// SPDX-License-Identifier: MIT
// Every shape, for property tests: a generator of random shapes, often degenerate and often touching, and C++ source to
// paste when a test fails. A new shape adds one Entry here, and one line in catalogue/instances.hpp.
//
//   const Sphere<2, float> sphere = *any<Sphere<2, float>>()          a single shape
//   const auto [a, b] = *any_pair<Sphere<2, float>, Obb<2, float>>()  two that share numbers and points
//   const AnyShape<3, double> shape = *any_shape<3, double>()         any of the types
#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <ostream>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/math/pose.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/description.hpp>
#include <graze/shape/fields/visit.hpp>
#include <graze/shape/shape.hpp>

#include "catalogue/numbers.hpp"
#include "catalogue/to_source.hpp"
#include "spaces.hpp"

namespace graze::test {

/// The catalogue's entry for a type: its name and `draw(source)`, which returns a random valid value. Types that cannot
/// be initialised by the fields of their description in braces have `source(value)`, the expression that creates them.
/// Convex shapes have `point_in(shape, w)`: for each w with coordinates in [-1, 1] a point of the shape, up to
/// rounding, calculated without `support`.
template <class S>
struct Entry;

/// Gives an entry `any(source)`, the generator that calls `draw`. One `exec` for each type compiles several times
/// faster than nested maps and tuples. `any<S>()` below compiles faster still.
template <class S, Dim N, class T>
struct Generated {
  static rc::Gen<S> any(const Source<N, T>& from) {
    return rc::gen::exec([from] { return Entry<S>::draw(from); });
  }
};

template <class S>
concept Catalogued = requires {
  Entry<S>::name;
};

template <Dim N, class T>
struct Entry<Vec<N, T>> : Generated<Vec<N, T>, N, T> {
  static constexpr std::string_view name = "Vec";
  static Vec<N, T> draw(const Source<N, T>& from) { return *from.point; }
  static Vec<N, double> point_in(const Vec<N, T>& point, const Vec<N, double>&) { return wide<N, T>(point); }
  static std::string source(const Vec<N, T>& point) { return type_source<N, T>(name) + initializer(point); }
};

template <Dim N, class T>
struct Entry<Segment<N, T>> : Generated<Segment<N, T>, N, T> {
  static constexpr std::string_view name = "Segment";
  static Segment<N, T> draw(const Source<N, T>& from) { return {*from.point, *from.point}; }
  static Vec<N, double> point_in(const Segment<N, T>& segment, const Vec<N, double>& w) {
    return wide<N, T>(segment.start) * (0.5 - w[0] / 2) + wide<N, T>(segment.end) * (0.5 + w[0] / 2);
  }
};

template <Dim N, class T>
struct Entry<Ray<N, T>> : Generated<Ray<N, T>, N, T> {
  static constexpr std::string_view name = "Ray";
  static Ray<N, T> draw(const Source<N, T>& from) { return {*from.point, *from.direction}; }
};

template <Dim N, class T>
struct Entry<Sphere<N, T>> : Generated<Sphere<N, T>, N, T> {
  static constexpr std::string_view name = "Sphere";
  static Sphere<N, T> draw(const Source<N, T>& from) { return {*from.point, *from.size}; }
  static Vec<N, double> point_in(const Sphere<N, T>& sphere, const Vec<N, double>& w) {
    return wide<N, T>(sphere.center) + w * (static_cast<double>(sphere.radius) / std::fmax(1, length(w)));
  }
};

template <Dim N, class T>
struct Entry<Aabb<N, T>> : Generated<Aabb<N, T>, N, T> {
  static constexpr std::string_view name = "Aabb";
  static Aabb<N, T> draw(const Source<N, T>& from) {
    const Vec<N, T> corner = *from.point;
    return Aabb<N, T>::from_corners(corner, *from.point);
  }
  static Vec<N, double> point_in(const Aabb<N, T>& box, const Vec<N, double>& w) {
    return wide<N, T>(box.min) * (0.5 - w / 2.0) + wide<N, T>(box.max) * (0.5 + w / 2.0);
  }
};

template <Dim N, class T>
struct Entry<Obb<N, T>> : Generated<Obb<N, T>, N, T> {
  static constexpr std::string_view name = "Obb";
  static Obb<N, T> draw(const Source<N, T>& from) {
    return {*from.point, *vector_of<N, T>(from.size), *any_rotation<N, T>()};
  }
  static Vec<N, double> point_in(const Obb<N, T>& box, const Vec<N, double>& w) {
    return wide<N, T>(box.center) + wide_matrix<N, T>(box.axes) * (wide<N, T>(box.half_extents) * w);
  }
};

/// A plane, or half-space, through a point of the source, up to rounding of the offset.
template <template <Dim, class> class S, Dim N, class T>
S<N, T> draw_level(const Source<N, T>& from) {
  const Vec<N, T> normal = *from.direction;
  return {normal, static_cast<T>(dot(wide<N, T>(normal), wide<N, T>(*from.point))) + T(0)};  // never minus zero
}

template <Dim N, class T>
struct Entry<Plane<N, T>> : Generated<Plane<N, T>, N, T> {
  static constexpr std::string_view name = "Plane";
  static Plane<N, T> draw(const Source<N, T>& from) { return draw_level<Plane, N, T>(from); }
};

template <Dim N, class T>
struct Entry<HalfSpace<N, T>> : Generated<HalfSpace<N, T>, N, T> {
  static constexpr std::string_view name = "HalfSpace";
  static HalfSpace<N, T> draw(const Source<N, T>& from) { return draw_level<HalfSpace, N, T>(from); }
};

template <Dim N, class T>
struct Entry<Triangle<N, T>> : Generated<Triangle<N, T>, N, T> {
  static constexpr std::string_view name = "Triangle";
  static Triangle<N, T> draw(const Source<N, T>& from) { return {*from.point, *from.point, *from.point}; }
  static Vec<N, double> point_in(const Triangle<N, T>& triangle, const Vec<N, double>& w) {
    const double along = 0.5 + w[0] / 2;
    const double up = (0.5 + w[1] / 2) * along;
    return wide<N, T>(triangle.a) * (1 - along) + wide<N, T>(triangle.b) * (along - up) + wide<N, T>(triangle.c) * up;
  }
};

template <Dim N, class T>
struct Entry<Capsule<N, T>> : Generated<Capsule<N, T>, N, T> {
  static constexpr std::string_view name = "Capsule";
  static Capsule<N, T> draw(const Source<N, T>& from) { return {*from.point, *from.point, *from.size}; }
  static Vec<N, double> point_in(const Capsule<N, T>& capsule, const Vec<N, double>& w) {
    const Vec<N, double> center = Entry<Segment<N, T>>::point_in(axis(capsule), w);
    return Entry<Sphere<N, double>>::point_in({center, static_cast<double>(capsule.radius)}, w);
  }
};

/// Hulls of one to eight points.
template <Dim N, class T>
struct Entry<Polytope<N, T>> : Generated<Polytope<N, T>, N, T> {
  static constexpr std::string_view name = "Polytope";
  static Polytope<N, T> draw(const Source<N, T>& from) { return convex_hull<N, T>(*some<Vec<N, T>>(8, from.point)); }
  static Vec<N, double> point_in(const Polytope<N, T>& polytope, const Vec<N, double>& w) {
    const std::size_t count = polytope.vertices().size();
    const auto pick = static_cast<std::size_t>((0.5 + w[0] / 2) * 0.999 * static_cast<double>(count));
    const Vec<N, T>& next = polytope.vertices()[(pick + 1) % count];
    return Entry<Segment<N, T>>::point_in({polytope.vertices()[pick], next}, Vec<N, double>(w[1]));
  }
  static std::string source(const Polytope<N, T>& polytope) {
    std::string points;
    for (const Vec<N, T>& vertex : polytope.vertices()) points += (points.empty() ? "" : ", ") + initializer(vertex);
    return type_source<N, T>("convex_hull") + "(std::vector<" + type_source<N, T>("Vec") + ">{" + points + "})";
  }
};

/// A shape of any type from a source, with compounds nested at most `depth` deep.
template <Dim N, class T>
AnyShape<N, T> draw_shape(const Source<N, T>& from, int depth = 2);

/// The C++ source of a value: an expression that can be pasted into a test (using namespace graze).
template <Catalogued S>
std::string to_source(const S& value);

template <Dim N, class T>
std::string to_source(const AnyShape<N, T>& shape) {
  return detail::visit([](const auto& held) { return to_source(held); }, shape);
}

/// Zero to three parts of any type.
template <Dim N, class T>
struct Entry<Compound<N, T>> : Generated<Compound<N, T>, N, T> {
  static constexpr std::string_view name = "Compound";
  static Compound<N, T> draw(const Source<N, T>& from, int depth = 2) {
    const std::size_t count = *choice(4);
    std::vector<AnyShape<N, T>> parts;
    for (std::size_t i = 0; i < count; ++i) parts.push_back(draw_shape<N, T>(from, depth - 1));
    return compound_of<N, T>(std::move(parts));
  }
  static std::string source(const Compound<N, T>& compound) {
    std::string parts;
    for (const Part<N, T>& part : compound.parts) parts += (parts.empty() ? "" : ", ") + to_source(part.shape);
    return type_source<N, T>("compound_of") + "({" + parts + "})";
  }
};

/// Surfaces of zero to four faces on one to six vertices; the same vertex may occur twice in a face.
template <Dim N, class T>
struct Entry<Mesh<N, T>> : Generated<Mesh<N, T>, N, T> {
  static constexpr std::string_view name = "Mesh";
  static Mesh<N, T> draw(const Source<N, T>& from) {
    const std::vector<Vec<N, T>> vertices = *some<Vec<N, T>>(6, from.point);
    std::vector<std::array<std::uint32_t, 3>> faces(*choice(5));
    for (std::array<std::uint32_t, 3>& face : faces) {
      for (std::uint32_t& vertex : face) vertex = static_cast<std::uint32_t>(*choice(vertices.size()));
    }
    return mesh_of<N, T>(vertices, faces);
  }
  static std::string source(const Mesh<N, T>& mesh) {
    std::string vertices;
    for (const Vec<N, T>& vertex : mesh.vertices()) vertices += (vertices.empty() ? "" : ", ") + initializer(vertex);
    std::string faces;
    for (const auto& [a, b, c] : mesh.faces()) {
      faces +=
          (faces.empty() ? "{" : ", {") + std::to_string(a) + ", " + std::to_string(b) + ", " + std::to_string(c) + "}";
    }
    const std::string kind = mesh.kind() == MeshKind::solid ? ", MeshKind::solid" : "";
    return type_source<N, T>("mesh_of") + "(std::vector<" + type_source<N, T>("Vec") + ">{" + vertices +
           "}, std::vector<std::array<std::uint32_t, 3>>{" + faces + "}" + kind + ")";
  }
};

template <Dim N, class T>
struct Entry<Pose<N, T>> : Generated<Pose<N, T>, N, T> {
  static constexpr std::string_view name = "Pose";
  static Pose<N, T> draw(const Source<N, T>& from) { return {*any_rotation<N, T>(), *from.point}; }
  static std::string source(const Pose<N, T>& pose) {
    return type_source<N, T>(name) + "{" + initializer(pose.rotation) + ", " + initializer(pose.position) + "}";
  }
};

template <template <Dim, class> class S, Dim N, class T>
std::string fields_source(const S<N, T>& value) {
  std::string text;
  detail::for_each_field(
      value, [&text](const auto&, const auto& field) { text += (text.empty() ? "" : ", ") + initializer(field); });
  return type_source<N, T>(Entry<S<N, T>>::name) + "{" + text + "}";
}

template <Catalogued S>
std::string to_source(const S& value) {
  if constexpr (requires { Entry<S>::source(value); }) {
    return Entry<S>::source(value);
  } else {
    return fields_source(value);
  }
}

template <Dim N, class T>
inline constexpr std::size_t number_of_types = std::variant_size_v<AnyShape<N, T>>;

/// Stands for any type where an index in AnyShape is expected.
inline constexpr std::size_t any_type = std::variant_npos;

/// A shape of the type at `index` in AnyShape.
template <Dim N, class T>
AnyShape<N, T> draw_shape_at(std::size_t index, const Source<N, T>& from, int depth = 2) {
  using Any = AnyShape<N, T>;
  if (index == any_type) return draw_shape<N, T>(from, depth);
  Any shape;
  [&]<std::size_t... Indices>(std::index_sequence<Indices...>) {
    const auto draw = [&]<class S>(std::type_identity<S>) {
      static_assert(Catalogued<S>, "an alternative of AnyShape has no Entry: add one to tests/catalogue.hpp");
      if constexpr (std::is_same_v<S, Compound<N, T>>) {
        shape = Entry<S>::draw(from, depth);
      } else {
        shape = Entry<S>::draw(from);
      }
    };
    ((index == Indices ? draw(std::type_identity<std::variant_alternative_t<Indices, Any>>()) : void()), ...);
  }
  (std::make_index_sequence<number_of_types<N, T>>());
  return shape;
}

template <Dim N, class T>
AnyShape<N, T> draw_shape(const Source<N, T>& from, int depth) {
  const std::size_t index = *choice(number_of_types<N, T>);
  const bool is_too_deep = depth <= 0 && index == AnyShape<N, T>(Compound<N, T>()).index();
  return draw_shape_at<N, T>(is_too_deep ? 0 : index, from, depth);
}

template <Dim N, class T>
struct Entry<AnyShape<N, T>> : Generated<AnyShape<N, T>, N, T> {
  static constexpr std::string_view name = "AnyShape";
  static AnyShape<N, T> draw(const Source<N, T>& from) { return draw_shape<N, T>(from); }
  static std::string source(const AnyShape<N, T>& shape) { return to_source<N, T>(shape); }
};

/// The space of a shape or a pose.
template <class S>
struct SpaceOf : ShapeTraits<S> {};
template <Dim N, class T>
struct SpaceOf<Pose<N, T>> : Space<N, T> {};

/// A shape of any type, including compounds with two levels.
template <Dim N, class T>
rc::Gen<AnyShape<N, T>> any_shape() {
  return rc::gen::exec([] { return draw_shape<N, T>(draw_source<N, T>()); });
}

/// A shape of the type at `index` in AnyShape.
template <Dim N, class T>
rc::Gen<AnyShape<N, T>> any_shape_at(std::size_t index) {
  return rc::gen::exec([index] { return draw_shape_at<N, T>(index, draw_source<N, T>()); });
}

/// A shape of the type at `index` in AnyShape, of any type by default, from a source.
template <Dim N, class T>
rc::Gen<AnyShape<N, T>> any_shape_from(const Source<N, T>& from, std::size_t index = any_type) {
  return rc::gen::exec([from, index] { return draw_shape_at<N, T>(index, from); });
}

template <Dim N, class T>
rc::Gen<Pose<N, T>> any_pose() {
  return rc::gen::exec([] { return Entry<Pose<N, T>>::draw(draw_source<N, T>()); });
}

template <Dim N, class T>
using AnyPair = std::pair<AnyShape<N, T>, AnyShape<N, T>>;

/// Two shapes of the types at these indices in AnyShape, made from the same kind of numbers.
template <Dim N, class T>
rc::Gen<AnyPair<N, T>> any_pair_at(std::size_t first, std::size_t second) {
  return rc::gen::exec([first, second] {
    const Source<N, T> from = draw_source<N, T>();
    AnyShape<N, T> a = draw_shape_at<N, T>(first, from);
    return AnyPair<N, T>(std::move(a), draw_shape_at<N, T>(second, from));
  });
}

/// The index of a type in AnyShape; `any_type` for AnyShape itself.
template <class S>
inline constexpr std::size_t shape_index = [] {
  using Any = AnyShape<SpaceOf<S>::dimension, typename SpaceOf<S>::scalar>;
  return []<std::size_t... Indices>(std::index_sequence<Indices...>) {
    std::size_t index = any_type;
    ((index = std::is_same_v<S, std::variant_alternative_t<Indices, Any>> ? Indices : index), ...);
    return index;
  }
  (std::make_index_sequence<std::variant_size_v<Any>>());
}();

/// The held shape, or the shape itself.
template <class S>
const S& held(const AnyShape<SpaceOf<S>::dimension, typename SpaceOf<S>::scalar>& shape) {
  if constexpr (shape_index<S> == any_type) {
    return shape;
  } else {
    return std::get<S>(shape);
  }
}

/// `*` draws a value, as from a generator. Shapes are drawn as AnyShape: RapidCheck's templates cost a good part of a
/// second of compile time per type, so they are instantiated once for each space.
template <class S>
struct Drawing {
  S operator*() const {
    return held<S>(*any_shape_at<SpaceOf<S>::dimension, typename SpaceOf<S>::scalar>(shape_index<S>));
  }
};

template <Dim N, class T>
struct Drawing<Pose<N, T>> {
  Pose<N, T> operator*() const { return *any_pose<N, T>(); }
};

template <class A, class B>
struct Drawing<std::pair<A, B>> {
  std::pair<A, B> operator*() const {
    const auto pair = *any_pair_at<SpaceOf<A>::dimension, typename SpaceOf<A>::scalar>(shape_index<A>, shape_index<B>);
    return {held<A>(pair.first), held<B>(pair.second)};
  }
};

/// A shape or pose of this type.
template <Catalogued S>
Drawing<S> any() {
  return {};
}

/// Two shapes made from the same kind of numbers, which often share points: many of them touch or overlap.
template <Catalogued A, Catalogued B>
Drawing<std::pair<A, B>> any_pair() {
  return {};
}

/// Runs `property`, which draws its values by `*any_...()`, like RC_GTEST_PROP, but inside any test, such as a
/// TYPED_TEST. A failure prints the smallest case found as C++ source.
#ifdef GRAZE_TEST_CATALOGUE
void check_property(const std::function<void()>& property);
#else
inline void check_property(const std::function<void()>& property) { rc::detail::checkGTest(property); }
#endif

/// Calls visit(std::type_identity<S>()) for every alternative S of AnyShape.
template <Dim N, class T, class Visit>
void for_each_shape_type(Visit visit) {
  [&]<class... S>(std::type_identity<std::variant<S...>>) {
    (visit(std::type_identity<S>()), ...);
  }(std::type_identity<AnyShape<N, T>>());
}

/// Checks `property(shape)` for random shapes of every type of AnyShape that it can be called with:
/// `[]<Convex S>(const S& shape) { ... }` is not called with planes.
template <Dim N, class T, class Property>
void check_every_type(Property property) {
  for_each_shape_type<N, T>([&]<class S>(std::type_identity<S>) {
    if constexpr (std::invocable<Property, const S&>) {
      check_property([&property] { property(*any<S>()); });
    }
  });
}

}  // namespace graze::test

// Failure messages find these by argument-dependent lookup.
namespace graze {
template <test::Catalogued S>
std::ostream& operator<<(std::ostream& out, const S& value) {
  return out << test::to_source(value);
}
}  // namespace graze

namespace glm {
template <graze::Dim N, graze::Scalar T>
std::ostream& operator<<(std::ostream& out, const graze::Vec<N, T>& value) {
  return out << graze::test::to_source(value);
}
}  // namespace glm

// Compiled once in the library graze_test_catalogue; a test without it compiles what it needs itself.
#ifdef GRAZE_TEST_CATALOGUE
#include "catalogue/instances.hpp"
GRAZE_TEST_NUMBERS(extern)
GRAZE_TEST_SPACE(extern, 2, float)
GRAZE_TEST_SPACE(extern, 3, float)
GRAZE_TEST_SPACE(extern, 2, double)
GRAZE_TEST_SPACE(extern, 3, double)
#endif
