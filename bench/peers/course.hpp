// SPDX-License-Identifier: MIT
// The scenes of the comparison: generated moving boxes, and static boxes from files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <graze/broad/scene_generators.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::race {

struct Trajectory {
  std::string name;            ///< "brownian", "chip_aes.csv"
  std::optional<World> world;  ///< None for a file.
  std::string file;            ///< Its path.
  Dim dimension = 3;
  bool is_double = false;
};

/// Parses "brownian", "2d:heavy", "double:line", "2d:double:line". Throws std::invalid_argument for anything else.
Trajectory world_course(std::string_view text);

/// The boxes of a scene file, in double, and also in float if that is exact. Throws io::InputError.
std::vector<Trajectory> file_courses(const std::string& path);

/// "brownian, 2D float".
std::string title_of(const Trajectory& course);

/// The target for the ratio of the fastest peer's time to graze's: from 100,000 to a million boxes 10 for easy scenes
/// and 6 for hard ones; 6 for files; otherwise 2.
double target_of(const Trajectory& course, std::size_t count);

/// The largest useful number of boxes: n boxes at one point have n (n - 1) / 2 pairs.
std::size_t most_boxes_on(const Trajectory& course);

/// The boxes of a course, frame by frame. Instantiated for 2D and 3D, float and double.
template <Dim N, class T>
class Frames {
 public:
  /// `count` is ignored for a file.
  Frames(const Trajectory& course, std::size_t count, std::uint64_t seed);

  std::span<const Aabb<N, T>> boxes() const { return world_ ? world_->boxes() : std::span<const Aabb<N, T>>(still_); }
  void step() {
    if (world_) world_->step();
  }

 private:
  std::optional<MovingBoxes<N, T>> world_;
  std::vector<Aabb<N, T>> still_;
};

}  // namespace graze::race
