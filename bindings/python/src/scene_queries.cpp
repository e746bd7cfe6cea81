// SPDX-License-Identifier: MIT
// The queries that scenes and snapshots have in common.
#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <graze/scene/slide.hpp>

#include "contact_columns.hpp"
#include "results.hpp"
#include "scenes.hpp"

namespace graze::python {
namespace {

/// use(view) with what the object holds, which no other thread changes meanwhile, without the GIL.
template <class Use>
auto read(const HeldScene& held, const Use& use) {
  return std::visit(
      [&](const auto& scene) {
        return without_gil([&] {
          const std::shared_lock lock(*held.lock);
          return scene.visit(use);
        });
      },
      held.any);
}
template <class Use>
auto read(const HeldView& held, const Use& use) {
  return std::visit([&](const auto& snapshot) { return without_gil([&] { return use(*snapshot); }); }, held.any);
}

/// use(In<N, T>()) of the world of an object.
template <class Held, class Use>
auto in_world_of(const Held& held, const Use& use) {
  return in_world(std::visit([](const auto& any) { return world_of(any); }, held.any), use);
}

template <Dim N, class T>
const SceneView<N, T>& unrecorded(const SceneView<N, T>& view) {
  return view;
}
template <Dim N, class T>
const SceneView<N, T>& unrecorded(const io::RecordedScene<N, T>& recorded) {
  return recorded.scene();
}

/// ask(view) if the view is of this world, as it always is.
template <Dim N, class T, class Held, class Ask>
auto read_in(const Held& held, const Ask& ask) {
  using Answer = decltype(ask(std::declval<const SceneView<N, T>&>()));
  return read(held, [&]<class View>(const View& view) -> Answer {
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(unrecorded(view))>, SceneView<N, T>>) {
      return ask(view);
    } else {
      throw std::logic_error("the scene is of another world");
    }
  });
}

/// Which objects a query may find, from its arguments.
struct QueryWords {
  template <class Held>
  QueryWords(const char* function, const Held& held, const py::object& layers, const py::object& excluding,
             bool ignore_initial_touch = false) {
    const std::vector<std::string> names = read(held, [](const auto& view) { return view.layer_names(); });
    ids = PackedNumbers({function, "excluding"}, excluding).names<ObjectId>(held.owner);
    query.layers = mask_of({function, "layers"}, layers, names);
    query.except = ids;
    query.ignore_initial_touch = ignore_initial_touch;
  }
  QueryWords(const QueryWords&) = delete;
  QueryWords& operator=(const QueryWords&) = delete;

  std::vector<ObjectId> ids;
  SceneQuery query;
};

template <Dim N, class T>
const Ray<N, T>& ray_in(const char* function, const HeldShape& shape) {
  const auto* const ray = std::get_if<Ray<N, T>>(&shape_in_scene<N, T>(function, shape));
  if (ray == nullptr) throw py::type_error(fmt::format("{}: ray is {}; a Ray is needed", function, described(shape)));
  return *ray;
}

// ---- Results

template <class T>
py::object python_near(const NearObject<T>& near) {
  static ResultClass near_class("NearObject");
  return near_class(packed(near.id), near.distance);
}
template <Dim N, class T>
py::object python_hit(const ObjectHit<N, T>& hit) {
  static ResultClass hit_class("ObjectHit");
  const RayHit<N, T>& without_face = hit.hit;
  return hit_class(packed(hit.id), hit.hit.face == no_face ? python_result(without_face) : python_result(hit.hit));
}
template <Dim N, class T>
py::object python_impact(const ObjectImpact<N, T>& impact) {
  static ResultClass impact_class("ObjectImpact");
  return impact_class(packed(impact.id), python_result(impact.impact));
}
template <Dim N, class T>
py::object python_touch(const ObjectTouch<N, T>& touch) {
  static ResultClass touch_class("ObjectTouch");
  return touch_class(packed(touch.id), python_result(touch.manifold));
}
template <Dim N, class T>
py::object python_contact(const ObjectContact<N, T>& contact) {
  static ResultClass contact_class("ObjectContact");
  return contact_class(packed(contact.pair.a), packed(contact.pair.b), python_result(contact.manifold));
}
template <class T>
py::object python_near_pair(const NearPair<T>& near) {
  static ResultClass pair_class("NearPair");
  return pair_class(packed(near.pair.a), packed(near.pair.b), near.distance);
}

template <class List, class Convert>
py::list python_list(const List& list, const Convert& convert) {
  py::list converted(list.size());
  for (std::size_t i = 0; i < list.size(); ++i) converted[i] = convert(list[i]);
  return converted;
}

// ---- The methods, for a scene and for a snapshot

template <class Held>
struct Queries {
  static py::object object(const Held& held, const py::object& number) {
    static ResultClass object_class("SceneObject");
    const ObjectId id = id_of("object", number, held.owner);
    return in_world_of(held, [&]<Dim N, class T>(In<N, T>) {
      const Object<N, T> found = read_in<N, T>(held, [&](const auto& view) { return view.object(id); });
      return object_class(python_shape<N, T>(found.shape, "object"), found.name, unsigned{found.layer}, found.mask,
                          found.user, found.mobility == Mobility::fixed);
    });
  }

