// SPDX-License-Identifier: MIT
#include <cstddef>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <graze/io/in_quotes.hpp>
#include <graze/io/tiled.hpp>
#include <graze/io/tiled_files.hpp>
#include <graze/io/tiled_json.hpp>
#include <graze/io/tiled_model.hpp>
#include <graze/io/tiled_shapes.hpp>
#include <graze/io/tiled_xml.hpp>
#include <graze/io/utf8.hpp>

namespace graze::io {
namespace {

/// An object with what the layers around it add.
struct PlacedObject {
  TiledResolvedObject resolved;
  std::string layer;
  Vec<2, double> shift = {0.0, 0.0};
};

/// Collects the objects of layers, groups opened, in drawing order.
class ObjectCollector {
 public:
  ObjectCollector(TiledFiles& files, const TiledScope& scope) : files_(files), scope_(scope) {}

  /// `path` and `shift` are those of the groups around the layers.
  void collect(const std::vector<TiledLayer>& layers, const std::string& path, const Vec<2, double>& shift) {
    for (const TiledLayer& layer : layers) {
      const std::string name = path + (layer.name.empty() ? "unnamed" : layer.name);
      const Vec<2, double> sum = shift + layer.shift;
      for (const TiledObject& object : layer.objects) objects_.push_back({files_.resolve(object, scope_), name, sum});
      collect(layer.layers, name + "/", sum);
    }
  }

  std::vector<PlacedObject> take() { return std::move(objects_); }

 private:
  TiledFiles& files_;
  TiledScope scope_;
  std::vector<PlacedObject> objects_;
};

/// A name for each object: its own if no other has it, else the own name, "#" and the object's id; where a broken map
/// has an id twice, "+" and a number follow.
std::vector<std::string> unique_names(const std::vector<PlacedObject>& objects) {
  std::unordered_map<std::string, std::size_t> uses;
  for (const PlacedObject& placed : objects) ++uses[placed.resolved.object.name.value_or("")];
  std::unordered_set<std::string> taken;
  for (const auto& [name, count] : uses) {
    if (count == 1) taken.insert(name);
  }
  std::unordered_map<std::string, std::size_t> repetitions;
  std::vector<std::string> names;
  for (const PlacedObject& placed : objects) {
    const TiledObject& object = placed.resolved.object;
    std::string name = object.name.value_or("");
    if (name.empty() || uses[name] > 1) {
      const std::string stem = fmt::format("{}#{}", name, object.id.value_or(0));
      name = stem;
      while (!taken.insert(name).second) name = fmt::format("{}+{}", stem, ++repetitions[stem]);
    }
    names.push_back(std::move(name));
  }
  return names;
}

/// Tiled's default for tile objects.
TiledAlignment usual_alignment(const TiledMap& map) {
  return tiled_alignment(map.orientation == "isometric" ? "bottom" : "bottomleft").value_or(TiledAlignment{});
}

void count_object_omissions(const TiledResolvedObject& resolved, std::vector<Omission>& omissions) {
  count_omission(omissions, "custom property", resolved.object.properties);
  count_omission(omissions, "object class", resolved.object.has_class ? 1 : 0);
  if (!resolved.tile) return;
  count_omission(omissions, "tile drawing offset", resolved.tile->tileset->has_drawing_offset ? 1 : 0);
  if (resolved.tile->tile != nullptr) {
    count_omission(omissions, "collision shape of a tile", resolved.tile->tile->shapes);
  }
}

/// Adds an object to the scene, or to the omissions. What the scene refuses becomes an error that names the place.
void add_object(const PlacedObject& placed, std::string name, const TiledMap& map, const TiledText& file,
                SceneFile& result) {
  const TiledObject& object = placed.resolved.object;
  auto& scene = std::get<Scene<2, double>>(result.scene);
  count_object_omissions(placed.resolved, result.omissions);
  try {
    TiledShape read = tiled_shape(placed.resolved, placed.shift, usual_alignment(map));
    if (!read.omission.empty()) count_omission(result.omissions, read.omission);
    if (!read.shape) return;
    const Layer layer = scene.layer(placed.layer);
    scene.add(*std::move(read.shape), {std::move(name), layer});
  } catch (const std::invalid_argument&) {
    fail_at(file, object.offset,
            fmt::format("{} reaches beyond the largest number there is, about 1.8e308", described(object)));
  } catch (const std::length_error&) {
    fail_at(file, object.offset,
            fmt::format("object layer {} is one too many: a scene has at most {} layers of different names",
                        in_quotes(placed.layer), max_layers));
  }
}

}  // namespace

SceneFile parse_tiled_map(std::string_view text, const std::string& source, const std::filesystem::path& folder) {
  const TiledText file{source, without_byte_order_mark(text)};
  const TiledMap map = is_tiled_xml(file.text) ? read_tiled_xml_map(file) : read_tiled_json_map(file);
  TiledFiles files;
  const std::vector<TiledTilesetUse> tilesets = files.tilesets(map.tilesets, file, folder);
  ObjectCollector collector(files, {file, folder, tilesets});
  collector.collect(map.layers, "", {0.0, 0.0});
  const std::vector<PlacedObject> objects = collector.take();

  SceneFile result{Scene<2, double>(), source, "tiled", YAxis::down, map.omissions};
  if (map.orientation != "orthogonal") {
    count_omission(result.omissions, fmt::format("{} projection of the map", map.orientation));
  }
  std::vector<std::string> names = unique_names(objects);
  for (std::size_t i = 0; i < objects.size(); ++i) add_object(objects[i], std::move(names[i]), map, file, result);
  return result;
}

}  // namespace graze::io
