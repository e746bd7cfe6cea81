// SPDX-License-Identifier: MIT
// Recordings of moving boxes in the .aabbs format of the Broadmark framework (Serpa and Rodrigues 2020), little endian:
//
//   byte   0  the name of the scene, filled up with zeros to 128 bytes
//        128  what its objects are, likewise
//        256  int32: boxes in each frame          260  int32: frames - 1          264  zeros
//        272  the world: a box
//        304  all boxes of the first frame, then all of the next
//
// A box has 32 bytes: min and max as four floats each, the fourth zero. In 2D every z, also the world's, is zero.
#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iosfwd>
#include <span>
#include <string>
#include <vector>

#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::io {

/// What a recording says before its first frame.
struct RecordingHead {
  std::string scene;         ///< Its name, at most 127 bytes.
  std::string objects_type;  ///< What its objects are, likewise.
  std::size_t boxes = 0;     ///< In every frame, below 2^31.
  std::size_t frames = 1;    ///< At least 1, at most 2^31. Broadmark itself wants two.
  Aabb<3, float> world;      ///< Holds all boxes. Its z is 0 to 0 in a 2D recording.

  Dim dimension() const { return world.min.z == 0 && world.max.z == 0 ? 2 : 3; }
};

/// Reads a recording frame by frame, in any order; only a block of a frame is in memory beside the boxes that are asked
/// for.
class RecordingReader {
 public:
  /// Opens a regular file and reads its head. Throws InputError, also when the file's size is not what the head
  /// promises.
  explicit RecordingReader(const std::filesystem::path& path);

  const RecordingHead& head() const { return head_; }

  /// Replaces `boxes` by those of the next frame; false, and no boxes, after the last one. Throws InputError, naming
  /// frame and box (the first are number 0), for a coordinate that is not finite, a min above its max or a
  /// z in a 2D recording; std::logic_error when N is not the recording's dimension.
  template <Dim N>
  bool next(std::vector<Aabb<N, float>>& boxes);

  /// Goes to a frame, which `next` then gives; head().frames is the end. Throws std::out_of_range beyond it.
  void seek(std::size_t frame);

 private:
  std::string source_;
  std::ifstream in_;
  RecordingHead head_;
  std::size_t next_frame_ = 0;
};

/// Writes a recording; `boxes_of(frame)` is called once for each frame, in order, and gives head.boxes boxes. Throws
/// OutputError for what the format cannot hold: too many boxes or frames, a name that is too long or holds a zero;
/// std::logic_error for frames that the head does not announce. The state of `out` is the caller's to check.
template <Dim N>
void write_recording(std::ostream& out, const RecordingHead& head,
                     const std::function<std::span<const Aabb<N, float>>(std::size_t)>& boxes_of);

}  // namespace graze::io