  static py::object find(const Held& held, const std::string& name) {
    const std::optional<ObjectId> id = read(held, [&](const auto& view) { return view.find(name); });
    return id ? py::object(py::int_(packed(*id))) : py::object(py::none());
  }

  /// False for a number that cannot be an id.
  static bool contains(const Held& held, const py::object& number) {
    const std::optional<std::uint64_t> packed_id = packed_if_possible({"contains", "id"}, number);
    if (!packed_id) return false;
    const auto id = unpacked<ObjectId>(*packed_id, held.owner);
    return read(held, [&](const auto& view) { return view.contains(id); });
  }

  static py::array ids(const Held& held) {
    return array_of_names<ObjectId>(read(held, [](const auto& view) { return view.ids(); }));
  }

  static bool excepted(const Held& held, const py::object& a, const py::object& b) {
    const ObjectId id_a = id_of("excepted", a, held.owner);
    const ObjectId id_b = id_of("excepted", b, held.owner);
    return read(held, [&](const auto& view) { return view.excepted(id_a, id_b); });
  }

  static py::array candidates(const Held& held, const py::object& margin) {
    const double grown = length_of({"candidates", "margin"}, margin);
    return array_of_name_pairs<ObjectPair>(read(held, [&](const auto& view) { return view.candidates(grown); }));
  }

  static py::array pairs(const Held& held) {
    return array_of_name_pairs<ObjectPair>(read(held, [](const auto& view) { return view.pairs(); }));
  }

  static py::list contacts(const Held& held, const py::object& threads) {
    const Threads used("contacts", threads);
    return in_world_of(held, [&]<Dim N, class T>(In<N, T>) {
      const auto found = read_in<N, T>(held, [&](const auto& view) { return view.contacts(used.executor()); });
      return python_list(found, [](const auto& contact) { return python_contact(contact); });
    });
  }

  static py::object contact_arrays(const Held& held, const py::object& threads) {
    const Threads used("contact_arrays", threads);
    return in_world_of(held, [&]<Dim N, class T>(In<N, T>) {
      return read_in<N, T>(held,
                           [&](const auto& view) {
                             ContactColumns<N, T, PackedPair> columns;
                             for (const auto& [pair, manifold] : view.contacts(used.executor())) {
                               columns.add({packed(pair.a), packed(pair.b)}, manifold);
                             }
                             return columns;
                           })
          .template to_python<std::uint64_t>();
    });
  }

  static py::list closest_pairs(const Held& held, const py::object& within) {
    const double reach = length_of({"closest_pairs", "within"}, within);
    return in_world_of(held, [&]<Dim N, class T>(In<N, T>) {
      const auto found =
          read_in<N, T>(held, [&](const auto& view) { return view.closest_pairs(static_cast<T>(reach)); });
      return python_list(found, [](const auto& near) { return python_near_pair(near); });
    });
  }

