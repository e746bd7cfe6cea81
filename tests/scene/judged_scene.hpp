// SPDX-License-Identifier: MIT
// A scene beside a PlainScene with the same objects, which judges its answers; and small shapes for both.
#pragma once

#include <cstddef>
#include <vector>

#include <graze/scene/plain_scene.hpp>
#include <graze/scene/scene.hpp>
#include <graze/shape/any_shape.hpp>

#include "broad/box_worlds.hpp"

namespace graze::test {

/// To inherit from: the derived class asks both scenes.
template <Dim N, class T>
class JudgedScene {
 public:
  using Shape = AnyShape<N, T>;

  void add(const Shape& shape, const ObjectOptions& options = {}) {
    held_.push_back({scene_.add(shape, options), judge_.add(shape, options)});
  }
  void move(std::size_t place, const Shape& shape) {
    scene_.move(held_[place].id, shape);
    judge_.move(held_[place].judged, shape);
  }
  void remove(std::size_t place) {
    scene_.remove(held_[place].id);
    judge_.remove(held_[place].judged);
    held_.erase(held_.begin() + static_cast<std::ptrdiff_t>(place));
  }
  std::size_t size() const { return held_.size(); }
  const Shape& shape(std::size_t place) const { return scene_.object(held_[place].id).shape; }

 protected:
  /// The same object in both. The scenes give out the same ids, except for the owner.
  struct Held {
    ObjectId id;
    ObjectId judged;
  };
  static bool are_same(const ObjectId& one, const ObjectId& other) {
    return one.index == other.index && one.generation == other.generation;
  }

  const Scene<N, T>& scene() const { return scene_; }
  const PlainScene<N, T>& judge() const { return judge_; }
  const Held& held(std::size_t place) const { return held_[place]; }

 private:
  Scene<N, T> scene_;
  PlainScene<N, T> judge_;
  std::vector<Held> held_;
};

/// A shape of about unit size or smaller, of one of six types, in a cube of 20.
template <Dim N, class T>
AnyShape<N, T> small_shape(Numbers& numbers) {
  const double kind = numbers.between(0, 6);
  const auto at = numbers.point<N, T>(0, 20);
  const auto length = [&numbers] { return static_cast<T>(numbers.between(0.01, 1)); };
  if (kind < 1) return Sphere<N, T>{at, length()};
  if (kind < 2) return Aabb<N, T>{at, at + length()};
  if (kind < 3) return Capsule<N, T>{at, at + numbers.point<N, T>(-2, 2), length()};
  if (kind < 4) return Triangle<N, T>{at, at + numbers.point<N, T>(-1, 1), at + numbers.point<N, T>(-1, 1)};
  if (kind < 5) return Segment<N, T>{at, at + numbers.point<N, T>(-1, 1)};
  return at;
}

}  // namespace graze::test
