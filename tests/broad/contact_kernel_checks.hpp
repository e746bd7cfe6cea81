// SPDX-License-Identifier: MIT
// Whether the manifolds that kernels write are those of single calls.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/contacts/contact_kernels.hpp>
#include <graze/query/manifold.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/shape_order.hpp>

#include "broad/same_manifolds.hpp"
#include "broad/simd_targets.hpp"
#include "catalogue.hpp"

namespace graze::test {

template <class A, class B>
using PairsOf = std::vector<std::pair<A, B>>;

/// Whether there are kernels for this instruction set: it must have vectors of at least four doubles.
inline bool has_contact_kernels([[maybe_unused]] std::int64_t target) {
#if HWY_ARCH_X86
  return target <= HWY_AVX2;  // better sets have lower bits
#else
  return false;
#endif
}

/// A pair in the order that kernels require; its manifold is that of (a, b), or of (b, a) if swapped.
template <Dim N, class T, class A, class B>
detail::PrimitivesToContact<N, T> to_contact(const A& a, const B& b, bool other_way, Manifold<N, T>& manifold) {
  const auto* first = reinterpret_cast<const T*>(&a);
  const auto* second = reinterpret_cast<const T*>(&b);
  if constexpr (std::is_same_v<A, B> && !detail::is_a<Sphere, A>) {
    const bool turned = other_way ? !detail::is_in_order(b, a) : !detail::is_in_order(a, b);
    if (turned != other_way) return {second, first, turned, &manifold};
  }
  return {first, second, other_way, &manifold};
}

/// Compares everything that a kernel writes with single calls. Returns the number of pairs it leaves.
template <Dim N, class T, class A, class B>
std::size_t left_by(detail::ContactKernel<N, T> kernel, const PairsOf<A, B>& drawn, const std::string& where) {
  std::vector<Manifold<N, T>> found(drawn.size());
  std::vector<detail::PrimitivesToContact<N, T>> pairs;
  const auto other_way = [](std::size_t i) { return i % 3 == 0; };
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    pairs.push_back(to_contact<N, T>(drawn[i].first, drawn[i].second, other_way(i), found[i]));
  }
  std::vector<std::uint32_t> left(drawn.size());
  left.resize(kernel(pairs, left.data()));
  std::vector<bool> is_left(drawn.size());
  for (const std::uint32_t place : left) {
    EXPECT_FALSE(is_left.at(place)) << where;
    is_left[place] = true;
  }
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    const auto& [a, b] = drawn[i];
    const Manifold<N, T> right = other_way(i) ? manifold(b, a) : manifold(a, b);
    EXPECT_TRUE(is_left[i] ? found[i] == (Manifold<N, T>{}) : same_manifolds(found[i], right))
        << where << '\n'
        << to_source<N, T>(a) << '\n'
        << to_source<N, T>(b);
  }
  return left.size();
}

/// With the kernel of every instruction set, kernel_of(); at most this share may be left, if there is one.
template <Dim N, class T, class A, class B, class KernelOf>
void expect_single_calls_of(const PairsOf<A, B>& drawn, double most_left, const KernelOf& kernel_of) {
  for (const std::int64_t target : simd_targets()) {
    const ForcedTarget forced(target);
    const std::size_t left = left_by<N, T>(kernel_of(), drawn, hwy::TargetName(target));
    if (!has_contact_kernels(target)) continue;
    EXPECT_LE(static_cast<double>(left), most_left * static_cast<double>(drawn.size())) << hwy::TargetName(target);
  }
}

}  // namespace graze::test
