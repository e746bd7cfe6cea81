// SPDX-License-Identifier: MIT
// The result of a scene query, written for people or programs. docs/cli.md documents the formats.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <graze/io/report/check.hpp>
#include <graze/math/platform/export.hpp>

namespace graze::io {

/// What is reported for each object in addition to its name and type.
enum class FoundDetail {
  none,
  distance,  ///< `number` is the distance from a point or a shape.
  hit,       ///< `number` is the t of a ray, `point` the hit point, `normal` the outward normal of the object there.
  impact,    ///< The same of a shape that moves; `normal` points into the object.
  contact,   ///< `number` is the depth of a contact point, `normal` points into the object; one row for each point.
};

/// One object, by name and type. Vectors have as many coordinates as the scene has dimensions.
struct FoundObject {
  std::string name;
  std::string_view type;
  double number = 0;
  std::vector<double> point = {};
  std::vector<double> normal = {};
};

/// All results of a query.
struct FoundReport {
  ReportHead head;
  FoundDetail detail = FoundDetail::none;
  std::vector<FoundObject> objects;
  double seconds = 0;  ///< Time of the search, without reading and writing.
};

/// Writes the objects in the given order. Numbers are the shortest that parse to the same value.
GRAZE_EXPORT void write_found(std::ostream& out, ReportFormat format, const FoundReport& report,
                              Colours colours = Colours::off);

/// The last line of a table: "2 found; 5 objects, 0.001 seconds".
GRAZE_EXPORT std::string summary_line(const FoundReport& report);

}  // namespace graze::io
