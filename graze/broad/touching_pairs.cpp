// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <variant>

#include <graze/broad/memory/prefetch.hpp>
#include <graze/broad/touching/pair_tasks.hpp>
#include <graze/broad/touching/touching_kernels.hpp>
#include <graze/broad/touching_pairs.hpp>
#include <graze/query/relation.hpp>

namespace graze {
namespace detail {
namespace {

/// Pairs per task: enough to be worth a task, few enough for every core to have some.
constexpr std::size_t pairs_in_task = 4096;

/// Pairs of one kind that are collected before their kernel runs.
constexpr std::size_t queue_size = 4 * touch_group;

/// Up to this size all shapes may be in a core's own cache, where prefetching costs more than it saves.
constexpr std::size_t cache_size = std::size_t{1} << 21U;

/// No kernel.
constexpr std::uint8_t no_kind = 0xFF;

template <class T>
constexpr std::size_t count_of_types = std::variant_size_v<AnyShape<2, T>>;

template <class S, class Any, std::size_t... I>
constexpr std::size_t place_among(std::index_sequence<I...>) {
  return ((std::is_same_v<S, std::variant_alternative_t<I, Any>> ? I : 0) + ...);
}

/// The index of a type in AnyShape.
template <class S, class Any>
constexpr std::size_t place_of = place_among<S, Any>(std::make_index_sequence<std::variant_size_v<Any>>());

/// The kernel of two types, given by their indices in AnyShape, the lower first.
template <Dim N, class T>
constexpr auto kinds_by_place() {
  using Any = AnyShape<N, T>;
  constexpr std::size_t types = count_of_types<T>;
  constexpr std::size_t sphere = place_of<Sphere<N, T>, Any>;
  constexpr std::size_t aabb = place_of<Aabb<N, T>, Any>;
  constexpr std::size_t obb = place_of<Obb<N, T>, Any>;
  constexpr std::size_t capsule = place_of<Capsule<N, T>, Any>;
  static_assert(sphere < aabb && aabb < obb && obb < capsule, "kernels take the lower place first");
  std::array<std::array<std::uint8_t, types>, types> kinds{};
  for (auto& row : kinds) row.fill(no_kind);
  const auto set = [&kinds](std::size_t a, std::size_t b, TouchKind kind) {
    kinds[a][b] = static_cast<std::uint8_t>(kind);
  };
  set(sphere, sphere, TouchKind::sphere_sphere);
  set(sphere, aabb, TouchKind::sphere_aabb);
  set(sphere, obb, TouchKind::sphere_obb);
  set(sphere, capsule, TouchKind::sphere_capsule);
  set(aabb, aabb, TouchKind::aabb_aabb);
  set(aabb, obb, TouchKind::aabb_obb);
  set(aabb, capsule, TouchKind::aabb_capsule);
  set(obb, obb, TouchKind::obb_obb);
  set(obb, capsule, TouchKind::obb_capsule);
  set(capsule, capsule, TouchKind::capsule_capsule);
  return kinds;
}

/// The address of the numbers of a struct that contains only numbers.
template <class T, class S>
const T* numbers_of(const S& shape) {
  static_assert(std::is_standard_layout_v<S> && std::is_trivially_copyable_v<S> && sizeof(S) % sizeof(T) == 0);
  return reinterpret_cast<const T*>(&shape);
}

/// The address of the numbers of a sphere, box, oriented box or capsule; it is the same for all of them, so this
/// compiles without a branch.
template <Dim N, class T>
const T* numbers_of_held(const AnyShape<N, T>& shape) {
  if (const auto* sphere = std::get_if<Sphere<N, T>>(&shape)) return numbers_of<T>(*sphere);
  if (const auto* box = std::get_if<Aabb<N, T>>(&shape)) return numbers_of<T>(*box);
  if (const auto* box = std::get_if<Obb<N, T>>(&shape)) return numbers_of<T>(*box);
  return numbers_of<T>(*std::get_if<Capsule<N, T>>(&shape));
}

/// Collects pairs by kind, and decides them with vector kernels.
template <Dim N, class T>
class Judge {
 public:
  Judge(std::span<const ShapePair<N, T>> pairs, Relation* out)
      : pairs_(pairs), out_(out), kernels_(touching_kernels<N, T>()) {}

