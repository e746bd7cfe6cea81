// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <graze/broad/brute_force_pairs.hpp>
#include <graze/broad/pairs/box_set.hpp>
#include <graze/broad/pairs/pair_methods.hpp>
#include <graze/math/random/linear_congruential.hpp>

namespace graze::detail {
namespace {

void require_countable(std::size_t boxes) {
  if (boxes > std::numeric_limits<std::uint32_t>::max()) {
    throw std::length_error("overlapping_pairs: there are more than 2^32 - 1 boxes");
  }
}

template <class T>
void require_margin(double margin) {
  if (!(margin >= 0 && std::isfinite(static_cast<T>(margin)))) {
    throw std::invalid_argument("overlapping_pairs: the margin is " + std::to_string(margin) +
                                "; it must be zero or more, and finite");
  }
}

/// Boxes without NaN, grown by a margin.
template <Dim N, class T>
class Grown {
 public:
  Grown(std::span<const Aabb<N, T>> boxes, double margin, BoxSet set) : boxes_(boxes) {
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      if (has_nan(boxes[k])) refuse_nan(k, set);
    }
    if (margin == 0) return;
    larger_.assign(boxes.begin(), boxes.end());
    boxes_ = larger_;
    for (Aabb<N, T>& box : larger_) {
      if (!is_nothing(box)) box = {box.min - static_cast<T>(margin), box.max + static_cast<T>(margin)};
    }
  }

  std::span<const Aabb<N, T>> boxes() const { return boxes_; }

 private:
  std::span<const Aabb<N, T>> boxes_;
  std::vector<Aabb<N, T>> larger_;
};

/// Passes pairs on in batches. `itself`: of one set, each pair once.
template <Dim N, class T>
void visit_brute_force_pairs(std::span<const Aabb<N, T>> boxes_a, std::span<const Aabb<N, T>> boxes_b, bool itself,
                             const PairVisitor& visit) {
  constexpr std::size_t enough = 1024;
  std::vector<Pair> pairs;
  for (std::uint32_t a = 0; a < boxes_a.size(); ++a) {
    add_brute_force_pairs(boxes_a[a], a, boxes_b, itself ? a + 1 : 0, pairs);
    if (pairs.size() < enough) continue;
    if (!visit(pairs)) return;
    pairs.clear();
  }
  if (!pairs.empty()) visit(pairs);
}

/// Calls use(boxes_a, boxes_b, itself) with both sets grown.
template <Dim N, class T, class Use>
auto with_grown(std::span<const Aabb<N, T>> boxes_a, const std::span<const Aabb<N, T>>* boxes_b, double margin,
                const Use& use) {
  const Grown<N, T> grown_a(boxes_a, margin, boxes_b == nullptr ? BoxSet::only : BoxSet::first);
  if (boxes_b == nullptr) return use(grown_a.boxes(), grown_a.boxes(), true);
  return use(grown_a.boxes(), Grown<N, T>(*boxes_b, margin, BoxSet::second).boxes(), false);
}

/// The estimated share of all pairs that overlap when the boxes are grown by the margin, from a sample. Both boxes of
/// each pair are drawn independently: if the two sets correspond to each other (a region for each box), matching boxes
/// are not drawn more often than others, and a large box counts for one pair only. There must be at least one pair.
template <Dim N, class T>
double share_overlapping(std::span<const Aabb<N, T>> boxes_a, const std::span<const Aabb<N, T>>* boxes_b,
                         double margin) {
  const std::span<const Aabb<N, T>> others = boxes_b != nullptr ? *boxes_b : boxes_a;
  constexpr std::size_t enough_to_see_one = 32;
  const std::size_t drawn = std::clamp<std::size_t>(boxes_a.size() + others.size(), enough_to_see_one, 256);
  const auto of_both = static_cast<T>(2 * margin);
  LinearCongruential random_a(1);
  LinearCongruential random_b(2);
  std::size_t overlapping = 0;
  for (std::size_t k = 0; k < drawn; ++k) {
    if (k == enough_to_see_one && overlapping == 0) return 0;
    const std::size_t at = random_a.below(boxes_a.size());
    std::size_t other = random_b.below(boxes_b != nullptr ? others.size() : others.size() - 1);
    if (boxes_b == nullptr && other >= at) ++other;  // not with itself
    const Aabb<N, T>& a = boxes_a[at];
    const Aabb<N, T>& b = others[other];
    unsigned overlap = 1;  // branch-free, because the outcome is unpredictable
    for (Dim i = 0; i < N; ++i) {
      overlap &=
          static_cast<unsigned>(a.min[i] - of_both <= b.max[i]) & static_cast<unsigned>(b.min[i] <= a.max[i] + of_both);
    }
    overlapping += overlap;
  }
  return static_cast<double>(overlapping) / static_cast<double>(drawn);
}

/// Rejects invalid input, and chooses the method.
template <Dim N, class T>
PairMethod checked_method(const PairOptions& options, std::span<const Aabb<N, T>> boxes_a,
                          const std::span<const Aabb<N, T>>* boxes_b) {
  require_countable(std::max(boxes_a.size(), boxes_b != nullptr ? boxes_b->size() : 0));
  require_margin<T>(options.margin);
  if (options.method != PairMethod::automatic) return options.method;
  return is_for_dense<N, T>(boxes_a, boxes_b, options.margin) ? PairMethod::dense : PairMethod::tree;
}

}  // namespace

