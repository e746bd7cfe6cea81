// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <graze/io/file/referenced_file.hpp>
#include <graze/io/file/unpack.hpp>
#include <graze/io/file/utf8_path.hpp>
#include <graze/io/gltf/accessors.hpp>
#include <graze/io/gltf/uri.hpp>
#include <graze/io/mesh/bytes.hpp>
#include <graze/io/text/in_quotes.hpp>

namespace graze::io {
namespace {

/// The most elements of an accessor whose numbers are zero where the file does not say otherwise.
constexpr std::size_t most_without_bytes = 100'000;

/// Types of numbers by their code in OpenGL.
constexpr std::size_t int8_code = 5120;
constexpr std::size_t uint8_code = 5121;
constexpr std::size_t int16_code = 5122;
constexpr std::size_t uint16_code = 5123;
constexpr std::size_t uint32_code = 5125;
constexpr std::size_t float32_code = 5126;

/// 0 for an unknown type.
std::size_t bytes_of_type(std::size_t type) {
  if (type == int8_code || type == uint8_code) return 1;
  if (type == int16_code || type == uint16_code) return 2;
  return type == uint32_code || type == float32_code ? 4 : 0;
}

double value_at(const char* bytes, std::size_t type) {
  if (type == int8_code) return number_at<std::int8_t>(bytes);
  if (type == uint8_code) return number_at<std::uint8_t>(bytes);
  if (type == int16_code) return number_at<std::int16_t>(bytes);
  if (type == uint16_code) return number_at<std::uint16_t>(bytes);
  if (type == uint32_code) return number_at<std::uint32_t>(bytes);
  return number_at<float>(bytes);
}

/// The value of a normalized integer, from -1 or 0 to 1 (glTF 2.0, section 3.11).
double normalized(double value, std::size_t type) {
  if (type == int8_code) return std::max(value / 127, -1.0);
  if (type == uint8_code) return value / 255;
  if (type == int16_code) return std::max(value / 32767, -1.0);
  return value / 65535;
}

}  // namespace

/// Where numbers are, and of which type.
struct GltfAccessors::Layout {
  std::optional<std::size_t> view;
  std::size_t offset = 0;  ///< From the beginning of the view.
  std::size_t type = 0;
  std::size_t count = 0;
  std::size_t components = 0;
  bool is_normalized = false;
};

GltfAccessors::Layout GltfAccessors::layout_of(const JsonFields& accessor, std::size_t components) const {
  Layout layout;
  layout.components = components;
  layout.count = gltf_size(accessor, "count", 0);
  layout.offset = gltf_size(accessor, "byteOffset", 0);
  layout.type = gltf_size(accessor, "componentType", 0);
  if (bytes_of_type(layout.type) == 0) {
    throw accessor.error("componentType", fmt::format("is {}; graze reads 5120 to 5123, 5125 and 5126", layout.type));
  }
  if (const auto flag = accessor.find("normalized")) {
    layout.is_normalized = flag->kind() == JsonKind::boolean && flag->boolean();
  }
  if (const auto view = accessor.find("bufferView")) {
    layout.view = root_.index(*view, {"bufferView"}, accessor.place(), GltfArray::buffer_views);
  }
  const std::string_view shape = components == 1 ? "SCALAR" : "VEC3";
  if (const std::string_view type = read_text(accessor.require("type"), {"type"}, accessor.place()); type != shape) {
    throw accessor.error("type", fmt::format("is {}; here it must be \"{}\"", in_quotes(type), shape));
  }
  return layout;
}

/// A file may describe the same bytes many times, so the numbers read are limited by its size.
void GltfAccessors::spend(const JsonFields& accessor, std::size_t values) {
  values_read_ += values;
  if (values_read_ <= total_bytes_ + most_without_bytes) return;
  throw accessor.place().error(accessor.offset(),
                               "the accessors up to this one have more numbers than the buffers have "
                               "bytes; do they overlap?");
}

std::vector<double> GltfAccessors::values(std::size_t accessor, std::size_t components) {
  const GltfItem item = root_.item(GltfArray::accessors, accessor);
  const JsonFields fields = item.fields();
  const Layout layout = layout_of(fields, components);
  std::vector<double> values;
  if (layout.view) {
    read(fields, layout, values);
  } else {
    if (layout.count > most_without_bytes) {
      throw item.place.error(fields.offset(),
                             fmt::format("has no \"bufferView\" for its {} elements; at most {} may be "
                                         "zero without one",
                                         layout.count, most_without_bytes));
    }
    values.assign(layout.count * components, 0);
    spend(fields, layout.count);
  }
  read_sparse(fields, layout, values);
  return values;
}

void GltfAccessors::read(const JsonFields& place, const Layout& layout, std::vector<double>& values) {
  const std::string_view bytes = bytes_of_view(*layout.view);
  const std::size_t size = bytes_of_type(layout.type);
  const std::size_t element = size * layout.components;
  const GltfItem view = root_.item(GltfArray::buffer_views, *layout.view);
  const std::size_t stride = gltf_size(view.fields(), "byteStride", element);
  if (stride < element) {
    throw view.place.error(view.value.offset(),
                           fmt::format("\"byteStride\" is {}, but an element has {} bytes", stride, element));
  }
  const std::size_t left = bytes.size() - std::min(layout.offset, bytes.size());
  if (layout.count > 0 && (left < element || layout.count - 1 > (left - element) / stride)) {
    throw place.place().error(place.offset(),
                              fmt::format("needs {} elements, {} bytes each, from byte {} of bufferView "
                                          "{}, which has only {} bytes",
                                          layout.count, stride, layout.offset, *layout.view, bytes.size()));
  }
  spend(place, layout.count);
  values.reserve(layout.count * layout.components);
  for (std::size_t i = 0; i < layout.count; ++i) {
    const char* const at = bytes.data() + layout.offset + i * stride;
    for (std::size_t j = 0; j < layout.components; ++j) {
      const double value = value_at(at + j * size, layout.type);
      if (!std::isfinite(value)) {
        throw place.place().error(place.offset(),
                                  fmt::format("element {} has {}; coordinates must be finite numbers", i, value));
      }
      values.push_back(layout.is_normalized && layout.type < uint32_code ? normalized(value, layout.type) : value);
    }
  }
}

/// Replaces some elements by others.
void GltfAccessors::read_sparse(const JsonFields& accessor, const Layout& layout, std::vector<double>& values) {
  const std::optional<JsonValue> sparse = accessor.find("sparse");
  if (!sparse) return;
  const JsonPlace& place = accessor.place();
  const auto object_in = [&place](JsonValue parent, std::string_view name) {
    const JsonValue value = JsonFields(parent, place, "a sparse accessor").require(name);
    if (value.kind() == JsonKind::object) return value;
    throw place.error(value.offset(), fmt::format("\"{}\" must be an object, not {}", name, kind_name(value.kind())));
  };
  if (sparse->kind() != JsonKind::object) throw accessor.error("sparse", "must be an object");
  const auto read_part = [&](std::string_view name, std::size_t type, std::size_t components) {
    const JsonFields fields(object_in(*sparse, name), place, "a sparse accessor");
    Layout part{root_.index(fields.require("bufferView"), {"bufferView"}, place, GltfArray::buffer_views),
                gltf_size(fields, "byteOffset", 0),
                type,
                gltf_size(JsonFields(*sparse, place, "a sparse accessor"), "count", 0),
                components,
                layout.is_normalized && name == "values"};
    if (name == "indices") part.type = gltf_size(fields, "componentType", 0);
    if (bytes_of_type(part.type) == 0) throw fields.error("componentType", "must be 5121, 5123 or 5125");
    std::vector<double> result;
    read(fields, part, result);
    return result;
  };
  const std::vector<double> indices = read_part("indices", layout.type, 1);
  const std::vector<double> replacements = read_part("values", layout.type, layout.components);
  for (std::size_t i = 0; i < indices.size(); ++i) {
    if (!(indices[i] >= 0 && indices[i] < static_cast<double>(layout.count) && indices[i] == std::floor(indices[i]))) {
      throw accessor.error("sparse", fmt::format("replaces element {}, but there are {}", indices[i], layout.count));
    }
    for (std::size_t j = 0; j < layout.components; ++j) {
      values[static_cast<std::size_t>(indices[i]) * layout.components + j] = replacements[i * layout.components + j];
    }
  }
}

const std::vector<Vec<3, double>>& GltfAccessors::points(std::size_t accessor) {
  const auto [known, is_new] = points_.try_emplace(accessor);
  if (!is_new) return known->second;
  const GltfItem item = root_.item(GltfArray::accessors, accessor);
  const std::vector<double> numbers = values(accessor, 3);
  if (gltf_size(item.fields(), "componentType", 0) == uint32_code) {
    throw item.fields().error("componentType", "is 5125; coordinates are floats (5126) or small integers");
  }
  known->second.reserve(numbers.size() / 3);
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3) {
    known->second.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
  }
  return known->second;
}

