// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <graze/shape/any_shape.hpp>

namespace graze::io {

/// Appends `"type": "sphere", "center": [0, 1], "radius": 2`. Reading it returns the same shape, bit for bit. Throws
/// OutputError for compounds nested deeper than `max_compound_depth`.
template <Dim N>
void append_json_shape(std::string& out, const AnyShape<N, double>& shape);

}  // namespace graze::io