  void run() {
    static constexpr auto kinds = kinds_by_place<N, T>();
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      const ShapePair<N, T>& later = pairs_[std::min(i + prefetch_distance, pairs_.size() - 1)];
      prefetch(later.a);
      prefetch(later.b);
      const AnyShape<N, T>& a = *pairs_[i].a;
      const AnyShape<N, T>& b = *pairs_[i].b;
      const std::uint8_t kind = kinds[std::min(a.index(), b.index())][std::max(a.index(), b.index())];
      if (kind == no_kind) {
        out_[i] = relation(a, b);
        continue;
      }
      const std::array<const T*, 2> numbers{numbers_of_held<N, T>(a), numbers_of_held<N, T>(b)};
      // an index instead of a branch, which would be mispredicted
      const std::size_t lower = b.index() < a.index() ? 1 : 0;
      add(kind, numbers[lower], numbers[1 - lower], i);
    }
    for (std::uint8_t kind = 0; kind < touch_kinds; ++kind) flush(kind);
  }

 private:
  struct Queue {
    std::array<const T*, queue_size> a;
    std::array<const T*, queue_size> b;
    std::array<std::uint32_t, queue_size> pair;
    std::size_t count = 0;
  };

  void add(std::uint8_t kind, const T* a, const T* b, std::size_t pair) {
    Queue& queue = queues_[kind];
    queue.a[queue.count] = a;
    queue.b[queue.count] = b;
    queue.pair[queue.count++] = static_cast<std::uint32_t>(pair);
    if (queue.count == queue_size) flush(kind);
  }

  void flush(std::uint8_t kind) {
    Queue& queue = queues_[kind];
    const std::size_t count = std::exchange(queue.count, 0);
    if (count == 0) return;
    const std::size_t groups = (count + touch_group - 1) / touch_group;
    for (std::size_t i = count; i < groups * touch_group; ++i) {
      queue.a[i] = queue.a[0];
      queue.b[i] = queue.b[0];
    }
    std::array<GroupVerdict, queue_size / touch_group> verdicts;
    kernels_.of[kind](queue.a.data(), queue.b.data(), groups, verdicts.data());
    for (std::size_t i = 0; i < count; ++i) {
      const GroupVerdict& verdict = verdicts[i / touch_group];
      const std::uint32_t pair = queue.pair[i];
      const bool apart = (verdict.apart >> i % touch_group & 1U) != 0;
      const bool overlapping = (verdict.overlapping >> i % touch_group & 1U) != 0;
      out_[pair] = overlapping ? Relation::overlapping : Relation::apart;
      if (!apart && !overlapping) out_[pair] = relation(*pairs_[pair].a, *pairs_[pair].b);
    }
  }

  std::span<const ShapePair<N, T>> pairs_;
  Relation* out_;
  const TouchingKernels<T>& kernels_;
  std::array<Queue, touch_kinds> queues_;
};

/// Runs the kernels for pairs of one type, one after the other.
template <class T>
struct ListKernels {
  TouchListKernel<T> of_all;
  TouchListKernel<T> of_open = nullptr;  ///< For what the first leaves open, if it can decide more.
};
template <Dim N, class T>
ListKernels<T> kernels_of(const TouchingKernels<T>& kernels, std::type_identity<Sphere<N, T>>) {
  return {kernels.of_spheres};
}
template <Dim N, class T>
ListKernels<T> kernels_of(const TouchingKernels<T>& kernels, std::type_identity<Aabb<N, T>>) {
  return {kernels.of_aabbs};
}
template <Dim N, class T>
ListKernels<T> kernels_of(const TouchingKernels<T>& kernels, std::type_identity<Obb<N, T>>) {
  return {kernels.of_obbs, kernels.of_open_obbs};
}
template <Dim N, class T>
ListKernels<T> kernels_of(const TouchingKernels<T>& kernels, std::type_identity<Capsule<N, T>>) {
  return {kernels.of_capsules};
}

/// Prefetches the second shapes. The first ones usually are in order.
template <class S>
void fetch_shapes(std::span<const S> shapes, std::span<const Pair> pairs) {
  for (const Pair& pair : pairs) prefetch(&shapes[pair.b]);
}

/// Which pairs of a task touch.
template <class S>
class TaskOfOneType {
 public:
  using T = scalar_of<S>;