  static py::array overlapping(const Held& held, const HeldShape& region, const py::object& layers,
                               const py::object& excluding) {
    const QueryWords words("overlapping", held, layers, excluding);
    return in_world_of(held, [&]<Dim N, class T>(In<N, T>) {
      const AnyShape<N, T>& shape = shape_in_scene<N, T>("overlapping", region);
      return array_of_names<ObjectId>(
          read_in<N, T>(held, [&](const auto& view) { return view.overlapping(shape, words.query); }));
    });
  }

  static py::array cull(const Held& held, const HeldShape& region, const py::object& layers,
                        const py::object& excluding) {
    const QueryWords words("cull", held, layers, excluding);
    return in_world_of(held, [&]<Dim N, class T>(In<N, T>) {
      const AnyShape<N, T>& shape = shape_in_scene<N, T>("cull", region);
      return array_of_names<ObjectId>(
          read_in<N, T>(held, [&](const auto& view) { return view.cull(shape, words.query); }));
    });
  }

  static py::list contacts_with(const Held& held, const HeldShape& given, const py::object& layers,
                                const py::object& excluding) {
    const QueryWords words("contacts_with", held, layers, excluding);
    return in_world_of(held, [&]<Dim N, class T>(In<N, T>) {
      const AnyShape<N, T>& shape = shape_in_scene<N, T>("contacts_with", given);
      const auto found = read_in<N, T>(held, [&](const auto& view) { return view.contacts_with(shape, words.query); });
      return python_list(found, [](const auto& touch) { return python_touch(touch); });
    });
  }

  /// To a point or a shape.
  static py::list nearest(const Held& held, const py::object& from, std::size_t count, const py::object& layers,
                          const py::object& excluding) {
    const QueryWords words("nearest", held, layers, excluding);
    return in_world_of(held, [&]<Dim N, class T>(In<N, T>) {
      std::vector<NearObject<T>> found;
      if (is_boxed<HeldShape>(from)) {
        const AnyShape<N, T>& shape = shape_in_scene<N, T>("nearest", unboxed<HeldShape>(from));
        found = read_in<N, T>(held, [&](const auto& view) { return view.nearest(shape, count, words.query); });
      } else {
        const auto point = point_of<N, T>({"nearest", "point"}, from);
        found = read_in<N, T>(held, [&](const auto& view) { return view.nearest(point, count, words.query); });
      }
      return python_list(found, [](const auto& near) { return python_near(near); });
    });
  }

  static py::object ray_cast(const Held& held, const HeldShape& given, const py::object& t_max,
                             const py::object& layers, const py::object& excluding) {
    const QueryWords words("ray_cast", held, layers, excluding);
    const double latest = number_of({"ray_cast", "t_max"}, t_max);
    return in_world_of(held, [&]<Dim N, class T>(In<N, T>) -> py::object {
      const Ray<N, T>& ray = ray_in<N, T>("ray_cast", given);
      const auto hit = read_in<N, T>(
          held, [&](const auto& view) { return view.ray_cast(ray, static_cast<T>(latest), words.query); });
      return hit ? python_hit(*hit) : py::none();
    });
  }

  static py::list ray_cast_all(const Held& held, const HeldShape& given, const py::object& t_max,
                               const py::object& layers, const py::object& excluding) {
    const QueryWords words("ray_cast_all", held, layers, excluding);
    const double latest = number_of({"ray_cast_all", "t_max"}, t_max);
    return in_world_of(held, [&]<Dim N, class T>(In<N, T>) {
      const Ray<N, T>& ray = ray_in<N, T>("ray_cast_all", given);
      const auto hits = read_in<N, T>(
          held, [&](const auto& view) { return view.ray_cast_all(ray, static_cast<T>(latest), words.query); });
      return python_list(hits, [](const auto& hit) { return python_hit(hit); });
    });
  }

