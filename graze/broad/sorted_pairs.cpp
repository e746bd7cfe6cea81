// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <graze/broad/sorted_pairs.hpp>

namespace graze {
namespace detail {
namespace {

/// Finds the pairs whose first box is in a range: it searches between the range and all boxes from its first one on,
/// and drops pairs in which the range's box is the second.
template <Dim N, class T>
class RangeSearch {
 public:
  RangeSearch(std::span<const Aabb<N, T>> boxes, const PairOptions& options) : boxes_(boxes), options_(options) {
    options_.order = PairOrder::sorted;
  }

  /// The number of pairs that `find` would hold, or any number above `most` if there are more.
  std::size_t count(std::size_t first, std::size_t last, std::size_t most) {
    std::size_t count = 0;
    const auto add = [&](std::span<const Pair> pairs) {
      count += pairs.size();
      return count <= most;
    };
    if (is_all(first, last)) {
      finder_.visit(boxes_, add, options_);
    } else {
      finder_.visit(boxes_.subspan(first, last - first), boxes_.subspan(first), add, options_);
    }
    return count;
  }

  /// The pairs, sorted; valid until the next call.
  std::span<const Pair> find(std::size_t first, std::size_t last) {
    if (is_all(first, last)) return finder_.find(boxes_, options_);
    pairs_.clear();
    const auto shift = static_cast<std::uint32_t>(first);
    for (const Pair& pair : finder_.find(boxes_.subspan(first, last - first), boxes_.subspan(first), options_)) {
      if (pair.a < pair.b) pairs_.push_back({pair.a + shift, pair.b + shift});
    }
    return pairs_;
  }

 private:
  bool is_all(std::size_t first, std::size_t last) const { return first == 0 && last == boxes_.size(); }

  std::span<const Aabb<N, T>> boxes_;
  PairOptions options_;
  PairFinder<N, T> finder_;
  std::vector<Pair> pairs_;
};

}  // namespace

// Ranges are as long as their numbers of pairs permit: halved while these are too large, where counting stops at the
// limit, and doubled while they are small. A range of one box has at most as many pairs as there are boxes.
template <Dim N, class T>
void visit_sorted_pairs(std::span<const Aabb<N, T>> boxes, const PairVisitor& visit, const PairOptions& options,
                        std::size_t most) {
  most = std::max(most, 2 * boxes.size());
  RangeSearch<N, T> search(boxes, options);
  std::size_t length = boxes.size();
  std::size_t first = 0;
  do {  // once even without boxes, to validate the options
    const std::size_t last = std::min(boxes.size(), first + length);
    const std::size_t count = search.count(first, last, most);
    if (count > most) {
      length = (last - first + 1) / 2;
      continue;
    }
    const std::span<const Pair> pairs = count == 0 ? std::span<const Pair>() : search.find(first, last);
    if (!pairs.empty() && !visit(pairs)) return;
    first = last;
    if (count < most / 4) length *= 2;
  } while (first < boxes.size());
}

}  // namespace detail

template <Dim N, class T>
void visit_sorted_pairs(std::span<const Aabb<N, T>> boxes, const PairVisitor& visit, const PairOptions& options) {
  constexpr std::size_t least = std::size_t{1} << 22U;
  detail::visit_sorted_pairs(boxes, visit, options, std::max(least, 8 * boxes.size()));
}

#define GRAZE_INSTANTIATE(N, T)                                                                                       \
  template void visit_sorted_pairs<N, T>(std::span<const Aabb<N, T>>, const PairVisitor&, const PairOptions&);        \
  template void detail::visit_sorted_pairs<N, T>(std::span<const Aabb<N, T>>, const PairVisitor&, const PairOptions&, \
                                                 std::size_t);

GRAZE_INSTANTIATE(2, float)
GRAZE_INSTANTIATE(3, float)
GRAZE_INSTANTIATE(2, double)
GRAZE_INSTANTIATE(3, double)

#undef GRAZE_INSTANTIATE

}  // namespace graze
