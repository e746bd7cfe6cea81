// SPDX-License-Identifier: MIT
// The contacts between the objects of a scene, and of a shape with them.
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <graze/broad/batch/tasks.hpp>
#include <graze/broad/contacts.hpp>
#include <graze/broad/executor.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/manifold.hpp>
#include <graze/scene/scene_query.hpp>
#include <graze/scene/scene_view.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze {
namespace {

/// Manifolds per task.
constexpr std::size_t task_size = 256;

}  // namespace

template <Dim N, class T>
std::vector<ObjectContact<N, T>> SceneView<N, T>::contacts(const Executor& executor) const {
  const std::vector<ObjectPair> touching = pairs();
  using Found = ObjectContact<N, T>;
  return detail::written_by_tasks<Found>(
      touching.size(), task_size, executor, [&](std::size_t first, std::size_t last, Found* out) {
        std::array<detail::ShapesToContact<N, T>, task_size> shapes;
        for (std::size_t i = 0; i < last - first; ++i) {
          out[i].pair = touching[first + i];
          const auto& [a, b] = out[i].pair;
          shapes[i] = {{&in_slot(a.index).shape, &in_slot(b.index).shape}, &out[i].manifold};
        }
        detail::contacts_of<N, T>(std::span(shapes).first(last - first));
      });
}

template <Dim N, class T>
std::vector<ObjectTouch<N, T>> SceneView<N, T>::contacts_with(const AnyShape<N, T>& shape,
                                                              const SceneQuery& query) const {
  detail::refuse_fault("shape", shape);
  std::vector<ObjectTouch<N, T>> result;
  for (const ObjectId& id : near(shape, query)) {
    const Manifold<N, T> found = manifold(shape, in_slot(id.index).shape);
    if (found.size > 0) result.push_back({id, found});
  }
  return result;
}

#define GRAZE_INSTANTIATE(N, T)                                                                                    \
  template std::vector<ObjectContact<N, T>> SceneView<N, T>::contacts(const Executor& executor) const;             \
  template std::vector<ObjectTouch<N, T>> SceneView<N, T>::contacts_with(const AnyShape<N, T>&, const SceneQuery&) \
      const;
GRAZE_INSTANTIATE(2, float)
GRAZE_INSTANTIATE(3, float)
GRAZE_INSTANTIATE(2, double)
GRAZE_INSTANTIATE(3, double)
#undef GRAZE_INSTANTIATE

}  // namespace graze
