// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <graze/io/json/shape_fields.hpp>
#include <graze/io/json/shape_reader.hpp>
#include <graze/io/text/in_quotes.hpp>
#include <graze/io/text/suggestion.hpp>
#include <graze/math/rotation.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/query/bounds.hpp>
#include <graze/shape/fields/description.hpp>
#include <graze/shape/mesh.hpp>

namespace graze::io {
namespace {

using detail::FieldKind;

/// A nonnegative number.
double read_length(const JsonFields& fields, std::string_view name) {
  const double length = fields.number(name);
  if (length < 0) throw fields.error(name, fmt::format("is {}; it must not be negative", length));
  return length;
}

template <Dim N>
Vec<N, double> read_half_extents(const JsonFields& fields, std::string_view name) {
  const Vec<N, double> half_extents = fields.vector<N>(name);
  for (Dim i = 0; i < N; ++i) {
    if (half_extents[i] < 0) {
      throw fields.error(name, fmt::format("has {} as coordinate {}; none may be negative", half_extents[i], i));
    }
  }
  return half_extents;
}

/// A vector of any nonzero length.
template <Dim N>
Vec<N, double> read_direction(const JsonFields& fields, std::string_view name) {
  const Vec<N, double> direction = fields.vector<N>(name);
  if (max_abs(direction) == 0) throw fields.error(name, "is zero and so has no direction; any other length is allowed");
  return direction;
}

template <Dim N>
Mat<N, double> read_axes(const JsonFields& fields, std::string_view name) {
  const JsonValue columns = fields.array(name);
  if (columns.size() != static_cast<std::size_t>(N)) {
    throw fields.error(name, fmt::format("must be {} columns, not {}", N, columns.size()));
  }
  Mat<N, double> axes;
  Dim i = 0;
  for (const JsonValue column : columns.items()) {
    axes[i] = read_vector<N>(column, {name, static_cast<std::size_t>(i)}, fields.place());
    ++i;
  }
  if (!(orthonormal_error<N, double>(axes) <= tolerance::orthonormal)) {
    throw fields.error(name, "are not orthonormal: columns must have length 1 and be at right angles");
  }
  return axes;
}

/// {"axis": [0, 0, 1], "angle": degrees}
Mat<3, double> read_rotation(const JsonFields& fields) {
  constexpr std::array<std::string_view, 2> names = {"axis", "angle"};
  const JsonValue value = fields.require("rotation");
  if (value.kind() != JsonKind::object) {
    throw fields.error("rotation", R"(must be an object: {"axis": [x, y, z], "angle": degrees})");
  }
  const JsonFields rotation(value, fields.place(), "a rotation");
  rotation.allow_only(names);
  const Vec<3, double> axis = read_direction<3>(rotation, "axis");
  // Scaled first, so that no square over- or underflows.
  return rotation_matrix(axis / max_abs(axis), rotation.number("angle"));
}

/// The axes of a box, or the angle or rotation that gives them; by default those of the world.
template <Dim N>
Mat<N, double> read_orientation(const JsonFields& fields, std::string_view axes) {
  constexpr std::string_view turn = orientation_field<N>;
  const bool turned = fields.find(turn).has_value();
  if (fields.find(axes)) {
    if (turned) throw fields.error(turn, fmt::format("and {} both give the rotation; give only one", in_quotes(axes)));
    return read_axes<N>(fields, axes);
  }
  if (!turned) return Mat<N, double>(1.0);
  if constexpr (N == 2) {
    return rotation_matrix(fields.number(turn));
  } else {
    return read_rotation(fields);
  }
}

template <FieldKind kind, Dim N>
auto read_value(const JsonFields& fields, std::string_view name) {
  if constexpr (kind == FieldKind::point) return fields.vector<N>(name);
  if constexpr (kind == FieldKind::direction) return read_direction<N>(fields, name);
  if constexpr (kind == FieldKind::length) return read_length(fields, name);
  if constexpr (kind == FieldKind::half_extents) return read_half_extents<N>(fields, name);
  if constexpr (kind == FieldKind::offset) return fields.number(name);
  if constexpr (kind == FieldKind::axes) return read_orientation<N>(fields, name);
}

/// Reads a shape directly from its fields.
template <class S>
S read_shape(const JsonFields& fields, std::type_identity<S>) {
  S shape;
  detail::for_each_field(shape, [&fields]<class Field>(const Field& field, auto& value) {
    value = read_value<Field::kind, dimension_of<S>>(fields, field.name);
  });
  if (const std::string_view flaw = defect(shape); !flaw.empty()) throw fields.place().error(fields.offset(), flaw);
  return shape;
}

template <Dim N>
Aabb<N, double> read_shape(const JsonFields& fields, std::type_identity<Aabb<N, double>>) {
  const bool by_corners = fields.find("min") || fields.find("max");
  const bool by_center = fields.find("center") || fields.find("half_extents");
  if (by_corners == by_center) {
    throw fields.place().error(fields.offset(),
                               R"(an aabb needs either "min" and "max" or "center" and "half_extents")");
  }
  if (by_center) {
    const auto box =
        Aabb<N, double>::from_center(fields.vector<N>("center"), read_half_extents<N>(fields, "half_extents"));
    if (!is_valid(box))
      throw fields.error("half_extents", "is too large: the box exceeds the largest number, about 1.8e308");
    return box;
  }
  const Aabb<N, double> box{fields.vector<N>("min"), fields.vector<N>("max")};
  for (Dim i = 0; i < N; ++i) {
    if (box.min[i] > box.max[i]) {
      throw fields.error("min", fmt::format("is above \"max\" in coordinate {}: {} > {}", i, box.min[i], box.max[i]));
    }
  }
  return box;
}

template <Dim N>
Polytope<N, double> read_shape(const JsonFields& fields, std::type_identity<Polytope<N, double>>) {
  std::vector<Vec<N, double>> points;
  for (const JsonValue point : fields.array("points").items()) {
    points.push_back(read_vector<N>(point, {"points", points.size()}, fields.place()));
  }
  if (points.empty()) throw fields.error("points", "is empty; a polytope needs at least one point");
  return convex_hull_in_order<N, double>(points);
}

/// The three vertices of a face.
std::array<std::uint32_t, 3> read_face(JsonValue value, const JsonFieldName& name, const JsonPlace& place,
                                       std::size_t vertices) {
  const JsonValue corners = read_array(value, name, place);
  if (corners.size() != 3) {
    throw place.error(value.offset(),
                      fmt::format("face {} must be three indices of vertices, not {}", *name.element, corners.size()));
  }
  std::array<std::uint32_t, 3> face{};
  std::size_t i = 0;
  for (const JsonValue corner : corners.items()) {
    const std::uint64_t vertex = read_whole(corner, name, place);
    if (vertex >= vertices) {
      throw place.error(corner.offset(),
                        fmt::format("face {} has vertex {}, but there are {} vertices, numbered from 0", *name.element,
                                    vertex, vertices));
    }
    face[i++] = static_cast<std::uint32_t>(vertex);
  }
  return face;
}

template <Dim N>
Mesh<N, double> read_shape(const JsonFields& fields, std::type_identity<Mesh<N, double>>) {
  if (N == 3 && !fields.find("vertices") && !fields.find("faces")) {
    throw fields.place().error(fields.offset(),
                               "a mesh needs \"vertices\" and \"faces\", or the \"file\" that has them");
  }
  std::vector<Vec<N, double>> vertices;
  for (const JsonValue vertex : fields.array("vertices").items()) {
    vertices.push_back(read_vector<N>(vertex, {"vertices", vertices.size()}, fields.place()));
  }
  std::vector<std::array<std::uint32_t, 3>> faces;
  for (const JsonValue face : fields.array("faces").items()) {
    faces.push_back(read_face(face, {"faces", faces.size()}, fields.place(), vertices.size()));
  }
  return mesh_of<N, double>(vertices, faces, read_json_mesh_kind(fields));
}

std::size_t part_depth(const JsonPlace& place) {
  std::size_t depth = 0;
  for (const JsonPlace* outer = place.outer; outer != nullptr; outer = outer->outer) ++depth;
  return depth;
}

template <Dim N>
Compound<N, double> read_shape(const JsonFields& fields, std::type_identity<Compound<N, double>>) {
  const JsonPlace& place = fields.place();
  if (part_depth(place) >= max_compound_depth) {
    throw place.error(fields.offset(), fmt::format("compounds are nested deeper than {}", max_compound_depth));
  }
  std::vector<AnyShape<N, double>> parts;
  for (const JsonValue part : fields.array("parts").items()) {
    const JsonPlace part_place{place.document, &place, "part", parts.size()};
    parts.push_back(read_json_shape<N>(part, part_place, {}));
  }
  return compound_of<N, double>(std::move(parts));
}

template <Dim N>
using ReadFunction = AnyShape<N, double> (*)(const JsonFields&);

template <Dim N>
constexpr auto readers = detail::table_of_shapes<N, double>([]<class S>(std::type_identity<S>) -> ReadFunction<N> {
  return [](const JsonFields& fields) -> AnyShape<N, double> { return read_shape(fields, std::type_identity<S>()); };
});

std::size_t read_type(JsonValue object, const JsonPlace& place) {
  const std::string_view type = read_text(JsonFields(object, place, "a shape").require("type"), {"type"}, place);
  if (const auto index = shape_type_index(type)) return *index;
  std::string message = "unknown type " + in_quotes(type);
  if (const auto ours = our_shape_name(type)) {
    message += fmt::format("; did you mean {}?", in_quotes(*ours));
  } else {
    message += did_you_mean(type, shape_type_names);
  }
  throw place.error(object.find("type")->offset(), message);
}

/// A field that the type has only in the other dimension gets a more specific message than "unknown".
template <Dim N>
void refuse_other_dimension(const JsonFields& fields, std::size_t type_index) {
  for (const std::string_view name : shape_fields(type_index, 5 - N)) {
    const auto here = shape_fields(type_index, N);
    if (std::find(here.begin(), here.end(), name) != here.end() || !fields.find(name)) continue;
    throw fields.error(
        name, fmt::format("belongs to dimension {}; in dimension {} give {}", 5 - N, N, in_quotes(here.back())));
  }
}

}  // namespace

MeshKind read_json_mesh_kind(const JsonFields& fields) {
  const std::optional<JsonValue> value = fields.find("kind");
  if (!value) return MeshKind::surface;
  const std::string_view kind = read_text(*value, {"kind"}, fields.place());
  const auto* const found = std::find(mesh_kind_names.begin(), mesh_kind_names.end(), kind);
  if (found == mesh_kind_names.end()) {
    throw fields.error("kind", fmt::format("is {}; a mesh is a \"surface\" or a \"solid\"", in_quotes(kind)));
  }
  return static_cast<MeshKind>(found - mesh_kind_names.begin());
}

template <Dim N>
AnyShape<N, double> read_json_shape(JsonValue object, const JsonPlace& place,
                                    std::span<const std::string_view> other_fields) {
  if (object.kind() != JsonKind::object) {
    throw place.error(object.offset(), fmt::format("must be an object, not {}", kind_name(object.kind())));
  }
  const std::size_t type_index = read_type(object, place);
  const std::string_view type = shape_type_names[type_index];
  const std::string what = detail::with_article(type);
  const JsonFields fields(object, place, what);
  refuse_other_dimension<N>(fields, type_index);
  const auto own_fields = shape_fields(type_index, N);
  std::vector<std::string_view> allowed = {"type"};
  allowed.insert(allowed.end(), own_fields.begin(), own_fields.end());
  allowed.insert(allowed.end(), other_fields.begin(), other_fields.end());
  fields.allow_only(allowed);
  return readers<N>[type_index](fields);
}

template <Dim N>
AnyShape<N, double> parse_json_shape(std::string_view text, const std::string& source) {
  const JsonDocument document(text, source);
  return read_json_shape<N>(document.root(), JsonPlace{document}, {});
}

template AnyShape<2, double> parse_json_shape<2>(std::string_view, const std::string&);
template AnyShape<3, double> parse_json_shape<3>(std::string_view, const std::string&);
template AnyShape<2, double> read_json_shape<2>(JsonValue, const JsonPlace&, std::span<const std::string_view>);
template AnyShape<3, double> read_json_shape<3>(JsonValue, const JsonPlace&, std::span<const std::string_view>);

}  // namespace graze::io
