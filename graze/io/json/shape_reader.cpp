// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <graze/io/json/shape_fields.hpp>
#include <graze/io/json/shape_reader.hpp>
#include <graze/io/text/in_quotes.hpp>
#include <graze/io/text/suggestion.hpp>
#include <graze/math/pose.hpp>
#include <graze/query/bounds.hpp>

namespace graze::io {
namespace {

double read_radius(const JsonFields& fields) {
  const double radius = fields.number("radius");
  if (radius < 0) throw fields.error("radius", fmt::format("is {}; it must not be negative", radius));
  return radius;
}

template <Dim N>
Vec<N, double> read_half_extents(const JsonFields& fields) {
  const Vec<N, double> half_extents = fields.vector<N>("half_extents");
  for (Dim i = 0; i < N; ++i) {
    if (half_extents[i] < 0) {
      throw fields.error("half_extents",
                         fmt::format("has {} as coordinate {}; none may be negative", half_extents[i], i));
    }
  }
  return half_extents;
}

/// A vector of any length but zero.
template <Dim N>
Vec<N, double> read_direction(const JsonFields& fields, std::string_view name) {
  const Vec<N, double> direction = fields.vector<N>(name);
  if (max_abs(direction) == 0) throw fields.error(name, "is zero, which points nowhere; any other length will do");
  return direction;
}

template <Dim N>
AnyShape<N, double> read_point(const JsonFields& fields) {
  return fields.vector<N>("position");
}

template <Dim N>
AnyShape<N, double> read_segment(const JsonFields& fields) {
  return Segment<N, double>{fields.vector<N>("start"), fields.vector<N>("end")};
}

template <Dim N>
AnyShape<N, double> read_ray(const JsonFields& fields) {
  return Ray<N, double>{fields.vector<N>("origin"), read_direction<N>(fields, "direction")};
}

template <Dim N>
AnyShape<N, double> read_sphere(const JsonFields& fields) {
  return Sphere<N, double>{fields.vector<N>("center"), read_radius(fields)};
}

template <Dim N>
AnyShape<N, double> read_aabb(const JsonFields& fields) {
  const bool by_corners = fields.find("min") || fields.find("max");
  const bool by_center = fields.find("center") || fields.find("half_extents");
  if (by_corners == by_center) {
    throw fields.place().error(fields.offset(),
                               R"(an aabb needs either "min" and "max" or "center" and "half_extents")");
  }
  if (by_center) {
    const auto box = Aabb<N, double>::from_center(fields.vector<N>("center"), read_half_extents<N>(fields));
    if (!is_valid(box)) throw fields.error("half_extents", "reaches beyond the largest number there is, about 1.8e308");
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
Mat<N, double> read_axes(const JsonFields& fields) {
  const JsonValue columns = fields.array("axes");
  if (columns.size() != static_cast<std::size_t>(N)) {
    throw fields.error("axes", fmt::format("must be {} columns, not {}", N, columns.size()));
  }
  Mat<N, double> axes;
  Dim i = 0;
  for (const JsonValue column : columns.items()) {
    axes[i] = read_vector<N>(column, {"axes", static_cast<std::size_t>(i)}, fields.place());
    ++i;
  }
  if (!(orthonormal_error<N, double>(axes) <= tolerance::orthonormal)) {
    throw fields.error("axes", "are not orthonormal: columns must have length 1 and be at right angles");
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
  // Scaled first, so that the square of no axis over- or underflows.
  return rotation_matrix(axis / max_abs(axis), rotation.number("angle"));
}

template <Dim N>
Mat<N, double> read_orientation(const JsonFields& fields) {
  constexpr std::string_view turn = N == 2 ? "angle" : "rotation";
  const bool turned = fields.find(turn).has_value();
  if (fields.find("axes")) {
    if (turned) throw fields.error(turn, R"(and "axes" say the same thing; give one of them)");
    return read_axes<N>(fields);
  }
  if (!turned) return Mat<N, double>(1.0);
  if constexpr (N == 2) {
    return rotation_matrix(fields.number("angle"));
  } else {
    return read_rotation(fields);
  }
}

template <Dim N>
AnyShape<N, double> read_obb(const JsonFields& fields) {
  return Obb<N, double>{fields.vector<N>("center"), read_half_extents<N>(fields), read_orientation<N>(fields)};
}

template <Dim N>
AnyShape<N, double> read_plane(const JsonFields& fields) {
  return Plane<N, double>{read_direction<N>(fields, "normal"), fields.number("offset")};
}

template <Dim N>
AnyShape<N, double> read_half_space(const JsonFields& fields) {
  return HalfSpace<N, double>{read_direction<N>(fields, "normal"), fields.number("offset")};
}

template <Dim N>
AnyShape<N, double> read_triangle(const JsonFields& fields) {
  return Triangle<N, double>{fields.vector<N>("a"), fields.vector<N>("b"), fields.vector<N>("c")};
}

template <Dim N>
AnyShape<N, double> read_capsule(const JsonFields& fields) {
  return Capsule<N, double>{fields.vector<N>("a"), fields.vector<N>("b"), read_radius(fields)};
}

template <Dim N>
AnyShape<N, double> read_polytope(const JsonFields& fields) {
  std::vector<Vec<N, double>> points;
  for (const JsonValue point : fields.array("points").items()) {
    points.push_back(read_vector<N>(point, {"points", points.size()}, fields.place()));
  }
  if (points.empty()) throw fields.error("points", "is empty; a polytope needs at least one point");
  return convex_hull_in_order<N, double>(points);
}

std::size_t part_depth(const JsonPlace& place) {
  std::size_t depth = 0;
  for (const JsonPlace* outer = place.outer; outer != nullptr; outer = outer->outer) ++depth;
  return depth;
}

template <Dim N>
AnyShape<N, double> read_compound(const JsonFields& fields) {
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

/// In the order of AnyShape.
template <Dim N>
constexpr std::array<AnyShape<N, double> (*)(const JsonFields&), std::variant_size_v<AnyShape<N, double>>> readers = {
    read_point<N>, read_segment<N>,    read_ray<N>,      read_sphere<N>,  read_aabb<N>,     read_obb<N>,
    read_plane<N>, read_half_space<N>, read_triangle<N>, read_capsule<N>, read_polytope<N>, read_compound<N>};

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

std::string_view with_article(std::size_t type_index) {
  constexpr std::array<std::string_view, shape_type_names.size()> names = {
      "a point", "a segment",    "a ray",      "a sphere",  "an aabb",    "an obb",
      "a plane", "a half_space", "a triangle", "a capsule", "a polytope", "a compound"};
  return names[type_index];
}

/// A field that the type has in the other dimension only deserves more than "unknown".
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

template <Dim N>
AnyShape<N, double> read_json_shape(JsonValue object, const JsonPlace& place,
                                    std::span<const std::string_view> other_fields) {
  if (object.kind() != JsonKind::object) {
    throw place.error(object.offset(), fmt::format("must be an object, not {}", kind_name(object.kind())));
  }
  const std::size_t type_index = read_type(object, place);
  const JsonFields fields(object, place, with_article(type_index));
  refuse_other_dimension<N>(fields, type_index);
  const auto own_fields = shape_fields(type_index, N);
  std::vector<std::string_view> allowed = {"type"};
  allowed.insert(allowed.end(), own_fields.begin(), own_fields.end());
  allowed.insert(allowed.end(), other_fields.begin(), other_fields.end());
  fields.allow_only(allowed);
  return readers<N>[type_index](fields);
}

template AnyShape<2, double> read_json_shape<2>(JsonValue, const JsonPlace&, std::span<const std::string_view>);
template AnyShape<3, double> read_json_shape<3>(JsonValue, const JsonPlace&, std::span<const std::string_view>);

}  // namespace graze::io
