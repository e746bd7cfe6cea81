// SPDX-License-Identifier: MIT
/// @file
/// slide(scene, shape, motion): moves a shape along a vector and along what is in its way.
#pragma once

#include <numbers>
#include <type_traits>
#include <vector>

#include <graze/math/platform/export.hpp>
#include <graze/math/vec.hpp>
#include <graze/scene/scene_query.hpp>
#include <graze/scene/scene_view.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze {

/// What blocks a sliding shape, and what it can climb.
struct SlideOptions {
  /// The objects that block it; the shape's own object should be among the exceptions.
  SceneQuery query = {};
  /// Against gravity, of any length but zero; in 2D the first two coordinates count.
  Vec<3, double> up = {0, 1, 0};
  /// In radians, from 0 to a right angle: a steeper surface cannot be climbed. The shape glides down along it, but
  /// stops before it like before a wall when it walks towards it. A right angle: every slope can be climbed.
  double max_slope = std::numbers::pi / 2;
  /// The height of the steps that the shape climbs, if it finds a place to stand there; a length.
  double step_height = 0;
  /// The shape stops this far from what is in its way: a length. What it comes nearer to by rounding, it moves away
  /// from at the start of the next slide. Without clearance it rests on what it touches, within the error of a cast.
  double clearance = 0.001;
};

/// Where a sliding shape ends, and what it met on its way.
template <Dim N, class T = float>
struct Slide {
  Vec<N, T> motion = Vec<N, T>(T(0));  ///< From the start to the end of its path: move the shape by it.
  /// In order, with the time of each touch, from 0 to 1. One object may be there several times.
  std::vector<ObjectImpact<N, T>> touches;
};

/// Moves a shape along `motion`, and where it meets an object, along its surface: after each touch, what is left of the
/// motion is turned as little as possible so that it leads into nothing that is touched; in a corner the shape stops.
/// It takes up to 16 such turns. The scene does not change.
///
/// Each part of the path is a shape_cast with `clearance` as the distance to stop at, so the shape passes through
/// nothing, and never ends in an overlap with an object that it did not overlap at the start. If it starts nearer to
/// objects than half the clearance, or overlapping them, it first moves out along the normals of the contacts, as far
/// as other objects let it. Objects are not moved; time is not part of it.
///
/// Throws std::invalid_argument if the shape is invalid (see `defect`), and if the motion or an option is not finite,
/// an option is negative or `up` is zero.
template <Dim N, class T>
GRAZE_EXPORT Slide<N, T> slide(const SceneView<N, T>& scene, const std::type_identity_t<AnyShape<N, T>>& shape,
                               const std::type_identity_t<Vec<N, T>>& motion, const SlideOptions& options = {});

}  // namespace graze
