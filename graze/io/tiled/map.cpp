// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <graze/io/text/in_quotes.hpp>
#include <graze/io/text/utf8.hpp>
#include <graze/io/tiled/files.hpp>
#include <graze/io/tiled/json.hpp>
#include <graze/io/tiled/map.hpp>
#include <graze/io/tiled/model.hpp>
#include <graze/io/tiled/omissions.hpp>
#include <graze/io/tiled/projection.hpp>
#include <graze/io/tiled/shapes.hpp>
#include <graze/io/tiled/tile_layer.hpp>
#include <graze/io/tiled/xml.hpp>

namespace graze::io {
namespace {

namespace fs = std::filesystem;

/// A layer with its groups resolved: its path through them, and their total offset.
struct PlacedLayer {
  TiledLayer* layer = nullptr;
  std::string name;
  Vec<2, double> shift = {0.0, 0.0};
};

/// The object and tile layers, with groups flattened, in drawing order.
void collect(std::vector<TiledLayer>& layers, const std::string& path, const Vec<2, double>& shift,
             std::vector<PlacedLayer>& placed) {
  for (TiledLayer& layer : layers) {
    const std::string name = path + (layer.name.empty() ? "unnamed" : layer.name);
    placed.push_back({&layer, name, shift + layer.shift});
    collect(layer.layers, name + "/", shift + layer.shift, placed);
  }
}

/// A name for each object: its own if no other object has it, otherwise its own name, "#" and the object's id; if a
/// broken map has duplicate ids, "+" and a number follow.
class UniqueNames {
 public:
  explicit UniqueNames(const std::vector<std::vector<TiledResolvedObject>>& objects) {
    for (const auto& of_layer : objects) {
      for (const TiledResolvedObject& resolved : of_layer) ++uses_[resolved.object.name.value_or("")];
    }
    for (const auto& [name, count] : uses_) {
      if (count == 1) taken_.insert(name);
    }
    for (const auto& of_layer : objects) {
      for (const TiledResolvedObject& resolved : of_layer) names_.push_back(name_for(resolved.object));
    }
  }

  const std::unordered_set<std::string>& all() const { return taken_; }

  /// The name of the next object, in the given order.
  std::string next() { return std::move(names_[next_++]); }

 private:
  std::string name_for(const TiledObject& object) {
    std::string name = object.name.value_or("");
    if (!name.empty() && uses_[name] == 1) return name;
    const std::string stem = fmt::format("{}#{}", name, object.id.value_or(0));
    name = stem;
    while (!taken_.insert(name).second) name = fmt::format("{}+{}", stem, ++repetitions_[stem]);
    return name;
  }

  std::unordered_map<std::string, std::size_t> uses_;
  std::unordered_map<std::string, std::size_t> repetitions_;
  std::unordered_set<std::string> taken_;
  std::vector<std::string> names_;
  std::size_t next_ = 0;
};

/// Tiled's default for tile objects.
TiledAlignment usual_alignment(const TiledGrid& grid) {
  return tiled_alignment(grid.orientation == "isometric" ? "bottom" : "bottomleft").value_or(TiledAlignment{});
}

bool is_known_orientation(std::string_view name) {
  static constexpr std::array<std::string_view, 5> known{"orthogonal", "isometric", "staggered", "hexagonal",
                                                         "oblique"};
  return std::find(known.begin(), known.end(), name) != known.end();
}

/// Makes the scene of a map.
class MapReader {
 public:
  MapReader(TiledMap map, const TiledText& file, const fs::path& folder)
      : map_(std::move(map)),
        file_(file),
        tilesets_(files_.tilesets(map_.tilesets, file, folder)),
        scope_{file, folder, tilesets_},
        projection_(map_.grid),
        result_{Scene<2, double>(), file.name, "tiled", YAxis::down, map_.omissions} {}

  SceneFile read() {
    count_map_omissions();
    std::vector<PlacedLayer> layers;
    collect(map_.layers, "", {0.0, 0.0}, layers);
    std::vector<std::vector<TiledResolvedObject>> objects(layers.size());
    for (std::size_t i = 0; i < layers.size(); ++i) {
      for (const TiledObject& object : layers[i].layer->objects) objects[i].push_back(files_.resolve(object, scope_));
    }
    UniqueNames names(objects);
    TiledTileLayers tile_layers(tilesets_, projection_, names.all());
    for (std::size_t i = 0; i < layers.size(); ++i) {
      add_tiles(layers[i], tile_layers);
      for (const TiledResolvedObject& resolved : objects[i]) add_object(resolved, layers[i], names.next());
    }
    return std::move(result_);
  }

