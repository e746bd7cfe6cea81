// SPDX-License-Identifier: MIT
// Compiled once per instruction set: Highway includes this file again for each.
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

#include <graze/broad/simd/choice.hpp>
#include <graze/broad/touching/touching_kernels.hpp>
#include <graze/math/tolerance.hpp>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "graze/broad/touching/touching_kernels.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#include <graze/broad/touching/boxes-inl.hpp>
#include <graze/broad/touching/lanes-inl.hpp>
#include <graze/broad/touching/round-inl.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {
namespace {

/// Calls verdict_between(a, b) for the shapes of each vector of pairs.
template <class T, class A, class B, class RowsA, class RowsB, class Verdict>
HWY_INLINE void judge_groups(RowsA a, RowsB b, std::size_t groups, GroupVerdict* verdicts,
                             const Verdict& verdict_between) {
  for (std::size_t group = 0; group < groups; ++group) {
    std::uint32_t apart = 0;
    std::uint32_t overlapping = 0;
    for (std::uint32_t k = 0; k < vectors_of<T>; ++k, a = a + lanes_of<T>, b = b + lanes_of<T>) {
      const LaneVerdict<T> verdict = verdict_between(A(a), B(b));
      apart |= bits_of<T>(verdict.apart) << k * lanes_of<T>;
      overlapping |= bits_of<T>(verdict.overlapping) << k * lanes_of<T>;
    }
    verdicts[group] = {static_cast<std::uint16_t>(apart), static_cast<std::uint16_t>(overlapping)};
  }
}

struct FullVerdict {
  template <class A, class B>
  HWY_INLINE auto operator()(const A& a, const B& b) const {
    return verdict_of(a, b);
  }
};
struct QuickVerdict {
  template <class A, class B>
  HWY_INLINE auto operator()(const A& a, const B& b) const {
    return quick_verdict_of(a, b);
  }
};

template <class T, class A, class B>
void kernel(const T* const* a, const T* const* b, std::size_t groups, GroupVerdict* verdicts) {
  judge_groups<T, A, B>(a, b, groups, verdicts, FullVerdict());
}

template <class T, class A, std::size_t Stride, class Verdict = FullVerdict>
void list_kernel(const T* shapes, const Pair* pairs, std::size_t groups, GroupVerdict* verdicts) {
  judge_groups<T, A, A>(SideOfPairs<T, Stride, &Pair::a>{shapes, pairs},
                        SideOfPairs<T, Stride, &Pair::b>{shapes, pairs}, groups, verdicts, Verdict());
}

/// Branch-free, because branches would be mispredicted: every pair is written, and the end advances conditionally.
std::size_t keep_overlapping(const Pair* pairs, const GroupVerdict* verdicts, std::size_t groups, Pair* out) {
  std::size_t kept = 0;
  for (std::size_t group = 0; group < groups; ++group, pairs += touch_group) {
    const std::uint32_t overlapping = verdicts[group].overlapping;
#if HWY_TARGET <= HWY_AVX3
    static_assert(sizeof(Pair) == sizeof(std::uint64_t));
    for (std::size_t half = 0; half < touch_group; half += touch_group / 2) {
      // Uses the intrinsic: for Highway's Compress, GCC copies a table of 2 KiB to the stack each time.
      const auto bits = static_cast<std::uint8_t>(overlapping >> half);
      const auto row = _mm512_maskz_compress_epi64(bits, _mm512_loadu_si512(pairs + half));
      _mm512_storeu_si512(out + kept, row);
      kept += static_cast<std::size_t>(std::popcount(bits));
    }
#else
    for (std::size_t i = 0; i < touch_group; ++i) {
      out[kept] = pairs[i];
      kept += overlapping >> i & 1U;
    }
#endif
  }
  return kept;
}

template <Dim N, class T>
TouchingKernels<T> kernels() {
  using Sphere = LaneSphere<N, T>;
  using Aabb = LaneAabb<N, T>;
  using Obb = LaneObb<N, T>;
  using Capsule = LaneCapsule<N, T>;
  return {{kernel<T, Sphere, Sphere>, kernel<T, Sphere, Aabb>, kernel<T, Sphere, Obb>, kernel<T, Sphere, Capsule>,
           kernel<T, Aabb, Aabb>, kernel<T, Aabb, Obb>, kernel<T, Aabb, Capsule>, kernel<T, Obb, Obb>,
           kernel<T, Obb, Capsule>, kernel<T, Capsule, Capsule>},
          list_kernel<T, Sphere, N + 1>,
          list_kernel<T, Aabb, 2 * N>,
          list_kernel<T, Obb, 2 * N + N * N, QuickVerdict>,
          list_kernel<T, Obb, 2 * N + N * N>,
          list_kernel<T, Capsule, 2 * N + 1>,
          keep_overlapping};
}

}  // namespace

const AllTouchingKernels& all_touching_kernels() {
  static_assert(touch_group == block_size && touch_kinds == 10);
  static const AllTouchingKernels all{kernels<2, float>(), kernels<3, float>(), kernels<2, double>(),
                                      kernels<3, double>()};
  return all;
}

}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graze::detail {
namespace {
HWY_EXPORT(all_touching_kernels);
}

template <Dim N, class T>
const TouchingKernels<T>& touching_kernels() {
  const AllTouchingKernels& all = HWY_DYNAMIC_DISPATCH(all_touching_kernels)();
  if constexpr (std::is_same_v<T, float>) {
    return N == 2 ? all.float_2d : all.solid_float;
  } else {
    return N == 2 ? all.double_2d : all.solid_double;
  }
}

template const TouchingKernels<float>& touching_kernels<2, float>();
template const TouchingKernels<float>& touching_kernels<3, float>();
template const TouchingKernels<double>& touching_kernels<2, double>();
template const TouchingKernels<double>& touching_kernels<3, double>();

}  // namespace graze::detail
#endif
