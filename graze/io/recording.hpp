// SPDX-License-Identifier: MIT
/// @file
/// Recordings of moving boxes in the .aabbs format of the Broadmark framework (Serpa and Rodrigues 2020), little
/// endian:
///
///     byte   0  the name of the scene, filled up with zeros to 128 bytes
///          128  what its objects are, likewise
///          256  int32: boxes in each frame          260  int32: frames - 1          264  zeros
///          272  the world: a box
///          304  all boxes of the first frame, then all of the next
///
/// A box has 32 bytes: min and max as four floats each, the fourth zero. In 2D every z, also that of the world, is
/// zero.
#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iosfwd>
#include <span>
#include <string>
#include <vector>

#include <graze/math/platform/export.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::io {

/// The header of a recording.
struct RecordingHead {
  std::string scene;         ///< Name of the scene, at most 127 bytes.
  std::string objects_type;  ///< Type of its objects, at most 127 bytes.
  std::size_t boxes = 0;     ///< Number of boxes in every frame, below 2^31.
  std::size_t frames = 1;    ///< Number of frames, 1 to 2^31. Broadmark itself requires two.
  Aabb<3, float> world;      ///< Contains all boxes. Its z is 0 to 0 in a 2D recording.

  /// 2 if the world's z is 0 to 0, otherwise 3.
  Dim dimension() const { return world.min.z == 0 && world.max.z == 0 ? 2 : 3; }
};

/// Reads a recording frame by frame, in any order; beside the boxes requested, only a block of a frame is in memory.
class GRAZE_EXPORT RecordingReader {
 public:
  /// Opens a regular file and reads its header. Throws InputError if that fails, or if the file's size differs from
  /// what the header states.
  explicit RecordingReader(const std::filesystem::path& path);

  /// The header of the file.
  const RecordingHead& head() const { return head_; }

  /// Replaces `boxes` by those of the next frame; after the last one clears them and returns false. Throws InputError,
  /// naming frame and box (counted from 0), for a coordinate that is not finite, a min above its max or a z in a 2D
  /// recording, and std::logic_error if N is not the recording's dimension.
  template <Dim N>
  GRAZE_EXPORT bool next(std::vector<Aabb<N, float>>& boxes);

  /// Moves to a frame, which `next` then reads; head().frames is the end. Throws std::out_of_range beyond it.
  void seek(std::size_t frame);

 private:
  std::string source_;
  std::ifstream in_;
  RecordingHead head_;
  std::size_t next_frame_ = 0;
};

/// Writes a recording. `boxes_of(frame)` is called once for each frame, in order, and returns head.boxes boxes. Throws
/// OutputError for what the format cannot hold: too many boxes or frames, a name that is too long or contains a zero
/// byte; std::logic_error if N is not the header's dimension, or a frame has another number of boxes than the header.
/// The caller checks the state of `out`.
template <Dim N>
GRAZE_EXPORT void write_recording(std::ostream& out, const RecordingHead& head,
                                  const std::function<std::span<const Aabb<N, float>>(std::size_t)>& boxes_of);

}  // namespace graze::io
