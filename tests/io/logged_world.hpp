// SPDX-License-Identifier: MIT
// Random histories of a scene, for the tests of query logs.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <graze/io/log/query_log.hpp>
#include <graze/io/recorded_scene.hpp>

#include "cameras.hpp"
#include "catalogue.hpp"

namespace graze::io {

/// Sends a scene all kinds of queries about random shapes.
template <Dim N, class T>
void ask_at_random(const RecordedScene<N, T>& scene) {
  const AnyShape<N, T> region = *test::any_shape<N, T>();
  const LayerMask layers = *rc::gen::element(all_layers, LayerMask{1}, LayerMask{2}, LayerMask{0});
  const std::vector<ObjectId> all = scene.ids();
  const std::vector<ObjectId> except(all.begin(),
                                     all.begin() + *rc::gen::inRange<std::ptrdiff_t>(0, std::ssize(all) + 1));
  const SceneQuery query{.layers = layers, .except = except, .ignore_initial_touch = *rc::gen::arbitrary<bool>()};
  switch (*rc::gen::inRange(0, 13)) {
    case 0:
      scene.overlapping(region, query);
      break;
    case 1:
      scene.cull(region, query);
      break;
    case 2:
      scene.nearest(*test::any<Vec<N, T>>(), *rc::gen::inRange<std::size_t>(0, 5), query);
      break;
    case 3:
      scene.ray_cast(*test::any<Ray<N, T>>(), *rc::gen::element(T(1), std::numeric_limits<T>::infinity()), query);
      break;
    case 4:
      scene.ray_cast_all(*test::any<Ray<N, T>>(), *rc::gen::element(T(1), std::numeric_limits<T>::infinity()), query);
      break;
    case 5:
      scene.contacts();
      break;
    case 6:
      scene.candidates(*rc::gen::element(0.0, 0.5, 3.0));
      break;
    case 7:
      scene.shape_cast(region, *test::any<Vec<N, T>>(), query);
      break;
    case 8:
      scene.shape_cast_all(region, *test::any<Vec<N, T>>(), query);
      break;
    case 9:
      scene.time_of_impact(region, {*test::any<Vec<N, T>>(), Turn<N, T>(T(1)), *test::any<Vec<N, T>>()}, query);
      break;
    case 10:
      scene.contacts_with(region, query);
      break;
    case 11:
      scene.nearest(region, *rc::gen::inRange<std::size_t>(0, 5), query);
      scene.closest_pairs(*rc::gen::element(T(0), T(0.5), T(3)));
      break;
    default:
      scene.pairs();
      scene.find(*rc::gen::element<std::string>("a", "b", ""));
  }
}

/// Adds, moves and removes objects at random; some calls are rejected.
template <Dim N, class T>
void change_at_random(RecordedScene<N, T>& scene, std::vector<ObjectId>& ids) {
  const AnyShape<N, T> shape = *test::any_shape<N, T>();
  const int act = *rc::gen::inRange(0, 10);
  if (act < 3 || ids.empty()) {
    const auto name = *rc::gen::element<std::string>("", "", "", "a", "b");
    const auto layer = *rc::gen::element<Layer>(0, 1, 1, 64);
    const auto mask = *rc::gen::element(all_layers, LayerMask{1});
    const auto mobility = *rc::gen::element(Mobility::moving, Mobility::fixed);
    ids.push_back(scene.add(shape, {name, layer, mask, 7, mobility}));
    return;
  }
  const auto any_id = [&ids] { return ids[*rc::gen::inRange<std::size_t>(0, ids.size())]; };  // including removed ones
  if (act < 5) {
    scene.move(any_id(), shape);
  } else if (act < 6) {
    std::vector<ObjectMove<N, T>> moves;
    for (int i = 0; i < 3; ++i) moves.push_back({any_id(), *test::any_shape<N, T>()});
    scene.move(moves);
  } else if (act < 7) {
    scene.remove(any_id());
  } else if (act < 8) {
    scene.except(any_id(), any_id());
  } else if (act < 9) {
    scene.accept(any_id(), any_id());
  } else {
    scene.layer(*rc::gen::element<std::string>("walls", "ghosts"));
  }
}

/// The log of such a history.
template <Dim N, class T>
std::string random_log(int length) {
  std::ostringstream log;
  RecordedScene<N, T> scene(log);
  std::vector<ObjectId> ids;
  for (int i = 0; i < length; ++i) {
    try {
      change_at_random(scene, ids);
    } catch (const std::logic_error&) {  // is recorded in the log
    }
    if (*rc::gen::inRange(0, 3) == 0) scene.update();
    if (*rc::gen::inRange(0, 2) == 0) ask_at_random(scene);
  }
  return log.str();
}

}  // namespace graze::io