const std::vector<Vec<3, double>>& GltfAccessors::corners(std::size_t accessor) {
  const std::vector<Vec<3, double>>& corners = points(accessor);
  spend(root_.item(GltfArray::accessors, accessor).fields(), corners.size());
  return corners;
}

std::vector<std::uint32_t> GltfAccessors::indices(std::size_t accessor) {
  const GltfItem item = root_.item(GltfArray::accessors, accessor);
  const std::size_t type = gltf_size(item.fields(), "componentType", 0);
  if (type != uint8_code && type != uint16_code && type != uint32_code) {
    throw item.place.error(item.value.offset(),
                           fmt::format("has componentType {}; indices have 5121, 5123 or 5125", type));
  }
  std::vector<std::uint32_t> result;
  const std::vector<double> numbers = values(accessor, 1);
  result.reserve(numbers.size());
  for (const double number : numbers) {
    if (number != std::floor(number)) throw item.place.error(item.value.offset(), "has an index that is not whole");
    result.push_back(static_cast<std::uint32_t>(number));
  }
  return result;
}

std::string_view GltfAccessors::bytes_of_view(std::size_t view) {
  const GltfItem item = root_.item(GltfArray::buffer_views, view);
  const JsonFields fields = item.fields();
  const std::size_t buffer = root_.index(fields.require("buffer"), {"buffer"}, item.place, GltfArray::buffers);
  const std::string_view bytes = bytes_of_buffer(buffer);
  const std::size_t offset = gltf_size(fields, "byteOffset", 0);
  fields.require("byteLength");
  const std::size_t length = gltf_size(fields, "byteLength", 0);
  if (offset > bytes.size() || length > bytes.size() - offset) {
    throw item.place.error(fields.offset(), fmt::format("has {} bytes from byte {} on, but buffer {} has only {}",
                                                        length, offset, buffer, bytes.size()));
  }
  return bytes.substr(offset, length);
}

