// SPDX-License-Identifier: MIT
// Ray casts against the objects of a scene.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <graze/broad/index/path_filter.hpp>
#include <graze/math/vec.hpp>
#include <graze/scene/scene_query.hpp>
#include <graze/scene/scene_view.hpp>
#include <graze/scene/storage/hit_with_face.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze {
namespace {

template <Dim N, class T>
void require_ray(const Ray<N, T>& ray, T t_max) {
  if (!is_valid(ray)) throw std::invalid_argument("Scene: the ray " + std::string(defect(ray)));
  if (!(t_max >= T(0))) throw std::invalid_argument("Scene: t_max is negative or not a number");
}

template <Dim N, class T>
bool is_hit_first(const ObjectHit<N, T>& a, const ObjectHit<N, T>& b) {
  return a.hit.t != b.hit.t ? a.hit.t < b.hit.t : a.id < b.id;
}

}  // namespace

template <Dim N, class T>
std::vector<ObjectId> SceneView<N, T>::near_way(const Ray<N, T>& ray, T t_max, const SceneQuery& query) const {
  return t_max < std::numeric_limits<T>::infinity() ? near(RayUntil<N, T>{ray, t_max}, query) : near(ray, query);
}

template <Dim N, class T>
std::optional<ObjectHit<N, T>> SceneView<N, T>::ray_cast(const Ray<N, T>& ray, T t_max, const SceneQuery& query) const {
  require_ray(ray, t_max);
  std::optional<ObjectHit<N, T>> best;
  const auto try_object = [&](const ObjectId& id) {
    if (best && best->id == id) return;
    // The limit is t_max, not the best hit so far: which of two nearly equal hits is first must not depend on their
    // order here.
    const auto hit = detail::hit_with_face(in_slot(id.index).shape, ray, t_max);
    if (!hit) return;
    const ObjectHit<N, T> found{id, *hit};
    if (!best || is_hit_first(found, *best)) best = found;
  };
  // Boxes come in the order in which the ray enters them, so most are never visited.
  const detail::SlotIndex<N, T>& index = this->index();
  index.ray_cast(ray, [&](std::uint32_t slot, double t) {
    if (t > static_cast<double>(best ? best->hit.t : t_max)) return false;
    if (detail::admits(query, id_of(slot), in_slot(slot).layer)) try_object(id_of(slot));
    return true;
  });
  // Because of rounding, a ray may touch a shape although it misses the shape's box.
  for (const ObjectId& id : near_way(ray, best ? best->hit.t : t_max, query)) try_object(id);
  return best;
}

template <Dim N, class T>
std::vector<ObjectHit<N, T>> SceneView<N, T>::ray_cast_all(const Ray<N, T>& ray, T t_max,
                                                           const SceneQuery& query) const {
  require_ray(ray, t_max);
  std::vector<ObjectHit<N, T>> result;
  for (const ObjectId& id : near_way(ray, t_max, query)) {
    if (const auto hit = detail::hit_with_face(in_slot(id.index).shape, ray, t_max)) result.push_back({id, *hit});
  }
  std::sort(result.begin(), result.end(), is_hit_first<N, T>);
  return result;
}

#define GRAZE_INSTANTIATE(N, T)                                                                                    \
  template std::vector<ObjectId> SceneView<N, T>::near_way(const Ray<N, T>&, T, const SceneQuery&) const;          \
  template std::optional<ObjectHit<N, T>> SceneView<N, T>::ray_cast(const Ray<N, T>&, T, const SceneQuery&) const; \
  template std::vector<ObjectHit<N, T>> SceneView<N, T>::ray_cast_all(const Ray<N, T>&, T, const SceneQuery&) const;
GRAZE_INSTANTIATE(2, float)
GRAZE_INSTANTIATE(3, float)
GRAZE_INSTANTIATE(2, double)
GRAZE_INSTANTIATE(3, double)
#undef GRAZE_INSTANTIATE

}  // namespace graze
