// SPDX-License-Identifier: MIT
// Shapes that JavaScript cannot pass as numbers (arguments.hpp): JSON in the format of scene files.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <graze/math/vec.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze::wasm {

/// The shape in a text; `role` names it in messages: "region". Throws io::InputError whose message omits line and
/// column, because the user has not seen the text.
template <Dim N>
AnyShape<N, double> shape_of(const std::string& text, const char* role);

/// The shapes of a JSON array.
template <Dim N>
std::vector<AnyShape<N, double>> shapes_of(const std::string& text);

/// Throws io::InputError with the message, without the line and column of a one-line text named `role`.
[[noreturn]] void rethrow_without_place(const std::string& message, std::string_view role);

}  // namespace graze::wasm
