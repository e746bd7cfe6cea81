// SPDX-License-Identifier: MIT
#include <algorithm>

#include <graze/broad/bvh/part.hpp>

namespace graze::detail {
namespace {

/// Among the centers equal to the border along an axis, the slot of the first one that belongs to the upper part.
template <Dim N, class T>
std::uint32_t border_slot(const BvhCenters<N, T>& centers, Dim axis, T border, std::size_t lower) {
  std::uint32_t* const slots = centers.beside.slots;
  std::size_t equal = 0;
  for (std::size_t k = 0; k < centers.count; ++k) {
    slots[equal] = centers.here.slots[k];
    equal += centers.here.at[axis][k] == border ? 1U : 0U;
  }
  std::nth_element(slots, slots + lower, slots + equal);
  return slots[lower];
}

/// Partitions centers when some equal to the border belong to each part.
template <Dim N, class T>
void part_equal(const BvhCenters<N, T>& centers, std::size_t lower, Dim axis, const Selected<T>& border) {
  const std::uint32_t slot = border_slot(centers, axis, border.value, lower - border.less);
  std::size_t low = 0;
  std::size_t high = lower;
  for (std::size_t k = 0; k < centers.count; ++k) {
    const T at = centers.here.at[axis][k];
    const bool is_low = at < border.value || (at == border.value && centers.here.slots[k] < slot);
    const std::size_t place = is_low ? low : high;
    for (Dim i = 0; i < N; ++i) centers.beside.at[i][place] = centers.here.at[i][k];
    centers.beside.slots[place] = centers.here.slots[k];
    low += is_low ? 1U : 0U;
    high += is_low ? 0U : 1U;
  }
}

}  // namespace

template <Dim N, class T>
T part_centers(const BvhCenters<N, T>& centers, std::size_t lower, Dim axis, BvhWanted wanted) {
  const BuildKernels<N, T>& kernels = build_kernels<N, T>();
  const Selected<T> border =
      kernels.select(centers.here.at[axis], centers.count, lower, centers.beside.at[0], centers.beside.at[1]);
  if (border.less != lower) {
    part_equal(centers, lower, axis, border);
  } else {
    const auto part = wanted == BvhWanted::all ? kernels.part : kernels.part_slots;
    part(centers.here, centers.count, axis, border, centers.beside);
  }
  return border.value;
}

template float part_centers(const BvhCenters<2, float>&, std::size_t, Dim, BvhWanted);
template float part_centers(const BvhCenters<3, float>&, std::size_t, Dim, BvhWanted);
template double part_centers(const BvhCenters<2, double>&, std::size_t, Dim, BvhWanted);
template double part_centers(const BvhCenters<3, double>&, std::size_t, Dim, BvhWanted);

}  // namespace graze::detail
