// SPDX-License-Identifier: MIT
// What a picture is to show: the objects of a scene and what they touch.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <graze/scene/scene.hpp>

namespace graze::io::svg {

/// What one object touches: how many others, and the positions (in the scene's list of ids) of the first few.
struct Touches {
  static constexpr std::size_t named = 4;

  std::size_t count = 0;
  std::array<std::uint32_t, named> first{};
};

/// What each object touches, in the order of `ids`, which is ascending as `Scene::ids()` gives it.
/// Throws std::invalid_argument when a pair holds an id that is not among them.
std::vector<Touches> touches_by_object(std::span<const ObjectId> ids, std::span<const ObjectPair> pairs);

/// A scene ready to be drawn: an object is spoken of by its position here.
template <Dim N>
struct Subject {
  std::vector<ObjectId> ids;
  std::vector<const Object<N, double>*> objects;  ///< As long as the scene lives.
  std::vector<std::string> names;                 ///< "#7" for object 7 if it has none; shortened where very long.
  std::vector<Touches> touches;
};

/// Throws like `touches_by_object`.
template <Dim N>
Subject<N> subject_of(const Scene<N, double>& scene, std::span<const ObjectPair> touching);

/// The sentence shown when the mouse rests on an object: "crate (aabb), touches floor, ball and 3 more".
template <Dim N>
std::string title(const Subject<N>& subject, std::size_t position);

}  // namespace graze::io::svg
