// SPDX-License-Identifier: MIT
// Shapes as Python objects: graze.Shape and a type derived from it for each alternative of AnyShape.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/capsule.hpp>
#include <graze/shape/obb.hpp>
#include <graze/shape/sphere.hpp>

#include "boxed.hpp"

namespace graze::python {

/// A dimension and number type, as a value.
struct World {
  Dim dimension = 3;
  bool is_double = true;

  friend bool operator==(const World&, const World&) = default;
};

/// The same as a type, passed to generic functions.
template <Dim N, class T>
struct In {
  static constexpr World world = {N, sizeof(T) == sizeof(double)};
};

/// Returns use(In<N, T>()) for a dimension of 2 or 3.
template <class Use>
auto in_world(World world, const Use& use) {
  if (world.dimension == 2) return world.is_double ? use(In<2, double>()) : use(In<2, float>());
  return world.is_double ? use(In<3, double>()) : use(In<3, float>());
}

/// One value for each world; the alternatives are in the same order for all templates.
template <template <Dim, class> class Value>
using InAnyWorld = std::variant<Value<2, float>, Value<2, double>, Value<3, float>, Value<3, double>>;

/// A valid shape of any world.
struct HeldShape {
  InAnyWorld<AnyShape> any;
};

template <>
struct BoxedName<HeldShape> {
  static constexpr auto name = py::detail::const_name("Shape");
};

template <>
struct WayOut<HeldShape> {
  /// How to make a shape of the object: ": graze.Mesh(mesh.vertices, mesh.faces) makes one of a mesh".
  static std::string of(py::handle object);
};

/// The world of a shape.
World world_of(const HeldShape& shape);

/// "in 3D of float64"
std::string described(World world);

/// "a Sphere in 3D of float64"
std::string described(const HeldShape& shape);

/// "float32" or "float64"
constexpr std::string_view name_of_numbers(World world) { return world.is_double ? "float64" : "float32"; }
py::object dtype_of(World world);

/// The world's number type from the argument `dtype`: anything that numpy.dtype accepts and that is float32 or float64.
/// Throws TypeError for any other.
bool is_double_dtype(py::handle dtype);

/// The names of the Python types, in the order of AnyShape.
std::string_view type_name_in_python(std::size_t alternative);

/// A new Python object of the type of the alternative. Throws ValueError, beginning with `role`, for a shape that is
/// not valid: results can overflow.
template <Dim N, class T>
py::object python_shape(AnyShape<N, T> shape, std::string_view role);

/// Calls use(shape_a, shape_b) for two shapes of one world. Throws ValueError for different dimensions, TypeError for
/// different number types; the message begins with the name of the function.
template <class Use>
auto on_pair(const char* function, const HeldShape& a, const HeldShape& b, const Use& use);

[[noreturn]] void refuse_pair(const char* function, const HeldShape& a, const HeldShape& b);

template <class Use>
auto on_pair(const char* function, const HeldShape& a, const HeldShape& b, const Use& use) {
  if (a.any.index() != b.any.index()) refuse_pair(function, a, b);
  return std::visit([&]<class Any>(const Any& in_a) { return use(in_a, *std::get_if<Any>(&b.any)); }, a.any);
}

/// Throws because what was given, of a text such as "a Sphere in 3D of float32", is not of the world of `other`:
/// ValueError for another dimension, TypeError for another dtype.
[[noreturn]] void refuse_world(std::string_view role, World given, std::string_view given_text, std::string_view other,
                               World needed);

/// A shape as one of the world of `other`, such as "the scene". Throws ValueError and TypeError as above.
template <Dim N, class T>
const AnyShape<N, T>& shape_in(std::string_view role, const HeldShape& shape, std::string_view other) {
  if (const auto* const any = std::get_if<AnyShape<N, T>>(&shape.any)) return *any;
  refuse_world(role, world_of(shape), described(shape), other, In<N, T>::world);
}

template <class Use>
auto on_shape(const HeldShape& shape, const Use& use) {
  return std::visit(use, shape.any);
}

/// Whether queries on a shape may take long enough that other Python threads should run.
template <Dim N, class T>
bool is_large(const AnyShape<N, T>& shape) {
  return std::holds_alternative<Mesh<N, T>>(shape) || std::holds_alternative<Compound<N, T>>(shape);
}

/// Many valid shapes of one world. Those that rows of arrays gave keep their one type for calls that take it, and
/// become AnyShapes at the first call that needs them.
template <Dim N, class T>
class ShapeList {
 public:
  explicit ShapeList(std::vector<AnyShape<N, T>> shapes) : shapes_(std::move(shapes)) {}

