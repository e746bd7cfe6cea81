// SPDX-License-Identifier: MIT
#include <bit>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <graze/io/input_error.hpp>
#include <graze/io/output_error.hpp>
#include <graze/io/recording.hpp>

#include "scene_text.hpp"
#include "tiled_folder.hpp"

namespace graze::io::recording_test {
namespace {

template <Dim N>
using Frames = std::vector<std::vector<Aabb<N, float>>>;

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

Frames<3> two_frames() {
  return {{{{0, 1, 2}, {3, 4, 5}}, {{-0.5F, 0, 0.25F}, {0, 0, 1e7F}}},
          {{{1, 1, 2}, {4, 4, 5}}, {{7, 7, 7}, {7, 8, 9}}}};
}

RecordingHead head_of_two() { return {"falling boxes", "Cube", 2, 2, {{-9, -9, -9}, {9, 9, 2e7F}}}; }

template <Dim N>
std::string text_of_recording(const RecordingHead& head, const Frames<N>& frames) {
  std::ostringstream out;
  write_recording<N>(out, head, [&](std::size_t frame) { return std::span<const Aabb<N, float>>(frames.at(frame)); });
  return out.str();
}

template <Dim N>
Frames<N> all_frames(RecordingReader& reader) {
  Frames<N> frames;
  std::vector<Aabb<N, float>> boxes;
  while (reader.next<N>(boxes)) frames.push_back(boxes);
  EXPECT_TRUE(boxes.empty());
  EXPECT_FALSE(reader.next<N>(boxes)) << "there is nothing behind the end";
  return frames;
}

/// The bytes of a number, the lowest first.
std::string bytes_of(std::uint32_t bits) {
  std::string bytes;
  for (int i = 0; i < 4; ++i) bytes += static_cast<char>(static_cast<unsigned char>(bits >> (8 * i)));
  return bytes;
}

std::string bytes_of(float number) { return bytes_of(std::bit_cast<std::uint32_t>(number)); }

/// The text with other bytes at a position.
std::string with(std::string text, std::size_t place, const std::string& bytes) {
  return text.replace(place, bytes.size(), bytes);
}

constexpr std::size_t place_of_counts = 256;
constexpr std::size_t place_of_world = 272;
constexpr std::size_t place_of_boxes = 304;

class Recording : public testing::Test {
 protected:
  /// The reader's message about such a file, without its name.
  template <Dim N = 3>
  std::string refusal(const std::string& text) const {
    folder_.write("r.aabbs", text);
    try {
      RecordingReader reader(path());
      std::vector<Aabb<N, float>> boxes;
      while (reader.next<N>(boxes)) {
      }
    } catch (const InputError& error) {
      const std::string message = error.what();
      const std::string begin = path().string() + ": ";
      EXPECT_TRUE(message.starts_with(begin)) << message;
      return message.substr(begin.size());
    }
    ADD_FAILURE() << "no InputError was thrown";
    return "";
  }

  std::filesystem::path path() const { return folder_.path() / "r.aabbs"; }

