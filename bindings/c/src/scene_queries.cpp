// SPDX-License-Identifier: MIT
// Questions to scenes and snapshots.
#include <cstddef>
#include <string>
#include <vector>

#include <graze/scene/scene_view.hpp>

#include "arrays.hpp"
#include "held_scene.hpp"
#include "rays.hpp"
#include "results.hpp"
#include "shape_in.hpp"
#include "vectors.hpp"

namespace graze::c {
namespace {

/// A query, and the ids that it leaves out.
class QueryIn {
 public:
  explicit QueryIn(const graze_query* query) {
    if (query == nullptr) return;
    require_array("query->except", query->except, query->except_count);
    except_.reserve(query->except_count);
    for (std::size_t i = 0; i < query->except_count; ++i) except_.push_back(id_in(query->except[i]));
    query_.except = except_;
    query_.layers = ~query->ignored_layers;
    query_.ignore_initial_touch = query->ignore_initial_touch;
  }
  QueryIn(const QueryIn&) = delete;
  QueryIn& operator=(const QueryIn&) = delete;

  const SceneQuery& operator*() const { return query_; }

 private:
  std::vector<ObjectId> except_;
  SceneQuery query_;
};

/// Calls ask(view, shape) for a shape in the world of the scene.
template <class Ask>
auto ask_with_shape(graze_scene scene, const char* role, const graze_shape* shape, const Ask& ask) {
  const graze_shape& given = required(role, shape);
  return on_view(scene, [&]<Dim N, class T>(const SceneView<N, T>& view) {
    require_world(role, given.world, "the scene", In<N, T>::world);
    return ask(view, *ShapeIn<N, T>(role, given));
  });
}

/// Writes what a scene has found or, if there is nothing, zeros.
template <class Result, class Found>
graze_status write_found(Result& out, const std::optional<Found>& found) {
  out = found ? c_result(*found) : Result{};
  return found ? GRAZE_OK : GRAZE_NONE;
}

}  // namespace
}  // namespace graze::c

using namespace graze;
using namespace graze::c;

// ---- Pairs of objects

graze_status graze_scene_pairs(graze_scene scene, graze_id_pair* out, size_t capacity, size_t* count) {
  return guarded(__func__, [&] {
    const Buffer<graze_id_pair> buffer(out, capacity, count);
    return on_view(scene, [&](const auto& view) { return buffer.fill(view.pairs(), found_in_c); });
  });
}

graze_status graze_scene_contacts(graze_scene scene, graze_object_contact* out, size_t capacity, size_t* count) {
  return guarded(__func__, [&] {
    const Buffer<graze_object_contact> buffer(out, capacity, count);
    return on_view(scene, [&](const auto& view) { return buffer.fill(view.contacts(), found_in_c); });
  });
}

graze_status graze_scene_closest_pairs(graze_scene scene, double within, graze_near_pair* out, size_t capacity,
                                       size_t* count) {
  return guarded(__func__, [&] {
    const Buffer<graze_near_pair> buffer(out, capacity, count);
    required_length("within", within);
    return on_view(scene, [&]<Dim N, class T>(const SceneView<N, T>& view) {
      return buffer.fill(view.closest_pairs(static_cast<T>(within)), found_in_c);
    });
  });
}

// ---- Objects by place

graze_status graze_scene_overlapping(graze_scene scene, const graze_shape* region, const graze_query* query,
                                     graze_id* out, size_t capacity, size_t* count) {
  return guarded(__func__, [&] {
    const Buffer<graze_id> buffer(out, capacity, count);
    const QueryIn asked(query);
    return ask_with_shape(scene, "region", region, [&](const auto& view, const auto& in) {
      return buffer.fill(view.overlapping(in, *asked), found_in_c);
    });
  });
}

graze_status graze_scene_contacts_with(graze_scene scene, const graze_shape* shape, const graze_query* query,
                                       graze_object_touch* out, size_t capacity, size_t* count) {
  return guarded(__func__, [&] {
    const Buffer<graze_object_touch> buffer(out, capacity, count);
    const QueryIn asked(query);
    return ask_with_shape(scene, "shape", shape, [&](const auto& view, const auto& in) {
      return buffer.fill(view.contacts_with(in, *asked), found_in_c);
    });
  });
}

