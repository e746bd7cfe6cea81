// SPDX-License-Identifier: MIT
#include "shape_fields.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <graze/query/bounds.hpp>
#include <graze/query/parts/visit.hpp>
#include <graze/shape/fields/description.hpp>

namespace graze::python {
namespace {

using detail::FieldKind;

struct FieldName {
  std::string_view name;
  FieldKind kind;
};

/// Of one type, as those of all worlds are alike.
template <class S>
constexpr auto fields_of = detail::description_of<S>.apply([]<class... Fields>(const Fields&... fields) {
  return std::array{FieldName{fields.name, Fields::kind}...};
});

constexpr auto fields_by_type = detail::table_of_shapes<2, float>(
    []<class S>(std::type_identity<S>) { return std::span<const FieldName>(fields_of<S>); });

template <class S>
constexpr auto names_of = detail::description_of<S>.apply([](const auto&... fields) {
  return std::array<std::string_view, sizeof...(fields)>{fields.name...};
});

constexpr auto names_by_type = detail::table_of_shapes<2, float>(
    []<class S>(std::type_identity<S>) { return std::span<const std::string_view>(names_of<S>); });

constexpr bool is_list_of_points(FieldKind kind) { return kind == FieldKind::hull || kind == FieldKind::vertices; }

/// Whether a constructor may leave a field out.
constexpr bool has_default(FieldKind kind) { return kind == FieldKind::axes || kind == FieldKind::mesh_kind; }

// ---- Arguments to values

template <Dim N, class T>
void read(Argument argument, py::handle value, Vec<N, T>& vector) {
  vector = vector_of<N, T>(argument, value);
}

template <class T>
requires std::is_floating_point_v<T>
void read(Argument argument, py::handle value, T& number) { number = static_cast<T>(number_of(argument, value)); }

template <Dim N, class T>
void read(Argument argument, py::handle value, Mat<N, T>& axes) {
  axes = matrix_of<N, T>(argument, value);
}

template <Dim N, class T, class S>
AnyShape<N, T> made(const FieldArguments& arguments) {
  const std::string_view type = type_name_in_python(arguments.alternative);
  const auto argument = [&](std::size_t i) { return Argument{type, names_of<S>[i]}; };
  if constexpr (std::is_same_v<S, Polytope<N, T>>) {
    return convex_hull_in_order<N, T>(points_of<N, T>(argument(0), arguments.values[0]));
  } else if constexpr (std::is_same_v<S, Mesh<N, T>>) {
    const MeshKind kind = mesh_kind_of(argument(2), arguments.values[2]);
    const auto vertices = points_of<N, T>(argument(0), arguments.values[0]);
    return mesh_of<N, T>(vertices, faces_of(argument(1), arguments.values[1]), kind);
  } else if constexpr (std::is_same_v<S, Compound<N, T>>) {
    return compound_of<N, T>(shapes_of<N, T>("Compound", arguments.values[0]));
  } else {
    S shape;
    std::size_t i = 0;
    detail::for_each_field(shape, [&](const auto&, auto& value) {
      if (arguments.values[i]) read(argument(i), arguments.values[i], value);
      ++i;
    });
    return shape;
  }
}

template <Dim N, class T>
AnyShape<N, T> made_of_type(const FieldArguments& arguments) {
  static constexpr auto makers =
      detail::table_of_shapes<N, T>([]<class S>(std::type_identity<S>) { return &made<N, T, S>; });
  return makers[arguments.alternative](arguments);
}

Dim size_of_vector(Argument argument, py::handle value) {
  const py::ssize_t size = PySequence_Check(value.ptr()) != 0 ? PySequence_Size(value.ptr()) : -1;
  if (PyErr_Occurred() != nullptr) PyErr_Clear();
  if (size == 2 || size == 3) return static_cast<Dim>(size);
  if (size < 0) {
    throw py::type_error(
        fmt::format("{} is a {}; 2 or 3 numbers are needed", argument.text(), Py_TYPE(value.ptr())->tp_name));
  }
  throw py::value_error(fmt::format("{} has {} elements; 2 or 3 numbers are needed", argument.text(), size));
}

// ---- Shapes from rows

/// Writes the rows of an array to a field of each shape, or one value to all.
template <Dim N, class T, class S, class Access>
void write_rows(Argument argument, py::handle value, std::vector<S>& shapes, const Access& access) {
  using Value = std::remove_cvref_t<decltype(access(shapes.front()))>;
  constexpr std::size_t side = N;
  std::vector<std::size_t> sizes = {shapes.size()};
  if constexpr (std::is_same_v<Value, Vec<N, T>>) sizes = {shapes.size(), side};
  if constexpr (std::is_same_v<Value, Mat<N, T>>) sizes = {shapes.size(), side, side};
  const py::array array = numbers_of<T>(argument, value, sizes, Rowwise::or_one_for_all);
  const auto* row = static_cast<const Value*>(array.data());
  for (S& shape : shapes) {
    if constexpr (std::is_same_v<Value, Mat<N, T>>) {
      access(shape) = transpose(*row++);
    } else {
      access(shape) = *row++;
    }
  }
}

template <Dim N, class T, class S>
ShapeList<N, T> made_from_rows(const FieldArguments& arguments) {
  if constexpr (detail::HasParts<S> || std::is_same_v<S, Polytope<N, T>>) {
    throw std::logic_error("shapes_from_rows: the type has no fixed size");
  } else {
    const std::string_view type = type_name_in_python(arguments.alternative);
    std::vector<S> shapes(static_cast<std::size_t>(py::len(arguments.values[0])));
    std::size_t i = 0;
    detail::description_of<S>.apply([&](const auto&... fields) {
      const auto write = [&](const auto& field) {
        const Argument argument{type, field.name};
        if (arguments.values[i]) {
          write_rows<N, T>(
              argument, arguments.values[i], shapes, [&](S & shape) -> auto& { return field.in(shape); });
        }
        ++i;
      };
      (write(fields), ...);
    });
    for (std::size_t row = 0; row < shapes.size(); ++row) {
      if (const std::string_view fault = defect(shapes[row]); !fault.empty()) {
        throw py::value_error(fmt::format("{}.many: the shape of row {} {}", type, row, fault));
      }
    }
    return ShapeList<N, T>(std::move(shapes));
  }
}

// ---- Values to Python

template <Dim N, class T>
py::object python_value(const Vec<N, T>& vector, py::handle) {
  return frozen_vector<N, T>(vector);
}
template <class T>
requires std::is_floating_point_v<T> py::object python_value(T number, py::handle) {
  return py::float_(static_cast<double>(number));
}
template <Dim N, class T>
py::object python_value(const Mat<N, T>& axes, py::handle) {
  return frozen_matrix<N, T>(axes);
}
template <Dim N, class T>
py::object python_value(std::span<const Vec<N, T>> points, py::handle owner) {
  return view_of<T>(points, static_cast<std::size_t>(N), owner);
}
py::object python_value(std::span<const std::array<std::uint32_t, 3>> faces, py::handle owner) {
  return view_of<std::uint32_t>(faces, 3, owner);
}
py::object python_value(MeshKind kind, py::handle) { return py::str(kind == MeshKind::solid ? "solid" : "surface"); }
template <Dim N, class T>
py::object python_value(const Parts<N, T>& parts, py::handle) {
  py::tuple shapes(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) shapes[i] = python_shape<N, T>(parts[i].shape, "Compound");
  return shapes;
}

// ---- Expressions

/// The shortest digits that give the number again, as Python spells a float.
template <class T>
requires std::is_floating_point_v<T> std::string spelled(T number) {
  std::string text = fmt::format("{}", number);
  if (text.find_first_not_of("-0123456789") == std::string::npos) text += ".0";
  return text;
}
template <Dim N, class T>
std::string spelled(const Vec<N, T>& vector) {
  std::string text;
  for (Dim i = 0; i < N; ++i) text += (i == 0 ? "" : ", ") + spelled(vector[i]);
  return "[" + text + "]";
}
template <Dim N, class T>
std::string spelled(const Mat<N, T>& axes) {
  std::string text;
  const Mat<N, T> rows = transpose(axes);
  for (Dim i = 0; i < N; ++i) text += (i == 0 ? "" : ", ") + spelled<N, T>(rows[i]);
  return "[" + text + "]";
}
template <Dim N, class T>
std::string spelled(std::span<const Vec<N, T>> points) {
  std::string text;
  for (const Vec<N, T>& point : points) text += (text.empty() ? "" : ", ") + spelled<N, T>(point);
  return "[" + text + "]";
}
std::string spelled(std::span<const std::array<std::uint32_t, 3>> faces) { return fmt::format("{}", faces); }
std::string spelled(MeshKind kind) { return kind == MeshKind::solid ? "'solid'" : "'surface'"; }

template <Dim N, class T>
std::string spelled_shape(const AnyShape<N, T>& shape);

template <Dim N, class T>
std::string spelled(const Parts<N, T>& parts) {
  std::string text;
  for (const Part<N, T>& part : parts) text += (text.empty() ? "" : ", ") + spelled_shape<N, T>(part.shape);
  return "[" + text + "]";
}

/// What the fields do not tell: the dimension if there are no points, and float32.
template <Dim N, class T, class S>
std::string rest_of_arguments(const S& shape) {
  std::string text;
  if constexpr (std::is_same_v<S, Compound<N, T>>) {
    if (!shape.parts.empty()) return "";
    text += fmt::format(", dimension={}", N);
  } else if constexpr (std::is_same_v<S, Mesh<N, T>>) {
    if (shape.vertices().empty()) text += fmt::format(", dimension={}", N);
  }
  if (sizeof(T) == sizeof(float)) text += ", dtype='float32'";
  return text;
}

template <Dim N, class T>
std::string spelled_shape(const AnyShape<N, T>& shape) {
  return detail::visit(
      [&shape]<class S>(const S& held) {
        std::string text;
        detail::for_each_field(
            held, [&text](const auto&, const auto& value) { text += (text.empty() ? "" : ", ") + spelled(value); });
        return fmt::format("graze.{}({}{})", type_name_in_python(shape.index()), text, rest_of_arguments<N, T>(held));
      },
      shape);
}

}  // namespace

MeshKind mesh_kind_of(Argument argument, py::handle value) {
  if (!value) return MeshKind::surface;
  if (PyUnicode_Check(value.ptr()) != 0) {
    const auto word = value.cast<std::string>();
    if (word == "surface") return MeshKind::surface;
    if (word == "solid") return MeshKind::solid;
  }
  throw py::value_error(
      fmt::format("{} is {}; 'surface' or 'solid' is needed", argument.text(), std::string(py::repr(value))));
}

std::span<const std::string_view> field_names(std::size_t alternative) { return names_by_type[alternative]; }

bool has_fixed_size(std::size_t alternative) {
  const FieldKind kind = fields_by_type[alternative].front().kind;
  return !is_list_of_points(kind) && kind != FieldKind::parts;
}

FieldArguments field_arguments(std::size_t alternative, const py::args& arguments, const py::kwargs& keywords) {
  const std::string_view type = type_name_in_python(alternative);
  const std::span<const std::string_view> names = names_by_type[alternative];
  FieldArguments found{alternative, std::vector<py::handle>(names.size()), 0, {}};
  if (arguments.size() > names.size()) {
    throw py::type_error(
        fmt::format("{}() takes {}, but {} arguments are given", type, fmt::join(names, ", "), arguments.size()));
  }
  for (std::size_t i = 0; i < arguments.size(); ++i) found.values[i] = PyTuple_GET_ITEM(arguments.ptr(), i);
  for (const auto& [key, value] : keywords) {
    const auto word = key.cast<std::string>();
    const auto place = std::find(names.begin(), names.end(), word);
    if (place != names.end()) {
      py::handle& field = found.values[static_cast<std::size_t>(place - names.begin())];
      if (field) throw py::type_error(fmt::format("{}() has two values for {}", type, word));
      field = value;
    } else if (word == "dtype") {
      if (!value.is_none()) found.dtype = value;
    } else if (word == "dimension" && !has_fixed_size(alternative)) {
      if (value.is_none()) continue;
      const double dimension = number_of({type, "dimension"}, value);
      if (dimension != 2 && dimension != 3) throw py::value_error(fmt::format("{}: dimension is not 2 or 3", type));
      found.dimension = static_cast<Dim>(dimension);
    } else {
      throw py::type_error(
          fmt::format("{}() has no argument {}; it takes {} and dtype", type, word, fmt::join(names, ", ")));
    }
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (found.values[i] && found.values[i].is_none()) found.values[i] = {};
    if (!found.values[i] && !has_default(fields_by_type[alternative][i].kind)) {
      throw py::type_error(fmt::format("{}() is missing {}; it takes {}", type, names[i], fmt::join(names, ", ")));
    }
  }
  return found;
}

World world_of_arguments(const FieldArguments& arguments, bool are_rows) {
  World world;
  if (arguments.dtype) world.is_double = is_double_dtype(arguments.dtype);
  const std::span<const FieldName> fields = fields_by_type[arguments.alternative];
  const Argument first{type_name_in_python(arguments.alternative), fields.front().name};
  const py::handle value = arguments.values.front();
  const bool is_empty = is_empty_sequence(value);
  if (fields.front().kind == FieldKind::parts) {
    if (is_empty && arguments.dimension == 0) {
      throw py::value_error("Compound: parts is empty; then dimension=2 or dimension=3 is needed");
    }
    if (is_empty) return {arguments.dimension, world.is_double};
    const World of_parts = world_of_shapes("Compound", value);
    if (arguments.dtype && of_parts.is_double != world.is_double) {
      throw py::type_error(fmt::format("Compound: dtype is {}, that of the parts {}", name_of_numbers(world),
                                       name_of_numbers(of_parts)));
    }
    return of_parts;
  }
  if (is_list_of_points(fields.front().kind)) {
    world.dimension = is_empty && arguments.dimension != 0 ? arguments.dimension : columns_of_points(first, value);
    return world;
  }
  world.dimension = are_rows ? columns_of_points(first, value) : size_of_vector(first, value);
  return world;
}

py::object shape_from(const FieldArguments& arguments) {
  const World world = world_of_arguments(arguments, false);
  return in_world(world, [&]<Dim N, class T>(In<N, T>) {
    return python_shape<N, T>(made_of_type<N, T>(arguments), type_name_in_python(arguments.alternative));
  });
}

template <Dim N, class T>
ShapeList<N, T> shapes_from_rows(const FieldArguments& arguments) {
  static constexpr auto makers =
      detail::table_of_shapes<N, T>([]<class S>(std::type_identity<S>) { return &made_from_rows<N, T, S>; });
  return makers[arguments.alternative](arguments);
}

py::object field_value(const HeldShape& shape, std::size_t field, py::handle owner) {
  py::object found;
  on_shape(shape, [&](const auto& any) {
    detail::visit(
        [&](const auto& held) {
          std::size_t i = 0;
          detail::for_each_field(held, [&](const auto&, const auto& value) {
            if (i++ == field) found = python_value(value, owner);
          });
        },
        any);
  });
  return found;
}

std::string expression(const HeldShape& shape) {
  return on_shape(shape, []<Dim N, class T>(const AnyShape<N, T>& any) { return spelled_shape<N, T>(any); });
}

template ShapeList<2, float> shapes_from_rows(const FieldArguments&);
template ShapeList<2, double> shapes_from_rows(const FieldArguments&);
template ShapeList<3, float> shapes_from_rows(const FieldArguments&);
template ShapeList<3, double> shapes_from_rows(const FieldArguments&);

}  // namespace graze::python