template <Dim N, class T>
bool is_for_dense(std::type_identity_t<std::span<const Aabb<N, T>>> boxes_a,
                  const std::type_identity_t<std::span<const Aabb<N, T>>>* boxes_b, double margin) {
  const auto rows = static_cast<double>(boxes_a.size());
  const auto columns = static_cast<double>(boxes_b != nullptr ? boxes_b->size() : boxes_a.size());
  const double comparisons = rows * columns / (boxes_b != nullptr ? 1 : 2);
  const double boxes = boxes_b != nullptr ? rows + columns : rows;
  // Nanoseconds, as measured on one machine. They affect only the time, not the answer.
  const double dense = 15 * rows + 0.32 * comparisons;
  const double tree = 300 + 8 * boxes;
  if (comparisons == 0 || dense <= tree) return true;  // regardless of how many overlap
  constexpr double more_per_pair_of_tree = 4.8;
  return dense <= tree + more_per_pair_of_tree * comparisons * share_overlapping<N, T>(boxes_a, boxes_b, margin);
}

template <Dim N, class T>
std::span<const Pair> PairMethods<N, T>::find(Boxes boxes_a, const Boxes* boxes_b, const PairOptions& options,
                                              PairSink& room) {
  last_ = checked_method(options, boxes_a, boxes_b);
  if (last_ == PairMethod::tree) return tree_.find(boxes_a, boxes_b, options, room);
  if (last_ == PairMethod::dense) return dense_.find(boxes_a, boxes_b, options, room);
  const std::vector<Pair> pairs =
      with_grown(boxes_a, boxes_b, options.margin, [](const Boxes& grown_a, const Boxes& grown_b, bool itself) {
        return itself ? brute_force_pairs(grown_a) : brute_force_pairs(grown_a, grown_b);
      });
  Pair* const first = room.all(pairs.size());
  std::copy(pairs.begin(), pairs.end(), first);
  return {first, pairs.size()};
}

template <Dim N, class T>
void PairMethods<N, T>::visit(Boxes boxes_a, const Boxes* boxes_b, const PairOptions& options,
                              const PairVisitor& visitor) {
  last_ = checked_method(options, boxes_a, boxes_b);
  if (last_ == PairMethod::tree) return tree_.visit(boxes_a, boxes_b, options, visitor);
  if (last_ == PairMethod::dense) return dense_.visit(boxes_a, boxes_b, options, visitor);
  with_grown(boxes_a, boxes_b, options.margin, [&](const Boxes& grown_a, const Boxes& grown_b, bool itself) {
    visit_brute_force_pairs(grown_a, grown_b, itself, visitor);
  });
}

#define GRAZE_INSTANTIATE(N, T)     \
  template class PairMethods<N, T>; \
  template bool is_for_dense<N, T>(std::span<const Aabb<N, T>>, const std::span<const Aabb<N, T>>*, double);

GRAZE_INSTANTIATE(2, float)
GRAZE_INSTANTIATE(3, float)
GRAZE_INSTANTIATE(2, double)
GRAZE_INSTANTIATE(3, double)

#undef GRAZE_INSTANTIATE

}  // namespace graze::detail
