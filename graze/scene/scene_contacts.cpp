// SPDX-License-Identifier: MIT
// Where the objects of a scene touch.
#include <algorithm>
#include <cstddef>
#include <vector>

#include <graze/broad/executor.hpp>
#include <graze/math/vec.hpp>
#include <graze/scene/manifolds.hpp>
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
  executor.parallel_for((touching.size() + task_size - 1) / task_size, [&](std::size_t task) {
    const std::size_t last = std::min(touching.size(), (task + 1) * task_size);
    for (std::size_t i = task * task_size; i < last; ++i) {
      const auto& [a, b] = touching[i];
      result[i] = {touching[i], manifold(in_slot(a.index).shape, in_slot(b.index).shape)};
    }
  });
  return result;
}

template std::vector<ObjectContact<2, float>> SceneView<2, float>::contacts(const Executor&) const;
template std::vector<ObjectContact<3, float>> SceneView<3, float>::contacts(const Executor&) const;
template std::vector<ObjectContact<2, double>> SceneView<2, double>::contacts(const Executor&) const;
template std::vector<ObjectContact<3, double>> SceneView<3, double>::contacts(const Executor&) const;

}  // namespace graze
