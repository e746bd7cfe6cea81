// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <limits>
#include <ostream>
#include <stdexcept>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include <graze/io/file/utf8_path.hpp>
#include <graze/io/input_error.hpp>
#include <graze/io/output_error.hpp>
#include <graze/io/recording.hpp>
#include <graze/io/text/in_quotes.hpp>
#include <graze/math/platform/bit_cast.hpp>

namespace graze::io {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t name_bytes = 128;
constexpr std::size_t number_bytes = 4;
constexpr std::size_t corner_bytes = 4 * number_bytes;
constexpr std::size_t box_bytes = 2 * corner_bytes;
constexpr std::size_t head_bytes = 2 * name_bytes + 4 * number_bytes + box_bytes;
constexpr std::size_t boxes_per_block = 4096;
constexpr std::size_t largest_count = std::numeric_limits<std::int32_t>::max();
constexpr std::array<std::string_view, 3> axis_letters = {"x", "y", "z"};

/// Four bytes, little endian.
std::uint32_t read_bits(const char* bytes) {
  std::uint32_t bits = 0;
  for (unsigned i = 0; i < 4; ++i) bits |= std::uint32_t{static_cast<unsigned char>(bytes[i])} << (8 * i);
  return bits;
}

void write_bits(char* bytes, std::uint32_t bits) {
  for (unsigned i = 0; i < 4; ++i) bytes[i] = static_cast<char>(static_cast<unsigned char>(bits >> (8 * i)));
}

/// The offset of a corner's coordinate.
std::size_t place_of(Dim axis) { return number_bytes * static_cast<std::size_t>(axis); }

Aabb<3, float> read_box(const char* bytes) {
  Aabb<3, float> box;
  for (Dim i = 0; i < 3; ++i) {
    box.min[i] = bit_cast<float>(read_bits(bytes + place_of(i)));
    box.max[i] = bit_cast<float>(read_bits(bytes + corner_bytes + place_of(i)));
  }
  return box;
}

template <Dim N>
void write_box(char* bytes, const Aabb<N, float>& box) {
  std::fill_n(bytes, box_bytes, '\0');
  for (Dim i = 0; i < N; ++i) {
    write_bits(bytes + place_of(i), bit_cast<std::uint32_t>(box.min[i]));
    write_bits(bytes + corner_bytes + place_of(i), bit_cast<std::uint32_t>(box.max[i]));
  }
}

/// Describes what is wrong with a box; empty if it is valid.
std::string fault_of(const Aabb<3, float>& box) {
  for (Dim i = 0; i < 3; ++i) {
    const std::string_view axis = axis_letters[static_cast<std::size_t>(i)];
    for (const auto& [end, value] : {std::pair{"min", box.min[i]}, std::pair{"max", box.max[i]}}) {
      if (!std::isfinite(value)) return fmt::format("{}_{} is {}; it must be a finite number", end, axis, value);
    }
    if (box.min[i] > box.max[i]) {
      return fmt::format("min_{0} is above max_{0}: {1} > {2}", axis, box.min[i], box.max[i]);
    }
  }
  return "";
}

/// Describes what is wrong with a box in a recording of that dimension.
std::string fault_of(const Aabb<3, float>& box, Dim dimension) {
  std::string fault = fault_of(box);
  if (fault.empty() && dimension == 2 && (box.min.z != 0 || box.max.z != 0)) {
    fault = fmt::format("z reaches from {} to {}; it must be 0, as the recording is 2D", box.min.z, box.max.z);
  }
  return fault;
}

/// A count in the header. Throws InputError if it is negative.
std::size_t read_count(const char* bytes, const std::string& source, std::string_view what) {
  const auto count = static_cast<std::int32_t>(read_bits(bytes));
  if (count >= 0) return static_cast<std::size_t>(count);
  throw InputError(
      fmt::format("{}: the number of {} is {}; it cannot be negative, so this is not a recording in "
                  "Broadmark's format",
                  source, what, count));
}

std::string read_name(const char* bytes) { return {bytes, std::find(bytes, bytes + name_bytes, '\0')}; }

std::uint64_t size_of(const fs::path& path, const std::string& source) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::status_known(status)) throw InputError(source + ": cannot be read: " + error.message());
  if (!fs::exists(status)) throw InputError(source + ": there is no such file");
  if (fs::is_directory(status)) throw InputError(source + ": this is a folder; give the recording in it");
  if (!fs::is_regular_file(status)) {
    throw InputError(source + ": a recording is read from a regular file, whose size shows whether it is complete");
  }
  const std::uintmax_t size = fs::file_size(path, error);
  if (error) throw InputError(source + ": cannot be read: " + error.message());
  return size;
}

void require_size(const RecordingHead& head, std::uint64_t size, const std::string& source) {
  const std::uint64_t rest = size - head_bytes;
  if (rest % box_bytes == 0 && rest / box_bytes == std::uint64_t{head.boxes} * head.frames) return;
  throw InputError(
      fmt::format("{}: holds {} bytes, but its header announces {} bytes and {} frame{} of {} boxes of {} bytes; it is "
                  "not complete, or not a recording in Broadmark's format",
                  source, size, head_bytes, head.frames, head.frames == 1 ? "" : "s", head.boxes, box_bytes));
}

/// The box without its z, which a 2D recording does not use.
template <Dim N>
Aabb<N, float> narrowed(const Aabb<3, float>& box) {
  return {Vec<N, float>(box.min), Vec<N, float>(box.max)};
}

