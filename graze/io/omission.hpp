// SPDX-License-Identifier: MIT
// What a file holds and graze does not read, as every answer about its scene tells it.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace graze::io {

/// What a scene lacks because of an omission.
enum class Loss {
  none,       ///< No shape: what was not read has none, such as a custom property or a picture.
  precision,  ///< Every shape is there, but not exactly the one in the file.
  shape,      ///< A shape that could touch others is not in the scene.
};

/// Something that a file holds and graze did not read, or read only approximately: "text object", 3 times.
struct Omission {
  std::string what;  ///< Singular, as the rest of "not read: 3 x ...".
  std::size_t count = 0;
  Loss loss = Loss::none;
  std::string where = {};  ///< Where the first one is: "level.tmx, line 12"; empty when the format does not say.
  std::string why =
      {};  ///< Why it was not read, and the way out where there is one; empty when the format does not say.
};

/// Those by which a shape is missing, so that an answer may lack something: the streams of data name only these, as
/// many files hold things that have no shape.
std::vector<Omission> missing_shapes(std::span<const Omission> omissions);

/// "3 x text object", and where a shape is missing its place and the reason: "1 x unknown layer (level.tmx, line 12:
/// graze does not know this kind of layer)".
std::string omission_text(const Omission& omission);

/// A JSON array on one line: of each `what`, `count`, `loss`, `where` and `why`.
std::string omissions_json(std::span<const Omission> omissions);

/// A line of NDJSON: `{"not_read": ...}` with such an object.
std::string omission_ndjson(const Omission& omission);

/// A row of CSV under `header`, the names of its columns: the text in the first column, "not_read" in the column
/// `kind`, by which rows are told apart, nothing in the others.
std::string omission_csv(const Omission& omission, std::string_view header, std::string_view kind);

}  // namespace graze::io
