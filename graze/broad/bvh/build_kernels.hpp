// SPDX-License-Identifier: MIT
// The inner loops of building a Bvh at once, once for every set of vector instructions that the compiler knows. Which
// one runs is chosen at run time, and makes no difference to any answer.
#pragma once

#include <cstddef>
#include <cstdint>

#include <graze/broad/simd/space_kernels.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::detail {

/// Centers of boxes, coordinate by coordinate, and whose they are.
template <Dim N, class T>
struct CenterLists {
  T* at[N];
  std::uint32_t* slots;

  CenterLists behind(std::size_t some) const {
    CenterLists rest = *this;
    for (Dim i = 0; i < N; ++i) rest.at[i] += some;
    rest.slots += some;
    return rest;
  }
};

/// One of some numbers, and how many are less.
template <class T>
struct Selected {
  T value;
  std::size_t less;
};

template <Dim N, class T>
struct BuildKernels {
  /// The name of the instruction set.
  const char* target;

  /// How many boxes from the first one on are finite and contain something.
  std::size_t (*finite)(const Aabb<N, T>* boxes, std::size_t count);

  /// The centers of finite boxes.
  void (*centers)(const Aabb<N, T>* boxes, std::size_t count, const CenterLists<N, T>& to);

  /// The bounds of one center at least.
  Aabb<N, T> (*bounds)(const CenterLists<N, T>& centers, std::size_t count);

  /// The number that would be at place `rank` were they sorted. They are finite and more than `rank`; there is room for
  /// as many twice. O(count) steps, O(count log count) where that fails: a sample tells two numbers between which it
  /// nearly always is, with few others (Floyd and Rivest 1975, "Expected time bounds for selection").
  Selected<T> (*select)(const T* numbers, std::size_t count, std::size_t rank, T* room, T* more_room);

  /// Copies those that are less than `border` along an axis, `less` in number, to the front, the others behind them.
  /// In their order.
  void (*part)(const CenterLists<N, T>& from, std::size_t count, Dim axis, const Selected<T>& border,
               const CenterLists<N, T>& to);

  /// The same, but copies the slots alone.
  void (*part_slots)(const CenterLists<N, T>& from, std::size_t count, Dim axis, const Selected<T>& border,
                     const CenterLists<N, T>& to);
};

/// The kernels of one instruction set.
using AllBuildKernels = SpaceKernels<BuildKernels>;

/// The instruction sets that kernels are compiled for, in Highway's bits.
std::int64_t center_kernel_targets();

/// The kernels for this machine. Instantiated for 2D and 3D, float and double.
template <Dim N, class T>
const BuildKernels<N, T>& build_kernels();

}  // namespace graze::detail
