// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <graze/io/json/document.hpp>
#include <graze/io/json/fields.hpp>
#include <graze/io/json/ids.hpp>
#include <graze/io/json/mesh_files.hpp>
#include <graze/io/json/shape_reader.hpp>
#include <graze/io/json_scene.hpp>
#include <graze/io/text/in_quotes.hpp>
#include <graze/io/text/suggestion.hpp>

namespace graze::io {
namespace {

constexpr std::array<std::string_view, 7> scene_fields = {"schema",     "dimension",      "y_axis", "layers",
                                                          "vacant_ids", "excepted_pairs", "objects"};
constexpr std::array<std::string_view, 7> object_fields = {"id", "name", "layer", "mask", "fixed", "user", "velocity"};

/// The layer of objects without one, in a file where other objects have a layer.
constexpr std::string_view default_layer = "default";

/// True for "graze.scene/2" and later.
bool is_newer_schema(std::string_view schema) {
  const std::string_view stem = json_scene_schema.substr(0, json_scene_schema.find('/') + 1);
  if (!schema.starts_with(stem)) return false;
  int version = 0;
  const auto [end, status] = std::from_chars(schema.data() + stem.size(), schema.data() + schema.size(), version);
  return end == schema.data() + schema.size() && (status != std::errc() || version > 1);
}

void require_schema(const JsonFields& scene) {
  const auto value = scene.find("schema");
  if (!value) {
    throw scene.place().error(
        scene.offset(), fmt::format(R"(there is no "schema"; a graze scene has "schema": "{}")", json_scene_schema));
  }
  const std::string_view schema = read_text(*value, {"schema"}, scene.place());
  if (schema == json_scene_schema) return;
  if (is_newer_schema(schema)) {
    throw scene.error("schema", fmt::format("is {}: written by a newer graze; this one reads \"{}\"", in_quotes(schema),
                                            json_scene_schema));
  }
  throw scene.error(
      "schema", fmt::format("is {}, which is not a scene; a scene has \"{}\"", in_quotes(schema), json_scene_schema));
}

Dim read_dimension(const JsonFields& scene) {
  const auto value = scene.find("dimension");
  if (!value) throw scene.place().error(scene.offset(), "there is no \"dimension\"; give 2 or 3");
  const double dimension = read_number(*value, {"dimension"}, scene.place());
  if (dimension == 2) return 2;
  if (dimension == 3) return 3;
  throw scene.error("dimension", fmt::format("is {}; it must be 2 or 3", dimension));
}

YAxis read_y_axis(const JsonFields& scene, Dim dimension) {
  const auto value = scene.find("y_axis");
  if (!value) return YAxis::up;
  if (dimension != 2) throw scene.error("y_axis", "is for scenes of dimension 2 only; leave it out");
  const std::string_view direction = read_text(*value, {"y_axis"}, scene.place());
  if (direction == "up") return YAxis::up;
  if (direction == "down") return YAxis::down;
  throw scene.error("y_axis", fmt::format("is {}; it must be \"up\" or \"down\"", in_quotes(direction)));
}

bool read_flag(JsonValue value, const JsonFieldName& name, const JsonPlace& place) {
  if (value.kind() == JsonKind::boolean) return value.boolean();
  throw place.error(value.offset(),
                    fmt::format("\"{}\" is {}; it must be true or false", name.name, kind_name(value.kind())));
}

/// Reads the objects of a file into a scene.
template <Dim N>
class ObjectReader {
 public:
  ObjectReader(const JsonFields& scene, const std::optional<std::filesystem::path>& folder)
      : document_place_(scene.place()),
        mesh_files_(folder),
        objects_(scene.array("objects")),
        excepted_pairs_(scene.find("excepted_pairs")) {
    read_layers(scene);
    collect_names();
    const SavedIds ids = read_saved_ids(scene);
    if (!ids.next.empty() || !ids.vacant.empty()) scene_.plan_ids(ids.next, ids.vacant);
  }

  /// The file's scene, and what a scene does not store.
  void read(SceneFile& file) {
    std::size_t index = 0;
    for (const JsonValue object : objects_.items()) add(object, index++);
    if (excepted_pairs_) except(*excepted_pairs_);
    file.scene = std::move(scene_);
    file.velocities = std::move(velocities_);
    file.omissions = mesh_files_.omissions();
    file.warnings = mesh_files_.warnings();
  }

