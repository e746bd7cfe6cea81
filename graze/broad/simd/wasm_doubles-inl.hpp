// SPDX-License-Identifier: MIT
// Operations on vectors of doubles that Highway 1.0 lacks for WebAssembly only, as far as kernels use them. Included by
// lanes-inl.hpp, so it has no ordinary include guard.
#if defined(GRAZE_BROAD_SIMD_WASM_DOUBLES_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BROAD_SIMD_WASM_DOUBLES_INL_HPP
#undef GRAZE_BROAD_SIMD_WASM_DOUBLES_INL_HPP
#else
#define GRAZE_BROAD_SIMD_WASM_DOUBLES_INL_HPP
#endif

#include <cstddef>

#include <hwy/highway.h>

#if HWY_TARGET == HWY_WASM && HWY_MAJOR == 1 && HWY_MINOR == 0

HWY_BEFORE_NAMESPACE();
namespace hwy::HWY_NAMESPACE {

template <std::size_t N, HWY_IF_LE128(double, N)>
HWY_API Vec128<double, N> Set(Simd<double, N, 0>, double value) {
  return {wasm_f64x2_splat(value)};
}

template <std::size_t N>
HWY_API Vec128<double, N> PromoteTo(Simd<double, N, 0>, Vec128<float, N> v) {
  return {wasm_f64x2_promote_low_f32x4(v.raw)};
}

/// Highway's own version returns the bits of a double as an integer.
template <std::size_t N>
HWY_API double GetLane(Vec128<double, N> v) {
  return wasm_f64x2_extract_lane(v.raw, 0);
}

template <std::size_t N>
HWY_API Vec128<double, N> operator+(Vec128<double, N> a, Vec128<double, N> b) {
  return {wasm_f64x2_add(a.raw, b.raw)};
}

template <std::size_t N>
HWY_API Vec128<double, N> operator-(Vec128<double, N> a, Vec128<double, N> b) {
  return {wasm_f64x2_sub(a.raw, b.raw)};
}

template <std::size_t N>
HWY_API Vec128<double, N> operator*(Vec128<double, N> a, Vec128<double, N> b) {
  return {wasm_f64x2_mul(a.raw, b.raw)};
}

template <std::size_t N>
HWY_API Vec128<double, N> operator/(Vec128<double, N> a, Vec128<double, N> b) {
  return {wasm_f64x2_div(a.raw, b.raw)};
}

template <std::size_t N>
HWY_API Vec128<double, N> MulAdd(Vec128<double, N> a, Vec128<double, N> b, Vec128<double, N> added) {
  return a * b + added;
}

template <std::size_t N>
HWY_API Vec128<double, N> NegMulAdd(Vec128<double, N> a, Vec128<double, N> b, Vec128<double, N> from) {
  return from - a * b;
}

template <std::size_t N>
HWY_API Vec128<double, N> Abs(Vec128<double, N> v) {
  return {wasm_f64x2_abs(v.raw)};
}

template <std::size_t N>
HWY_API Vec128<double, N> Sqrt(Vec128<double, N> v) {
  return {wasm_f64x2_sqrt(v.raw)};
}

template <std::size_t N>
HWY_API Vec128<double, N> Min(Vec128<double, N> a, Vec128<double, N> b) {
  return {wasm_f64x2_min(a.raw, b.raw)};
}

template <std::size_t N>
HWY_API Vec128<double, N> Max(Vec128<double, N> a, Vec128<double, N> b) {
  return {wasm_f64x2_max(a.raw, b.raw)};
}

template <std::size_t N>
HWY_API Mask128<double, N> operator==(Vec128<double, N> a, Vec128<double, N> b) {
  return {wasm_f64x2_eq(a.raw, b.raw)};
}

template <std::size_t N>
HWY_API Mask128<double, N> operator<(Vec128<double, N> a, Vec128<double, N> b) {
  return {wasm_f64x2_lt(a.raw, b.raw)};
}

template <std::size_t N>
HWY_API Mask128<double, N> operator<=(Vec128<double, N> a, Vec128<double, N> b) {
  return {wasm_f64x2_le(a.raw, b.raw)};
}

template <std::size_t N>
HWY_API Mask128<double, N> operator>(Vec128<double, N> a, Vec128<double, N> b) {
  return {wasm_f64x2_gt(a.raw, b.raw)};
}

template <std::size_t N>
HWY_API Mask128<double, N> operator>=(Vec128<double, N> a, Vec128<double, N> b) {
  return {wasm_f64x2_ge(a.raw, b.raw)};
}

}  // namespace hwy::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
#endif