  static py::object shape_cast(const Held& held, const HeldShape& given, const py::object& motion,
                               const py::object& layers, const py::object& excluding, bool ignore_initial_touch) {
    const QueryWords words("shape_cast", held, layers, excluding, ignore_initial_touch);
    return in_world_of(held, [&]<Dim N, class T>(In<N, T>) -> py::object {
      const AnyShape<N, T>& shape = shape_in_scene<N, T>("shape_cast", given);
      const auto way = point_of<N, T>({"shape_cast", "motion"}, motion);
      const auto found =
          read_in<N, T>(held, [&](const auto& view) { return view.shape_cast(shape, way, words.query); });
      return found ? python_impact(*found) : py::none();
    });
  }

  static py::list shape_cast_all(const Held& held, const HeldShape& given, const py::object& motion,
                                 const py::object& layers, const py::object& excluding, bool ignore_initial_touch) {
    const QueryWords words("shape_cast_all", held, layers, excluding, ignore_initial_touch);
    return in_world_of(held, [&]<Dim N, class T>(In<N, T>) {
      const AnyShape<N, T>& shape = shape_in_scene<N, T>("shape_cast_all", given);
      const auto way = point_of<N, T>({"shape_cast_all", "motion"}, motion);
      const auto found =
          read_in<N, T>(held, [&](const auto& view) { return view.shape_cast_all(shape, way, words.query); });
      return python_list(found, [](const auto& impact) { return python_impact(impact); });
    });
  }

  static py::object time_of_impact(const Held& held, const HeldShape& given, const py::object& motion,
                                   const py::object& layers, const py::object& excluding) {
    const QueryWords words("time_of_impact", held, layers, excluding);
    return in_world_of(held, [&]<Dim N, class T>(In<N, T>) -> py::object {
      const AnyShape<N, T>& shape = shape_in_scene<N, T>("time_of_impact", given);
      const auto way = motion_of<N, T>({"time_of_impact", "motion"}, motion);
      const auto found =
          read_in<N, T>(held, [&](const auto& view) { return view.time_of_impact(shape, way, words.query); });
      return found ? python_impact(*found) : py::none();
    });
  }

  static py::object slide_along(const Held& held, const HeldShape& given, const py::object& motion,
                                const py::object& layers, const py::object& excluding, const py::object& up,
                                double max_slope, double step_height, double clearance) {
    static ResultClass slide_class("Slide");
    const QueryWords words("slide", held, layers, excluding);
    SlideOptions options;
    options.query = words.query;
    options.max_slope = max_slope;
    options.step_height = step_height;
    options.clearance = clearance;
    return in_world_of(held, [&]<Dim N, class T>(In<N, T>) {
      if (!up.is_none()) {
        const auto direction = point_of<N, double>({"slide", "up"}, up);
        options.up = Vec<3, double>(0.0);
        for (Dim i = 0; i < N; ++i) options.up[i] = direction[i];
      }
      const AnyShape<N, T>& shape = shape_in_scene<N, T>("slide", given);
      const auto way = point_of<N, T>({"slide", "motion"}, motion);
      const Slide<N, T> found =
          read_in<N, T>(held, [&](const auto& view) { return slide<N, T>(unrecorded(view), shape, way, options); });
      return slide_class(frozen_vector<N, T>(found.motion),
                         py::tuple(python_list(found.touches, [](const auto& touch) { return python_impact(touch); })));
    });
  }

  static std::size_t size(const Held& held) {
    return read(held, [](const auto& view) { return view.size(); });
  }

  static void add_state(TypeMaker& maker) {
    maker.method("__len__", &size);
    maker.method("__contains__", &contains, py::arg("id"));
    maker.method("__repr__", [](const Held& held) {
      return in_world_of(held, [&]<Dim N, class T>(In<N, T>) {
        return fmt::format("<graze.{}: {} objects in {}D, {}>", BoxedName<Held>::name.text, size(held), N,
                           name_of_numbers(In<N, T>::world));
      });
    });
    maker.method("object", &object, py::arg("id"), "The SceneObject with this id.");
    maker.method("find", &find, py::arg("name"), "The id of the object with this name, or None.");
    maker.method("ids", &ids, "All ids, ascending: (n,) of uint64.");
    maker.method("excepted", &excepted, py::arg("a"), py::arg("b"), "Whether two objects are excepted as a pair.");
    maker.property(
        "layer_names",
        [](const Held& held) { return py::cast(read(held, [](const auto& view) { return view.layer_names(); })); },
        "The names of the layers, by number.");
    maker.property(
        "dimension", [](const Held& held) { return in_world_of(held, []<Dim N, class T>(In<N, T>) { return N; }); },
        "2 or 3");
    maker.property(
        "dtype",
        [](const Held& held) {
          return in_world_of(
              held, []<Dim N, class T>(In<N, T>) { return py::dtype(std::string(name_of_numbers(In<N, T>::world))); });
        },
        "float32 or float64");
  }