  TiledFolder folder_;
};

TEST_F(Recording, WhatWasWrittenIsReadFrameByFrame) {
  folder_.write("r.aabbs", text_of_recording(head_of_two(), two_frames()));
  RecordingReader reader(path());
  EXPECT_EQ(reader.head().scene, "falling boxes");
  EXPECT_EQ(reader.head().objects_type, "Cube");
  EXPECT_EQ(reader.head().boxes, 2U);
  EXPECT_EQ(reader.head().frames, 2U);
  EXPECT_EQ(reader.head().dimension(), 3);
  EXPECT_EQ(reader.head().world, head_of_two().world);
  EXPECT_EQ(all_frames<3>(reader), two_frames());
}

TEST_F(Recording, FramesAreReadInAnyOrder) {
  folder_.write("r.aabbs", text_of_recording(head_of_two(), two_frames()));
  RecordingReader reader(path());
  std::vector<Aabb<3, float>> boxes;
  for (const std::size_t frame : {1U, 0U, 0U, 1U}) {
    reader.seek(frame);
    ASSERT_TRUE(reader.next<3>(boxes));
    EXPECT_EQ(boxes, two_frames()[frame]) << frame;
  }
  EXPECT_FALSE(reader.next<3>(boxes)) << "the last frame was read";
  reader.seek(0);
  EXPECT_EQ(all_frames<3>(reader), two_frames());
  reader.seek(2);
  EXPECT_FALSE(reader.next<3>(boxes)) << "this is the end";
  EXPECT_THROW(reader.seek(3), std::out_of_range);
}

TEST_F(Recording, AfterAFrameThatCannotBeReadOthersCan) {
  folder_.write("r.aabbs", with(text_of_recording(head_of_two(), two_frames()), place_of_boxes, bytes_of(nan)));
  RecordingReader reader(path());
  std::vector<Aabb<3, float>> boxes;
  EXPECT_THROW(reader.next<3>(boxes), InputError);
  reader.seek(1);
  ASSERT_TRUE(reader.next<3>(boxes));
  EXPECT_EQ(boxes, two_frames()[1]);
}

TEST_F(Recording, HasTheBytesOfTheFormat) {
  std::string expected = "falling boxes" + std::string(115, '\0') + "Cube" + std::string(124, '\0');
  expected += bytes_of(2U) + bytes_of(1U) + std::string(8, '\0');
  const auto box = [](const Aabb<3, float>& one) {
    const auto corner = [](const Vec<3, float>& v) {
      return bytes_of(v.x) + bytes_of(v.y) + bytes_of(v.z) + bytes_of(0U);
    };
    return corner(one.min) + corner(one.max);
  };
  expected += box(head_of_two().world);
  for (const auto& frame : two_frames()) {
    for (const auto& one : frame) expected += box(one);
  }
  EXPECT_EQ(expected.size(), 304U + 4 * 32);
  EXPECT_EQ(text_of_recording(head_of_two(), two_frames()), expected);
  // 1.0f is 0x3f800000: its lowest byte comes first.
  EXPECT_EQ(bytes_of(1.0F), std::string("\0\0\x80\x3f", 4));
}

TEST_F(Recording, FlatWorldsAreTwoDimensional) {
  const Frames<2> frames = {{{{0, 1}, {2, 3}}}, {{{0.5F, 1}, {2.5F, 3}}}, {{{1, 1}, {3, 3}}}};
  folder_.write("r.aabbs", text_of_recording<2>({"flat", "", 1, 3, {{-9, -9, 0}, {9, 9, 0}}}, frames));
  RecordingReader reader(path());
  EXPECT_EQ(reader.head().dimension(), 2);
  EXPECT_EQ(reader.head().objects_type, "");
  std::vector<Aabb<3, float>> boxes;
  EXPECT_THROW(reader.next<3>(boxes), std::logic_error);
  EXPECT_EQ(all_frames<2>(reader), frames);
}

TEST_F(Recording, ManyBoxesGoThroughInBlocks) {
  Frames<2> frames(2);
  for (int i = 0; i < 10000; ++i) {
    const auto x = static_cast<float>(i);
    frames[0].push_back({{x, 0}, {x + 1, 1}});
    frames[1].push_back({{x, -x}, {x + 2, 1}});
  }
  folder_.write("r.aabbs", text_of_recording<2>({"many", "", 10000, 2, {{0, -1e4F, 0}, {2e4F, 1, 0}}}, frames));
  RecordingReader reader(path());
  EXPECT_EQ(all_frames<2>(reader), frames);
}

TEST_F(Recording, MayHoldNoBoxesAndOneFrame) {
  folder_.write("r.aabbs", text_of_recording<3>({"", "", 0, 1, {{0, 0, 0}, {1, 1, 1}}}, {{}}));
  RecordingReader reader(path());
  EXPECT_EQ(reader.head().frames, 1U);
  EXPECT_EQ(all_frames<3>(reader), Frames<3>{{}});
}

TEST_F(Recording, NamesMayFillTheirPlace) {
  RecordingHead head = head_of_two();
  head.scene = std::string(127, 's');
  head.objects_type = std::string(127, 'o');
  folder_.write("r.aabbs", text_of_recording(head, two_frames()));
  EXPECT_EQ(RecordingReader(path()).head().scene, head.scene);
  // Other programs may write no zero after a name.
  folder_.write("r.aabbs", with(text_of_recording(head, two_frames()), 127, "S"));
  EXPECT_EQ(RecordingReader(path()).head().scene, head.scene + "S");
  EXPECT_EQ(RecordingReader(path()).head().objects_type, head.objects_type);
}

TEST_F(Recording, FilesThatAreTooShortOrTooLongAreRefused) {
  const std::string text = text_of_recording(head_of_two(), two_frames());
  EXPECT_EQ(refusal(""), "holds 0 bytes; a recording in Broadmark's format begins with a header of 304");
  EXPECT_EQ(refusal(text.substr(0, 303)),
            "holds 303 bytes; a recording in Broadmark's format begins with a header of 304");
  const std::string promise =
      ", but its header announces 304 bytes and 2 frames of 2 boxes of 32 bytes; it is not complete, or not a "
      "recording "
      "in "
      "Broadmark's format";
  EXPECT_EQ(refusal(text.substr(0, 304)), "holds 304 bytes" + promise);
  EXPECT_EQ(refusal(text.substr(0, text.size() - 32)), "holds 400 bytes" + promise);
  EXPECT_EQ(refusal(text.substr(0, text.size() - 1)), "holds 431 bytes" + promise);
  EXPECT_EQ(refusal(text + "x"), "holds 433 bytes" + promise);
}

TEST_F(Recording, CountsThatCannotBeAreRefused) {
  const std::string text = text_of_recording(head_of_two(), two_frames());
  const std::string end = "; it cannot be negative, so this is not a recording in Broadmark's format";
  EXPECT_EQ(refusal(with(text, place_of_counts, bytes_of(0xffffffffU))), "the number of boxes is -1" + end);
  EXPECT_EQ(refusal(with(text, place_of_counts + 4, bytes_of(0x80000000U))),
            "the number of frames is -2147483648" + end);
  // 2^31 frames of 2^31 - 1 boxes have more bytes than can be counted.
  const std::string most = bytes_of(0x7fffffffU) + bytes_of(0x7fffffffU);
  EXPECT_NE(refusal(with(text, place_of_counts, most)).find("2147483648 frames of 2147483647 boxes"),
            std::string::npos);
}

TEST_F(Recording, UselessCoordinatesAreRefusedWithFrameAndBox) {
  const std::string text = text_of_recording(head_of_two(), two_frames());
  const auto place = [](std::size_t frame, std::size_t box, std::size_t number) {
    return place_of_boxes + (frame * 2 + box) * 32 + number * 4;
  };
  EXPECT_EQ(refusal(with(text, place(1, 0, 2), bytes_of(nan))),
            "frame 1, box 0: min_z is nan; it must be a finite number");
  EXPECT_EQ(refusal(with(text, place(0, 1, 5), bytes_of(infinity))),
            "frame 0, box 1: max_y is inf; it must be a finite number");
  EXPECT_EQ(refusal(with(text, place(0, 0, 0), bytes_of(-infinity))),
            "frame 0, box 0: min_x is -inf; it must be a finite number");
  EXPECT_EQ(refusal(with(text, place(1, 1, 4), bytes_of(6.5F))), "frame 1, box 1: min_x is above max_x: 7 > 6.5");
  EXPECT_EQ(refusal(with(text, place_of_world + 4, bytes_of(10.0F))), "the world's min_y is above max_y: 10 > 9");
  EXPECT_EQ(refusal(with(text, place_of_world + 16, bytes_of(nan))),
            "the world's max_x is nan; it must be a finite number");
}

TEST_F(Recording, AFlatWorldHasNoBoxesWithDepth) {
  const Frames<2> frames = {{{{0, 1}, {2, 3}}}};
  const std::string text = text_of_recording<2>({"flat", "", 1, 1, {{-9, -9, 0}, {9, 9, 0}}}, frames);
  EXPECT_EQ(refusal<2>(with(text, place_of_boxes + 24, bytes_of(0.5F))),
            "frame 0, box 0: z reaches from 0 to 0.5; it must be 0, as the recording is 2D");
}

TEST_F(Recording, FilesThatAreNoneAreRefused) {
  const auto says = [](const std::filesystem::path& path) -> std::string {
    try {
      const RecordingReader reader(path);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(says(path()), path().string() + ": there is no such file");
  EXPECT_EQ(says(folder_.path()), folder_.path().string() + ": this is a folder; give the recording in it");
  EXPECT_EQ(says("/dev/null"),
            "/dev/null: a recording is read from a regular file, whose size shows whether it is complete");
}

TEST_F(Recording, AFileThatShrinksMeanwhileIsRefused) {
  RecordingHead head = head_of_two();
  head.boxes = 10000;  // more than a stream buffers
  folder_.write("r.aabbs", text_of_recording<3>(head, Frames<3>(2, std::vector<Aabb<3, float>>(head.boxes))));
  RecordingReader reader(path());
  std::filesystem::resize_file(path(), 304 + 15000 * 32);
  std::vector<Aabb<3, float>> boxes;
  try {
    while (reader.next<3>(boxes)) {
    }
    FAIL() << "no InputError was thrown";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()), path().string() + ": frame 1 cannot be read to its end");
  }
}

TEST_F(Recording, WhatTheFormatCannotHoldIsRefused) {
  const auto says = [](const RecordingHead& head) -> std::string {
    try {
      text_of_recording(head, two_frames());
    } catch (const OutputError& error) {
      return error.what();
    }
    return "";
  };
  RecordingHead head = head_of_two();
  head.scene = std::string(128, 's');
  EXPECT_TRUE(says(head).ends_with("it must have at most 127 bytes and no zero")) << says(head);
  head.scene = std::string("a\0b", 3);
  EXPECT_EQ(says(head), "a recording cannot hold the name \"a\\x00b\"; it must have at most 127 bytes and no zero");
  head = head_of_two();
  head.boxes = std::size_t{1} << 31U;
  EXPECT_EQ(says(head), "a recording cannot hold 2147483648 boxes; at most 2147483647");
  head = head_of_two();
  head.frames = 0;
  EXPECT_EQ(says(head), "a recording cannot hold 0 frames; at least 1");
  head.frames = (std::size_t{1} << 31U) + 1;
  EXPECT_EQ(says(head), "a recording cannot hold 2147483649 frames; at most 2147483648");
}

TEST_F(Recording, FramesThatTheHeadDoesNotAnnounceAreACallersBug) {
  RecordingHead head = head_of_two();
  head.boxes = 3;
  EXPECT_THROW(text_of_recording(head, two_frames()), std::logic_error);
  head = head_of_two();
  head.world.min.z = head.world.max.z = 0;
  EXPECT_THROW(text_of_recording(head, two_frames()), std::logic_error);
}

TEST_F(Recording, WritingStopsWhenTheStreamHasFailed) {
  std::ostringstream out;
  out.setstate(std::ios::badbit);
  int asked = 0;
  write_recording<3>(out, head_of_two(), [&](std::size_t) {
    ++asked;
    return std::span<const Aabb<3, float>>();
  });
  EXPECT_EQ(asked, 0);
}

}  // namespace
}  // namespace graze::io::recording_test
