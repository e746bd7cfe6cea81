// SPDX-License-Identifier: MIT
/// @file
/// The parts of a file that the library does not read; every report about its scene lists them.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <graze/math/platform/export.hpp>

namespace graze::io {

/// What a scene lacks because of an omission.
enum class Loss {
  none,       ///< No shape: what was not read has none, such as a custom property or a picture.
  precision,  ///< All shapes are there, but one only approximately.
  shape,      ///< A shape that could touch others is missing.
};

/// Part of a file that was not read, or only approximately: "text object", 3 times.
struct Omission {
  std::string what;        ///< Singular, as the rest of "not read: 3 x ...".
  std::size_t count = 0;   ///< How often it occurs.
  Loss loss = Loss::none;  ///< What the scene lacks because of it.
  std::string where = {};  ///< Where it first occurs: "level.tmx, line 12"; empty if the format does not tell.
  std::string why = {};    ///< Why it was not read, and the way out if there is one; empty if the format does not tell.
};

/// The omissions that leave out a shape, so that results may be incomplete. Data streams list only these, because many
/// files contain things without a shape.
GRAZE_EXPORT std::vector<Omission> missing_shapes(std::span<const Omission> omissions);

/// "3 x text object"; for a missing shape also its place and the reason: "1 x unknown layer (level.tmx, line 12: graze
/// does not know this kind of layer)".
GRAZE_EXPORT std::string omission_text(const Omission& omission);

/// A JSON array on one line, with `what`, `count`, `loss`, `where` and `why` of each.
GRAZE_EXPORT std::string omissions_json(std::span<const Omission> omissions);

/// A line of NDJSON: `{"not_read": ...}` with the same members.
GRAZE_EXPORT std::string omission_ndjson(const Omission& omission);

/// A row of CSV under `header`, the column names: the text in the first column, "not_read" in the column `kind`, which
/// tells rows apart, and nothing in the others.
GRAZE_EXPORT std::string omission_csv(const Omission& omission, std::string_view header, std::string_view kind);

}  // namespace graze::io
