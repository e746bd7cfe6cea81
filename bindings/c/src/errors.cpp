// SPDX-License-Identifier: MIT
#include "errors.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <new>
#include <utility>

#include <graze/io/input_error.hpp>

#include "world.hpp"

namespace graze::c {
namespace {

std::string& last_message() {
  thread_local std::string message;
  return message;
}

/// What is shown if there is no memory for the message.
thread_local const char* fallback_message = nullptr;

graze_status keep(graze_status status, const char* function, const char* message) noexcept {
  try {
    last_message() = std::string(function) + ": " + message;
    fallback_message = nullptr;
  } catch (...) {
    fallback_message = "there is no memory for the message of this error";
  }
  return status;
}

constexpr std::array status_names{
    std::pair<graze_status, const char*>(GRAZE_OK, "GRAZE_OK"),
    std::pair<graze_status, const char*>(GRAZE_NONE, "GRAZE_NONE"),
    std::pair<graze_status, const char*>(GRAZE_TRUNCATED, "GRAZE_TRUNCATED"),
    std::pair<graze_status, const char*>(GRAZE_INVALID_ARGUMENT, "GRAZE_INVALID_ARGUMENT"),
    std::pair<graze_status, const char*>(GRAZE_OUT_OF_RANGE, "GRAZE_OUT_OF_RANGE"),
    std::pair<graze_status, const char*>(GRAZE_WRONG_WORLD, "GRAZE_WRONG_WORLD"),
    std::pair<graze_status, const char*>(GRAZE_INPUT_ERROR, "GRAZE_INPUT_ERROR"),
    std::pair<graze_status, const char*>(GRAZE_TOO_MANY, "GRAZE_TOO_MANY"),
    std::pair<graze_status, const char*>(GRAZE_OUT_OF_MEMORY, "GRAZE_OUT_OF_MEMORY"),
    std::pair<graze_status, const char*>(GRAZE_INTERNAL_ERROR, "GRAZE_INTERNAL_ERROR")};

const char* name_of_world(graze_world world) {
  constexpr std::array names{"GRAZE_3D", "GRAZE_2D", "GRAZE_3D_FLOAT", "GRAZE_2D_FLOAT"};
  return in_world(world, [&]<Dim N, class T>(In<N, T>) { return names[static_cast<std::size_t>(In<N, T>::world)]; });
}

}  // namespace

graze_status status_of_exception(const char* function) noexcept {
  try {
    throw;
  } catch (const Error& error) {
    return keep(error.status(), function, error.what());
  } catch (const io::InputError& error) {
    return keep(GRAZE_INPUT_ERROR, function, error.what());
  } catch (const std::out_of_range& error) {
    return keep(GRAZE_OUT_OF_RANGE, function, error.what());
  } catch (const std::length_error& error) {
    return keep(GRAZE_TOO_MANY, function, error.what());
  } catch (const std::invalid_argument& error) {
    return keep(GRAZE_INVALID_ARGUMENT, function, error.what());
  } catch (const std::bad_alloc&) {
    return keep(GRAZE_OUT_OF_MEMORY, function, "there is not enough memory");
  } catch (const std::exception& error) {
    return keep(GRAZE_INTERNAL_ERROR, function, error.what());
  } catch (...) {
    return keep(GRAZE_INTERNAL_ERROR, function, "an unknown exception");
  }
}

void refuse_null(std::string_view name) {
  throw Error(GRAZE_INVALID_ARGUMENT, std::string(name) + " is a null pointer, which is not allowed here");
}

void require_array(std::string_view name, const void* pointer, std::size_t count) {
  if (pointer == nullptr && count > 0) {
    throw Error(GRAZE_INVALID_ARGUMENT,
                std::string(name) + " is a null pointer, but has " + std::to_string(count) + " elements");
  }
}

double required_length(std::string_view name, double number) {
  if (number >= 0 && std::isfinite(number)) return number;
  throw Error(GRAZE_INVALID_ARGUMENT,
              std::string(name) + " is " + std::to_string(number) + "; a finite number of at least 0 is needed");
}

void require_world(const char* role, graze_world world, const char* other_role, graze_world other) {
  if (world == other) return;
  throw Error(GRAZE_WRONG_WORLD, std::string(role) + " is in " + name_of_world(world) + ", but " + other_role + " in " +
                                     name_of_world(other));
}

}  // namespace graze::c

using namespace graze::c;

const char* graze_error_message(void) {
  return fallback_message != nullptr ? fallback_message : last_message().c_str();
}

const char* graze_status_name(graze_status status) {
  for (const auto& [number, name] : status_names) {
    if (number == status) return name;
  }
  return "unknown";
}
