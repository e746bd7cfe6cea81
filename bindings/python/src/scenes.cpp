// SPDX-License-Identifier: MIT
#include "scenes.hpp"

#include <algorithm>
#include <cerrno>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <graze/io/output_error.hpp>

#include "files.hpp"
#include "results.hpp"

namespace graze::python {
namespace {

/// use(scene) with the scene to itself, without the GIL.
template <class Use>
auto change(HeldScene& held, const Use& use) {
  return std::visit(
      [&](auto& scene) {
        return without_gil([&] {
          const std::scoped_lock lock(*held.lock);
          return scene.visit(use);
        });
      },
      held.any);
}

py::object new_scene(const py::object& dimension, const py::object& dtype) {
  return in_world(world_of_words("Scene", dimension, dtype),
                  []<Dim N, class T>(In<N, T>) { return python_scene<N, T>(Scene<N, T>()); });
}

/// Throws ValueError or TypeError unless the shapes are of the scene's world.
template <Dim N, class T>
void require_world(const std::string& function, const py::object& shapes) {
  const World world = world_of_shapes(function.c_str(), shapes);
  if (world == In<N, T>::world) return;
  refuse_world(function + ": the shapes are", world, described(world), "the scene", In<N, T>::world);
}

/// Locks without keeping the GIL from others meanwhile. Whoever waits for the lock has let go of the GIL.
std::unique_lock<std::shared_mutex> locked_with_gil(std::shared_mutex& mutex) {
  std::unique_lock lock(mutex, std::try_to_lock);
  if (!lock) without_gil([&lock] { lock.lock(); });
  return lock;
}

/// The properties of an object as Python gives them.
struct ObjectWords {
  std::string name;
  py::object layer;
  py::object mask;
  py::object user;
  bool fixed;
};

std::uint64_t unsigned_of(Argument argument, const py::object& value) {
  try {
    return packed_of(argument, value);
  } catch (const py::index_error&) {
    throw py::value_error(argument.text() + " is not from 0 to 2^64 - 1");
  }
}

/// Creates a layer that is named and does not exist. Called with the scene to itself.
template <class World>
ObjectOptions options_of(const char* function, World& scene, const ObjectWords& words) {
  ObjectOptions options;
  options.name = words.name;
  options.user = unsigned_of({function, "user"}, words.user);
  options.mobility = words.fixed ? Mobility::fixed : Mobility::moving;
  if (PyUnicode_Check(words.layer.ptr()) != 0) {
    options.layer = scene.layer(words.layer.cast<std::string>());
  } else {
    const std::uint64_t layer = unsigned_of({function, "layer"}, words.layer);
    if (layer >= max_layers)
      throw py::value_error(fmt::format("{}: layer is {}; there are {} layers", function, layer, max_layers));
    options.layer = static_cast<Layer>(layer);
  }
  options.mask = mask_of({function, "mask"}, words.mask, scene.layer_names());
  return options;
}

std::uint64_t add_object(HeldScene& held, const HeldShape& shape, const std::string& name, const py::object& layer,
                         const py::object& mask, const py::object& user, bool fixed) {
  const ObjectWords words{name, layer, mask, user, fixed};
  return std::visit(
      [&]<Dim N, class T>(LoggedScene<N, T>& logged) {
        const AnyShape<N, T>& any = shape_in_scene<N, T>("add", shape);
        const auto lock = locked_with_gil(*held.lock);
        const ObjectId id = logged.visit([&](auto& scene) {
          ObjectOptions options = options_of("add", scene, words);
          return without_gil_if(logged.log != nullptr, [&] { return scene.add(any, std::move(options)); });
        });
        held.owner = id.owner;
        return packed(id);
      },
      held.any);
}

py::array add_objects(HeldScene& held, const py::object& shapes, const py::object& layer, const py::object& mask,
                      bool fixed) {
  const ObjectWords words{"", layer, mask, py::int_(0), fixed};
  return std::visit(
      [&]<Dim N, class T>(LoggedScene<N, T>& logged) {
        if (is_empty_sequence(shapes)) return array_of_names<ObjectId>(std::vector<ObjectId>());
        require_world<N, T>("add_many", shapes);
        const ShapeSequence<N, T> all("add_many", shapes);
        const auto lock = locked_with_gil(*held.lock);
        const std::vector<ObjectId> ids = logged.visit([&](auto& scene) {
          const ObjectOptions options = options_of("add_many", scene, words);
          const std::span<const AnyShape<N, T>> added = all.any();
          return without_gil([&] {
            std::vector<ObjectId> result;
            for (const AnyShape<N, T>& shape : added) result.push_back(scene.add(shape, options));
            return result;
          });
        });
        if (!ids.empty()) held.owner = ids.front().owner;
        return array_of_names<ObjectId>(ids);
      },
      held.any);
}

void move_object(HeldScene& held, const py::object& number, const HeldShape& shape) {
  const ObjectId id = id_of("move", number, held.owner);
  std::visit(
      [&]<Dim N, class T>(LoggedScene<N, T>& logged) {
        const AnyShape<N, T>& any = shape_in_scene<N, T>("move", shape);
        const auto lock = locked_with_gil(*held.lock);
        logged.visit([&](auto& scene) { without_gil_if(logged.log != nullptr, [&] { scene.move(id, any); }); });
      },
      held.any);
}

template <class World, Dim N, class T>
void move_to_shapes(World& scene, std::span<const ObjectId> ids, const ShapeList<N, T>& list) {
  list.visit([&]<class S>(std::span<const S> shapes) {
    if constexpr (std::is_same_v<S, AnyShape<N, T>>) {
      std::vector<ObjectMove<N, T>> moves;
      moves.reserve(ids.size());
      for (std::size_t i = 0; i < ids.size(); ++i) moves.push_back({ids[i], shapes[i]});
      scene.move(std::span<const ObjectMove<N, T>>(moves));
    } else {
      scene.move(ids, shapes);
    }
  });
}

/// To shapes, or to boxes as rows of an array.
void move_objects(HeldScene& held, const py::object& numbers, const py::object& shapes) {
  const auto ids = PackedNumbers({"move_many", "ids"}, numbers).names<ObjectId>(held.owner);
  const auto require_count = [&](std::size_t count) {
    if (count == ids.size()) return;
    throw py::value_error(fmt::format("move_many: there are {} ids and {} shapes", ids.size(), count));
  };
  std::visit(
      [&]<Dim N, class T>(LoggedScene<N, T>& logged) {
        if (py::isinstance<py::array>(shapes)) {
          const Rows rows =
              rows_in({"move_many", "boxes"}, shapes, 2 * static_cast<std::size_t>(N), In<N, T>::world, "the scene");
          require_count(rows.count);
          without_gil([&] {
            const std::scoped_lock lock(*held.lock);
            logged.visit([&](auto& scene) { scene.move(std::span<const ObjectId>(ids), rows.as<Aabb<N, T>>()); });
          });
          return;
        }
        if (ids.empty() && is_empty_sequence(shapes)) return;
        require_world<N, T>("move_many", shapes);
        const ShapeSequence<N, T> all("move_many", shapes);
        require_count(all.list().size());
        without_gil([&] {
          const std::scoped_lock lock(*held.lock);
          logged.visit([&](auto& scene) { move_to_shapes(scene, ids, all.list()); });
        });
      },
      held.any);
}

void remove_object(HeldScene& held, const py::object& number) {
  const ObjectId id = id_of("remove", number, held.owner);
  change(held, [&](auto& scene) { scene.remove(id); });
}

void except_pair(HeldScene& held, const py::object& a, const py::object& b) {
  const ObjectId id_a = id_of("except_pair", a, held.owner);
  const ObjectId id_b = id_of("except_pair", b, held.owner);
  change(held, [&](auto& scene) { scene.except(id_a, id_b); });
}

void accept_pair(HeldScene& held, const py::object& a, const py::object& b) {
  const ObjectId id_a = id_of("accept_pair", a, held.owner);
  const ObjectId id_b = id_of("accept_pair", b, held.owner);
  change(held, [&](auto& scene) { scene.accept(id_a, id_b); });
}

unsigned layer_named(HeldScene& held, const std::string& name) {
  return change(held, [&](auto& scene) { return unsigned{scene.layer(name)}; });
}

/// The pairs of a scene's events as Python has them.
struct EventPairs {
  explicit EventPairs(const SceneEvents& events)
      : began(packed_pairs<ObjectPair>(events.began)),
        stayed(packed_pairs<ObjectPair>(events.stayed)),
        ended(packed_pairs<ObjectPair>(events.ended)) {}

