// SPDX-License-Identifier: MIT
// The contacts between the objects of a scene.
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <graze/broad/contacts.hpp>
#include <graze/broad/executor.hpp>
#include <graze/broad/touching/pair_tasks.hpp>
#include <graze/math/vec.hpp>
#include <graze/scene/scene_view.hpp>

namespace graze {
namespace {

/// Manifolds per task.
constexpr std::size_t task_size = 256;

}  // namespace

template <Dim N, class T>
std::vector<ObjectContact<N, T>> SceneView<N, T>::contacts(const Executor& executor) const {
  const std::vector<ObjectPair> touching = pairs();
  std::vector<ObjectContact<N, T>> result(touching.size());
  detail::in_tasks(touching.size(), task_size, executor, [&](std::size_t first, std::size_t last) {
    std::array<detail::ShapesToContact<N, T>, task_size> shapes;
    for (std::size_t i = first; i < last; ++i) {
      const auto& [a, b] = touching[i];
      result[i].pair = touching[i];
      shapes[i - first] = {{&in_slot(a.index).shape, &in_slot(b.index).shape}, &result[i].manifold};
    }
    detail::contacts_of<N, T>(std::span(shapes).first(last - first));
  });
  return result;
}

template std::vector<ObjectContact<2, float>> SceneView<2, float>::contacts(const Executor&) const;
template std::vector<ObjectContact<3, float>> SceneView<3, float>::contacts(const Executor&) const;
template std::vector<ObjectContact<2, double>> SceneView<2, double>::contacts(const Executor&) const;
template std::vector<ObjectContact<3, double>> SceneView<3, double>::contacts(const Executor&) const;

}  // namespace graze
