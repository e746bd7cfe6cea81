// SPDX-License-Identifier: MIT
// The header line of a scene in CSV: which shapes it has, and which column holds what.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <graze/io/csv/records.hpp>
#include <graze/io/input_error.hpp>
#include <graze/io/scene_file.hpp>
#include <graze/io/text/position.hpp>
#include <graze/math/vec.hpp>

namespace graze::io {

/// A text in CSV, with the name that messages call it by.
struct CsvText {
  std::string_view text;
  std::string_view source;

  InputError error(const CsvField& field, std::string_view message) const {
    return error_at(text, source, field.offset, message);
  }
};

/// The shapes of a file: it has one kind.
enum class CsvShape {
  box,      ///< min_x, min_y, max_x, max_y; in 3D also min_z, max_z
  capsule,  ///< ax, ay, bx, by, radius; in 3D also az, bz
  sphere,   ///< x, y, radius; in 3D also z
};

/// Which column holds what.
struct CsvColumns {
  std::size_t count = 0;
  CsvShape shape = CsvShape::box;
  Dim dimension = 2;
  std::optional<std::size_t> id;
  std::optional<std::size_t> layer;
  std::vector<std::size_t> numbers;       ///< Of a shape, in the order above with z behind y: points, then the radius.
  std::vector<std::string> number_names;  ///< The same columns' names.
  std::vector<Omission> not_read;
};

/// Reads the header. The columns' names decide the shape and, by those with z, the dimension; `id` and `layer` are
/// optional, further columns are counted as omissions. Throws InputError for a column that is missing or stands twice.
CsvColumns read_csv_header(const CsvText& text, const std::vector<CsvField>& fields);

}  // namespace graze::io
