// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include <graze/math/vec.hpp>
#include <graze/scene/filter.hpp>
#include <graze/scene/object.hpp>
#include <graze/scene/relations.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze {

/// Two objects of a scene, the one added first as `a`.
struct ObjectPair {
  ObjectId a;
  ObjectId b;

  friend auto operator<=>(const ObjectPair&, const ObjectPair&) = default;
};

/// Shapes with names, layers and lifetimes. Reading is const and safe from many threads at once; writing is for one.
/// A call that throws leaves the scene as it was. Instantiated for 2D and 3D, float and double.
template <Dim N, class T = float>
class Scene {
 public:
  /// Adds an object. Throws std::invalid_argument, naming the fact, when the shape is not valid (see `defect`),
  /// the name is taken or the layer is not below `max_layers`.
  ObjectId add(AnyShape<N, T> shape, ObjectOptions options = {});

  /// Replaces an object's shape. Throws like `add` and `object`.
  void move(ObjectId id, AnyShape<N, T> shape);

  /// Removes an object; its id is never valid again. Throws like `object`.
  void remove(ObjectId id);

  /// True while the id names an object.
  bool contains(ObjectId id) const;

  /// The object. Throws std::out_of_range when the id names none (any more).
  const Object<N, T>& object(ObjectId id) const;

  /// The object of that name, if there is one. Empty names are not found.
  std::optional<ObjectId> find(std::string_view name) const;

  /// All ids in the order of their index, which is the order of adding while nothing is removed.
  std::vector<ObjectId> ids() const;

  std::size_t size() const { return size_; }

  /// The layer of that name; made if there is none yet. Throws std::length_error beyond `max_layers`.
  Layer layer(std::string_view name);

  /// The names of the layers made so far, by number.
  const std::vector<std::string>& layer_names() const { return layer_names_; }

  /// All pairs whose boxes overlap and whose filters admit each other: what is worth an exact test. Ascending.
  std::vector<ObjectPair> candidates() const;

  /// All pairs that touch or overlap and whose filters admit each other, exactly tested. Ascending.
  std::vector<ObjectPair> pairs() const;

 private:
  struct Slot {
    std::optional<Object<N, T>> object;
    std::uint32_t generation = 0;
  };

  std::vector<Slot> slots_;
  std::vector<std::uint32_t> free_;
  std::unordered_map<std::string, ObjectId> by_name_;
  std::vector<std::string> layer_names_;
  std::size_t size_ = 0;
};

extern template class Scene<2, float>;
extern template class Scene<3, float>;
extern template class Scene<2, double>;
extern template class Scene<3, double>;

}  // namespace graze