  static void add(TypeMaker& maker) {
    add_state(maker);
    const py::arg shape("shape");
    const py::arg motion("motion");
    const py::arg ray("ray");
    const py::kw_only keywords;
    const py::arg_v layers("layers", py::none(), "None");
    const py::arg_v excluding("excluding", py::tuple(), "()");
    const py::arg_v t_max("t_max", std::numeric_limits<double>::infinity(), "inf");
    const py::arg_v ignore("ignore_initial_touch", false);
    maker.method(
        "candidates", &candidates, py::arg("margin") = 0.0,
        "The pairs whose boxes overlap, or are at most `margin` apart along every axis: (n, 2) ids, ascending.");
    maker.method("pairs", &pairs, "All pairs that touch or overlap: (n, 2) ids, ascending.");
    maker.method("contacts", &contacts, keywords, py::arg("threads") = py::none(),
                 "The contact points of `pairs`: a list of ObjectContact.");
    maker.method("contact_arrays", &contact_arrays, keywords, py::arg("threads") = py::none(),
                 "The same as arrays, for scenes with many: Contacts, whose pairs are ids.");
    maker.method("closest_pairs", &closest_pairs, py::arg("within"),
                 "All pairs at most `within` apart: a list of NearPair.");
    maker.method("overlapping", &overlapping, shape, keywords, layers, excluding,
                 "The objects that touch or overlap a shape: ids, ascending.");
    maker.method("cull", &cull, shape, keywords, layers, excluding,
                 "The objects whose boxes touch or overlap a shape: cheaper, and never fewer.");
    maker.method("contacts_with", &contacts_with, shape, keywords, layers, excluding,
                 "The objects that touch a shape, and where: a list of ObjectTouch.");
    maker.method("nearest", &nearest, py::arg("point"), py::arg("count") = 1, keywords, layers, excluding,
                 "The `count` objects nearest to a point (N,) or a shape: a list of NearObject, by distance.");
    maker.method("ray_cast", &ray_cast, ray, t_max, keywords, layers, excluding,
                 "The first object that a Ray hits: an ObjectHit, or None.");
    maker.method("ray_cast_all", &ray_cast_all, ray, t_max, keywords, layers, excluding,
                 "All objects that a Ray hits: a list of ObjectHit, by t.");
    maker.method("shape_cast", &shape_cast, shape, motion, keywords, layers, excluding, ignore,
                 "The first object that a shape touches as it moves by a vector: an ObjectImpact, or None.");
    maker.method("shape_cast_all", &shape_cast_all, shape, motion, keywords, layers, excluding, ignore,
                 "All objects that a moving shape touches: a list of ObjectImpact, by t.");
    maker.method(
        "time_of_impact", &time_of_impact, shape, motion, keywords, layers, excluding,
        "The first object that a shape touches as it moves and rotates by a Motion: an ObjectImpact, or None.");
    maker.method("slide", &slide_along, shape, motion, keywords, layers, excluding, py::arg("up") = py::none(),
                 py::arg("max_slope") = SlideOptions().max_slope, py::arg("step_height") = 0.0,
                 py::arg("clearance") = SlideOptions().clearance,
                 "Moves a shape by a vector and along what is in its way: a Slide.");
  }
};

}  // namespace

void add_scene_queries(TypeMaker& scene, TypeMaker& view) {
  Queries<HeldScene>::add(scene);
  Queries<HeldView>::add(view);
}

}  // namespace graze::python
