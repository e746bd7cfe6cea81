// SPDX-License-Identifier: MIT
// Random walks of a shape that slides through a scene and must never overlap an object.
#pragma once

#include <cstddef>

#include <gtest/gtest.h>

#include <graze/query/relation.hpp>
#include <graze/query/transformed.hpp>
#include <graze/scene/scene_view.hpp>
#include <graze/scene/slide.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze::test {

/// Whether a shape certainly overlaps an object, by more than the rounding error of `relation`.
template <Dim N, class T>
bool overlaps_an_object(const SceneView<N, T>& scene, const AnyShape<N, T>& shape) {
  for (const ObjectId& id : scene.overlapping(shape)) {
    if (relation(shape, scene.object(id).shape) == Relation::overlapping) return true;
  }
  return false;
}

/// What happened on a walk.
template <Dim N, class T>
struct Walk {
  AnyShape<N, T> end;
  std::size_t touches = 0;
  double way = 0;  ///< The sum of the largest coordinates of all motions.
};

/// Slides a shape by motion_of(step) in each step. It must overlap nothing at the start.
template <Dim N, class T, class MotionOf>
Walk<N, T> expect_a_walk_without_overlap(const SceneView<N, T>& scene, const AnyShape<N, T>& start, std::size_t steps,
                                         const SlideOptions& options, const MotionOf& motion_of) {
  Walk<N, T> walk{start};
  for (std::size_t step = 0; step < steps; ++step) {
    const Slide<N, T> moved = slide(scene, walk.end, motion_of(step), options);
    walk.end = translated<N, T>(walk.end, moved.motion);
    walk.touches += moved.touches.size();
    walk.way += static_cast<double>(max_abs(moved.motion));
    if (!overlaps_an_object(scene, walk.end)) continue;
    ADD_FAILURE() << "the shape overlaps an object after step " << step;
    break;
  }
  return walk;
}

}  // namespace graze::test
