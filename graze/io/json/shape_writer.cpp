// SPDX-License-Identifier: MIT
#include <cmath>
#include <functional>
#include <iterator>
#include <string>
#include <string_view>
#include <tuple>
#include <variant>

#include <fmt/format.h>

#include <graze/io/json/shape_fields.hpp>
#include <graze/io/json/shape_members.hpp>
#include <graze/io/json/shape_writer.hpp>
#include <graze/io/output_error.hpp>
#include <graze/shape/fields/visit.hpp>

namespace graze::io {
namespace {

/// The shortest text that reads back as the same double; independent of the locale. A negative zero keeps its sign also
/// in readers that take -0 for an integer.
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

template <class Value>
void append_field(std::string& out, std::string_view name, const Value& value) {
  fmt::format_to(std::back_inserter(out), ", \"{}\": ", name);
  append(out, value);
}

template <class Shape>
void append_fields(std::string& out, const Shape& shape) {
  std::apply([&](const auto&... each) { (append_field(out, each.name, std::invoke(each.of, shape)), ...); },
             shape_members<Shape>);
}

template <Dim N>
void append_fields(std::string& out, const Polytope<N, double>& polytope) {
  out += ", \"points\": [";
  bool first = true;
  for (const Vec<N, double>& vertex : polytope.vertices()) {
    if (!first) out += ", ";
    append(out, vertex);
    first = false;
  }
  out += ']';
}

template <Dim N>
void append_shape(std::string& out, const AnyShape<N, double>& shape, std::size_t outer_compounds);

template <Dim N>
void append_parts(std::string& out, const Compound<N, double>& compound, std::size_t outer_compounds) {
  if (outer_compounds >= max_compound_depth) {
    throw OutputError(
        fmt::format("compounds are nested deeper than {}, the most that the scene format allows", max_compound_depth));
  }
  out += ", \"parts\": [";
  bool first = true;
  for (const Part<N, double>& part : compound.parts) {
    out += first ? "{" : ", {";
    append_shape<N>(out, part.shape, outer_compounds + 1);
    out += '}';
    first = false;
  }
  out += ']';
}

template <Dim N>
void append_shape(std::string& out, const AnyShape<N, double>& shape, std::size_t outer_compounds) {
  fmt::format_to(std::back_inserter(out), "\"type\": \"{}\"", type_name<N, double>(shape));
  if (const auto* compound = std::get_if<Compound<N, double>>(&shape)) {
    append_parts(out, *compound, outer_compounds);
    return;
  }
  detail::visit(
      [&out](const auto& held) {
        if constexpr (!std::is_same_v<std::decay_t<decltype(held)>, Compound<N, double>>) append_fields(out, held);
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