 private:
  const JsonDocument& document() const { return document_place_.document; }

  void read_layers(const JsonFields& scene) {
    const auto value = scene.find("layers");
    if (!value) return;
    layers_are_listed_ = uses_layers_ = true;
    std::size_t number = 0;
    for (const JsonValue name : read_array(*value, {"layers"}, document_place_).items()) {
      const std::string_view text = read_text(name, {"layers", number}, document_place_);
      if (text.empty()) throw document_place_.error(name.offset(), "a layer in \"layers\" has an empty name");
      if (layer_number(name, text, document_place_) != number) {
        throw document_place_.error(name.offset(), fmt::format("\"layers\" names {} twice", in_quotes(text)));
      }
      ++number;
    }
  }

  /// Names must be unique, and generated names must not clash with given ones, so all given names are read first.
  void collect_names() {
    std::size_t index = 0;
    for (const JsonValue object : objects_.items()) {
      if (object.kind() == JsonKind::object) {
        if (const auto name = object.find("name")) take_name(*name, index);
        uses_layers_ = uses_layers_ || object.find("layer") || object.find("mask");
      }
      ++index;
    }
  }

  void take_name(JsonValue value, std::size_t index) {
    const JsonPlace place{document(), nullptr, "object", index};
    const std::string_view name = read_text(value, {"name"}, place);
    if (name.empty()) throw place.error(value.offset(), "\"name\" is empty; give a name or leave the field out");
    const auto [taken, is_new] = index_by_name_.try_emplace(name, index);
    if (is_new) return;
    throw place.error(value.offset(), fmt::format("the name {} is taken by object {}; names must be unique",
                                                  in_quotes(name), taken->second));
  }

  /// "#7" for object 7; "#7-2" and so on if another object has that name.
  std::string name_for_unnamed(std::size_t index) const {
    std::string name = fmt::format("#{}", index);
    for (int next = 2; index_by_name_.contains(name); ++next) name = fmt::format("#{}-{}", index, next);
    return name;
  }

  void add(JsonValue object, std::size_t index) {
    JsonPlace place{document(), nullptr, "object", index};
    if (object.kind() == JsonKind::object) {
      if (const auto name = object.find("name")) place.name = name->text();
    }
    AnyShape<N, double> shape = read_shape(object, place);
    ObjectOptions options = read_options(object, place);
    if (options.name.empty()) options.name = name_for_unnamed(index);
    try {
      const ObjectId id = scene_.add(std::move(shape), std::move(options));
      ids_.push_back(id);
      if (const auto velocity = object.find("velocity")) {
        const Vec<N, double> read = read_vector<N>(*velocity, {"velocity"}, place);
        Vec<3, double>& kept = velocities_.emplace_back(ObjectVelocity{id, Vec<3, double>(0)}).velocity;
        for (Dim i = 0; i < N; ++i) kept[i] = read[i];
      }
    } catch (const std::invalid_argument& refusal) {
      throw place.error(object.offset(), refusal.what());
    }
  }

  AnyShape<N, double> read_shape(JsonValue object, const JsonPlace& place) {
    if (!is_mesh_by_file(object)) return read_json_shape<N>(object, place, object_fields);
    if constexpr (N == 3) {
      return mesh_files_.read(object, place, object_fields);
    } else {
      throw JsonFields(object, place, "a mesh")
          .error("file", "names a mesh file, which is 3D; in a 2D scene, a mesh has \"vertices\" and \"faces\"");
    }
  }

  void except(JsonValue pairs) {
    std::size_t number = 0;
    for (const JsonValue value : read_array(pairs, {"excepted_pairs"}, document_place_).items()) {
      const JsonFieldName name{"excepted_pairs", number++};
      std::vector<ObjectId> pair;
      for (const JsonValue object : read_array(value, name, document_place_).items()) {
        pair.push_back(object_called(object, name));
      }
      if (pair.size() != 2 || pair[0] == pair[1]) {
        throw document_place_.error(
            value.offset(), fmt::format("\"{}\"[{}] must name two different objects", name.name, *name.element));
      }
      scene_.except(pair[0], pair[1]);
    }
  }

