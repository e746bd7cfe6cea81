// SPDX-License-Identifier: MIT
#include "shape_in.hpp"

#include <array>
#include <string>
#include <type_traits>
#include <utility>

#include <graze/query/parts/visit.hpp>
#include <graze/shape/fields/description.hpp>
#include <graze/shape/fields/visit.hpp>

#include "vectors.hpp"

namespace graze::c {
namespace {

template <class S>
constexpr bool is_geometry = detail::HasParts<S> || std::is_same_v<S, Polytope<dimension_of<S>, scalar_of<S>>>;

constexpr std::size_t kinds = shape_type_names.size();
static_assert(shape_type_names[GRAZE_POINT] == "point" && shape_type_names[GRAZE_SPHERE] == "sphere" &&
                  shape_type_names[GRAZE_AABB] == "aabb" && shape_type_names[GRAZE_TRIANGLE] == "triangle" &&
                  shape_type_names[GRAZE_CAPSULE] == "capsule" && shape_type_names[GRAZE_MESH] == "mesh" &&
                  kinds == GRAZE_MESH + 1,
              "graze_kind lists the alternatives of AnyShape in their order");

// ---- The numbers of a shape's fields, one after another. Each vector of C has three.

const double* read(const double* from, double, float& number) {
  number = static_cast<float>(*from);
  return from + 1;
}
const double* read(const double* from, double, double& number) {
  number = *from;
  return from + 1;
}
template <Dim N, class T>
const double* read(const double* from, T, Vec<N, T>& vector) {
  vector = vec_in<N, T>({from[0], from[1], from[2]});
  return from + 3;
}
template <Dim N, class T>
const double* read(const double* from, T, Mat<N, T>& matrix) {
  const double* const end = from + 9;
  for (Dim j = 0; j < N; ++j) {
    matrix[j] = vec_in<N, T>({from[0], from[1], from[2]});
    from += 3;
  }
  return end;
}

template <class T>
requires std::is_floating_point_v<T>
double* write(double* to, T number) {
  *to = static_cast<double>(number);
  return to + 1;
}
template <Dim N, class T>
double* write(double* to, const Vec<N, T>& vector) {
  const graze_vec out = vec_out<N, T>(vector);
  to[0] = out.x;
  to[1] = out.y;
  to[2] = out.z;
  return to + 3;
}
template <Dim N, class T>
double* write(double* to, const Mat<N, T>& matrix) {
  for (const graze_vec& column : mat_out<N, T>(matrix).columns)
    to = write<3, double>(to, {column.x, column.y, column.z});
  return to;
}

template <Dim N, class T, class S>
AnyShape<N, T> from_numbers(const double* numbers) {
  S shape;
  if constexpr (!is_geometry<S>) {
    detail::for_each_field(shape, [&](const auto&, auto& value) { numbers = read(numbers, T(), value); });
  }
  return shape;
}

std::string kind_in_words(graze_kind kind) {
  const std::string_view name = shape_type_names[static_cast<std::size_t>(kind)];
  return std::string(detail::article_of(name)) + std::string(name);
}

template <Dim N, class T>
AnyShape<N, T> fixed_size_shape(std::string_view role, const graze_shape& shape) {
  static constexpr auto makers =
      detail::table_of_shapes<N, T>([]<class S>(std::type_identity<S>) { return &from_numbers<N, T, S>; });
  AnyShape<N, T> result = makers[static_cast<std::size_t>(shape.kind)](shape.as.numbers);
  if (const std::string_view fault = defect(result); !fault.empty()) {
    throw Error(GRAZE_INVALID_ARGUMENT,
                std::string(role) + ", " + kind_in_words(shape.kind) + ", " + std::string(fault));
  }
  return result;
}

}  // namespace

HandleTable<const Geometry>& geometries() {
  static HandleTable<const Geometry> table('G', "geometry");
  return table;
}

void refuse_kind(std::string_view role, graze_kind kind, const char* needed) {
  const bool is_known = kind >= 0 && static_cast<std::size_t>(kind) < kinds;
  throw Error(GRAZE_INVALID_ARGUMENT, std::string(role) + " is " +
                                          (is_known ? kind_in_words(kind) : "of the kind " + std::to_string(kind)) +
                                          "; " + needed + " is needed");
}

template <Dim N, class T>
ShapeIn<N, T>::ShapeIn(std::string_view role, const graze_shape& shape) {
  require_world(std::string(role).c_str(), shape.world, "the call", In<N, T>::world);
  if (shape.kind < 0 || static_cast<std::size_t>(shape.kind) >= kinds) {
    refuse_kind(role, shape.kind, "a kind from GRAZE_POINT to GRAZE_MESH");
  }
  if (shape.kind < GRAZE_POLYTOPE) {
    value_ = fixed_size_shape<N, T>(role, shape);
    return;
  }
  geometry_ = geometries().find(shape.as.geometry.handle);
  require_world(std::string(role).c_str(), shape.world, "its geometry",
                static_cast<graze_world>(geometry_->any.index()));
  const std::size_t kind = std::get_if<AnyShape<N, T>>(&geometry_->any)->index();
  if (kind != static_cast<std::size_t>(shape.kind)) {
    const std::string needed = kind_in_words(static_cast<graze_kind>(kind)) + ", as its geometry is,";
    refuse_kind(role, shape.kind, needed.c_str());
  }
}

template <Dim N, class T>
std::vector<AnyShape<N, T>> shapes_in(std::string_view role, const graze_shape* shapes, std::size_t count) {
  require_array(role, shapes, count);
  std::vector<AnyShape<N, T>> result;
  result.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    result.push_back(*ShapeIn<N, T>(std::string(role) + "[" + std::to_string(i) + "]", shapes[i]));
  }
  return result;
}

template <Dim N, class T>
graze_shape shape_out(AnyShape<N, T> shape) {
  graze_shape result{};
  result.kind = static_cast<graze_kind>(shape.index());
  result.world = In<N, T>::world;
  if (result.kind >= GRAZE_POLYTOPE) {
    result.as.geometry.handle = geometries().add(std::make_shared<const Geometry>(Geometry{std::move(shape)}));
    return result;
  }
  detail::visit(
      [&result]<class S>(const S& held) {
        if constexpr (!is_geometry<S>) {
          double* to = result.as.numbers;
          detail::for_each_field(held, [&to](const auto&, const auto& value) { to = write(to, value); });
        }
      },
      shape);
  return result;
}

#define GRAZE_C_SHAPES(N, T)                                                                         \
  template class ShapeIn<N, T>;                                                                      \
  template std::vector<AnyShape<N, T>> shapes_in(std::string_view, const graze_shape*, std::size_t); \
  template graze_shape shape_out(AnyShape<N, T>);
GRAZE_C_SHAPES(2, float)
GRAZE_C_SHAPES(2, double)
GRAZE_C_SHAPES(3, float)
GRAZE_C_SHAPES(3, double)
#undef GRAZE_C_SHAPES

}  // namespace graze::c
