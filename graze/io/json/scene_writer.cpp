// SPDX-License-Identifier: MIT
#include <algorithm>
#include <bit>
#include <cstdint>
#include <iterator>
#include <ostream>
#include <string>
#include <string_view>
#include <unordered_map>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include <graze/io/json/shape_writer.hpp>
#include <graze/io/json_scene.hpp>
#include <graze/io/output_error.hpp>
#include <graze/io/text/in_quotes.hpp>
#include <graze/io/text/utf8.hpp>

namespace graze::io {
namespace {

/// RFC 8259, section 7: quotes, backslashes and control characters must be escaped; everything else may be written
/// unchanged.
std::string quoted_name(std::string_view text) {
  if (find_invalid_utf8(text) != std::string_view::npos) {
    throw OutputError(fmt::format("the name {} is not UTF-8 text, so a scene file cannot hold it", in_quotes(text)));
  }
  std::string result = "\"";
  for (const char character : text) {
    if (character == '"' || character == '\\') {
      result += '\\';
      result += character;
    } else if (static_cast<unsigned char>(character) < 0x20) {
      fmt::format_to(std::back_inserter(result), "\\u{:04x}", static_cast<unsigned>(character));
    } else {
      result += character;
    }
  }
  return result + '"';
}

std::string json_strings(const std::vector<std::string>& texts) {
  std::string result = "[";
  for (const std::string& text : texts) result += (result.size() == 1 ? "" : ", ") + quoted_name(text);
  return result + ']';
}

/// Names for all layers of a scene, by number. Programs may use layers by number only, but a file refers to layers by
/// name. Empty if the scene uses only the defaults.
template <Dim N>
std::vector<std::string> names_of_layers(const Scene<N, double>& scene) {
  std::vector<std::string> names = scene.layer_names();
  std::size_t needed = 0;
  for (const ObjectId id : scene.ids()) {
    const Object<N, double>& object = scene.object(id);
    const bool is_default = object.layer == 0 && object.mask == all_layers;
    if (!is_default || !names.empty()) needed = std::max(needed, std::size_t{object.layer} + 1);
    if (object.mask != all_layers) needed = std::max(needed, static_cast<std::size_t>(std::bit_width(object.mask)));
  }
  while (names.size() < needed) {
    std::string name = fmt::format("layer {}", names.size());
    while (std::find(names.begin(), names.end(), name) != names.end()) name += '\'';
    names.push_back(name);
  }
  return names;
}

std::vector<std::string> names_in_mask(LayerMask mask, const std::vector<std::string>& layers) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    if ((mask & only_layer(static_cast<Layer>(i))) != 0) names.push_back(layers[i]);
  }
  return names;
}

std::string json_id(const ObjectId& id) { return fmt::format("[{}, {}]", id.index, id.generation); }

/// Whether the ids differ from those that reading would assign: generation 1, in the order of objects.
template <Dim N>
bool has_ids_of_its_own(const Scene<N, double>& scene) {
  if (!scene.vacant_ids().empty()) return true;
  const std::vector<ObjectId> ids = scene.ids();
  return std::any_of(ids.begin(), ids.end(), [](const ObjectId& id) { return id.generation != 1; });
}

/// The excepted pairs by the names of objects, or by their numbers in the file if they have no name.
template <Dim N>
std::string json_excepted_pairs(const Scene<N, double>& scene, const std::vector<ObjectPair>& pairs) {
  const std::vector<ObjectId> ids = scene.ids();
  const auto called = [&](const ObjectId& id) {
    const std::string& name = scene.object(id).name;
    if (!name.empty()) return quoted_name(name);
    return fmt::format("{}", std::lower_bound(ids.begin(), ids.end(), id) - ids.begin());
  };
  std::string text = "[";
  for (const auto& [a, b] : pairs) {
    text += (text.size() == 1 ? "[" : ", [") + called(a) + ", " + called(b) + ']';
  }
  return text + ']';
}

template <Dim N>
std::string json_velocity(const Vec<3, double>& velocity) {
  std::string text = ", \"velocity\": [";
  for (Dim i = 0; i < N; ++i)
    text += (i > 0 ? ", " : "") + fmt::format("{}", velocity[i] + 0.0);  // + 0.0 turns minus zero into zero
  return text + ']';
}

/// What a file stores of an object in addition to the scene: fields before and after the others, with their commas.
struct Around {
  std::string before;
  std::string after;
};

template <Dim N>
void append_object(std::string& out, const Around& around, const Object<N, double>& object,
                   const std::vector<std::string>& layers) {
  out += "    {" + around.before;
  if (!object.name.empty()) out += "\"name\": " + quoted_name(object.name) + ", ";
  try {
    append_json_shape<N>(out, object.shape);
  } catch (const OutputError& error) {
    throw OutputError(fmt::format("object {}: {}", in_quotes(object.name), error.what()));
  }
  if (!layers.empty()) out += ", \"layer\": " + quoted_name(layers[object.layer]);
  if (object.mask != all_layers) out += ", \"mask\": " + json_strings(names_in_mask(object.mask, layers));
  if (object.mobility == Mobility::fixed) out += ", \"fixed\": true";
  if (object.user != 0) fmt::format_to(std::back_inserter(out), ", \"user\": {}", object.user);
  out += around.after + '}';
}

template <Dim N>
void write(std::ostream& out, const Scene<N, double>& scene, const SceneFile& file) {
  constexpr std::size_t chunk = 1U << 16U;
  const std::vector<std::string> layers = names_of_layers(scene);
  std::string text = fmt::format("{{\n  \"schema\": \"{}\",\n  \"dimension\": {},\n", json_scene_schema, N);
  if (N == 2 && file.y_axis == YAxis::down) text += "  \"y_axis\": \"down\",\n";
  if (!layers.empty()) text += "  \"layers\": " + json_strings(layers) + ",\n";
  const bool with_ids = has_ids_of_its_own(scene);
  if (const std::vector<ObjectId> vacant = scene.vacant_ids(); !vacant.empty()) {
    text += "  \"vacant_ids\": [";
    for (const ObjectId& id : vacant) text += (id == vacant.front() ? "" : ", ") + json_id(id);
    text += "],\n";
  }
  if (const std::vector<ObjectPair> pairs = scene.excepted_pairs(); !pairs.empty()) {
    text += "  \"excepted_pairs\": " + json_excepted_pairs(scene, pairs) + ",\n";
  }
  std::unordered_map<std::uint32_t, std::string> velocities;  // by the index of an id
  for (const ObjectVelocity& each : file.velocities) velocities[each.id.index] = json_velocity<N>(each.velocity);
  text += "  \"objects\": [";
  bool first = true;
  for (const ObjectId id : scene.ids()) {
    text += first ? "\n" : ",\n";
    first = false;
    Around around;
    if (with_ids) around.before = "\"id\": " + json_id(id) + ", ";
    if (const auto velocity = velocities.find(id.index); velocity != velocities.end()) around.after = velocity->second;
    append_object(text, around, scene.object(id), layers);
    if (text.size() < chunk) continue;
    out << text;
    text.clear();
  }
  out << text << (first ? "]\n}\n" : "\n  ]\n}\n");
}

}  // namespace

void write_json_scene(std::ostream& out, const SceneFile& file) {
  std::visit([&](const auto& scene) { write(out, scene, file); }, file.scene);
}

}  // namespace graze::io