std::string_view GltfAccessors::bytes_of_buffer(std::size_t buffer) {
  const GltfItem item = root_.item(GltfArray::buffers, buffer);
  const JsonFields fields = item.fields();
  fields.require("byteLength");
  const std::size_t length = gltf_size(fields, "byteLength", 0);
  const bool is_chunk = !fields.find("uri");
  if (is_chunk && (!binary_ || buffer != 0)) {
    throw item.place.error(fields.offset(), "has no \"uri\"; only the first buffer of a .glb file may do without one");
  }
  auto known = loaded_.find(buffer);
  if (known == loaded_.end()) {
    known = loaded_.emplace(buffer, is_chunk ? std::string() : load(item)).first;
    total_bytes_ += is_chunk ? binary_->size() : known->second.size();
  }
  const std::string_view bytes = is_chunk ? *binary_ : std::string_view(known->second);
  if (bytes.size() < length) {
    throw item.place.error(fields.offset(),
                           fmt::format("promises {} bytes, but has only {}; is it cut off?", length, bytes.size()));
  }
  return bytes.substr(0, length);
}

std::string GltfAccessors::load(const GltfItem& buffer) const {
  const JsonFields fields = buffer.fields();
  const std::string_view uri = read_text(fields.require("uri"), {"uri"}, buffer.place);
  constexpr std::string_view data = "data:";
  if (!uri.starts_with(data)) return load_file(fields, uri);
  constexpr std::string_view mark = ";base64,";
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos || comma + 1 < mark.size() ||
      uri.substr(comma + 1 - mark.size(), mark.size()) != mark) {
    throw fields.error("uri", "holds data that is not base64");
  }
  Unpacked unpacked = decoded_base64(uri.substr(comma + 1));
  if (unpacked.fault) throw fields.error("uri", "holds data that " + unpacked.fault->fact);
  return std::move(unpacked.bytes);
}

std::string GltfAccessors::load_file(const JsonFields& buffer, std::string_view uri) const {
  const std::optional<std::string> name = file_of_gltf_uri(uri);
  if (!name) {
    throw buffer.error("uri", fmt::format("is {}; graze opens only files in the same folder and below, because a file "
                                          "from elsewhere must not choose what is read here",
                                          in_quotes(uri)));
  }
  ReferencedFile file = read_referenced_file(folder_ / path_from_utf8(*name));
  if (file.fault.empty()) return std::move(file.bytes);
  throw buffer.error("uri", fmt::format("is {}, which cannot be read: {}", in_quotes(*name), file.fault));
}

}  // namespace graze::io
