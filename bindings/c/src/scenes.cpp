// SPDX-License-Identifier: MIT
// Scenes are made, changed and read.
#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <graze/io/file/utf8_path.hpp>
#include <graze/io/scene_file.hpp>
#include <graze/scene/scene.hpp>

#include "arrays.hpp"
#include "held_scene.hpp"
#include "shape_in.hpp"

namespace graze::c {

HandleTable<const HeldScene>& scenes() {
  static HandleTable<const HeldScene> table('S', "scene");
  return table;
}

namespace {

ObjectOptions options_in(const graze_object_options* options) {
  ObjectOptions result;
  if (options == nullptr) return result;
  if (options->layer >= max_layers) {
    throw Error(GRAZE_INVALID_ARGUMENT, "options->layer is " + std::to_string(options->layer) +
                                            "; layers are numbered 0 to " + std::to_string(max_layers - 1));
  }
  if (options->name != nullptr) result.name = options->name;
  result.layer = static_cast<Layer>(options->layer);
  result.mask = ~options->ignored_layers;
  result.user = options->user;
  result.mobility = options->is_fixed ? Mobility::fixed : Mobility::moving;
  return result;
}

template <Dim N, class T>
graze_object object_out(const Object<N, T>& object) {
  graze_object result{};
  result.options.name = object.name.c_str();
  result.options.user = object.user;
  result.options.ignored_layers = ~object.mask;
  result.options.layer = object.layer;
  result.options.is_fixed = object.mobility == Mobility::fixed;
  result.box = c_result(object.box);
  return result;
}

/// A valid shape in the world of a scene.
template <Dim N, class T>
ShapeIn<N, T> shape_of_scene(const char* role, const graze_shape* shape) {
  const graze_shape& given = required(role, shape);
  require_world(role, given.world, "the scene", In<N, T>::world);
  return ShapeIn<N, T>(role, given);
}

const std::vector<ObjectPair>& list_of(const SceneEvents& events, graze_event event) {
  switch (event) {
    case GRAZE_BEGAN:
      return events.began;
    case GRAZE_STAYED:
      return events.stayed;
    case GRAZE_ENDED:
      return events.ended;
    default:
      throw Error(GRAZE_INVALID_ARGUMENT, "there is no event " + std::to_string(event) +
                                              "; GRAZE_BEGAN, GRAZE_STAYED or GRAZE_ENDED is needed");
  }
}

}  // namespace
}  // namespace graze::c

using namespace graze;
using namespace graze::c;

graze_status graze_create_scene(graze_world world, graze_scene* out) {
  return guarded(__func__, [&] {
    graze_scene& result = required("out", out);
    result = in_world(world, []<Dim N, class T>(In<N, T>) { return scene_out(Scene<N, T>()); });
  });
}

graze_status graze_read_scene(const char* path, graze_scene* out) {
  return guarded(__func__, [&] {
    const std::string name = &required("path", path);
    graze_scene& result = required("out", out);
    io::SceneFile file = io::read_scene(io::path_from_utf8(name));
    result = std::visit([](auto& scene) { return scene_out(std::move(scene)); }, file.scene);
  });
}

graze_status graze_scene_snapshot(graze_scene scene, graze_scene* out) {
  return guarded(__func__, [&] {
    graze_scene& result = required("out", out);
    const auto held = scenes().find(scene.handle);
    const auto copy = std::visit(
        [](const auto& of_world) {
          auto snapshot = of_world;
          if (snapshot.scene != nullptr) snapshot.view = std::exchange(snapshot.scene, nullptr)->snapshot();
          return HeldScene{std::move(snapshot)};
        },
        held->any);
    result.handle = scenes().add(std::make_shared<const HeldScene>(copy));
  });
}

graze_status graze_destroy_scene(graze_scene scene) {
  return guarded(__func__, [&] {
    if (scene.handle != 0) scenes().end(scene.handle);
  });
}

graze_status graze_scene_add(graze_scene scene, const graze_shape* shape, const graze_object_options* options,
                             graze_id* out) {
  return guarded(__func__, [&] {
    graze_id& result = required("out", out);
    result = on_scene(scene, [&]<Dim N, class T>(Scene<N, T>& in) {
      return c_result(in.add(*shape_of_scene<N, T>("shape", shape), options_in(options)));
    });
  });
}

