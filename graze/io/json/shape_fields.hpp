// SPDX-License-Identifier: MIT
// The words of the scene format: which fields each type of shape has, by its description and the ways beside it.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include <graze/math/vec.hpp>

namespace graze::io {

/// How many compounds may lie inside each other in a scene file, the outermost included.
inline constexpr std::size_t max_compound_depth = 32;

/// The field that turns an oriented box, instead of its axes.
template <Dim N>
inline constexpr std::string_view orientation_field = N == 2 ? "angle" : "rotation";

/// The place in `shape_type_names` of a type's name.
std::optional<std::size_t> shape_type_index(std::string_view type);

/// Our name for a type that others call differently: "sphere" for "circle".
std::optional<std::string_view> our_shape_name(std::string_view foreign);

/// The fields that a shape of a type (by its place in `shape_type_names`) can have in a scene file, "type" not among
/// them.
std::span<const std::string_view> shape_fields(std::size_t type_index, Dim dimension);

}  // namespace graze::io
