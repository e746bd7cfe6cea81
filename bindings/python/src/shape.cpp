// SPDX-License-Identifier: MIT
#include "shape.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>

#include <fmt/format.h>
#include <pybind11/numpy.h>

#include <graze/io/shape_numbers.hpp>
#include <graze/shape/fields/shape_order.hpp>

#include "equality.hpp"
#include "files.hpp"
#include "module.hpp"
#include "shape_fields.hpp"

namespace graze::python {
namespace {

struct ShapeType {
  const char* name;  ///< With that of the module.
  const char* doc;
};

/// In the order of AnyShape.
constexpr std::array<ShapeType, std::variant_size_v<AnyShape<2, float>>> shape_types = {{
    {"graze.Point", "Point(position, *, dtype=numpy.float64)\n--\n\nA point, as a shape. position: (N,), N = 2 or 3."},
    {"graze.Segment", "Segment(start, end, *, dtype=numpy.float64)\n--\n\nAll points between two ends, (N,) each."},
    {"graze.Ray",
     "Ray(origin, direction, *, dtype=numpy.float64)\n--\n\nAll points origin + t * direction with t >= 0. The "
     "direction, "
     "(N,), may have any length but zero."},
    {"graze.Sphere", "Sphere(center, radius, *, dtype=numpy.float64)\n--\n\nA ball; in 2D a disk. center: (N,)."},
    {"graze.Aabb", "Aabb(min, max, *, dtype=numpy.float64)\n--\n\nA box along the axes, min <= max: (N,) each."},
    {"graze.Obb",
     "Obb(center, half_extents, axes=None, *, dtype=numpy.float64)\n--\n\nA box of any orientation: all center + axes "
     "@ u "
     "with abs(u) <= half_extents. axes: (N, N), a rotation matrix, whose columns are the axes of the box."},
    {"graze.Plane",
     "Plane(normal, offset, *, dtype=numpy.float64)\n--\n\nAll x with normal @ x == offset; in 2D a line."},
    {"graze.HalfSpace",
     "HalfSpace(normal, offset, *, dtype=numpy.float64)\n--\n\nAll x with normal @ x <= offset: the normal points out "
     "of "
     "the solid."},
    {"graze.Triangle", "Triangle(a, b, c, *, dtype=numpy.float64)\n--\n\nA triangle of three corners, (N,) each."},
    {"graze.Capsule",
     "Capsule(a, b, radius, *, dtype=numpy.float64)\n--\n\nAll points at most `radius` away from the segment from a to "
     "b."},
    {"graze.Polytope",
     "Polytope(points, *, dtype=numpy.float64)\n--\n\nThe convex hull of points, (n, N); its corners in the order of "
     "the "
     "points, in 2D counter-clockwise. `convex_hull` sorts them."},
    {"graze.Compound",
     "Compound(parts, *, dimension=None, dtype=None)\n--\n\nThe union of shapes of one dimension and dtype. Without "
     "parts "
     "it needs the dimension, and touches nothing."},
    {"graze.Mesh",
     "Mesh(vertices, faces, kind='surface', *, dimension=None, dtype=numpy.float64)\n--\n\nTriangles with common "
     "vertices: "
     "(n, N) numbers and (m, 3) indices. kind: 'surface', the union of the faces, or 'solid', in 3D also what they "
     "enclose."},
}};

std::array<PyTypeObject*, shape_types.size()> python_types = {};

constexpr std::string_view name_in_module(const char* qualified) {
  const std::string_view name = qualified;
  return name.substr(name.rfind('.') + 1);
}

// ---- Equality and hash

bool are_equal(const HeldShape& a, const HeldShape& b) {
  if (a.any.index() != b.any.index()) return false;
  return on_pair("==", a, b, []<Dim N, class T>(const AnyShape<N, T>& in_a, const AnyShape<N, T>& in_b) {
    return detail::compare<N, T>(in_a, in_b) == 0;
  });
}

py::ssize_t hash_of(const HeldShape& shape) {
  Hash hash;
  hash.add(static_cast<std::uint64_t>(shape.any.index()));
  on_shape(shape, [&hash]<Dim N, class T>(const AnyShape<N, T>& any) { hash.add<N, T>(any); });
  return hash.value();
}

// ---- The types

std::size_t alternative_of(const HeldShape& shape) {
  return on_shape(shape, [](const auto& any) { return any.index(); });
}

/// The shape behind `self`, which is anything if Python calls a method through its type.
const HeldShape& shape_behind(const py::object& self) {
  if (!is_boxed<HeldShape>(self)) {
    throw py::type_error(fmt::format("a {} is no shape", Py_TYPE(self.ptr())->tp_name));
  }
  return unboxed<HeldShape>(self);
}

/// The constructor's arguments, for pickle.
py::tuple reduced(const py::object& self) {
  const HeldShape& shape = shape_behind(self);
  const std::size_t alternative = alternative_of(shape);
  py::dict keywords;
  const auto names = field_names(alternative);
  for (std::size_t i = 0; i < names.size(); ++i) {
    keywords[py::str(std::string(names[i]))] = field_value(shape, i, self);
  }
  keywords["dtype"] = std::string(name_of_numbers(world_of(shape)));
  if (!has_fixed_size(alternative)) keywords["dimension"] = world_of(shape).dimension;
  const py::object restore = py::module_::import("graze._shapes").attr("restore_shape");
  return py::make_tuple(restore, py::make_tuple(std::string(type_name_in_python(alternative)), keywords));
}

template <class T>
py::object with_numbers_of(const HeldShape& shape) {
  return on_shape(shape, []<Dim N, class From>(const AnyShape<N, From>& any) {
    return python_shape<N, T>(io::with_numbers<T, N, From>(any), "astype: the result");
  });
}

py::object as_type(const py::object& self, const py::object& dtype) {
  const HeldShape& shape = shape_behind(self);
  const bool is_double = is_double_dtype(dtype);
  if (is_double == world_of(shape).is_double) return self;
  return is_double ? with_numbers_of<double>(shape) : with_numbers_of<float>(shape);
}

py::object many(std::size_t alternative, const py::args& arguments, const py::kwargs& keywords) {
  const FieldArguments fields = field_arguments(alternative, arguments, keywords);
  return in_world(world_of_arguments(fields, true),
                  [&]<Dim N, class T>(In<N, T>) { return boxed(HeldShapes{shapes_from_rows<N, T>(fields)}); });
}

py::object field_of(const py::object& self, std::size_t alternative, std::size_t field) {
  const HeldShape& shape = shape_behind(self);
  if (alternative_of(shape) != alternative) {
    throw py::type_error(fmt::format("{} is no {}", described(shape), type_name_in_python(alternative)));
  }
  return field_value(shape, field, self);
}

void add_shape_type(py::module_& module, std::size_t alternative) {
  TypeMaker maker = TypeMaker::of<HeldShape>(module, shape_types[alternative].name, shape_types[alternative].doc,
                                             boxed_type<HeldShape>);
  python_types[alternative] = maker.type();
  maker.constructor([alternative](const py::args& arguments, const py::kwargs& keywords) {
    return shape_from(field_arguments(alternative, arguments, keywords));
  });
  const auto names = field_names(alternative);
  py::tuple match_arguments(names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string name(names[i]);
    maker.property(
        name.c_str(), [i, alternative](const py::object& self) { return field_of(self, alternative, i); }, "");
    match_arguments[i] = name;
  }
  maker.attribute("__match_args__", match_arguments);
  if (has_fixed_size(alternative)) {
    maker.static_method(
        "many",
        [alternative](const py::args& arguments, const py::kwargs& keywords) {
          return many(alternative, arguments, keywords);
        },
        "graze.Shapes of this type, from arrays with a row for each: the arguments of the constructor with one more "
        "axis.");
  }
  maker.finish();
}

}  // namespace

std::string_view type_name_in_python(std::size_t alternative) { return name_in_module(shape_types[alternative].name); }

py::object dtype_of(World world) { return py::dtype(std::string(name_of_numbers(world))); }

World world_of(const HeldShape& shape) {
  return on_shape(shape, []<Dim N, class T>(const AnyShape<N, T>&) { return In<N, T>::world; });
}

std::string described(World world) { return fmt::format("in {}D of {}", world.dimension, name_of_numbers(world)); }

std::string described(const HeldShape& shape) {
  const std::string_view type = type_name_in_python(alternative_of(shape));
  return fmt::format("{} {} {}", type == "Aabb" || type == "Obb" ? "an" : "a", type, described(world_of(shape)));
}

std::string WayOut<HeldShape>::of(py::handle object) {
  if (py::hasattr(object, "vertices") && py::hasattr(object, "faces")) {
    return ": graze.Mesh(mesh.vertices, mesh.faces) makes one of a mesh";
  }
  if (py::hasattr(object, "exterior")) {
    return ": graze.Polytope(polygon.exterior.coords) makes one of a convex polygon";
  }
  if (is_boxed<HeldShapes>(object)) return ": graze.Compound makes one of several";
  if (py::isinstance<py::array>(object) || py::isinstance<py::list>(object) || py::isinstance<py::tuple>(object)) {
    return ": graze.Point makes one of a position, graze.convex_hull one of several";
  }
  return ": make one by graze.Sphere, graze.Obb, graze.Mesh or another of its types";
}

bool is_double_dtype(py::handle dtype) {
  const py::dtype type = py::dtype::from_args(py::reinterpret_borrow<py::object>(dtype));
  if (type.kind() == 'f' && (type.itemsize() == 4 || type.itemsize() == 8)) return type.itemsize() == 8;
  throw py::type_error(
      fmt::format("dtype is {}; float32 or float64 is needed", std::string(py::str(py::object(type)))));
}

template <Dim N, class T>
py::object python_shape(AnyShape<N, T> shape, std::string_view role) {
  if (const std::string_view fault = defect(shape); !fault.empty()) {
    throw py::value_error(fmt::format("{} {}", role, fault));
  }
  PyTypeObject* const type = python_types[shape.index()];
  return boxed_as<HeldShape>(type, HeldShape{std::move(shape)});
}

void refuse_pair(const char* function, const HeldShape& a, const HeldShape& b) {
  const std::string facts = fmt::format("{}: a is {}, b is {}", function, described(a), described(b));
  if (world_of(a).dimension != world_of(b).dimension) {
    throw py::value_error(facts + "; both need the same dimension");
  }
  throw py::type_error(facts + "; both need the same dtype: use astype");
}

void refuse_world(std::string_view role, World given, std::string_view given_text, std::string_view other,
                  World needed) {
  const std::string facts = fmt::format("{} {}, {} {}", role, given_text, other, described(needed));
  if (given.dimension != needed.dimension) throw py::value_error(facts);
  throw py::type_error(facts + ": use astype");
}

World world_of_shapes(const char* function, py::handle sequence) {
  if (is_boxed<HeldShapes>(sequence)) return world_of(unboxed<HeldShapes>(sequence));
  const bool is_sequence = PySequence_Check(sequence.ptr()) != 0;
  const py::ssize_t size = is_sequence ? PySequence_Size(sequence.ptr()) : -1;
  if (is_sequence && size < 0) throw py::error_already_set();
  if (size == 0) throw py::value_error(fmt::format("{}: there are no shapes, so the dimension is unknown", function));
  const auto first = size > 0 ? py::reinterpret_steal<py::object>(PySequence_GetItem(sequence.ptr(), 0)) : py::object();
  if (PyErr_Occurred() != nullptr) throw py::error_already_set();
  if (!first || !is_boxed<HeldShape>(first)) {
    throw py::type_error(fmt::format("{}: {} is not a sequence of shapes", function, Py_TYPE(sequence.ptr())->tp_name));
  }
  return world_of(unboxed<HeldShape>(first));
}

template <Dim N, class T>
std::vector<AnyShape<N, T>> shapes_of(const char* function, py::handle sequence) {
  if (is_boxed<HeldShapes>(sequence)) {
    const auto shapes = std::get<ShapeList<N, T>>(unboxed<HeldShapes>(sequence).any).any();
    return {shapes.begin(), shapes.end()};
  }
  const auto list = py::reinterpret_steal<py::object>(PySequence_Fast(sequence.ptr(), "shapes are needed"));
  if (!list) throw py::error_already_set();
  std::vector<AnyShape<N, T>> shapes;
  const auto size = static_cast<std::size_t>(PySequence_Fast_GET_SIZE(list.ptr()));
  shapes.reserve(size);
  for (std::size_t i = 0; i < size; ++i) {
    const py::handle element = PySequence_Fast_GET_ITEM(list.ptr(), static_cast<py::ssize_t>(i));
    if (!is_boxed<HeldShape>(element)) {
      throw py::type_error(fmt::format("{}: shape {} is a {}", function, i, Py_TYPE(element.ptr())->tp_name));
    }
    const auto& held = unboxed<HeldShape>(element);
    const auto* const shape = std::get_if<AnyShape<N, T>>(&held.any);
    if (shape == nullptr) {
      const std::string facts = fmt::format("{}: shape {} is {}, but the others are in {}D of {}", function, i,
                                            described(held), N, name_of_numbers(In<N, T>::world));
      if (world_of(held).dimension != N) throw py::value_error(facts);
      throw py::type_error(facts + ": use astype");
    }
    shapes.push_back(*shape);
  }
  return shapes;
}

void add_shapes(py::module_& module) {
  TypeMaker base = TypeMaker::of<HeldShape>(module, "graze.Shape",
                                            "What all shapes have in common: closed sets in world coordinates, which "
                                            "never change. Shapes with equal fields are "
                                            "equal, and `repr` is an expression that makes the shape.");
  base.no_constructor("Shape is the base of the types of shapes: make a Sphere, an Obb, a Mesh or another");
  add_equality<HeldShape>(base, &are_equal, &hash_of);
  base.method("__repr__", &expression);
  base.method("__reduce__", &reduced);
  base.method("_repr_svg_", &svg_of_shape, "A picture of the shape.");
  base.method("astype", &as_type, py::arg("dtype"), "The shape with numbers of float32 or float64, which are rounded.");
  base.property(
      "dimension", [](const HeldShape& shape) { return world_of(shape).dimension; }, "2 or 3");
  base.property(
      "dtype", [](const HeldShape& shape) { return dtype_of(world_of(shape)); }, "float32 or float64");
  for (std::size_t alternative = 0; alternative < shape_types.size(); ++alternative)
    add_shape_type(module, alternative);
  base.finish();
}

#define GRAZE_PYTHON_SHAPES(N, T)                                           \
  template py::object python_shape<N, T>(AnyShape<N, T>, std::string_view); \
  template std::vector<AnyShape<N, T>> shapes_of<N, T>(const char*, py::handle);
GRAZE_PYTHON_SHAPES(2, float)
GRAZE_PYTHON_SHAPES(2, double)
GRAZE_PYTHON_SHAPES(3, float)
GRAZE_PYTHON_SHAPES(3, double)
#undef GRAZE_PYTHON_SHAPES

}  // namespace graze::python
