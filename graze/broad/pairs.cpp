// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <graze/broad/brute_force.hpp>
#include <graze/broad/pair_search.hpp>
#include <graze/broad/pairs.hpp>

namespace graze {
namespace {

constexpr std::array methods{PairMethod::automatic, PairMethod::brute_force, PairMethod::tree};

// Below this many boxes the double loop beats building a tree.
constexpr std::size_t brute_force_limit = 32;

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
  Grown(std::span<const Aabb<N, T>> boxes, double margin) : boxes_(boxes) {
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      if (has_nan(boxes[k])) {
        throw std::invalid_argument("overlapping_pairs: box " + std::to_string(k) + " has a coordinate that is NaN");
      }
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
  static bool has_nan(const Aabb<N, T>& box) {
    for (Dim i = 0; i < N; ++i) {
      if (std::isnan(box.min[i]) || std::isnan(box.max[i])) return true;
    }
    return false;
  }

  std::span<const Aabb<N, T>> boxes_;
  std::vector<Aabb<N, T>> larger_;
};

/// Gives the pairs away before they become many. `itself`: of one set, each pair once.
template <Dim N, class T>
void visit_brute_force_pairs(std::span<const Aabb<N, T>> boxes_a, std::span<const Aabb<N, T>> boxes_b, bool itself,
                             const PairVisitor& visit) {
  constexpr std::size_t enough = 1024;
  std::vector<Pair> pairs;
  for (std::uint32_t a = 0; a < boxes_a.size(); ++a) {
    detail::add_brute_force_pairs(boxes_a[a], a, boxes_b, itself ? a + 1 : 0, pairs);
    if (pairs.size() < enough) continue;
    if (!visit(pairs)) return;
    pairs.clear();
  }
  if (!pairs.empty()) visit(pairs);
}

/// Refuses what has no answer, and chooses the method.
template <class T>
PairMethod checked_method(const PairOptions& options, std::size_t count_a, std::size_t count_b) {
  require_countable(std::max(count_a, count_b));
  require_margin<T>(options.margin);
  if (options.method != PairMethod::automatic) return options.method;
  return std::min(count_a, count_b) <= brute_force_limit ? PairMethod::brute_force : PairMethod::tree;
}

}  // namespace

std::string_view name_of(PairMethod method) {
  switch (method) {
    case PairMethod::automatic:
      return "automatic";
    case PairMethod::brute_force:
      return "brute_force";
    case PairMethod::tree:
      return "tree";
  }
  return "unknown";
}

std::optional<PairMethod> pair_method_named(std::string_view name) {
  for (const PairMethod method : methods) {
    if (name_of(method) == name) return method;
  }
  return std::nullopt;
}

std::span<const PairMethod> all_pair_methods() { return methods; }

template <Dim N, class T>
PairFinder<N, T>::PairFinder() : search_(std::make_unique<detail::PairSearch<N, T>>()) {}
template <Dim N, class T>
PairFinder<N, T>::~PairFinder() = default;
template <Dim N, class T>
PairFinder<N, T>::PairFinder(PairFinder&& other) noexcept = default;
template <Dim N, class T>
PairFinder<N, T>& PairFinder<N, T>::operator=(PairFinder&& other) noexcept = default;

template <Dim N, class T>
std::span<const Pair> PairFinder<N, T>::find(std::span<const Aabb<N, T>> boxes, const PairOptions& options) {
  search_->method = checked_method<T>(options, boxes.size(), boxes.size());
  if (search_->method == PairMethod::tree) return search_->find(boxes, nullptr, options);
  const Grown<N, T> grown(boxes, options.margin);
  return search_->keep(brute_force_pairs(grown.boxes()));
}

template <Dim N, class T>
std::span<const Pair> PairFinder<N, T>::find(std::span<const Aabb<N, T>> boxes_a, std::span<const Aabb<N, T>> boxes_b,
                                             const PairOptions& options) {
  search_->method = checked_method<T>(options, boxes_a.size(), boxes_b.size());
  if (search_->method == PairMethod::tree) return search_->find(boxes_a, &boxes_b, options);
  const Grown<N, T> grown_a(boxes_a, options.margin);
  const Grown<N, T> grown_b(boxes_b, options.margin);
  return search_->keep(brute_force_pairs(grown_a.boxes(), grown_b.boxes()));
}

template <Dim N, class T>
void PairFinder<N, T>::visit(std::span<const Aabb<N, T>> boxes, const PairVisitor& visitor,
                             const PairOptions& options) {
  search_->method = checked_method<T>(options, boxes.size(), boxes.size());
  if (search_->method == PairMethod::tree) return search_->visit(boxes, nullptr, options, visitor);
  const Grown<N, T> grown(boxes, options.margin);
  visit_brute_force_pairs(grown.boxes(), grown.boxes(), true, visitor);
}

template <Dim N, class T>
void PairFinder<N, T>::visit(std::span<const Aabb<N, T>> boxes_a, std::span<const Aabb<N, T>> boxes_b,
                             const PairVisitor& visitor, const PairOptions& options) {
  search_->method = checked_method<T>(options, boxes_a.size(), boxes_b.size());
  if (search_->method == PairMethod::tree) return search_->visit(boxes_a, &boxes_b, options, visitor);
  const Grown<N, T> grown_a(boxes_a, options.margin);
  const Grown<N, T> grown_b(boxes_b, options.margin);
  visit_brute_force_pairs(grown_a.boxes(), grown_b.boxes(), false, visitor);
}

template <Dim N, class T>
PairMethod PairFinder<N, T>::method() const {
  return search_->method;
}

template <Dim N, class T>
std::size_t PairFinder<N, T>::bytes() const {
  return search_->bytes();
}

template <Dim N, class T>
std::vector<Pair> overlapping_pairs(std::span<const Aabb<N, T>> boxes, const PairOptions& options) {
  PairFinder<N, T> finder;
  const std::span<const Pair> pairs = finder.find(boxes, options);
  return {pairs.begin(), pairs.end()};
}

template <Dim N, class T>
std::vector<Pair> overlapping_pairs(std::span<const Aabb<N, T>> boxes_a, std::span<const Aabb<N, T>> boxes_b,
                                    const PairOptions& options) {
  PairFinder<N, T> finder;
  const std::span<const Pair> pairs = finder.find(boxes_a, boxes_b, options);
  return {pairs.begin(), pairs.end()};
}

template <Dim N, class T>
void visit_overlapping_pairs(std::span<const Aabb<N, T>> boxes, const PairVisitor& visit, const PairOptions& options) {
  PairFinder<N, T>().visit(boxes, visit, options);
}

template <Dim N, class T>
void visit_overlapping_pairs(std::span<const Aabb<N, T>> boxes_a, std::span<const Aabb<N, T>> boxes_b,
                             const PairVisitor& visit, const PairOptions& options) {
  PairFinder<N, T>().visit(boxes_a, boxes_b, visit, options);
}

#define GRAZE_INSTANTIATE(N, T)                                                                                     \
  template class PairFinder<N, T>;                                                                                  \
  template std::vector<Pair> overlapping_pairs<N, T>(std::span<const Aabb<N, T>>, const PairOptions&);              \
  template std::vector<Pair> overlapping_pairs<N, T>(std::span<const Aabb<N, T>>, std::span<const Aabb<N, T>>,      \
                                                     const PairOptions&);                                           \
  template void visit_overlapping_pairs<N, T>(std::span<const Aabb<N, T>>, const PairVisitor&, const PairOptions&); \
  template void visit_overlapping_pairs<N, T>(std::span<const Aabb<N, T>>, std::span<const Aabb<N, T>>,             \
                                              const PairVisitor&, const PairOptions&);

GRAZE_INSTANTIATE(2, float)
GRAZE_INSTANTIATE(3, float)
GRAZE_INSTANTIATE(2, double)
GRAZE_INSTANTIATE(3, double)

#undef GRAZE_INSTANTIATE

}  // namespace graze