  NewRows<PackedPair> began;
  NewRows<PackedPair> stayed;
  NewRows<PackedPair> ended;
};

py::object python_events(EventPairs events) {
  static ResultClass events_class("SceneEvents");
  return events_class(array_of<std::uint64_t>(std::move(events.began), 2),
                      array_of<std::uint64_t>(std::move(events.stayed), 2),
                      array_of<std::uint64_t>(std::move(events.ended), 2));
}

py::object update_scene(HeldScene& held, const py::object& threads) {
  const Threads used("update", threads);
  return python_events(change(held, [&](auto& scene) { return EventPairs(scene.update(used.executor())); }));
}

py::object events_of(HeldScene& held) {
  return python_events(std::visit(
      [&](const auto& logged) {
        return without_gil([&] {
          const std::shared_lock lock(*held.lock);
          return EventPairs(logged.scene.events());
        });
      },
      held.any));
}

py::object snapshot_of(HeldScene& held) {
  return std::visit(
      [&]<Dim N, class T>(LoggedScene<N, T>& logged) {
        Snapshot<N, T> snapshot = without_gil([&] {
          const std::scoped_lock lock(*held.lock);
          return logged.scene.snapshot();
        });
        return boxed(HeldView{std::move(snapshot), held.owner});
      },
      held.any);
}

void start_recording(HeldScene& held, const py::object& path) {
  const std::filesystem::path place = path_of(path);
  std::visit(
      [&]<Dim N, class T>(LoggedScene<N, T>& logged) {
        without_gil([&] {
          const std::scoped_lock lock(*held.lock);
          if (logged.log) throw std::logic_error("record: the scene is recorded already; call stop_recording before");
          logged.log = std::make_unique<SceneLog<N, T>>(place, logged.scene);
        });
      },
      held.any);
}

void stop_recording(HeldScene& held) {
  std::visit(
      [&](auto& logged) {
        without_gil([&] {
          const std::scoped_lock lock(*held.lock);
          const auto log = std::move(logged.log);
          if (log) log->finish();
        });
      },
      held.any);
}

}  // namespace

template <Dim N, class T>
SceneLog<N, T>::SceneLog(const std::filesystem::path& path, Scene<N, T>& scene)
    : path_(path), stream_(&start_), scene_(stream_, scene) {
  if (!file_.open(path, std::ios::out | std::ios::binary)) {
    throw io::OutputError(path.string() + ": cannot be opened: " + std::generic_category().message(errno));
  }
  stream_.rdbuf(&file_);
  stream_ << start_.str() << std::flush;
  start_.str("");
  require_written();
}

template <Dim N, class T>
void SceneLog<N, T>::finish() {
  if (!file_.close()) stream_.setstate(std::ios::failbit);
  require_written();
}

template <Dim N, class T>
void SceneLog<N, T>::require_written() const {
  if (stream_) return;
  throw io::OutputError(path_.string() +
                        ": the log cannot be written; after stop_recording() the scene goes on without it");
}

LayerMask mask_of(Argument argument, py::handle value, const std::vector<std::string>& names) {
  if (value.is_none()) return all_layers;
  if (PyLong_Check(value.ptr()) != 0) return unsigned_of(argument, py::reinterpret_borrow<py::object>(value));
  if (PySequence_Check(value.ptr()) == 0 || PyUnicode_Check(value.ptr()) != 0) {
    throw py::type_error(fmt::format("{} is a {}; None, a mask, or a sequence of names and numbers is needed",
                                     argument.text(), Py_TYPE(value.ptr())->tp_name));
  }
  LayerMask mask = 0;
  for (const py::handle layer : py::tuple(py::reinterpret_borrow<py::object>(value))) {
    std::uint64_t number = 0;
    if (PyUnicode_Check(layer.ptr()) != 0) {
      const auto word = layer.cast<std::string>();
      const auto place = std::find(names.begin(), names.end(), word);
      if (place == names.end())
        throw py::value_error(fmt::format("{} names '{}', which is no layer", argument.text(), word));
      number = static_cast<std::uint64_t>(place - names.begin());
    } else {
      number = unsigned_of(argument, py::reinterpret_borrow<py::object>(layer));
    }
    if (number >= max_layers)
      throw py::value_error(fmt::format("{} has layer {}; there are {}", argument.text(), number, max_layers));
    mask |= only_layer(static_cast<Layer>(number));
  }
  return mask;
}

template <Dim N, class T>
py::object python_scene(Scene<N, T> scene) {
  const std::vector<ObjectId> ids = scene.ids();
  return boxed(HeldScene{LoggedScene<N, T>{std::move(scene), nullptr}, ids.empty() ? 0 : ids.front().owner});
}

void add_scenes(py::module_& module) {
  TypeMaker view = TypeMaker::of<HeldView>(
      module, "graze.SceneView", "A read-only copy of a scene, from Scene.snapshot: it has the queries of a Scene.");
  view.no_constructor("a SceneView is made by Scene.snapshot");
  TypeMaker scene = TypeMaker::of<HeldScene>(module, "graze.Scene",
                                             "Scene(dimension=3, dtype=numpy.float64)\n--\n\nA world of shapes that "
                                             "are added, moved and removed. Objects have ids: "
                                             "integers that are never valid again after the object is removed.");
  scene.constructor(&new_scene, py::arg("dimension") = 3, py::arg("dtype") = py::none());
  const py::arg_v layer("layer", 0);
  const py::arg_v mask("mask", py::none(), "None");
  scene.method(
      "add", &add_object, py::arg("shape"), py::kw_only(), py::arg("name") = "", layer, mask, py::arg("user") = 0,
      py::arg("fixed") = false,
      "Adds an object and returns its id. layer: a name or a number below 64; mask: the layers that it can touch, as "
      "`layers` of queries; fixed objects are never a pair.");
  scene.method("add_many", &add_objects, py::arg("shapes"), py::kw_only(), layer, mask, py::arg("fixed") = false,
               "Adds shapes, without names, and returns their ids, (n,) of uint64.");
  scene.method("move", &move_object, py::arg("id"), py::arg("shape"), "Replaces an object's shape.");
  scene.method(
      "move_many", &move_objects, py::arg("ids"), py::arg("shapes"),
      "Replaces the shapes of many objects, or of none if one is not valid: by graze.Shapes, another sequence of "
      "shapes, or boxes, (n, 2 * N).");
  scene.method("remove", &remove_object, py::arg("id"), "Removes an object.");
  scene.method("except_pair", &except_pair, py::arg("a"), py::arg("b"),
               "From now on, the two objects are never a pair.");
  scene.method("accept_pair", &accept_pair, py::arg("a"), py::arg("b"), "Undoes except_pair.");
  scene.method("layer", &layer_named, py::arg("name"),
               "The number of the layer with this name, created if there is none.");
  scene.method("update", &update_scene, py::kw_only(), py::arg("threads") = py::none(),
               "Finds the pairs that touch now, and how they changed since the last update: SceneEvents.");
  scene.property("events", &events_of, "The events of the last update.");
  scene.method("snapshot", &snapshot_of, "A read-only copy, for readers that keep it while the scene continues.");
  scene.method(
      "record", &start_recording, py::arg("path"),
      "Writes this scene's calls and their answers from now on to a file, which it replaces: a query log "
      "(docs/query_log.md). Fails if other pairs touch than at the last update, and if a log is being written.");
  scene.method("stop_recording", &stop_recording, "Ends the log of `record`, if there is one.");
  scene.method("_repr_svg_", &svg_of, "A picture of the scene, its touching pairs highlighted.");
  scene.method(
      "_repr_html_",
      [](const py::object& self) { return py::module_::import("graze._drawing").attr("scene_html")(self); },
      "The picture, and a table of objects.");
  add_scene_queries(scene, view);
  view.finish();
  scene.finish();
}

template py::object python_scene(Scene<2, float>);
template py::object python_scene(Scene<2, double>);
template py::object python_scene(Scene<3, float>);
template py::object python_scene(Scene<3, double>);

}  // namespace graze::python
