// SPDX-License-Identifier: MIT
// A scene as held by JavaScript.
#pragma once

#include <cstdint>
#include <string>
#include <tuple>
#include <type_traits>
#include <variant>
#include <vector>

#include <graze/io/scene_file.hpp>
#include <graze/math/vec.hpp>
#include <graze/scene/filter.hpp>
#include <graze/scene/object.hpp>
#include <graze/shape/any_shape.hpp>

#include "bridge.hpp"

namespace graze::wasm {

/// An object with a velocity, as it was when its file was read.
template <Dim N>
struct Mover {
  ObjectId id;
  AnyShape<N, double> shape;
  Vec<N, double> velocity;
};

/// An object's shape before a pose rotates and moves it.
template <Dim N>
struct Unposed {
  std::uint32_t generation = 0;  ///< The generation of its object; 0 for none.
  AnyShape<N, double> shape = Vec<N, double>(0.0);
};

/// A scene of either dimension with what its file says in addition, and the owner of its ids, which JavaScript does not
/// see.
struct SceneHandle {
  io::SceneFile file;
  std::uint32_t owner = 0;
  std::variant<std::vector<Mover<2>>, std::vector<Mover<3>>> movers = {};
  std::tuple<std::vector<Unposed<2>>, std::vector<Unposed<3>>> unposed = {};  ///< By the indexes of ids.

  ObjectId id_of(double id) const {
    const UnpackedId unpacked = unpacked_id(id);
    return {unpacked.index, unpacked.generation, owner};
  }

  /// Calls visitor(scene) with the scene of its dimension.
  template <class Visit>
  auto visit(const Visit& visitor) {
    return std::visit(visitor, file.scene);
  }
};

template <class S>
inline constexpr Dim dimension_in = 0;
template <Dim N>
inline constexpr Dim dimension_in<Scene<N, double>> = N;

/// The dimension of the scene passed to a generic visitor.
template <class S>
inline constexpr Dim dimension_of_scene = dimension_in<std::remove_cvref_t<S>>;

inline void put_id(ObjectId id) { answer().push_back(packed_id(id.index, id.generation)); }

inline void put_ids(const std::vector<ObjectId>& ids) {
  for (const ObjectId id : ids) put_id(id);
}

/// A const method: embind requires methods of the registered class, hence functions that take the scene.
template <auto question>
constexpr auto asked = &Guarded<question>::call;

/// The options of an object from JSON, before names of layers are looked up.
class ObjectWords {
 public:
  /// Throws io::InputError.
  explicit ObjectWords(const std::string& text);

  /// The options for this scene. Creates layers with unknown names, unless the name of the object is already taken,
  /// which `add` then reports.
  template <Dim N>
  ObjectOptions in(Scene<N, double>& scene) const;

 private:
  using LayerWord = std::variant<std::string, Layer>;

  ObjectOptions options_;
  LayerWord layer_ = Layer{0};
  std::vector<LayerWord> mask_;
  bool has_mask_ = false;
};

/// The mask of a JSON array of names and numbers of layers; all layers for an empty text. Throws std::invalid_argument
/// for a name that is not in `names`, io::InputError for other faults.
LayerMask mask_of_words(const std::string& text, const std::vector<std::string>& names);

}  // namespace graze::wasm
