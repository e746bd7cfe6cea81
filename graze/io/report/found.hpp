// SPDX-License-Identifier: MIT
// What a question to a scene found, written for people or for programs. The formats are documented in docs/cli.md.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <graze/io/report/check.hpp>

namespace graze::io {

/// What is known of each object beside its name and type.
enum class FoundDetail {
  none,
  distance,  ///< `number` is how far it is from a point.
  hit,       ///< `number` is the t of a ray, `point` where it hits, `normal` out of the object.
};

/// One object, by name and type; vectors have as many coordinates as the scene.
struct FoundObject {
  std::string name;
  std::string_view type;
  double number = 0;
  std::vector<double> point = {};
  std::vector<double> normal = {};
};

/// Everything that was found.
struct FoundReport {
  ReportHead head;
  FoundDetail detail = FoundDetail::none;
  std::vector<FoundObject> objects;
  double seconds = 0;  ///< To find them, without reading and writing.
};

/// Writes what was found, in the order in which it is given. Numbers are as short as they can be read back.
void write_found(std::ostream& out, ReportFormat format, const FoundReport& report, Colours colours = Colours::off);

/// The sentence that closes a table: "2 found; 5 objects, 0.001 seconds".
std::string summary_line(const FoundReport& report);

}  // namespace graze::io
