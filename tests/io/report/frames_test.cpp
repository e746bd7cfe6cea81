// SPDX-License-Identifier: MIT
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <graze/io/report/frames.hpp>

namespace graze::io::frame_report_test {
namespace {

std::string line(const FrameReport& report) {
  std::ostringstream out;
  write_frame(out, report);
  return out.str();
}

TEST(FrameReport, IsALineOfJson) {
  EXPECT_EQ(line({3, 0.25, 4, {{"a", "b"}, {"a", "c"}}, {{"b", "c"}}}),
            R"({"frame": 3, "seconds": 0.25, "touching": 4, "began": [["a", "b"], ["a", "c"]], "ended": [["b", "c"]]})"
            "\n");
  EXPECT_EQ(line({}), "{\"frame\": 0, \"seconds\": 0, \"touching\": 0, \"began\": [], \"ended\": []}\n");
}

TEST(FrameReport, KeepsNamesWhateverBytesTheyHold) {
  const auto document = nlohmann::json::parse(line({0, 0, 1, {{"\"\n", "b\xff"}}, {}}));
  EXPECT_EQ(document["began"][0][0], "\"\n");
  EXPECT_EQ(document["began"][0][1], "b\xef\xbf\xbd");
}

}  // namespace
}  // namespace graze::io::frame_report_test
