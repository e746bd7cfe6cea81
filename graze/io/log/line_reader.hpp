// SPDX-License-Identifier: MIT
// Reads and validates the lines of a query log.
#pragma once

#include <graze/io/json/document.hpp>
#include <graze/io/log/logged_answer.hpp>
#include <graze/io/log/logged_call.hpp>
#include <graze/math/vec.hpp>

namespace graze::io {

/// Reads what call_line writes. Throws InputError.
template <Dim N>
LoggedCall<N> read_call(const JsonDocument& document);

/// Reads what answer_line writes. Throws InputError.
LoggedAnswer read_answer(const JsonDocument& document);

}  // namespace graze::io
