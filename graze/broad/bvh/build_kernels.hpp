// SPDX-License-Identifier: MIT
// Inner loops of building a Bvh, compiled for each instruction set and chosen at run time. All give the same answers.
#pragma once

#include <cstddef>
#include <cstdint>

#include <graze/broad/simd/space_kernels.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::detail {

/// Centers of boxes, coordinate by coordinate, and their slots.
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

/// A number of given rank, and how many numbers are less.
template <class T>
struct Selected {
  T value;
  std::size_t less;
};

template <Dim N, class T>
struct BuildKernels {
  /// The name of the instruction set.
  const char* target;

  /// The length of the longest prefix of boxes that are finite and not empty.
  std::size_t (*finite)(const Aabb<N, T>* boxes, std::size_t count);

  /// The centers of finite boxes.
  void (*centers)(const Aabb<N, T>* boxes, std::size_t count, const CenterLists<N, T>& to);

  /// The bounds of at least one center.
  Aabb<N, T> (*bounds)(const CenterLists<N, T>& centers, std::size_t count);

  /// The number that would be at index `rank` after sorting. Numbers must be finite and more than `rank`; `room` and
  /// `more_room` hold as many. O(count) expected, O(count log count) in the worst case: a sample gives two numbers that
  /// nearly always enclose it, with few others (Floyd and Rivest 1975, "Expected time bounds for selection").
  Selected<T> (*select)(const T* numbers, std::size_t count, std::size_t rank, T* room, T* more_room);

  /// Copies the `less` centers below `border` along an axis to the front and the others behind them. Stable.
  void (*part)(const CenterLists<N, T>& from, std::size_t count, Dim axis, const Selected<T>& border,
               const CenterLists<N, T>& to);

  /// The same, but copies the slots only.
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
