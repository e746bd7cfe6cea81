// SPDX-License-Identifier: MIT
// The observable state of a scene, for comparison with a later one.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <graze/math/vec.hpp>
#include <graze/scene/scene.hpp>

namespace graze::test {

template <Dim N, class T>
struct SceneSight {
  std::vector<ObjectId> ids;
  std::vector<ObjectId> vacant;
  std::vector<std::pair<std::string, Aabb<N, T>>> objects;
  std::vector<std::string> layers;
  std::vector<ObjectPair> excepted;
  std::vector<ObjectPair> candidates;
  std::vector<ObjectPair> pairs;
  std::vector<ObjectPair> began;
  std::vector<ObjectPair> stayed;
  std::vector<ObjectPair> ended;
  std::vector<ObjectId> overlapping;
  std::vector<NearObject<T>> nearest;

  friend bool operator==(const SceneSight&, const SceneSight&) = default;
};

template <Dim N, class T>
SceneSight<N, T> ray_verdict_of(const Scene<N, T>& scene) {
  SceneSight<N, T> verdict;
  verdict.ids = scene.ids();
  verdict.vacant = scene.vacant_ids();
  for (const ObjectId id : verdict.ids) {
    const Object<N, T>& object = scene.object(id);
    // Whether the name finds another object is part of the state.
    const bool is_found = object.name.empty() || scene.find(object.name) == id;
    verdict.objects.emplace_back(is_found ? object.name : "not found", object.box);
  }
  verdict.layers = scene.layer_names();
  verdict.excepted = scene.excepted_pairs();
  verdict.candidates = scene.candidates();
  verdict.pairs = scene.pairs();
  verdict.began = scene.events().began;
  verdict.stayed = scene.events().stayed;
  verdict.ended = scene.events().ended;
  verdict.overlapping = scene.overlapping(Sphere<N, T>{Vec<N, T>(T(0)), T(9)});
  verdict.nearest = scene.nearest(Vec<N, T>(T(0)), 9);
  return verdict;
}

}  // namespace graze::test