  TaskOfOneType(std::span<const S> shapes, std::span<const Pair> pairs)
      : shapes_(shapes),
        pairs_(pairs),
        kernels_(touching_kernels<dimension_of<S>, T>()),
        judges_(kernels_of(kernels_, std::type_identity<S>())) {
    judge_all();
    judge_open();
  }

  /// Writes the touching pairs to `out`, which has space for all, in order. Returns their number.
  std::size_t keep_touching(Pair* out) const {
    const std::size_t groups = pairs_.size() / touch_group;
    std::size_t kept = kernels_.keep(pairs_.data(), verdicts_.data(), groups, out);
    for (std::size_t i = groups * touch_group; i < pairs_.size(); ++i) {
      if ((verdicts_[groups].overlapping >> i % touch_group & 1U) != 0) out[kept++] = pairs_[i];
    }
    return kept;
  }

 private:
  static_assert(pairs_in_task % queue_size == 0 && queue_size % touch_group == 0);

  void judge(TouchListKernel<T> kernel, const Pair* pairs, std::size_t count, GroupVerdict* verdicts) const {
    kernel(numbers_of<T>(shapes_[0]), pairs, count / touch_group, verdicts);
  }

  void judge_all() {
    const bool is_in_cache = shapes_.size_bytes() <= cache_size;
    const std::size_t whole = pairs_.size() / touch_group * touch_group;
    const std::size_t step = is_in_cache ? pairs_in_task : queue_size;
    for (std::size_t first = 0; first < whole; first += step) {
      const std::size_t next = std::min(first + step, whole);
      if (!is_in_cache) fetch_shapes(shapes_, pairs_.subspan(next, std::min(queue_size, whole - next)));
      judge(judges_.of_all, &pairs_[first], next - first, &verdicts_[first / touch_group]);
    }
    if (whole == pairs_.size()) return;
    std::array<Pair, touch_group> padded;
    padded.fill(pairs_[whole]);
    std::copy(pairs_.begin() + static_cast<std::ptrdiff_t>(whole), pairs_.end(), padded.begin());
    judge(judges_.of_all, padded.data(), touch_group, &verdicts_[whole / touch_group]);
  }

  /// Collects open pairs, and decides them by the other kernel or one by one.
  void judge_open() {
    std::array<std::uint32_t, queue_size> open;
    std::size_t count = 0;
    for (std::size_t first = 0; first < pairs_.size(); first += touch_group) {
      const GroupVerdict& verdict = verdicts_[first / touch_group];
      const std::size_t size = std::min(touch_group, pairs_.size() - first);
      std::uint32_t rest = ((1U << size) - 1U) & ~static_cast<std::uint32_t>(verdict.apart | verdict.overlapping);
      for (; rest != 0; rest &= rest - 1) {
        open[count++] = static_cast<std::uint32_t>(first) + static_cast<std::uint32_t>(std::countr_zero(rest));
        if (count == queue_size) decide(std::span(open).first(std::exchange(count, 0U)));
      }
    }
    decide(std::span(open).first(count));
  }

  void decide(std::span<const std::uint32_t> open) {
    std::array<GroupVerdict, queue_size / touch_group> verdicts{};
    if (judges_.of_open != nullptr && !open.empty()) {
      std::array<Pair, queue_size> pairs;
      pairs.fill(pairs_[open[0]]);
      for (std::size_t i = 0; i < open.size(); ++i) pairs[i] = pairs_[open[i]];
      judge(judges_.of_open, pairs.data(), (open.size() + touch_group - 1) / touch_group * touch_group,
            verdicts.data());
    }
    for (std::size_t i = 0; i < open.size(); ++i) {
      const GroupVerdict& verdict = verdicts[i / touch_group];
      const std::uint32_t bit = 1U << i % touch_group;
      const bool touches =
          (verdict.overlapping & bit) != 0 || ((verdict.apart & bit) == 0 && do_touch(pairs_[open[i]]));
      if (touches) set_touching(open[i]);
    }
  }

  bool do_touch(const Pair& pair) const { return relation(shapes_[pair.a], shapes_[pair.b]) != Relation::apart; }

  void set_touching(std::size_t i) {
    std::uint16_t& bits = verdicts_[i / touch_group].overlapping;
    bits = static_cast<std::uint16_t>(bits | 1U << i % touch_group);
  }

