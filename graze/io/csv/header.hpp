// SPDX-License-Identifier: MIT
// The header line of a CSV scene: the kind of its shapes and the meaning of each column.
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

/// A CSV text, and its name in messages.
struct CsvText {
  std::string_view text;
  std::string_view source;

  InputError error(const CsvField& field, std::string_view message) const {
    return error_at(text, source, field.offset, message);
  }
};

/// The shapes of a file: all are of one kind.
enum class CsvShape {
  box,      ///< min_x, min_y, max_x, max_y; in 3D also min_z, max_z
  capsule,  ///< ax, ay, bx, by, radius; in 3D also az, bz
  sphere,   ///< x, y, radius; in 3D also z
};

/// The index of each column.
struct CsvColumns {
  std::size_t count = 0;
  CsvShape shape = CsvShape::box;
  Dim dimension = 2;
  std::optional<std::size_t> id;
  std::optional<std::size_t> layer;
  std::vector<std::size_t>
      numbers;  ///< The columns of a shape, in the order above with z after y: points, then the radius.
  std::vector<std::string> number_names;  ///< The names of these columns.
  std::vector<Omission> not_read;
};

/// Reads the header. The names of the columns determine the kind of shape and, by whether there are z columns, the
/// dimension. `id` and `layer` are optional; other columns are counted as omissions. Throws InputError for a missing or
/// duplicate column.
CsvColumns read_csv_header(const CsvText& text, const std::vector<CsvField>& fields);

}  // namespace graze::io
