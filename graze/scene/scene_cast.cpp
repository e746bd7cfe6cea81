// SPDX-License-Identifier: MIT
// Moving shapes against the objects of a scene.
#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <vector>

#include <graze/broad/index/swept_box.hpp>
#include <graze/math/motion.hpp>
#include <graze/math/rounding.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/shape_cast.hpp>
#include <graze/query/time_of_impact.hpp>
#include <graze/scene/scene_query.hpp>
#include <graze/scene/scene_view.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze {
namespace {

/// Of a vector or a Motion.
template <class M>
void require_finite_motion(const M& motion) {
  if (!is_finite(motion)) throw std::invalid_argument("Scene: the motion has a number that is not finite");
}

template <Dim N, class T>
bool comes_first(const ObjectImpact<N, T>& a, const ObjectImpact<N, T>& b) {
  return a.impact.t != b.impact.t ? a.impact.t < b.impact.t : a.id < b.id;
}

}  // namespace

template <Dim N, class T>
template <class Find>
std::optional<ObjectImpact<N, T>> SceneView<N, T>::first_impact(const detail::SweptBox<N>& sweep,
                                                                const SceneQuery& query, const Find& find) const {
  std::optional<ObjectImpact<N, T>> first;
  double limit = std::numeric_limits<double>::infinity();
  index().visit_swept(sweep, [&](std::uint32_t slot) {
    const Object<N, T>& object = in_slot(slot);
    const ObjectId id = id_of(slot);
    if (!detail::admits(query, id, object.layer)) return limit;
    const std::optional<Impact<N, T>> impact = find(object.shape);
    if (!impact) return limit;
    const ObjectImpact<N, T> found{id, *impact};
    if (!first || comes_first(found, *first)) first = found;
    // Times are rounded down to T: what is entered later than this comes second, and does not even tie.
    limit = static_cast<double>(next_up(first->impact.t));
    return limit;
  });
  return first;
}

template <Dim N, class T>
std::optional<ObjectImpact<N, T>> SceneView<N, T>::shape_cast(const AnyShape<N, T>& shape, const Vec<N, T>& motion,
                                                              const SceneQuery& query) const {
  detail::refuse_fault("moving shape", shape);
  require_finite_motion(motion);
  return first_impact(detail::swept_box_of(touching_bounds(shape), motion), query, [&](const AnyShape<N, T>& other) {
    return graze::shape_cast(shape, motion, other, detail::cast_options(query));
  });
}

template <Dim N, class T>
std::vector<ObjectImpact<N, T>> SceneView<N, T>::shape_cast_all(const AnyShape<N, T>& shape, const Vec<N, T>& motion,
                                                                const SceneQuery& query) const {
  detail::refuse_fault("moving shape", shape);
  require_finite_motion(motion);
  std::vector<ObjectImpact<N, T>> result;
  index().visit_swept(detail::swept_box_of(touching_bounds(shape), motion), [&](std::uint32_t slot) {
    const Object<N, T>& object = in_slot(slot);
    if (detail::admits(query, id_of(slot), object.layer)) {
      if (const auto impact = graze::shape_cast(shape, motion, object.shape, detail::cast_options(query)))
        result.push_back({id_of(slot), *impact});
    }
    return std::numeric_limits<double>::infinity();
  });
  std::sort(result.begin(), result.end(), comes_first<N, T>);
  return result;
}

template <Dim N, class T>
std::optional<ObjectImpact<N, T>> SceneView<N, T>::time_of_impact(const AnyShape<N, T>& shape,
                                                                  const Motion<N, T>& motion,
                                                                  const SceneQuery& query) const {
  detail::refuse_fault("moving shape", shape);
  require_finite_motion(motion);
  return first_impact(detail::swept_box_of(touching_bounds(shape), motion), query, [&](const AnyShape<N, T>& other) {
    return graze::time_of_impact(shape, motion, other, Motion<N, T>{});
  });
}

#define GRAZE_INSTANTIATE(N, T)                                                                                     \
  template std::optional<ObjectImpact<N, T>> SceneView<N, T>::shape_cast(const AnyShape<N, T>&, const Vec<N, T>&,   \
                                                                         const SceneQuery&) const;                  \
  template std::vector<ObjectImpact<N, T>> SceneView<N, T>::shape_cast_all(const AnyShape<N, T>&, const Vec<N, T>&, \
                                                                           const SceneQuery&) const;                \
  template std::optional<ObjectImpact<N, T>> SceneView<N, T>::time_of_impact(                                       \
      const AnyShape<N, T>&, const Motion<N, T>&, const SceneQuery&) const;
GRAZE_INSTANTIATE(2, float)
GRAZE_INSTANTIATE(3, float)
GRAZE_INSTANTIATE(2, double)
GRAZE_INSTANTIATE(3, double)
#undef GRAZE_INSTANTIATE

}  // namespace graze