  std::span<const S> shapes_;
  std::span<const Pair> pairs_;
  const TouchingKernels<T>& kernels_;
  ListKernels<T> judges_;
  std::array<GroupVerdict, pairs_in_task / touch_group> verdicts_;
};

template <Dim N, class T>
std::vector<ShapePair<N, T>> shape_pairs(std::span<const AnyShape<N, T>> shapes, std::span<const Pair> pairs) {
  std::vector<ShapePair<N, T>> result(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) result[i] = {&shapes[pairs[i].a], &shapes[pairs[i].b]};
  return result;
}

}  // namespace

template <Dim N, class T>
void relations_of(std::span<const ShapePair<N, T>> pairs, Relation* out) {
  Judge<N, T>(pairs, out).run();
}

}  // namespace detail

template <Dim N, class T>
std::vector<Relation> relations(std::span<const AnyShape<N, T>> shapes, std::span<const Pair> pairs,
                                const TouchOptions& options) {
  detail::check_pairs(pairs, shapes.size(), "relations");
  std::vector<Relation> result(pairs.size());
  detail::in_tasks(pairs.size(), detail::pairs_in_task, detail::executor_of(options),
                   [&](std::size_t first, std::size_t last) {
                     const auto both = detail::shape_pairs(shapes, pairs.subspan(first, last - first));
                     detail::relations_of<N, T>(both, result.data() + first);
                   });
  return result;
}

template <Dim N, class T>
std::vector<Pair> touching_pairs(std::span<const AnyShape<N, T>> shapes, std::span<const Pair> candidates,
                                 const TouchOptions& options) {
  detail::check_pairs(candidates, shapes.size(), "touching_pairs");
  return detail::kept_of_tasks<Pair>(candidates.size(), detail::pairs_in_task, detail::executor_of(options),
                                     [&](std::size_t first, std::size_t last, Pair* out) {
                                       const auto both =
                                           detail::shape_pairs(shapes, candidates.subspan(first, last - first));
                                       std::vector<Relation> verdicts(both.size());
                                       detail::relations_of<N, T>(both, verdicts.data());
                                       Pair* end = out;
                                       for (std::size_t i = 0; i < both.size(); ++i) {
                                         if (verdicts[i] != Relation::apart) *end++ = candidates[first + i];
                                       }
                                       return static_cast<std::size_t>(end - out);
                                     });
}

template <class S>
std::vector<Pair> touching_pairs(std::span<const S> shapes, std::span<const Pair> candidates,
                                 const TouchOptions& options) {
  detail::check_pairs(candidates, shapes.size(), "touching_pairs");
  return detail::kept_of_tasks<Pair>(
      candidates.size(), detail::pairs_in_task, detail::executor_of(options),
      [&](std::size_t first, std::size_t last, Pair* out) {
        return detail::TaskOfOneType<S>(shapes, candidates.subspan(first, last - first)).keep_touching(out);
      });
}

#define GRAZE_INSTANTIATE(N, T)                                                                                       \
  template std::vector<Relation> relations(std::span<const AnyShape<N, T>>, std::span<const Pair>,                    \
                                           const TouchOptions&);                                                      \
  template std::vector<Pair> touching_pairs(std::span<const AnyShape<N, T>>, std::span<const Pair>,                   \
                                            const TouchOptions&);                                                     \
  template std::vector<Pair> touching_pairs(std::span<const Sphere<N, T>>, std::span<const Pair>,                     \
                                            const TouchOptions&);                                                     \
  template std::vector<Pair> touching_pairs(std::span<const Aabb<N, T>>, std::span<const Pair>, const TouchOptions&); \
  template std::vector<Pair> touching_pairs(std::span<const Obb<N, T>>, std::span<const Pair>, const TouchOptions&);  \
  template std::vector<Pair> touching_pairs(std::span<const Capsule<N, T>>, std::span<const Pair>,                    \
                                            const TouchOptions&);                                                     \
  template void detail::relations_of(std::span<const detail::ShapePair<N, T>>, Relation*);

GRAZE_INSTANTIATE(2, float)
GRAZE_INSTANTIATE(3, float)
GRAZE_INSTANTIATE(2, double)
GRAZE_INSTANTIATE(3, double)

#undef GRAZE_INSTANTIATE

}  // namespace graze
