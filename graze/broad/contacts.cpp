// SPDX-License-Identifier: MIT
#include <cstddef>

#include <graze/broad/contacts.hpp>
#include <graze/broad/executor.hpp>
#include <graze/broad/manifolds.hpp>
#include <graze/broad/pair_tasks.hpp>

namespace graze {
namespace {

/// Manifolds per task, each a microsecond or a few. In the order of pairs: to take those of a kind together gains
/// nothing, since a manifold takes far longer than it takes to find its kind.
constexpr std::size_t manifolds_per_task = 256;

}  // namespace

template <Dim N, class T>
std::vector<PairContact<N, T>> contacts(std::span<const AnyShape<N, T>> shapes, std::span<const Pair> candidates,
                                        const TouchOptions& options) {
  detail::check_pairs(candidates, shapes.size(), "contacts");
  const std::vector<Pair> touching = touching_pairs(shapes, candidates, options);
  std::vector<PairContact<N, T>> result(touching.size());
  const Executor& executor = detail::executor_of(options);
  detail::in_tasks(touching.size(), manifolds_per_task, executor, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      result[i] = {touching[i], manifold(shapes[touching[i].a], shapes[touching[i].b])};
    }
  });
  return result;
}

#define GRAZE_INSTANTIATE(N, T)                                                                            \
  template std::vector<PairContact<N, T>> contacts(std::span<const AnyShape<N, T>>, std::span<const Pair>, \
                                                   const TouchOptions&);

GRAZE_INSTANTIATE(2, float)
GRAZE_INSTANTIATE(3, float)
GRAZE_INSTANTIATE(2, double)
GRAZE_INSTANTIATE(3, double)

#undef GRAZE_INSTANTIATE

}  // namespace graze
