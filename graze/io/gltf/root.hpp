// SPDX-License-Identifier: MIT
// The top-level arrays of glTF, whose elements refer to each other by index.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include <graze/io/json/document.hpp>
#include <graze/io/json/fields.hpp>

namespace graze::io {

enum class GltfArray : std::uint8_t { scenes, nodes, meshes, accessors, buffer_views, buffers };

/// An element and its place in messages.
struct GltfItem {
  JsonValue value;
  JsonPlace place;
  std::string_view what;  ///< "a mesh"

  JsonFields fields() const { return {value, place, what}; }
};

/// Whether a JSON document is glTF, of any version.
bool is_gltf(JsonValue root);

class GltfRoot {
 public:
  /// Refers to the document, which must outlive this. Throws InputError if an array is something else, or an element is
  /// not an object.
  explicit GltfRoot(const JsonDocument& document);

  JsonFields fields() const { return {document_.root(), place_, "a glTF file"}; }
  const JsonPlace& place() const { return place_; }
  std::size_t size(GltfArray array) const { return items_[static_cast<std::size_t>(array)].size(); }
  /// An element that exists.
  GltfItem item(GltfArray array, std::size_t index) const;

  /// The index of the element that a field refers to. Throws InputError if there is no such element.
  std::size_t index(JsonValue value, const JsonFieldName& name, const JsonPlace& place, GltfArray array) const;

 private:
  const JsonDocument& document_;
  JsonPlace place_;
  std::array<std::vector<JsonValue>, 6> items_;
};

/// A whole number, `otherwise` if there is no such field; at most 2^48, so that sums do not overflow. Throws
/// InputError.
std::size_t gltf_size(const JsonFields& fields, std::string_view name, std::size_t otherwise);

}  // namespace graze::io
