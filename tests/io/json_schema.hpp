// SPDX-License-Identifier: MIT
// Validates by a JSON Schema (2020-12), with the few keywords that the lines of a log need, so that tests compare the
// schema file with the reader.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <regex>
#include <stdexcept>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

namespace graze::io {

class JsonSchema {
 public:
  using Json = nlohmann::json;

  explicit JsonSchema(Json document) : document_(std::move(document)) {}

  /// Whether the definition of this name in the document accepts the value. Throws std::runtime_error for a keyword
  /// that this class does not support.
  bool definition_allows(const std::string& name, const Json& value) const {
    return allows(document_.at("$defs").at(name), value);
  }

 private:
  bool allows(const Json& schema, const Json& value) const {
    if (schema.is_boolean()) return schema.get<bool>();
    bool is_allowed = true;
    for (const auto& keyword : schema.items()) {
      is_allowed = is_allowed && meets(schema, keyword.key(), keyword.value(), value);
    }
    return is_allowed;
  }

  /// Whether the value satisfies one keyword of the schema.
  bool meets(const Json& schema, const std::string& key, const Json& said, const Json& value) const {
    const auto is_met = [&](const Json& inner) { return allows(inner, value); };
    if (key == "description") return true;
    if (key == "$ref") return is_met(document_.at(Json::json_pointer(said.get<std::string>().substr(1))));
    if (key == "type") return is_of_type(said.get<std::string>(), value);
    if (key == "const") return value == said;
    if (key == "enum") return std::find(said.begin(), said.end(), value) != said.end();
    if (key == "anyOf") return std::any_of(said.begin(), said.end(), is_met);
    if (key == "oneOf") return std::count_if(said.begin(), said.end(), is_met) == 1;
    if (key == "not") return !is_met(said);
    if (key == "minimum") return !value.is_number() || value >= said;
    if (key == "maximum") return !value.is_number() || value <= said;
    if (key == "pattern") return !value.is_string() || is_found(said.get<std::string>(), value.get<std::string>());
    if (key == "required" || key == "properties" || key == "additionalProperties") {
      return !value.is_object() || meets_of_object(schema, key, said, value);
    }
    return !value.is_array() || meets_of_array(schema, key, said, value);
  }

  bool meets_of_object(const Json& schema, const std::string& key, const Json& said, const Json& value) const {
    if (key == "required") {
      return std::all_of(said.begin(), said.end(), [&](const Json& name) { return value.contains(name); });
    }
    const Json& known = schema.at("properties");
    bool is_met = true;
    for (const auto& field : value.items()) {
      const bool is_known = known.contains(field.key());
      if (is_known != (key == "properties")) continue;
      is_met = is_met && allows(is_known ? known.at(field.key()) : said, field.value());
    }
    return is_met;
  }

  bool meets_of_array(const Json& schema, const std::string& key, const Json& said, const Json& value) const {
    if (key == "minItems") return value.size() >= said.get<std::size_t>();
    if (key == "maxItems") return value.size() <= said.get<std::size_t>();
    const auto is_met = [&](const Json& item) { return allows(said, item); };
    if (key == "contains") return std::any_of(value.begin(), value.end(), is_met);
    const std::size_t given = schema.value("prefixItems", Json::array()).size();
    const auto rest = value.begin() + static_cast<std::ptrdiff_t>(std::min(given, value.size()));
    if (key == "prefixItems") {
      return std::equal(value.begin(), rest, said.begin(),
                        [&](const Json& item, const Json& inner) { return allows(inner, item); });
    }
    if (key == "items") return std::all_of(rest, value.end(), is_met);
    throw std::runtime_error("JsonSchema: the keyword \"" + key + "\" is not known");
  }

  static bool is_of_type(const std::string& type, const Json& value) {
    if (type != "integer") return type == value.type_name();
    return value.is_number() && value.get<double>() == std::floor(value.get<double>());
  }

  static bool is_found(const std::string& pattern, const std::string& text) {
    return std::regex_search(text, std::regex(pattern));
  }

  Json document_;
};

}  // namespace graze::io
