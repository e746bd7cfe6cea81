// SPDX-License-Identifier: MIT
#include <ostream>
#include <string>

#include <fmt/format.h>

#include <graze/io/report/frames.hpp>
#include <graze/io/text/quoting.hpp>

namespace graze::io {
namespace {

std::string json_pairs(const std::vector<NamePair>& pairs) {
  std::string text = "[";
  for (const auto& [a, b] : pairs) {
    text += fmt::format("{}[{}, {}]", text.size() == 1 ? "" : ", ", json_string(a), json_string(b));
  }
  return text + "]";
}

}  // namespace

void write_frame(std::ostream& out, const FrameReport& report) {
  out << fmt::format("{{\"frame\": {}, \"seconds\": {}, \"touching\": {}, \"began\": {}, \"ended\": {}}}\n",
                     report.frame, report.seconds, report.touching, json_pairs(report.began), json_pairs(report.ended));
}

}  // namespace graze::io
