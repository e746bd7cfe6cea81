// SPDX-License-Identifier: MIT
// The objects of a scene near a point or a shape, and near each other.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <stdexcept>
#include <variant>
#include <vector>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/distance.hpp>
#include <graze/query/signed_distance.hpp>
#include <graze/scene/scene_query.hpp>
#include <graze/scene/scene_view.hpp>
#include <graze/scene/visit_candidates.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze {
namespace {

/// The distance of a point from a shape; 0 inside solids.
template <Dim N, class T>
T distance_from(const AnyShape<N, T>& shape, const Vec<N, T>& point) {
  const T signed_value = signed_distance(shape, point);
  return std::holds_alternative<Plane<N, T>>(shape) ? std::fabs(signed_value) : std::max(T(0), signed_value);
}

/// The nearer of a and b; of equal ones the one with the lower id.
template <class T>
bool is_nearer(const NearObject<T>& a, const NearObject<T>& b) {
  return a.distance != b.distance ? a.distance < b.distance : a.id < b.id;
}

}  // namespace

template <Dim N, class T>
template <class Measure>
std::vector<NearObject<T>> SceneView<N, T>::nearest_to(const Aabb<N, T>& from, std::size_t count,
                                                       const SceneQuery& query, const Measure& distance_to) const {
  std::vector<NearObject<T>> result;
  if (count == 0) return result;
  const detail::SlotIndex<N, T>& index = this->index();
  // Boxes come by distance, which is at most that of their objects: once the last box is farther away than the last
  // object wanted, no other object can be nearer.
  std::size_t tested = 0;
  for (std::size_t asked = 2 * std::min(count, size()) + 4;; asked *= 2) {
    const std::vector<Neighbour> boxes = index.nearest(from, std::min(asked, size()));
    for (const Neighbour& box : std::span(boxes).subspan(tested)) {  // the boxes before are those of the last time
      const std::uint32_t slot = box.key.index;
      if (!detail::admits(query, id_of(slot), in_slot(slot).layer)) continue;
      const T distance = distance_to(in_slot(slot).shape);
      if (distance < std::numeric_limits<T>::infinity()) result.push_back({id_of(slot), distance});
    }
    tested = boxes.size();
    std::sort(result.begin(), result.end(), is_nearer<T>);
    if (result.size() > count) result.resize(count);
    if (asked >= size() || tested < asked) return result;
    // Squared distances that overflow or underflow have no order: then all boxes are tested.
    const double squared = boxes.back().distance_squared;
    if (!(squared > 0x1p-960 && std::isfinite(squared))) continue;
    // Reduced by the error of a distance and rounded as distances are, so that an object at the same distance is not
    // missed.
    const T reached = static_cast<T>(std::sqrt(squared) * (1 - tolerance::gjk_relative_gap));
    if (result.size() == count && reached > result.back().distance) return result;
  }
}

template <Dim N, class T>
std::vector<NearObject<T>> SceneView<N, T>::nearest(const Vec<N, T>& point, std::size_t count,
                                                    const SceneQuery& query) const {
  if (!is_finite(point)) throw std::invalid_argument("Scene: the point has a coordinate that is not finite");
  return nearest_to({point, point}, count, query,
                    [&point](const AnyShape<N, T>& other) { return distance_from<N, T>(other, point); });
}

template <Dim N, class T>
std::vector<NearObject<T>> SceneView<N, T>::nearest(const AnyShape<N, T>& shape, std::size_t count,
                                                    const SceneQuery& query) const {
  detail::refuse_fault("shape", shape);
  const Aabb<N, T> box = touching_bounds(shape);
  if (is_nothing(box)) return {};  // infinitely far from everything
  return nearest_to(box, count, query, [&shape](const AnyShape<N, T>& other) { return distance(shape, other); });
}

template <Dim N, class T>
std::vector<NearPair<T>> SceneView<N, T>::closest_pairs(T within) const {
  if (!(within >= T(0) && std::isfinite(within))) {
    throw std::invalid_argument("Scene: the distance of closest pairs is negative or not finite");
  }
  // Farther by the error of a distance.
  const double margin =
      std::min(static_cast<double>(within) * (1 + tolerance::gjk_relative_gap), std::numeric_limits<double>::max());
  std::vector<NearPair<T>> result;
  const auto measure = [&](std::span<const ObjectPair> candidates) {
    for (const ObjectPair& pair : candidates) {
      const T found = distance(in_slot(pair.a.index).shape, in_slot(pair.b.index).shape);
      if (found <= within) result.push_back({pair, found});
    }
    return true;
  };
  visit_candidates<N, T>(*this, measure, margin);
  return result;
}

#define GRAZE_INSTANTIATE(N, T)                                                                                       \
  template std::vector<NearObject<T>> SceneView<N, T>::nearest(const Vec<N, T>&, std::size_t, const SceneQuery&)      \
      const;                                                                                                          \
  template std::vector<NearObject<T>> SceneView<N, T>::nearest(const AnyShape<N, T>&, std::size_t, const SceneQuery&) \
      const;                                                                                                          \
  template std::vector<NearPair<T>> SceneView<N, T>::closest_pairs(T) const;
GRAZE_INSTANTIATE(2, float)
GRAZE_INSTANTIATE(3, float)
GRAZE_INSTANTIATE(2, double)
GRAZE_INSTANTIATE(3, double)
#undef GRAZE_INSTANTIATE

}  // namespace graze