 private:
  TiledPlace place_of(std::size_t offset) const { return {file_, offset}; }

  Scene<2, double>& scene() { return std::get<Scene<2, double>>(result_.scene); }

  void count_map_omissions() {
    for (const TiledTilesetUse& use : tilesets_) {
      if (use.fault.empty()) continue;
      count_omission(result_.omissions, tiled_omission::missing_tileset, place_of(use.tileset->offset));
    }
    if (is_known_orientation(map_.grid.orientation)) return;
    const std::string what = fmt::format("{} projection of the map", map_.grid.orientation);
    count_omission(result_.omissions,
                   {what, Loss::precision, "graze does not support it; the map is read as orthogonal"}, place_of(0));
  }

  void count_object_omissions(const TiledResolvedObject& resolved) {
    const TiledPlace place = place_of(resolved.object.offset);
    count_omission(result_.omissions, tiled_omission::custom_property, place, resolved.object.properties);
    count_omission(result_.omissions, tiled_omission::object_class, place, resolved.object.has_class ? 1 : 0);
    if (resolved.tile && resolved.tile->tile != nullptr) {
      count_omission(result_.omissions, tiled_omission::object_collision, place, resolved.tile->tile->shapes.size());
    }
  }

  /// Adds an object to the scene, or counts it as an omission.
  void add_object(const TiledResolvedObject& resolved, const PlacedLayer& layer, std::string name) {
    count_object_omissions(resolved);
    const TiledObject& object = resolved.object;
    add_at(object.offset, described(object), layer, [&] {
      TiledShape read = tiled_shape(resolved, {projection_, layer.shift, usual_alignment(map_.grid)});
      if (!read.omission.what.empty()) count_omission(result_.omissions, read.omission, place_of(object.offset));
      if (!read.shape) return;
      const Layer number = scene().layer(layer.name);
      scene().add(*std::move(read.shape), {.name = std::move(name), .layer = number});
    });
  }

  /// Adds the shapes of a layer's tiles.
  void add_tiles(const PlacedLayer& placed, TiledTileLayers& tile_layers) {
    TiledLayer& layer = *placed.layer;
    if (layer.cells.empty()) return;
    const std::string what = fmt::format("tile layer {}", in_quotes(placed.name));
    add_at(layer.offset, what, placed, [&] {
      tile_layers.add({layer, placed.name, placed.shift, place_of(layer.offset)}, scene(), result_.omissions);
    });
  }

  /// Turns the scene's exceptions into errors that name the position.
  template <class Add>
  void add_at(std::size_t offset, const std::string& what, const PlacedLayer& layer, const Add& add) {
    try {
      add();
    } catch (const std::invalid_argument&) {
      fail_at(file_, offset,
              fmt::format("{} is too large: its coordinates exceed the largest number, about 1.8e308", what));
    } catch (const std::length_error&) {
      if (scene().layer_names().size() < max_layers) throw;
      fail_at(file_, offset,
              fmt::format("layer {} is one too many: a scene has at most {} layers of different names",
                          in_quotes(layer.name), max_layers));
    }
  }

  TiledMap map_;
  const TiledText& file_;
  TiledFiles files_;
  std::vector<TiledTilesetUse> tilesets_;
  TiledScope scope_;
  TiledProjection projection_;
  SceneFile result_;
};

}  // namespace

SceneFile parse_tiled_map(std::string_view text, const std::string& source, const fs::path& folder) {
  const TiledText file{source, without_byte_order_mark(text)};
  TiledMap map = is_tiled_xml(file.text) ? read_tiled_xml_map(file) : read_tiled_json_map(file);
  return MapReader(std::move(map), file, folder).read();
}

SceneFile read_tiled_map(const JsonDocument& document, std::string_view text, const std::string& source,
                         const fs::path& folder) {
  const TiledText file{source, text};
  return MapReader(read_tiled_json_map(file, document), file, folder).read();
}

}  // namespace graze::io
