// SPDX-License-Identifier: MIT
// Made-up worlds of moving boxes, friendly and hostile, to measure and test broad phases with. The same seed gives the
// same boxes, bit for bit, on every machine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze {

/// How the boxes of a world are spread around the origin. Unless said otherwise they are the bounding boxes of unit
/// cubes in random orientations (unit squares in 2D). From 5,000 boxes up there are 0.5 to 4 overlapping pairs per box,
/// but for lattice (13 in 3D), point (all) and giants (more beyond a million).
enum class World {
  brownian,  ///< Spread evenly; the cubes fill a tenth of space (Serpa and Rodrigues 2020, "Broadmark"), in 2D three.
  heavy,     ///< Sizes over 1 to 1000 with a heavy tail: one in s is larger than s. The volumes of the boxes add up to
             ///< that of the world.
  cluster,   ///< Dense clouds of various sizes far from each other: one per 10,000 boxes, at least eight.
  line,      ///< All centers on one line along the first axis.
  plane,     ///< All centers on one plane across the last axis; in 2D the same as line.
  lattice,   ///< Axis-aligned unit cubes at integer places that touch their neighbours exactly. They move as one.
  giants,    ///< As brownian, and one in 100,000, at least three, is half as wide as the world.
  point,     ///< All centers at one point. They move as one.
};

/// The name of a world, as the command line spells it.
std::string_view name_of(World world);

/// The world of that name, if there is one.
std::optional<World> world_named(std::string_view name);

/// All worlds, in the order of the enumeration.
std::span<const World> all_worlds();

namespace detail {

/// A box before it is rounded to its scalar type, so that neither size nor place drifts while it moves.
template <Dim N>
struct MovingBody {
  Vec<N, double> center;
  Vec<N, double> half_extents;
};

}  // namespace detail

/// The boxes of a world, frame by frame. Instantiated for 2D and 3D, float and double; those in float are those in
/// double, rounded.
template <Dim N, class T = float>
class MovingBoxes {
 public:
  MovingBoxes(World world, std::size_t count, std::uint64_t seed);

  /// The boxes of the present frame, of which the first is number 0.
  std::span<const Aabb<N, T>> boxes() const { return boxes_; }

  /// Moves every box by a random step of at most a tenth of a unit along each axis. Centers bounce off the walls of the
  /// world, so that it stays as dense as it is, and stay on their line or plane.
  void step();

  /// A box that contains all boxes of all frames.
  Aabb<N, T> bounds() const;

 private:
  void place_boxes();

  std::vector<Aabb<N, T>> boxes_;
  std::vector<detail::MovingBody<N>> bodies_;
  Aabb<N, double> walls_;                               ///< Contains the centers.
  Vec<N, double> common_offset_ = Vec<N, double>(0.0);  ///< How far all have moved together.
  std::uint64_t state_ = 0;
  bool moves_as_one_ = false;
};

extern template class MovingBoxes<2, float>;
extern template class MovingBoxes<3, float>;
extern template class MovingBoxes<2, double>;
extern template class MovingBoxes<3, double>;

}  // namespace graze
