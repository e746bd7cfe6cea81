// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::detail {

/// A box to test against many others: the same answers as boxes_overlap, without branches, for unpredictable answers. A
/// box with a NaN overlaps none.
///
/// The six numbers of a 3D box, with max negated, are compared with six limits at once. Every x86-64 processor has the
/// vector instructions; elsewhere they are compared one by one.
template <Dim N, class T>
class BoxLimits {
 public:
  using Box = Aabb<N, T>;

  explicit BoxLimits(const Box& box) {
    for (Dim i = 0; i < N; ++i) {
      limits_[i] = box.max[i];
      limits_[N + i] = -box.min[i];
    }
  }

  bool meets(const Box& box) const {
#if defined(__SSE2__)
    static_assert(sizeof(Box) == sizeof(limits_));
    return apart(&box.min[0]) == 0;
#else
    unsigned apart = 0;
    for (Dim i = 0; i < N; ++i) {
      apart |=
          static_cast<unsigned>(!(box.min[i] <= limits_[i])) | static_cast<unsigned>(!(-box.max[i] <= limits_[N + i]));
    }
    return apart == 0;
#endif
  }

 private:
#if defined(__SSE2__)
  /// Whether one of four consecutive numbers, from the k-th on, is beyond its limit.
  int apart_from(const float* box, Dim k) const {
    const auto sign = [k](Dim at) { return k + at < N ? 0.0F : -0.0F; };
    const __m128 signs = _mm_setr_ps(sign(0), sign(1), sign(2), sign(3));
    return _mm_movemask_ps(_mm_cmpnle_ps(_mm_xor_ps(_mm_loadu_ps(box + k), signs), _mm_loadu_ps(limits_ + k)));
  }

  int apart(const float* box) const {
    if constexpr (N == 2) {
      return apart_from(box, 0);
    } else {
      return apart_from(box, 0) | apart_from(box, 2);  // the middle two numbers are compared twice
    }
  }

  int apart(const double* box) const {
    __m128d beyond = _mm_setzero_pd();
    for (Dim k = 0; k < 2 * N; k += 2) {
      const __m128d signs = _mm_setr_pd(k < N ? 0.0 : -0.0, k + 1 < N ? 0.0 : -0.0);
      const __m128d numbers = _mm_xor_pd(_mm_loadu_pd(box + k), signs);
      beyond = _mm_or_pd(beyond, _mm_cmpnle_pd(numbers, _mm_loadu_pd(limits_ + k)));
    }
    return _mm_movemask_pd(beyond);
  }
#endif

  T limits_[2 * N];
};

}  // namespace graze::detail