graze_status graze_scene_move(graze_scene scene, graze_id id, const graze_shape* shape) {
  return guarded(__func__, [&] {
    on_scene(scene,
             [&]<Dim N, class T>(Scene<N, T>& in) { in.move(id_in(id), *shape_of_scene<N, T>("shape", shape)); });
  });
}

graze_status graze_scene_move_many(graze_scene scene, const graze_id* ids, const graze_shape* shapes, size_t count) {
  return guarded(__func__, [&] {
    require_array("ids", ids, count);
    on_scene(scene, [&]<Dim N, class T>(Scene<N, T>& in) {
      std::vector<AnyShape<N, T>> all = shapes_in<N, T>("shapes", shapes, count);
      std::vector<ObjectMove<N, T>> moves;
      moves.reserve(count);
      for (std::size_t i = 0; i < count; ++i) moves.push_back({id_in(ids[i]), std::move(all[i])});
      in.move(std::span<const ObjectMove<N, T>>(moves));
    });
  });
}

graze_status graze_scene_remove(graze_scene scene, graze_id id) {
  return guarded(__func__, [&] { on_scene(scene, [&](auto& in) { in.remove(id_in(id)); }); });
}

graze_status graze_scene_except(graze_scene scene, graze_id a, graze_id b) {
  return guarded(__func__, [&] { on_scene(scene, [&](auto& in) { in.except(id_in(a), id_in(b)); }); });
}

graze_status graze_scene_accept(graze_scene scene, graze_id a, graze_id b) {
  return guarded(__func__, [&] { on_scene(scene, [&](auto& in) { in.accept(id_in(a), id_in(b)); }); });
}

graze_status graze_scene_layer(graze_scene scene, const char* name, uint32_t* out) {
  return guarded(__func__, [&] {
    const std::string text = &required("name", name);
    uint32_t& result = required("out", out);
    result = on_scene(scene, [&](auto& in) { return std::uint32_t{in.layer(text)}; });
  });
}

graze_status graze_scene_update(graze_scene scene) {
  return guarded(__func__, [&] { on_scene(scene, [](auto& in) { in.update(); }); });
}

graze_status graze_scene_events(graze_scene scene, graze_event event, graze_id_pair* out, size_t capacity,
                                size_t* count) {
  return guarded(__func__, [&] {
    const Buffer<graze_id_pair> buffer(out, capacity, count);
    return on_scene(scene, [&](auto& in) { return buffer.fill(list_of(in.events(), event), found_in_c); });
  });
}

graze_status graze_scene_world(graze_scene scene, graze_world* out) {
  return guarded(__func__, [&] {
    graze_world& result = required("out", out);
    result = static_cast<graze_world>(scenes().find(scene.handle)->any.index());
  });
}

graze_status graze_scene_size(graze_scene scene, size_t* out) {
  return guarded(__func__, [&] {
    std::size_t& result = required("out", out);
    result = on_view(scene, [](const auto& in) { return in.size(); });
  });
}

graze_status graze_scene_has(graze_scene scene, graze_id id, bool* out) {
  return guarded(__func__, [&] {
    bool& result = required("out", out);
    result = on_view(scene, [&](const auto& in) { return in.contains(id_in(id)); });
  });
}

graze_status graze_scene_ids(graze_scene scene, graze_id* out, size_t capacity, size_t* count) {
  return guarded(__func__, [&] {
    const Buffer<graze_id> buffer(out, capacity, count);
    return on_view(scene, [&](const auto& in) { return buffer.fill(in.ids(), found_in_c); });
  });
}

graze_status graze_scene_find(graze_scene scene, const char* name, graze_id* out) {
  return guarded(__func__, [&] {
    const std::string text = &required("name", name);
    graze_id& result = required("out", out);
    const auto found = on_view(scene, [&](const auto& in) { return in.find(text); });
    result = found ? c_result(*found) : graze_id{};
    return found ? GRAZE_OK : GRAZE_NONE;
  });
}

graze_status graze_scene_object(graze_scene scene, graze_id id, graze_object* out) {
  return guarded(__func__, [&] {
    graze_object& result = required("out", out);
    result = on_view(scene, [&](const auto& in) { return object_out(in.object(id_in(id))); });
  });
}

graze_status graze_scene_shape(graze_scene scene, graze_id id, graze_shape* out) {
  return guarded(__func__, [&] {
    graze_shape& result = required("out", out);
    result = on_view(
        scene, [&]<Dim N, class T>(const SceneView<N, T>& in) { return shape_out<N, T>(in.object(id_in(id)).shape); });
  });
}
