// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>

#include <graze/io/json/fields.hpp>
#include <graze/math/platform/export.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/mesh.hpp>

namespace graze::io {

/// Reads the shape in a JSON object: its "type" and that type's fields. `other_fields` are the names of further allowed
/// fields. Throws InputError; the returned shape is valid.
template <Dim N>
AnyShape<N, double> read_json_shape(JsonValue object, const JsonPlace& place,
                                    std::span<const std::string_view> other_fields);

/// The field "kind" of a mesh; a surface if it is missing. Throws InputError.
MeshKind read_json_mesh_kind(const JsonFields& fields);

/// Reads a shape from the text of a JSON object, `source` in messages. Throws InputError; the returned shape is valid.
template <Dim N>
GRAZE_EXPORT AnyShape<N, double> parse_json_shape(std::string_view text, const std::string& source);

}  // namespace graze::io
