// SPDX-License-Identifier: MIT
#include <algorithm>

#include <fmt/format.h>

#include <graze/io/json/fields.hpp>
#include <graze/io/text/in_quotes.hpp>
#include <graze/io/text/suggestion.hpp>

namespace graze::io {
namespace {

std::string description(const JsonFieldName& name) {
  return name.element ? fmt::format("{}[{}]", in_quotes(name.name), *name.element) : in_quotes(name.name);
}

std::string description(const JsonPlace& place) {
  if (place.word.empty()) return "";
  std::string result = place.outer == nullptr ? "" : description(*place.outer);
  if (!result.empty()) result += ", ";
  result += fmt::format("{} {}", place.word, place.index);
  if (!place.name.empty()) result += ' ' + in_quotes(place.name);
  return result;
}

/// The error '"radius" must be a number, not a string'.
InputError wrong_kind(JsonValue value, const JsonFieldName& name, std::string_view wanted, const JsonPlace& place) {
  const std::string given(kind_name(value.kind()));
  return place.error(value.offset(), fmt::format("{} must be {}, not {}", description(name), wanted, given));
}

}  // namespace

InputError JsonPlace::error(std::size_t offset, std::string_view message) const {
  const std::string where = description(*this);
  return document.error(offset, where.empty() ? std::string(message) : fmt::format("{}: {}", where, message));
}

double read_number(JsonValue value, const JsonFieldName& name, const JsonPlace& place) {
  if (!value.is_number()) throw wrong_kind(value, name, "a number", place);
  return value.number();
}

std::string_view read_text(JsonValue value, const JsonFieldName& name, const JsonPlace& place) {
  if (value.kind() != JsonKind::text) throw wrong_kind(value, name, "a string", place);
  return value.text();
}

std::uint64_t read_whole(JsonValue value, const JsonFieldName& name, const JsonPlace& place) {
  if (value.kind() == JsonKind::whole) return value.whole();
  if (!value.is_number()) throw wrong_kind(value, name, "a whole number", place);
  throw place.error(value.offset(), fmt::format("{} is {}; it must be a whole number from 0 to 18446744073709551615",
                                                description(name), value.number()));
}

JsonValue read_array(JsonValue value, const JsonFieldName& name, const JsonPlace& place) {
  if (value.kind() != JsonKind::array) throw wrong_kind(value, name, "an array", place);
  return value;
}

template <Dim N>
Vec<N, double> read_vector(JsonValue value, const JsonFieldName& name, const JsonPlace& place) {
  if (value.kind() != JsonKind::array) throw wrong_kind(value, name, fmt::format("an array of {} numbers", N), place);
  if (value.size() != static_cast<std::size_t>(N)) {
    throw place.error(value.offset(), fmt::format("{} has {} number{}; this scene has dimension {}", description(name),
                                                  value.size(), value.size() == 1 ? "" : "s", N));
  }
  Vec<N, double> result;
  Dim i = 0;
  for (const JsonValue coordinate : value.items()) {
    if (!coordinate.is_number()) {
      throw place.error(coordinate.offset(), fmt::format("{} must hold numbers; coordinate {} is {}", description(name),
                                                         i, kind_name(coordinate.kind())));
    }
    result[i++] = coordinate.number();
  }
  return result;
}

template Vec<2, double> read_vector<2>(JsonValue, const JsonFieldName&, const JsonPlace&);
template Vec<3, double> read_vector<3>(JsonValue, const JsonFieldName&, const JsonPlace&);

void JsonFields::allow_only(std::span<const std::string_view> names) const {
  for (const JsonField field : object_.fields()) {
    if (std::find(names.begin(), names.end(), field.name) != names.end()) continue;
    throw place_->error(field.offset, "unknown field " + in_quotes(field.name) + did_you_mean(field.name, names));
  }
}

JsonValue JsonFields::require(std::string_view name) const {
  if (const auto value = find(name)) return *value;
  throw place_->error(offset(), fmt::format("{} needs the field {}", what_, in_quotes(name)));
}

InputError JsonFields::error(std::string_view name, std::string_view message) const {
  return place_->error(require(name).offset(), fmt::format("{} {}", in_quotes(name), message));
}

}  // namespace graze::io
