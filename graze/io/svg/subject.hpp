// SPDX-License-Identifier: MIT
// The content of a picture: the objects of a scene and their reported pairs.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <graze/query/verdict.hpp>
#include <graze/scene/scene.hpp>

namespace graze::io::svg {

/// A reported pair: the positions of its objects in the scene's list of ids, and their relation. A pair that is `apart`
/// was reported because its objects are near each other.
struct DrawnPair {
  std::uint32_t a;
  std::uint32_t b;
  Relation relation;

  friend bool operator==(const DrawnPair&, const DrawnPair&) = default;
};

/// The pairs of an object: their number, the positions of the first few partners, and the closest relation.
struct Touches {
  static constexpr std::size_t named = 4;

  std::size_t count = 0;
  std::array<std::uint32_t, named> first{};
  Relation closest = Relation::apart;
};

/// The pairs of each object, by position.
std::vector<Touches> touches_by_object(std::size_t objects, std::span<const DrawnPair> pairs);

/// The CSS class of an object: "overlapping", "touching" (all its contacts only touch), "near" (reported, but apart
/// from all others), or empty if it is in no pair.
std::string_view class_of(const Touches& touches);

/// A scene prepared for drawing; objects are referred to by their position here.
template <Dim N>
struct Subject {
  std::vector<ObjectId> ids;
  std::vector<const Object<N, double>*> objects;  ///< Valid as long as the scene.
  std::vector<std::string> names;                 ///< "#7" for object 7 without a name; long names are shortened.
  std::vector<Touches> touches;
  std::vector<DrawnPair> pairs;
};

/// Determines the relation of each pair. Throws std::invalid_argument if a pair names an object that is not in the
/// scene.
template <Dim N>
Subject<N> subject_of(const Scene<N, double>& scene, std::span<const ObjectPair> reported);

/// The tooltip of an object: "crate (aabb), touches floor, sphere and 3 more".
template <Dim N>
std::string title(const Subject<N>& subject, std::size_t position);

}  // namespace graze::io::svg
