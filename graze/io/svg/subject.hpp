// SPDX-License-Identifier: MIT
// What a picture is to show: the objects of a scene and what they touch.
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

/// A reported pair: the positions of its objects in the scene's list of ids, and how they meet. A pair that is `apart`
/// was reported because its objects are near each other.
struct DrawnPair {
  std::uint32_t a;
  std::uint32_t b;
  Relation relation;

  friend bool operator==(const DrawnPair&, const DrawnPair&) = default;
};

/// The pairs an object is in: how many, the positions of the first few partners, and the closest relation among them.
struct Touches {
  static constexpr std::size_t named = 4;

  std::size_t count = 0;
  std::array<std::uint32_t, named> first{};
  Relation closest = Relation::apart;
};

/// The pairs of each of so many objects, by position.
std::vector<Touches> touches_by_object(std::size_t objects, std::span<const DrawnPair> pairs);

/// How the picture shows an object, as the class of its element: "overlapping", "touching" (what it meets it only
/// touches), "near" (reported, but apart from all others), or empty where it is in no pair.
std::string_view class_of(const Touches& touches);

/// A scene ready to be drawn: an object is spoken of by its position here.
template <Dim N>
struct Subject {
  std::vector<ObjectId> ids;
  std::vector<const Object<N, double>*> objects;  ///< As long as the scene lives.
  std::vector<std::string> names;                 ///< "#7" for object 7 if it has none; shortened where very long.
  std::vector<Touches> touches;
  std::vector<DrawnPair> pairs;
};

/// Decides how the objects of each pair meet. Throws std::invalid_argument when a pair names no object of the scene.
template <Dim N>
Subject<N> subject_of(const Scene<N, double>& scene, std::span<const ObjectPair> reported);

/// The sentence shown when the mouse rests on an object: "crate (aabb), touches floor, sphere and 3 more".
template <Dim N>
std::string title(const Subject<N>& subject, std::size_t position);

}  // namespace graze::io::svg
