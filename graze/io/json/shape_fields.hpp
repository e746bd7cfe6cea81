// SPDX-License-Identifier: MIT
// The names in the scene format: which fields each type of shape has, from its description and as alternatives.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include <graze/math/vec.hpp>

namespace graze::io {

/// How deeply compounds may be nested in a scene file, the outermost included.
inline constexpr std::size_t max_compound_depth = 32;

/// The field that gives the rotation of an oriented box, instead of its axes.
template <Dim N>
inline constexpr std::string_view orientation_field = N == 2 ? "angle" : "rotation";

/// The index of a type's name in `shape_type_names`.
std::optional<std::size_t> shape_type_index(std::string_view type);

/// The graze name of a type that other programs name differently: "sphere" for "circle".
std::optional<std::string_view> our_shape_name(std::string_view foreign);

/// The fields that a shape of a type (by its index in `shape_type_names`) can have in a scene file, except "type".
std::span<const std::string_view> shape_fields(std::size_t type_index, Dim dimension);

}  // namespace graze::io
