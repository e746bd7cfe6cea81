// SPDX-License-Identifier: MIT
// Reads and validates the fields of JSON objects. Faults become an InputError that names file, line, column, object and
// field.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <graze/io/input_error.hpp>
#include <graze/io/json/document.hpp>
#include <graze/math/vec.hpp>

namespace graze::io {

/// A reader's position in a scene: 'object 3 "chair", part 2'. Lives on the stack; converted to text only for errors.
struct JsonPlace {
  const JsonDocument& document;
  const JsonPlace* outer = nullptr;  ///< The enclosing place, if any.
  std::string_view word = {};        ///< "object" or "part"; empty for the document.
  std::size_t index = 0;
  std::string_view name = {};

  /// The error "file: line 3, column 7: object 3 "chair", part 2: message".
  InputError error(std::size_t offset, std::string_view message) const;
};

/// The name of a field or of an array element in messages: "points" or "points"[3].
struct JsonFieldName {
  std::string_view name;
  std::optional<std::size_t> element = std::nullopt;
};

/// A finite number. Throws InputError.
double read_number(JsonValue value, const JsonFieldName& name, const JsonPlace& place);

/// A string. Throws InputError.
std::string_view read_text(JsonValue value, const JsonFieldName& name, const JsonPlace& place);

/// A whole number from 0 to 2^64 - 1. Throws InputError.
std::uint64_t read_whole(JsonValue value, const JsonFieldName& name, const JsonPlace& place);

/// The value, checked to be an array. Throws InputError.
JsonValue read_array(JsonValue value, const JsonFieldName& name, const JsonPlace& place);

/// An array of N numbers. Throws InputError.
template <Dim N>
Vec<N, double> read_vector(JsonValue value, const JsonFieldName& name, const JsonPlace& place);

/// Finds the fields of one object by name. All members but `find` throw InputError.
class JsonFields {
 public:
  /// `what` names the object in messages about missing fields: "a sphere".
  JsonFields(JsonValue object, const JsonPlace& place, std::string_view what)
      : object_(object), place_(&place), what_(what) {}

  const JsonPlace& place() const { return *place_; }
  std::size_t offset() const { return object_.offset(); }

  /// Refuses fields with other names and suggests the nearest allowed one.
  void allow_only(std::span<const std::string_view> names) const;

  std::optional<JsonValue> find(std::string_view name) const { return object_.find(name); }
  JsonValue require(std::string_view name) const;
  double number(std::string_view name) const { return read_number(require(name), {name}, *place_); }
  JsonValue array(std::string_view name) const { return read_array(require(name), {name}, *place_); }
  template <Dim N>
  Vec<N, double> vector(std::string_view name) const {
    return read_vector<N>(require(name), {name}, *place_);
  }

  /// An error about the field of that name, which must exist.
  InputError error(std::string_view name, std::string_view message) const;

 private:
  JsonValue object_;
  const JsonPlace* place_;
  std::string_view what_;
};

}  // namespace graze::io
