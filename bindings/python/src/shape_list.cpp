// SPDX-License-Identifier: MIT
// graze.Shapes.
#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <pybind11/numpy.h>

#include <graze/shape/fields/shape_order.hpp>

#include "equality.hpp"
#include "module.hpp"
#include "shape.hpp"

namespace graze::python {
namespace {

py::object shapes_from(const py::object& sequence, const py::object& dimension, const py::object& dtype) {
  if (is_boxed<HeldShapes>(sequence)) return sequence;
  if (is_empty_sequence(sequence) && !dimension.is_none()) {
    return in_world(world_of_words("Shapes", dimension, dtype), []<Dim N, class T>(In<N, T>) {
      return boxed(HeldShapes{ShapeList<N, T>(std::vector<AnyShape<N, T>>())});
    });
  }
  return in_world(world_of_shapes("Shapes", sequence), [&]<Dim N, class T>(In<N, T>) {
    return boxed(HeldShapes{ShapeList<N, T>(shapes_of<N, T>("Shapes", sequence))});
  });
}

py::ssize_t size_of(const HeldShapes& shapes) {
  return std::visit([](const auto& list) { return static_cast<py::ssize_t>(list.size()); }, shapes.any);
}

/// shapes[first:last:step]: they keep the one type that all have.
py::object part_of(const HeldShapes& shapes, const py::slice& slice) {
  py::ssize_t place = 0;
  py::ssize_t last = 0;
  py::ssize_t step = 0;
  py::ssize_t count = 0;
  if (!slice.compute(size_of(shapes), &place, &last, &step, &count)) throw py::error_already_set();
  return std::visit(
      [&]<Dim N, class T>(const ShapeList<N, T>& list) {
        return list.visit([&]<class S>(std::span<const S> all) {
          std::vector<S> part;
          part.reserve(static_cast<std::size_t>(count));
          for (py::ssize_t i = 0; i < count; ++i) part.push_back(all[static_cast<std::size_t>(place + i * step)]);
          return boxed(HeldShapes{ShapeList<N, T>(std::move(part))});
        });
      },
      shapes.any);
}

py::object element_of(const HeldShapes& shapes, const py::object& which) {
  if (py::isinstance<py::slice>(which)) return part_of(shapes, which);
  const py::ssize_t index = PyNumber_AsSsize_t(which.ptr(), PyExc_IndexError);
  if (index == -1 && PyErr_Occurred() != nullptr) throw py::error_already_set();
  const py::ssize_t size = size_of(shapes);
  const py::ssize_t place = index < 0 ? index + size : index;
  if (place < 0 || place >= size)
    throw py::index_error(fmt::format("Shapes has {} shapes, but the index is {}", size, index));
  return std::visit(
      [place]<Dim N, class T>(const ShapeList<N, T>& list) {
        return python_shape<N, T>(list.any()[static_cast<std::size_t>(place)], "Shapes");
      },
      shapes.any);
}

bool are_equal(const HeldShapes& a, const HeldShapes& b) {
  if (a.any.index() != b.any.index()) return false;
  return std::visit(
      [&b]<Dim N, class T>(const ShapeList<N, T>& list) {
        const auto of_a = list.any();
        const auto of_b = std::get<ShapeList<N, T>>(b.any).any();
        return std::equal(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(),
                          [](const auto& one, const auto& other) { return detail::compare<N, T>(one, other) == 0; });
      },
      a.any);
}

py::ssize_t hash_of(const HeldShapes& shapes) {
  Hash hash;
  hash.add(static_cast<std::uint64_t>(shapes.any.index()));
  std::visit(
      [&hash]<Dim N, class T>(const ShapeList<N, T>& list) {
        for (const AnyShape<N, T>& shape : list.any()) hash.add<N, T>(shape);
      },
      shapes.any);
  return hash.value();
}

}  // namespace

World world_of(const HeldShapes& shapes) {
  return std::visit([]<Dim N, class T>(const ShapeList<N, T>&) { return In<N, T>::world; }, shapes.any);
}

void add_shape_list(py::module_& module) {
  TypeMaker maker = TypeMaker::of<HeldShapes>(
      module, "graze.Shapes",
      "Shapes(shapes, dimension=None, dtype=numpy.float64)\n--\n\nAn immutable sequence of shapes of one dimension "
      "and dtype, which batches read without a copy; equal to others of the same dtype with equal shapes. "
      "Types like Sphere make one from arrays: Sphere.many(centers, radii).");
  maker.constructor(&shapes_from, py::arg("shapes"), py::arg("dimension") = py::none(), py::arg("dtype") = py::none());
  maker.method("__len__", &size_of);
  maker.method("__getitem__", &element_of, py::arg("index"));
  add_equality<HeldShapes>(maker, &are_equal, &hash_of);
  maker.method("__reduce__", [](const py::object& self) {
    if (!is_boxed<HeldShapes>(self)) throw py::type_error("the object is no graze.Shapes");
    const HeldShapes& shapes = unboxed<HeldShapes>(self);
    const World world = world_of(shapes);
    const py::handle type = reinterpret_cast<PyObject*>(boxed_type<HeldShapes>);
    if (size_of(shapes) > 0) return py::make_tuple(type, py::make_tuple(py::list(self)));
    return py::make_tuple(type,
                          py::make_tuple(py::list(), world.dimension, py::dtype(std::string(name_of_numbers(world)))));
  });
  maker.method("__repr__", [](const HeldShapes& shapes) {
    const World world = world_of(shapes);
    return fmt::format("<graze.Shapes: {} in {}D, {}>", size_of(shapes), world.dimension, name_of_numbers(world));
  });
  maker.property(
      "dimension", [](const HeldShapes& shapes) { return world_of(shapes).dimension; }, "2 or 3");
  maker.property(
      "dtype", [](const HeldShapes& shapes) { return dtype_of(world_of(shapes)); }, "float32 or float64");
  maker.finish();
}

}  // namespace graze::python
