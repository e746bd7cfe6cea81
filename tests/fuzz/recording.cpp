// SPDX-License-Identifier: MIT
// Any bytes as a recording of boxes: they are rejected with a message, or read; what was read is written identically.
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include <graze/io/recording.hpp>

#include "fuzz/input.hpp"
#include "fuzz/texts.hpp"
#include "scratch_folder.hpp"

using namespace graze;
using test::fuzz::require;

namespace {

template <Dim N>
using Frames = std::vector<std::vector<Aabb<N, float>>>;

constexpr std::size_t head_bytes = 304;
constexpr std::size_t place_of_counts = 256;
constexpr std::size_t box_bytes = 32;
constexpr std::size_t most_frames = 64;  // without boxes, a few bytes may stand for 2^31

/// The bytes, cut or extended to the size that the header promises if that is small: hardly any mutation of a count
/// would otherwise match.
std::string with_promised_size(std::string bytes) {
  if (bytes.size() < head_bytes) return bytes;
  std::uint32_t boxes = 0;
  std::uint32_t frames = 0;
  std::memcpy(&boxes, bytes.data() + place_of_counts, sizeof boxes);
  std::memcpy(&frames, bytes.data() + place_of_counts + sizeof boxes, sizeof frames);
  const std::uint64_t promised = (std::uint64_t{frames} + 1) * boxes;
  if (promised < 64) bytes.resize(head_bytes + static_cast<std::size_t>(promised) * box_bytes);
  return bytes;
}

const test::ScratchFolder& folder() {
  static const test::ScratchFolder only("graze fuzz");
  return only;
}

/// A recording from a file with these bytes, if they are one.
std::optional<io::RecordingReader> opened(const std::string& bytes) {
  folder().write("recording", bytes);
  return test::fuzz::read_or_refuse([] { return io::RecordingReader(folder().file("recording")); });
}

/// All frames, or the first of very many; none if one of them is rejected.
template <Dim N>
std::optional<Frames<N>> frames_of(io::RecordingReader& reader) {
  return test::fuzz::read_or_refuse([&] {
    Frames<N> frames;
    std::vector<Aabb<N, float>> boxes;
    while (frames.size() < most_frames && reader.next(boxes)) frames.push_back(boxes);
    return frames;
  });
}

template <Dim N>
std::string written(io::RecordingHead head, const Frames<N>& frames) {
  head.frames = frames.size();
  if (head.scene.size() == 128) head.scene.pop_back();  // which others may write, but we do not
  if (head.objects_type.size() == 128) head.objects_type.pop_back();
  std::ostringstream out;
  io::write_recording<N>(out, head, [&](std::size_t frame) { return std::span<const Aabb<N, float>>(frames[frame]); });
  return out.str();
}

template <Dim N>
void check(io::RecordingReader& reader) {
  const std::optional<Frames<N>> frames = frames_of<N>(reader);
  if (!frames) return;
  const std::size_t last = frames->size() - 1;
  reader.seek(last);
  std::vector<Aabb<N, float>> boxes;
  require(reader.next(boxes) && boxes == frames->back(),
          [](std::ostream& out) { out << "a frame must not depend on the order of reading"; });
  const std::string bytes = written<N>(reader.head(), *frames);
  std::optional<io::RecordingReader> again = opened(bytes);
  require(again.has_value(), [](std::ostream& out) { out << "what was written must be readable"; });
  const std::optional<Frames<N>> frames_again = frames_of<N>(*again);
  require(frames_again && *frames_again == *frames,
          [](std::ostream& out) { out << "boxes must be unchanged after writing and reading"; });
  require(written<N>(again->head(), *frames_again) == bytes,
          [](std::ostream& out) { out << "what was read back must be written identically"; });
}

}  // namespace

/// The first byte selects whether the file has the size that its header promises, or any.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  test::fuzz::Input input(data, size);
  const bool is_integer = input.below(4) != 0;
  const std::string bytes = is_integer ? with_promised_size(input.rest()) : input.rest();
  std::optional<io::RecordingReader> reader = opened(bytes);
  if (!reader) return 0;
  if (reader->head().dimension() == 2) {
    check<2>(*reader);
  } else {
    check<3>(*reader);
  }
  return 0;
}
