// SPDX-License-Identifier: MIT
// Shapes as JavaScript hands them over where it cannot write them as numbers (arguments.hpp): as JSON in the vocabulary
// of scene files.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <graze/math/vec.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze::wasm {

/// The shape of a text; `role` names it in messages: "region". Throws io::InputError, whose message does not mention
/// line and column, as nobody has seen the text.
template <Dim N>
AnyShape<N, double> shape_of(const std::string& text, const char* role);

/// The shapes of a JSON array.
template <Dim N>
std::vector<AnyShape<N, double>> shapes_of(const std::string& text);

/// Throws io::InputError with the message, less line and column where it is about a text of one line that is called
/// `role`.
[[noreturn]] void rethrow_without_place(const std::string& message, std::string_view role);

}  // namespace graze::wasm
