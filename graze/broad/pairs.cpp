// SPDX-License-Identifier: MIT
#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include <graze/broad/pairs.hpp>
#include <graze/broad/pairs/pair_list.hpp>
#include <graze/broad/pairs/pair_methods.hpp>

namespace graze {
namespace {

constexpr std::array methods{PairMethod::automatic, PairMethod::brute_force, PairMethod::dense, PairMethod::tree};

}  // namespace

std::string_view name_of(PairMethod method) {
  switch (method) {
    case PairMethod::automatic:
      return "automatic";
    case PairMethod::brute_force:
      return "brute_force";
    case PairMethod::dense:
      return "dense";
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
struct PairFinder<N, T>::State {
  detail::PairMethods<N, T> methods;
  detail::KeptPairSink room;
  std::size_t given = 0;  // size of the last answer, which is in the memory of `methods` or `room`

  std::span<const Pair> find(std::span<const Aabb<N, T>> boxes_a, const std::span<const Aabb<N, T>>* boxes_b,
                             const PairOptions& options) {
    given = 0;
    const std::span<const Pair> pairs = methods.find(boxes_a, boxes_b, options, room);
    given = pairs.size();
    return pairs;
  }

  void visit(std::span<const Aabb<N, T>> boxes_a, const std::span<const Aabb<N, T>>* boxes_b,
             const PairOptions& options, const PairVisitor& visitor) {
    given = 0;
    methods.visit(boxes_a, boxes_b, options, visitor);
  }

  std::size_t bytes() const { return methods.bytes() + room.bytes() - given * sizeof(Pair); }
};

template <Dim N, class T>
PairFinder<N, T>::PairFinder() : state_(std::make_unique<State>()) {}
template <Dim N, class T>
PairFinder<N, T>::~PairFinder() = default;
template <Dim N, class T>
PairFinder<N, T>::PairFinder(PairFinder&& other) noexcept = default;
template <Dim N, class T>
PairFinder<N, T>& PairFinder<N, T>::operator=(PairFinder&& other) noexcept = default;

template <Dim N, class T>
std::span<const Pair> PairFinder<N, T>::find(std::span<const Aabb<N, T>> boxes, const PairOptions& options) {
  return state_->find(boxes, nullptr, options);
}

template <Dim N, class T>
std::span<const Pair> PairFinder<N, T>::find(std::span<const Aabb<N, T>> boxes_a, std::span<const Aabb<N, T>> boxes_b,
                                             const PairOptions& options) {
  return state_->find(boxes_a, &boxes_b, options);
}

template <Dim N, class T>
void PairFinder<N, T>::visit(std::span<const Aabb<N, T>> boxes, const PairVisitor& visitor,
                             const PairOptions& options) {
  state_->visit(boxes, nullptr, options, visitor);
}

template <Dim N, class T>
void PairFinder<N, T>::visit(std::span<const Aabb<N, T>> boxes_a, std::span<const Aabb<N, T>> boxes_b,
                             const PairVisitor& visitor, const PairOptions& options) {
  state_->visit(boxes_a, &boxes_b, options, visitor);
}

template <Dim N, class T>
PairMethod PairFinder<N, T>::method() const {
  return state_->methods.last();
}

template <Dim N, class T>
std::size_t PairFinder<N, T>::bytes() const {
  return state_->bytes();
}

namespace {

template <Dim N, class T>
std::vector<Pair> all_pairs(std::span<const Aabb<N, T>> boxes_a, const std::span<const Aabb<N, T>>* boxes_b,
                            const PairOptions& options) {
  detail::PairList list(detail::executor_of(options));
  detail::PairMethods<N, T> search;
  search.find(boxes_a, boxes_b, options, list);
  return list.take();
}

}  // namespace

template <Dim N, class T>
std::vector<Pair> overlapping_pairs(std::span<const Aabb<N, T>> boxes, const PairOptions& options) {
  return all_pairs<N, T>(boxes, nullptr, options);
}

template <Dim N, class T>
std::vector<Pair> overlapping_pairs(std::span<const Aabb<N, T>> boxes_a, std::span<const Aabb<N, T>> boxes_b,
                                    const PairOptions& options) {
  return all_pairs(boxes_a, &boxes_b, options);
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
