// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <vector>

#include <graze/broad/sorted_pairs.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/scene/visit_candidates.hpp>

namespace graze {

template <class T>
PairOptions detail::candidate_options(double margin) {
  if (!(margin >= 0 && std::isfinite(margin))) {
    throw std::invalid_argument("Scene: the margin of candidates is negative or not finite");
  }
  // Each box is enlarged by half of it; touching_bounds covers the rounding of coordinates, the factor that of margins.
  return {.margin = margin * (0.5 + tolerance::convex_in<T>)};
}

template <Dim N, class T>
void visit_candidates(const SceneView<N, T>& scene, const CandidateVisitor& visit, double margin) {
  constexpr std::size_t block_size = 4096;
  const std::vector<ObjectId> ids = scene.ids();
  std::vector<Aabb<N, T>> boxes;
  boxes.reserve(ids.size());
  for (const ObjectId& id : ids) boxes.push_back(touching_bounds(scene.object(id)));
  std::vector<ObjectPair> block;
  block.reserve(block_size);
  const auto give = [&] {
    const bool goes_on = block.empty() || visit(block);
    block.clear();
    return goes_on;
  };
  const auto take = [&](std::span<const Pair> pairs) {
    for (const Pair& pair : pairs) {
      const ObjectPair candidate{ids[pair.a], ids[pair.b]};
      const bool is_admitted =
          may_touch(scene.object(candidate.a), scene.object(candidate.b)) && !scene.excepted(candidate.a, candidate.b);
      if (is_admitted) block.push_back(candidate);
      if (block.size() == block_size && !give()) return false;
    }
    return give();
  };
  visit_sorted_pairs<N, T>(boxes, take, detail::candidate_options<T>(margin));
}

#define GRAZE_INSTANTIATE(N, T) \
  template void visit_candidates<N, T>(const SceneView<N, T>&, const CandidateVisitor&, double);

GRAZE_INSTANTIATE(2, float)
GRAZE_INSTANTIATE(3, float)
GRAZE_INSTANTIATE(2, double)
GRAZE_INSTANTIATE(3, double)

#undef GRAZE_INSTANTIATE

template PairOptions detail::candidate_options<float>(double);
template PairOptions detail::candidate_options<double>(double);

}  // namespace graze