  /// An object by its name or by its number in the file.
  ObjectId object_called(JsonValue value, const JsonFieldName& name) const {
    if (value.kind() != JsonKind::text) {
      const std::uint64_t number = read_whole(value, name, document_place_);
      if (number < ids_.size()) return ids_[number];
      throw document_place_.error(value.offset(),
                                  fmt::format("there is no object {}; the scene has {}", number, ids_.size()));
    }
    const auto found = scene_.find(value.text());
    if (found) return *found;
    std::vector<std::string_view> names;
    for (const ObjectId& id : ids_) names.push_back(scene_.object(id).name);
    throw document_place_.error(value.offset(), fmt::format("there is no object {}{}", in_quotes(value.text()),
                                                            did_you_mean(value.text(), names)));
  }

  ObjectOptions read_options(JsonValue object, const JsonPlace& place) {
    ObjectOptions options;
    options.name = place.name;
    if (const auto layer = object.find("layer")) {
      options.layer = layer_number(*layer, read_text(*layer, {"layer"}, place), place);
    } else if (uses_layers_) {
      options.layer = layer_number(object, default_layer, place);
    }
    if (const auto mask = object.find("mask")) options.mask = read_mask(*mask, place);
    if (const auto fixed = object.find("fixed"); fixed && read_flag(*fixed, {"fixed"}, place)) {
      options.mobility = Mobility::fixed;
    }
    if (const auto user = object.find("user")) options.user = read_whole(*user, {"user"}, place);
    return options;
  }

  LayerMask read_mask(JsonValue value, const JsonPlace& place) {
    LayerMask mask = 0;
    std::size_t element = 0;
    for (const JsonValue name : read_array(value, {"mask"}, place).items()) {
      mask |= only_layer(layer_number(name, read_text(name, {"mask", element++}, place), place));
    }
    return mask;
  }

  /// The layer of that name; created if the file does not list its layers. `value` is the position for errors.
  Layer layer_number(JsonValue value, std::string_view name, const JsonPlace& place) {
    const std::vector<std::string>& known = scene_.layer_names();
    const bool is_object = !place.word.empty();
    if (is_object && layers_are_listed_ && name != default_layer &&
        std::find(known.begin(), known.end(), name) == known.end()) {
      const std::vector<std::string_view> names(known.begin(), known.end());
      throw place.error(value.offset(),
                        fmt::format("the layer {} is not in \"layers\"{}", in_quotes(name), did_you_mean(name, names)));
    }
    if (name.empty()) throw place.error(value.offset(), "a layer's name is empty; give a name or leave the field out");
    try {
      return scene_.layer(name);
    } catch (const std::length_error&) {
      throw place.error(value.offset(), fmt::format("the layer {} is one too many; a scene has at most {}",
                                                    in_quotes(name), max_layers));
    }
  }

  const JsonPlace& document_place_;
  JsonMeshFiles mesh_files_;
  JsonValue objects_;
  std::optional<JsonValue> excepted_pairs_;
  Scene<N, double> scene_;
  std::vector<ObjectId> ids_;  // by number in the file
  std::vector<ObjectVelocity> velocities_;
  std::unordered_map<std::string_view, std::size_t> index_by_name_;
  bool uses_layers_ = false;
  bool layers_are_listed_ = false;
};

}  // namespace

SceneFile read_json_scene(const JsonDocument& document, const std::optional<std::filesystem::path>& folder) {
  const JsonPlace place{document};
  const JsonValue root = document.root();
  if (root.kind() != JsonKind::object) {
    throw place.error(root.offset(), fmt::format("a scene is a JSON object, not {}", kind_name(root.kind())));
  }
  const JsonFields scene(root, place, "a scene");
  require_schema(scene);
  scene.allow_only(scene_fields);
  const Dim dimension = read_dimension(scene);
  const YAxis y_axis = read_y_axis(scene, dimension);
  SceneFile file{AnyScene(), document.source(), std::string(json_scene_schema), y_axis, {}};
  dimension == 2 ? ObjectReader<2>(scene, folder).read(file) : ObjectReader<3>(scene, folder).read(file);
  return file;
}

SceneFile parse_json_scene(std::string_view text, const std::string& source) {
  return read_json_scene(JsonDocument(text, source), std::nullopt);
}

}  // namespace graze::io
