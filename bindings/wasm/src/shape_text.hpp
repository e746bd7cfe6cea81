// SPDX-License-Identifier: MIT
// Shapes as JavaScript hands them over: as JSON in the vocabulary of scene files.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <graze/math/vec.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/ray.hpp>

namespace graze::wasm {

/// The shape of a text; `role` names it in messages: "region". Throws io::InputError, whose message does not mention
/// line and column, as nobody has seen the text.
template <Dim N>
AnyShape<N, double> shape_of(const std::string& text, const char* role);

/// The shapes of a JSON array.
template <Dim N>
std::vector<AnyShape<N, double>> shapes_of(const std::string& text);

/// A shape that must be a ray.
template <Dim N>
Ray<N, double> ray_of(const std::string& text);

template <Dim N>
std::string text_of(const AnyShape<N, double>& shape);

/// Throws io::InputError with the message, less line and column where it is about a text of one line that is called
/// `role`.
[[noreturn]] void rethrow_without_place(const std::string& message, std::string_view role);

}  // namespace graze::wasm
