// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include <graze/io/json/shape_fields.hpp>
#include <graze/io/json/shape_writer.hpp>
#include <graze/io/output_error.hpp>
#include <graze/shape/fields/description.hpp>
#include <graze/shape/fields/visit.hpp>
#include <graze/shape/mesh.hpp>

namespace graze::io {
namespace {

/// The shortest text that parses to the same double, independent of the locale. A negative zero is written so that it
/// keeps its sign even in readers that take -0 for an integer.
void append(std::string& out, double value) {
  if (value == 0) {
    out += std::signbit(value) ? "-0.0" : "0";
  } else {
    fmt::format_to(std::back_inserter(out), "{}", value);
  }
}

template <Dim N>
void append(std::string& out, const Vec<N, double>& vector) {
  out += '[';
  for (Dim i = 0; i < N; ++i) {
    if (i > 0) out += ", ";
    append(out, vector[i]);
  }
  out += ']';
}

template <Dim N>
void append(std::string& out, const Mat<N, double>& axes) {
  out += '[';
  for (Dim i = 0; i < N; ++i) {
    if (i > 0) out += ", ";
    append<N>(out, axes[i]);
  }
  out += ']';
}

template <Dim N>
void append_shape(std::string& out, const AnyShape<N, double>& shape, std::size_t outer_compounds);

/// A JSON array; `append_one` writes each element.
template <class List, class AppendOne>
void append_list(std::string& out, const List& list, const AppendOne& append_one) {
  out += '[';
  bool first = true;
  for (const auto& element : list) {
    if (!first) out += ", ";
    append_one(element);
    first = false;
  }
  out += ']';
}

template <Dim N>
void append(std::string& out, std::span<const Vec<N, double>> points) {
  append_list(out, points, [&out](const Vec<N, double>& point) { append(out, point); });
}

void append(std::string& out, std::span<const std::array<std::uint32_t, 3>> faces) {
  append_list(out, faces, [&out](const std::array<std::uint32_t, 3>& face) {
    fmt::format_to(std::back_inserter(out), "[{}, {}, {}]", face[0], face[1], face[2]);
  });
}

void append(std::string& out, MeshKind kind) {
  fmt::format_to(std::back_inserter(out), "\"{}\"", mesh_kind_names[static_cast<std::size_t>(kind)]);
}

template <Dim N>
void append_parts(std::string& out, const Parts<N, double>& parts, std::size_t outer_compounds) {
  append_list(out, parts, [&](const Part<N, double>& part) {
    out += '{';
    append_shape<N>(out, part.shape, outer_compounds + 1);
    out += '}';
  });
}

template <class Field, class Value>
void append_field(std::string& out, const Field& field, const Value& value, std::size_t outer_compounds) {
  fmt::format_to(std::back_inserter(out), ", \"{}\": ", field.name);
  if constexpr (Field::kind == detail::FieldKind::parts) {
    append_parts(out, value, outer_compounds);
  } else {
    append(out, value);
  }
}

template <Dim N>
void append_shape(std::string& out, const AnyShape<N, double>& shape, std::size_t outer_compounds) {
  if (outer_compounds >= max_compound_depth && std::holds_alternative<Compound<N, double>>(shape)) {
    throw OutputError(
        fmt::format("compounds are nested deeper than {}, the most that the scene format allows", max_compound_depth));
  }
  fmt::format_to(std::back_inserter(out), "\"type\": \"{}\"", type_name<N, double>(shape));
  detail::visit(
      [&](const auto& held) {
        detail::for_each_field(
            held, [&](const auto& field, const auto& value) { append_field(out, field, value, outer_compounds); });
      },
      shape);
}

}  // namespace

template <Dim N>
void append_json_shape(std::string& out, const AnyShape<N, double>& shape) {
  append_shape<N>(out, shape, 0);
}

template void append_json_shape<2>(std::string&, const AnyShape<2, double>&);
template void append_json_shape<3>(std::string&, const AnyShape<3, double>&);

}  // namespace graze::io
