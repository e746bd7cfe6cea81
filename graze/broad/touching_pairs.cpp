// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <variant>

#include <graze/broad/pair_tasks.hpp>
#include <graze/broad/prefetch.hpp>
#include <graze/broad/relations.hpp>
#include <graze/broad/touch_kernels.hpp>
#include <graze/broad/touching_pairs.hpp>

namespace graze {
namespace detail {
namespace {

/// Pairs per task: enough to be worth a task, few enough for every core to have some.
constexpr std::size_t task_size = 4096;

/// Pairs of one kind that are collected before their kernel runs.
constexpr std::size_t queue_size = 4 * touch_group;

/// Up to this size all shapes may be in a core's own cache, where asking for them ahead takes more time than it saves.
constexpr std::size_t cache_size = std::size_t{1} << 21U;

/// No kernel.
constexpr std::uint8_t no_kind = 0xFF;

template <class T>
constexpr std::size_t count_of_types = std::variant_size_v<AnyShape<2, T>>;

template <class S, class Any, std::size_t... I>
constexpr std::size_t place_among(std::index_sequence<I...>) {
  return ((std::is_same_v<S, std::variant_alternative_t<I, Any>> ? I : 0) + ...);
}

/// The place of a type in AnyShape.
template <class S, class Any>
constexpr std::size_t place_of = place_among<S, Any>(std::make_index_sequence<std::variant_size_v<Any>>());

/// The kernel of two types by their places in AnyShape, the lower first.
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

/// Where the numbers of a struct begin: it holds nothing but numbers.
template <class T, class S>
const T* numbers_of(const S& shape) {
  static_assert(std::is_standard_layout_v<S> && std::is_trivially_copyable_v<S> && sizeof(S) % sizeof(T) == 0);
  return reinterpret_cast<const T*>(&shape);
}

/// Where the numbers of a sphere, box, oriented box or capsule begin: in truth at one place for all of them, so that
/// nothing is left to choose.
template <Dim N, class T>
const T* numbers_of_held(const AnyShape<N, T>& shape) {
  if (const auto* sphere = std::get_if<Sphere<N, T>>(&shape)) return numbers_of<T>(*sphere);
  if (const auto* box = std::get_if<Aabb<N, T>>(&shape)) return numbers_of<T>(*box);
  if (const auto* box = std::get_if<Obb<N, T>>(&shape)) return numbers_of<T>(*box);
  return numbers_of<T>(*std::get_if<Capsule<N, T>>(&shape));
}

/// Collects pairs by kind, and has them judged by the vector.
template <Dim N, class T>
class Judge {
 public:
  Judge(std::span<const ShapePair<N, T>> pairs, Relation* out)
      : pairs_(pairs), out_(out), kernels_(touch_kernels<N, T>()) {}

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
      const std::size_t lower = b.index() < a.index() ? 1 : 0;  // an index and no branch, which would guess wrong
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
  const TouchKernels<T>& kernels_;
  std::array<Queue, touch_kinds> queues_;
};

/// The kernel of pairs of one type.
template <Dim N, class T>
TouchListKernel<T> kernel_of(const TouchKernels<T>& kernels, std::type_identity<Sphere<N, T>>) {
  return kernels.of_spheres;
}
template <Dim N, class T>
TouchListKernel<T> kernel_of(const TouchKernels<T>& kernels, std::type_identity<Aabb<N, T>>) {
  return kernels.of_aabbs;
}
template <Dim N, class T>
TouchListKernel<T> kernel_of(const TouchKernels<T>& kernels, std::type_identity<Obb<N, T>>) {
  return kernels.of_obbs;
}
template <Dim N, class T>
TouchListKernel<T> kernel_of(const TouchKernels<T>& kernels, std::type_identity<Capsule<N, T>>) {
  return kernels.of_capsules;
}

/// Which of the pairs that a group begins with touch, one bit each.
template <class S>
std::uint32_t touching_of_group(std::span<const S> shapes, std::span<const Pair> group, const GroupVerdict& verdict) {
  std::uint32_t touching = verdict.overlapping;
  std::uint32_t open = ((1U << group.size()) - 1U) & ~(touching | verdict.apart);
  for (; open != 0; open &= open - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(open));
    if (relation(shapes[group[i].a], shapes[group[i].b]) != Relation::apart) touching |= 1U << i;
  }
  return touching;
}

/// Asks for the shapes that come second. The first ones usually are in order.
template <class S>
void fetch_shapes(std::span<const S> shapes, std::span<const Pair> pairs) {
  for (const Pair& pair : pairs) prefetch(&shapes[pair.b]);
}

/// Writes those of the pairs that touch to `out`, which has room for all, in their order. Returns how many.
template <class S>
std::size_t keep_touching(std::span<const S> shapes, std::span<const Pair> pairs, Pair* out) {
  using T = scalar_of<S>;
  const TouchListKernel<T> kernel = kernel_of(touch_kernels<dimension_of<S>, T>(), std::type_identity<S>());
  const bool is_in_cache = shapes.size_bytes() <= cache_size;
  std::array<GroupVerdict, queue_size / touch_group> verdicts;
  std::size_t kept = 0;
  const auto judge = [&](std::span<const Pair> part, const Pair* padded) {
    const std::size_t groups = (part.size() + touch_group - 1) / touch_group;
    kernel(numbers_of<T>(shapes[0]), padded, groups, verdicts.data());
    for (std::size_t first = 0; first < part.size(); first += touch_group) {
      const std::span<const Pair> group = part.subspan(first, std::min(touch_group, part.size() - first));
      const std::uint32_t touching = touching_of_group(shapes, group, verdicts[first / touch_group]);
      for (std::size_t i = 0; i < group.size(); ++i) {  // without a branch, which would guess wrong all the time
        out[kept] = group[i];
        kept += touching >> i & 1U;
      }
    }
  };
  const std::size_t whole = pairs.size() / touch_group * touch_group;
  for (std::size_t first = 0; first < whole; first += queue_size) {
    const std::span<const Pair> part = pairs.subspan(first, std::min(queue_size, whole - first));
    if (!is_in_cache)
      fetch_shapes(shapes, pairs.subspan(first + part.size(), std::min(queue_size, whole - first - part.size())));
    judge(part, part.data());
  }
  if (whole < pairs.size()) {
    const std::span<const Pair> rest = pairs.subspan(whole);
    std::array<Pair, touch_group> padded;
    padded.fill(rest[0]);
    std::copy(rest.begin(), rest.end(), padded.begin());
    judge(rest, padded.data());
  }
  return kept;
}

const Executor& executor_of(const TouchOptions& options) {
  return options.executor != nullptr ? *options.executor : default_executor();
}

/// The pairs that keep(first, last, out) leaves of each task, one after the other.
template <class Keep>
std::vector<Pair> kept_of_tasks(std::size_t count, const TouchOptions& options, const Keep& keep) {
  std::vector<Pair> kept(count);
  std::vector<std::size_t> counts((count + task_size - 1) / task_size);
  in_tasks(count, task_size, executor_of(options), [&](std::size_t first, std::size_t last) {
    counts[first / task_size] = keep(first, last, kept.data() + first);
  });
  std::size_t end = 0;
  for (std::size_t task = 0; task < counts.size(); ++task) {
    const auto first = kept.begin() + static_cast<std::ptrdiff_t>(task * task_size);
    std::copy(first, first + static_cast<std::ptrdiff_t>(counts[task]),
              kept.begin() + static_cast<std::ptrdiff_t>(end));
    end += counts[task];
  }
  kept.resize(end);
  return kept;
}

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
  detail::in_tasks(pairs.size(), detail::task_size, detail::executor_of(options),
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
  return detail::kept_of_tasks(candidates.size(), options, [&](std::size_t first, std::size_t last, Pair* out) {
    const auto both = detail::shape_pairs(shapes, candidates.subspan(first, last - first));
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
  return detail::kept_of_tasks(candidates.size(), options, [&](std::size_t first, std::size_t last, Pair* out) {
    return detail::keep_touching(shapes, candidates.subspan(first, last - first), out);
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
