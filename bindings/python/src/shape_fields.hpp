// SPDX-License-Identifier: MIT
// Shapes from the arguments of a Python constructor and back, by the description of their fields
// (graze/shape/fields/description.hpp).
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <graze/shape/any_shape.hpp>
#include <graze/shape/mesh.hpp>

#include "arrays.hpp"
#include "shape.hpp"

namespace graze::python {

/// "surface" or "solid"; a surface for no object. Throws ValueError for any other.
MeshKind mesh_kind_of(Argument argument, py::handle value);

/// What a constructor was called with: an object for each field of the type, null for those that are left out, and a
/// dimension of 0 and no dtype if they were not given.
struct FieldArguments {
  std::size_t alternative = 0;
  std::vector<py::handle> values;
  Dim dimension = 0;
  py::handle dtype;
};

/// Assigns the arguments of a call to the fields, as Python does. Throws TypeError for what does not fit.
FieldArguments field_arguments(std::size_t alternative, const py::args& arguments, const py::kwargs& keywords);

/// The shape that a constructor makes.
py::object shape_from(const FieldArguments& arguments);

/// The shapes of arrays with a row for each shape, for types of a fixed number of numbers. Throws ValueError, naming
/// the row, for a shape that is not valid.
template <Dim N, class T>
ShapeList<N, T> shapes_from_rows(const FieldArguments& arguments);

/// The world that the arguments determine; `are_rows` if each has a row for each shape.
World world_of_arguments(const FieldArguments& arguments, bool are_rows);

/// The names of a type's fields.
std::span<const std::string_view> field_names(std::size_t alternative);

/// Whether `many` makes shapes of this type.
bool has_fixed_size(std::size_t alternative);

/// A field's value as NumPy arrays, numbers and the like; `owner` keeps the memory of what is not copied.
py::object field_value(const HeldShape& shape, std::size_t field, py::handle owner);

/// An expression that makes the shape, with `import graze`.
std::string expression(const HeldShape& shape);

}  // namespace graze::python
