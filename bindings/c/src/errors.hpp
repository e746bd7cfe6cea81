// SPDX-License-Identifier: MIT
// Exceptions of C++ as statuses and messages of C.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

#include "../graze.h"

namespace graze::c {

/// An error with its status; the message is without the function's name.
class Error : public std::runtime_error {
 public:
  Error(graze_status status, const std::string& message) : std::runtime_error(message), status_(status) {}
  graze_status status() const { return status_; }

 private:
  graze_status status_;
};

/// The status of the exception that is being handled. Keeps its message, with the function's name in front, for
/// graze_error_message.
graze_status status_of_exception(const char* function) noexcept;

/// Runs the body of a function of the interface: its status, or GRAZE_OK if it returns none.
template <class Body>
graze_status guarded(const char* function, const Body& body) noexcept {
  try {
    if constexpr (std::is_void_v<decltype(body())>) {
      body();
      return GRAZE_OK;
    } else {
      return body();
    }
  } catch (...) {
    return status_of_exception(function);
  }
}

[[noreturn]] void refuse_null(std::string_view name);

/// The value behind an argument. Throws Error, naming the argument, if the pointer is null.
template <class Value>
Value& required(std::string_view name, Value* pointer) {
  if (pointer == nullptr) refuse_null(name);
  return *pointer;
}

/// Throws Error if an array is null although it has elements.
void require_array(std::string_view name, const void* pointer, std::size_t count);

/// A length: at least 0 and finite. Throws Error for other numbers.
double required_length(std::string_view name, double number);

}  // namespace graze::c