graze_status graze_scene_cull(graze_scene scene, const graze_shape* region, const graze_query* query, graze_id* out,
                              size_t capacity, size_t* count) {
  return guarded(__func__, [&] {
    const Buffer<graze_id> buffer(out, capacity, count);
    const QueryIn asked(query);
    return ask_with_shape(scene, "region", region, [&](const auto& view, const auto& in) {
      return buffer.fill(view.cull(in, *asked), found_in_c);
    });
  });
}

graze_status graze_scene_nearest(graze_scene scene, const graze_shape* shape, const graze_query* query,
                                 graze_near_object* out, size_t capacity, size_t* count) {
  return guarded(__func__, [&] {
    const Buffer<graze_near_object> buffer(out, capacity, count);
    const QueryIn asked(query);
    return ask_with_shape(scene, "shape", shape, [&](const auto& view, const auto& in) {
      return buffer.fill(view.nearest(in, capacity, *asked), found_in_c);
    });
  });
}

graze_status graze_scene_ray_cast(graze_scene scene, const graze_ray* ray, const graze_ray_options* options,
                                  const graze_query* query, graze_object_hit* out) {
  return guarded(__func__, [&] {
    const graze_ray& given = required("ray", ray);
    graze_object_hit& result = required("out", out);
    const QueryIn asked(query);
    return on_view(scene, [&]<Dim N, class T>(const SceneView<N, T>& view) {
      return write_found(result, view.ray_cast(ray_in<N, T>("ray", given), limit_in<T>(options), *asked));
    });
  });
}

graze_status graze_scene_ray_cast_all(graze_scene scene, const graze_ray* ray, const graze_ray_options* options,
                                      const graze_query* query, graze_object_hit* out, size_t capacity, size_t* count) {
  return guarded(__func__, [&] {
    const graze_ray& given = required("ray", ray);
    const Buffer<graze_object_hit> buffer(out, capacity, count);
    const QueryIn asked(query);
    return on_view(scene, [&]<Dim N, class T>(const SceneView<N, T>& view) {
      const auto hits = view.ray_cast_all(ray_in<N, T>("ray", given), limit_in<T>(options), *asked);
      return buffer.fill(hits, found_in_c);
    });
  });
}

graze_status graze_scene_shape_cast(graze_scene scene, const graze_shape* shape, graze_vec motion,
                                    const graze_query* query, graze_object_impact* out) {
  return guarded(__func__, [&] {
    graze_object_impact& result = required("out", out);
    const QueryIn asked(query);
    return ask_with_shape(scene, "shape", shape,
                          [&]<Dim N, class T>(const SceneView<N, T>& view, const AnyShape<N, T>& in) {
                            return write_found(result, view.shape_cast(in, finite_in<N, T>("motion", motion), *asked));
                          });
  });
}

graze_status graze_scene_shape_cast_all(graze_scene scene, const graze_shape* shape, graze_vec motion,
                                        const graze_query* query, graze_object_impact* out, size_t capacity,
                                        size_t* count) {
  return guarded(__func__, [&] {
    const Buffer<graze_object_impact> buffer(out, capacity, count);
    const QueryIn asked(query);
    return ask_with_shape(
        scene, "shape", shape, [&]<Dim N, class T>(const SceneView<N, T>& view, const AnyShape<N, T>& in) {
          return buffer.fill(view.shape_cast_all(in, finite_in<N, T>("motion", motion), *asked), found_in_c);
        });
  });
}

graze_status graze_scene_time_of_impact(graze_scene scene, const graze_shape* shape, const graze_motion* motion,
                                        const graze_query* query, graze_object_impact* out) {
  return guarded(__func__, [&] {
    const graze_motion& given = required("motion", motion);
    graze_object_impact& result = required("out", out);
    const QueryIn asked(query);
    return ask_with_shape(
        scene, "shape", shape, [&]<Dim N, class T>(const SceneView<N, T>& view, const AnyShape<N, T>& in) {
          return write_found(result, view.time_of_impact(in, motion_in<N, T>("motion", &given), *asked));
        });
  });
}
