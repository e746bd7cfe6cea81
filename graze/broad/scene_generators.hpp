// SPDX-License-Identifier: MIT
/// @file
/// Synthetic worlds of moving boxes, easy and hard, to measure and test broad phases. The same seed gives the same
/// boxes, bit for bit, on every machine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <graze/math/platform/export.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze {

/// How the boxes of a world are distributed around the origin. Unless stated otherwise they are the bounding boxes of
/// unit cubes in random orientations (unit squares in 2D). From 5,000 boxes on there are 0.5 to 4 overlapping pairs per
/// box, except for lattice (13 in 3D), point (all) and giants (more beyond a million).
enum class World {
  /// Uniformly distributed; the cubes fill 0.1 of the volume, in 2D 0.3 of the area (Serpa and Rodrigues 2020,
  /// "Broadmark").
  brownian,
  heavy,  ///< Sizes over 1 to 1000 with a heavy tail: one box in s is larger than s. The volumes of the boxes add up to
          ///< that of the world.
  cluster,  ///< Dense clouds of various sizes far from each other: one per 10,000 boxes, at least eight.
  line,     ///< All centers on one line along the first axis.
  plane,    ///< All centers on one plane across the last axis; in 2D the same as line.
  lattice,  ///< Axis-aligned unit cubes at integer places that touch their neighbours exactly. They move as one.
  giants,   ///< As brownian, and one in 100,000, at least three, is half as wide as the world.
  point,    ///< All centers at one point. They move as one.
};

/// The name of a world as the command line spells it.
GRAZE_EXPORT std::string_view name_of(World world);

/// The world with this name, or none.
GRAZE_EXPORT std::optional<World> world_named(std::string_view name);

/// All worlds, in the order of the enumeration.
GRAZE_EXPORT std::span<const World> all_worlds();

namespace detail {

/// A box before it is rounded to its scalar type, so that size and position do not drift while it moves.
template <Dim N>
struct MovingBody {
  Vec<N, double> center;
  Vec<N, double> half_extents;
};

}  // namespace detail

/// The boxes of a world, frame by frame. Instantiated for 2D and 3D, float and double; the float boxes are the double
/// ones, rounded.
template <Dim N, class T = float>
class GRAZE_EXPORT MovingBoxes {
 public:
  /// Creates the first frame, with `count` boxes.
  MovingBoxes(World world, std::size_t count, std::uint64_t seed);

  /// The boxes of the current frame. The view is valid as long as the object; `step` changes the boxes in place.
  std::span<const Aabb<N, T>> boxes() const { return boxes_; }

  /// Moves every box by a random step of at most a tenth of a unit along each axis. Centers bounce off the walls of the
  /// world, so that its density stays the same, and stay on their line or plane.
  void step();

  /// A box that contains the boxes of all frames.
  Aabb<N, T> bounds() const;

 private:
  void place_boxes();

  std::vector<Aabb<N, T>> boxes_;
  std::vector<detail::MovingBody<N>> bodies_;
  Aabb<N, double> walls_;                               ///< Contains the centers.
  Vec<N, double> common_offset_ = Vec<N, double>(0.0);  ///< Offset of the boxes that move as one.
  std::uint64_t state_ = 0;
  bool moves_as_one_ = false;
};

}  // namespace graze
