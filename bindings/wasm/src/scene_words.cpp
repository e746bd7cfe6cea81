// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <graze/io/input_error.hpp>
#include <graze/io/json/document.hpp>
#include <graze/io/json/fields.hpp>
#include <graze/io/text/in_quotes.hpp>
#include <graze/io/text/suggestion.hpp>

#include "scenes.hpp"
#include "shape_text.hpp"

namespace graze::wasm {
namespace {

using LayerWord = std::variant<std::string, Layer>;

LayerWord read_layer(io::JsonValue value, const io::JsonFieldName& name, const io::JsonPlace& place) {
  if (value.kind() == io::JsonKind::text) return std::string(value.text());
  if (value.kind() == io::JsonKind::whole && value.whole() < max_layers) return static_cast<Layer>(value.whole());
  throw place.error(value.offset(), fmt::format("{} must hold a layer's name, or its number from 0 to {}",
                                                io::in_quotes(name.name), max_layers - 1));
}

std::vector<LayerWord> read_layers(io::JsonValue value, const io::JsonFieldName& name, const io::JsonPlace& place) {
  std::vector<LayerWord> layers;
  for (const io::JsonValue item : io::read_array(value, name, place).items()) {
    layers.push_back(read_layer(item, name, place));
  }
  return layers;
}

}  // namespace

ObjectWords::ObjectWords(const std::string& text) {
  constexpr std::array<std::string_view, 5> known = {"name", "layer", "mask", "user", "fixed"};
  constexpr const char* role = "options";
  try {
    const io::JsonDocument document(text, role);
    const io::JsonPlace place{document};
    const io::JsonFields fields(document.root(), place, "options");
    fields.allow_only(known);
    if (const auto name = fields.find("name")) options_.name = io::read_text(*name, {"name"}, place);
    if (const auto user = fields.find("user")) options_.user = io::read_whole(*user, {"user"}, place);
    if (const auto layer = fields.find("layer")) layer_ = read_layer(*layer, {"layer"}, place);
    if (const auto mask = fields.find("mask")) {
      mask_ = read_layers(*mask, {"mask"}, place);
      has_mask_ = true;
    }
    // JavaScript writes 1 for true and omits false, because scene files have no use for JSON's booleans.
    if (fields.find("fixed")) options_.mobility = Mobility::fixed;
  } catch (const io::InputError& error) {
    rethrow_without_place(error.what(), role);
  }
}

template <Dim N>
ObjectOptions ObjectWords::in(Scene<N, double>& scene) const {
  ObjectOptions options = options_;
  if (scene.find(options.name)) return options;
  const auto number_of = [&scene](const LayerWord& word) {
    const auto* const name = std::get_if<std::string>(&word);
    return name != nullptr ? scene.layer(*name) : std::get<Layer>(word);
  };
  options.layer = number_of(layer_);
  if (has_mask_) options.mask = 0;
  for (const LayerWord& word : mask_) options.mask |= only_layer(number_of(word));
  return options;
}

template ObjectOptions ObjectWords::in(Scene<2, double>&) const;
template ObjectOptions ObjectWords::in(Scene<3, double>&) const;

LayerMask mask_of_words(const std::string& text, const std::vector<std::string>& names) {
  if (text.empty()) return all_layers;
  constexpr const char* role = "layers";
  std::vector<LayerWord> words;
  try {
    const io::JsonDocument document(text, role);
    words = read_layers(document.root(), {role}, io::JsonPlace{document});
  } catch (const io::InputError& error) {
    rethrow_without_place(error.what(), role);
  }
  LayerMask mask = 0;
  for (const LayerWord& word : words) {
    const auto* const name = std::get_if<std::string>(&word);
    if (name == nullptr) {
      mask |= only_layer(std::get<Layer>(word));
      continue;
    }
    const auto place = std::find(names.begin(), names.end(), *name);
    if (place == names.end()) {
      const std::vector<std::string_view> known(names.begin(), names.end());
      throw std::invalid_argument("layers: there is no layer " + io::in_quotes(*name) + io::did_you_mean(*name, known));
    }
    mask |= only_layer(static_cast<Layer>(place - names.begin()));
  }
  return mask;
}

}  // namespace graze::wasm