  template <class S>
  explicit ShapeList(std::vector<S> shapes) {
    if constexpr (std::is_constructible_v<Kept, std::in_place_type_t<std::vector<S>>>) {
      shapes_ = std::move(shapes);
    } else {
      shapes_ = std::vector<AnyShape<N, T>>(shapes.begin(), shapes.end());
    }
  }

  std::size_t size() const {
    return visit([](const auto& shapes) { return shapes.size(); });
  }

  /// The shapes, which stay valid as long as the list. The first call may take long, and needs the GIL.
  std::span<const AnyShape<N, T>> any() const {
    return visit([this]<class S>(std::span<const S> shapes) -> std::span<const AnyShape<N, T>> {
      if constexpr (std::is_same_v<S, AnyShape<N, T>>) {
        return shapes;
      } else {
        if (converted_.empty()) converted_.assign(shapes.begin(), shapes.end());
        return converted_;
      }
    });
  }

  /// use(std::span<const S>()), where S is the type that all have, or AnyShape<N, T>.
  template <class Use>
  auto visit(const Use& use) const {
    return std::visit([&use]<class S>(const std::vector<S>& shapes) { return use(std::span<const S>(shapes)); },
                      shapes_);
  }

 private:
  using Kept = std::variant<std::vector<AnyShape<N, T>>, std::vector<Aabb<N, T>>, std::vector<Obb<N, T>>,
                            std::vector<Sphere<N, T>>, std::vector<Capsule<N, T>>>;

  Kept shapes_;
  mutable std::vector<AnyShape<N, T>> converted_;
};

/// graze.Shapes, of any world.
struct HeldShapes {
  InAnyWorld<ShapeList> any;
};

template <>
struct BoxedName<HeldShapes> {
  static constexpr auto name = py::detail::const_name("Shapes");
};

World world_of(const HeldShapes& shapes);

/// The world of graze.Shapes, or of the first shape of a sequence. Throws TypeError for anything else, ValueError for
/// an empty sequence.
World world_of_shapes(const char* function, py::handle sequence);

/// The shapes of a sequence, all of one world. Throws TypeError and ValueError, naming the first that does not fit.
template <Dim N, class T>
std::vector<AnyShape<N, T>> shapes_of(const char* function, py::handle sequence);

/// graze.Shapes, which are not copied, or the shapes of another sequence.
template <Dim N, class T>
class ShapeSequence {
 public:
  ShapeSequence(const char* function, py::handle sequence) {
    if (is_boxed<HeldShapes>(sequence)) {
      list_ = &std::get<ShapeList<N, T>>(unboxed<HeldShapes>(sequence).any);
    } else {
      list_ = &copied_.emplace(shapes_of<N, T>(function, sequence));
    }
  }
  ShapeSequence(const ShapeSequence&) = delete;
  ShapeSequence& operator=(const ShapeSequence&) = delete;

  const ShapeList<N, T>& list() const { return *list_; }
  std::span<const AnyShape<N, T>> any() const { return list_->any(); }

 private:
  std::optional<ShapeList<N, T>> copied_;
  const ShapeList<N, T>* list_;
};

void add_shapes(py::module_& module);
void add_shape_list(py::module_& module);

}  // namespace graze::python