void write_name(char* bytes, const std::string& name) {
  const bool fits = name.size() < name_bytes && name.find('\0') == std::string::npos;
  if (fits) {
    std::copy(name.begin(), name.end(), bytes);
    return;
  }
  throw OutputError(fmt::format("a recording cannot hold the name {}; it must have at most {} bytes and no zero",
                                in_quotes(name), name_bytes - 1));
}

void require_count(std::size_t count, std::size_t limit, std::string_view what) {
  if (count <= limit) return;
  throw OutputError(fmt::format("a recording cannot hold {} {}; at most {}", count, what, limit));
}

std::array<char, head_bytes> encoded(const RecordingHead& head) {
  if (head.frames == 0) throw OutputError("a recording cannot hold 0 frames; at least 1");
  require_count(head.boxes, largest_count, "boxes");
  require_count(head.frames, largest_count + 1, "frames");
  std::array<char, head_bytes> bytes{};
  write_name(bytes.data(), head.scene);
  write_name(bytes.data() + name_bytes, head.objects_type);
  write_bits(bytes.data() + 2 * name_bytes, static_cast<std::uint32_t>(head.boxes));
  write_bits(bytes.data() + 2 * name_bytes + number_bytes, static_cast<std::uint32_t>(head.frames - 1));
  write_box(bytes.data() + head_bytes - box_bytes, head.world);
  return bytes;
}

}  // namespace

RecordingReader::RecordingReader(const fs::path& path) : source_(utf8_from_path(path)) {
  const std::uint64_t size = size_of(path, source_);
  errno = 0;
  in_.open(path, std::ios::binary);
  if (!in_) throw InputError(source_ + ": cannot be opened: " + std::generic_category().message(errno));
  std::array<char, head_bytes> bytes{};
  if (size < head_bytes || !in_.read(bytes.data(), bytes.size())) {
    throw InputError(fmt::format("{}: holds {} bytes; a recording in Broadmark's format begins with a header of {}",
                                 source_, size, head_bytes));
  }
  head_.scene = read_name(bytes.data());
  head_.objects_type = read_name(bytes.data() + name_bytes);
  head_.boxes = read_count(bytes.data() + 2 * name_bytes, source_, "boxes");
  head_.frames = read_count(bytes.data() + 2 * name_bytes + number_bytes, source_, "frames") + 1;
  head_.world = read_box(bytes.data() + head_bytes - box_bytes);
  require_size(head_, size, source_);
  const std::string fault = fault_of(head_.world);
  if (!fault.empty()) throw InputError(fmt::format("{}: the world's {}", source_, fault));
}

template <Dim N>
bool RecordingReader::next(std::vector<Aabb<N, float>>& boxes) {
  if (N != head_.dimension()) throw std::logic_error("RecordingReader::next: the recording has another dimension");
  boxes.clear();
  if (next_frame_ == head_.frames) return false;
  boxes.reserve(head_.boxes);
  std::vector<char> block(std::min(head_.boxes, boxes_per_block) * box_bytes);
  while (boxes.size() < head_.boxes) {
    const std::size_t count = std::min(head_.boxes - boxes.size(), boxes_per_block);
    if (!in_.read(block.data(), static_cast<std::streamsize>(count * box_bytes))) {
      throw InputError(fmt::format("{}: frame {} cannot be read to its end", source_, next_frame_));
    }
    for (std::size_t i = 0; i < count; ++i) {
      const Aabb<3, float> box = read_box(block.data() + i * box_bytes);
      const std::string fault = fault_of(box, N);
      if (!fault.empty()) {
        throw InputError(fmt::format("{}: frame {}, box {}: {}", source_, next_frame_, boxes.size(), fault));
      }
      boxes.push_back(narrowed<N>(box));
    }
  }
  ++next_frame_;
  return true;
}

void RecordingReader::seek(std::size_t frame) {
  if (frame > head_.frames) throw std::out_of_range("RecordingReader::seek: the recording has no such frame");
  in_.clear();  // clears the error state after a frame that could not be read
  in_.seekg(static_cast<std::streamoff>(head_bytes + std::uint64_t{frame} * head_.boxes * box_bytes));
  next_frame_ = frame;
}

template <Dim N>
void write_recording(std::ostream& out, const RecordingHead& head,
                     const std::function<std::span<const Aabb<N, float>>(std::size_t)>& boxes_of) {
  if (N != head.dimension()) throw std::logic_error("write_recording: the world has another dimension than its boxes");
  const std::array<char, head_bytes> bytes = encoded(head);
  out.write(bytes.data(), bytes.size());
  std::vector<char> block(std::min(head.boxes, boxes_per_block) * box_bytes);
  for (std::size_t frame = 0; frame < head.frames && out; ++frame) {
    std::span<const Aabb<N, float>> rest = boxes_of(frame);
    if (rest.size() != head.boxes)
      throw std::logic_error("write_recording: a frame has not as many boxes as announced");
    while (!rest.empty()) {
      const std::size_t count = std::min(rest.size(), boxes_per_block);
      for (std::size_t i = 0; i < count; ++i) write_box(block.data() + i * box_bytes, rest[i]);
      out.write(block.data(), static_cast<std::streamsize>(count * box_bytes));
      rest = rest.subspan(count);
    }
  }
}

template bool RecordingReader::next<2>(std::vector<Aabb<2, float>>&);
template bool RecordingReader::next<3>(std::vector<Aabb<3, float>>&);
template void write_recording<2>(std::ostream&, const RecordingHead&,
                                 const std::function<std::span<const Aabb<2, float>>(std::size_t)>&);
template void write_recording<3>(std::ostream&, const RecordingHead&,
                                 const std::function<std::span<const Aabb<3, float>>(std::size_t)>&);

}  // namespace graze::io
