// SPDX-License-Identifier: MIT
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include <graze/io/gltf/root.hpp>

namespace graze::io {
namespace {

/// The names of an array, of an element, and of an element with its article.
struct ArrayName {
  std::string_view field;
  std::string_view word;
  std::string_view what;
};

constexpr std::array<ArrayName, 6> array_names = {{{"scenes", "scene", "a scene"},
                                                   {"nodes", "node", "a node"},
                                                   {"meshes", "mesh", "a mesh"},
                                                   {"accessors", "accessor", "an accessor"},
                                                   {"bufferViews", "bufferView", "a bufferView"},
                                                   {"buffers", "buffer", "a buffer"}}};

const ArrayName& name_of(GltfArray array) { return array_names[static_cast<std::size_t>(array)]; }

}  // namespace

bool is_gltf(JsonValue root) {
  if (root.kind() != JsonKind::object || root.find("schema")) return false;
  const std::optional<JsonValue> asset = root.find("asset");
  return (asset && asset->kind() == JsonKind::object) || (root.find("accessors") && root.find("meshes"));
}

GltfRoot::GltfRoot(const JsonDocument& document) : document_(document), place_{document} {
  for (std::size_t i = 0; i < array_names.size(); ++i) {
    const std::optional<JsonValue> array = document.root().find(array_names[i].field);
    if (!array) continue;
    std::size_t index = 0;
    for (const JsonValue value : read_array(*array, {array_names[i].field}, place_).items()) {
      const JsonPlace place{document, nullptr, array_names[i].word, index++};
      if (value.kind() != JsonKind::object) {
        throw place.error(value.offset(), fmt::format("must be an object, not {}", kind_name(value.kind())));
      }
      items_[i].push_back(value);
    }
  }
}

GltfItem GltfRoot::item(GltfArray array, std::size_t index) const {
  const JsonValue value = items_[static_cast<std::size_t>(array)][index];
  return {value, JsonPlace{document_, nullptr, name_of(array).word, index}, name_of(array).what};
}

std::size_t GltfRoot::index(JsonValue value, const JsonFieldName& name, const JsonPlace& place, GltfArray array) const {
  const std::uint64_t index = read_whole(value, name, place);
  if (index < size(array)) return static_cast<std::size_t>(index);
  throw place.error(value.offset(), fmt::format("\"{}\" is {}, but \"{}\" has {} elements, numbered from 0", name.name,
                                                index, name_of(array).field, size(array)));
}

std::size_t gltf_size(const JsonFields& fields, std::string_view name, std::size_t otherwise) {
  const std::optional<JsonValue> value = fields.find(name);
  if (!value) return otherwise;
  const std::uint64_t size = read_whole(*value, {name}, fields.place());
  if (size > std::uint64_t{1} << 48U) {
    throw fields.error(name, fmt::format("is {}, which is more than any file holds", size));
  }
  return static_cast<std::size_t>(size);
}

}  // namespace graze::io
