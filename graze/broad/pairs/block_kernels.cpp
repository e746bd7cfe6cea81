// SPDX-License-Identifier: MIT
// Compiled once per instruction set: Highway includes this file again for each.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>
#include <utility>

#include <graze/broad/memory/prefetch.hpp>
#include <graze/broad/pairs/block_kernels.hpp>
#include <graze/broad/simd/choice.hpp>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "graze/broad/pairs/block_kernels.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#include <graze/broad/simd/box_lanes-inl.hpp>
#include <graze/broad/simd/lanes-inl.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {
namespace {

template <Dim N, class T>
HWY_INLINE void survey_one(const Aabb<N, T>& box, Aabb<N, T>& centers) {
  if (is_finite(box.min) && is_finite(box.max) && !is_nothing(box)) centers.grow(box.center());
}

template <Dim N, class T>
Aabb<N, T> survey_boxes(const Aabb<N, T>* boxes, std::size_t count) {
  const Tag<T> d;
  const auto half = hn::Set(d, T(0.5));
  const auto largest = hn::Set(d, std::numeric_limits<T>::max());
  Lanes<T> low[N];
  Lanes<T> high[N];
  for (Dim i = 0; i < N; ++i) {
    low[i] = hn::Set(d, std::numeric_limits<T>::infinity());
    high[i] = hn::Neg(low[i]);
  }
  Aabb<N, T> centers = Aabb<N, T>::nothing();
  std::size_t k = 0;
  for (; k + lanes_of<T> <= count; k += lanes_of<T>) {
    const BoxLanes<N, T> box = load_boxes(boxes + k);
    Lanes<T> center[N];
    auto usual = hn::FirstN(d, lanes_of<T>);
    for (Dim i = 0; i < N; ++i) {
      const auto min = box.min[i];
      const auto max = box.max[i];
      usual = hn::And(usual, hn::And(hn::Le(min, max), hn::And(hn::Ge(min, hn::Neg(largest)), hn::Le(max, largest))));
      center[i] = hn::Add(hn::Mul(min, half), hn::Mul(max, half));
    }
    if (HWY_LIKELY(hn::AllTrue(d, usual))) {
      for (Dim i = 0; i < N; ++i) {
        low[i] = hn::Min(low[i], center[i]);
        high[i] = hn::Max(high[i], center[i]);
      }
    } else {
      for (std::size_t j = k; j < k + lanes_of<T>; ++j) survey_one(boxes[j], centers);
    }
  }
  for (; k < count; ++k) survey_one(boxes[k], centers);
  for (Dim i = 0; i < N; ++i) {
    centers.min[i] = std::min(centers.min[i], hn::GetLane(hn::MinOfLanes(d, low[i])));
    centers.max[i] = std::max(centers.max[i], hn::GetLane(hn::MaxOfLanes(d, high[i])));
  }
  return centers;
}

/// Calculates the cell numbers of centers, a vector at a time.
template <Dim N, class T>
class CellNumbers {
 public:
  using Half = hn::Rebind<std::int32_t, Tag<T>>;
  using Cells = hn::Vec<Half>;

  HWY_INLINE explicit CellNumbers(const CellGrid<N, T>& grid) {
    for (Dim i = 0; i < N; ++i) {
      origin_[i] = hn::Set(Tag<T>(), grid.origin[i]);
      scale_[i] = hn::Set(Tag<T>(), grid.cells_per_unit[i]);
      last_[i] = hn::Set(Half(), static_cast<std::int32_t>(grid.cells[i]) - 1);
      last_place_[i] = hn::Set(Tag<T>(), static_cast<T>(grid.cells[i] - 1));
      bits_[i] = std::countr_zero(grid.cells[i]);
    }
  }

  HWY_INLINE Cells operator()(const Lanes<T>* center) const {
    const Half d;
    const auto one = hn::Set(d, 1);
    Cells number = along(center, N - 1);
    for (Dim i = N - 1; i-- > 0;) {
      // Every other row runs backwards: in a row of 2^k cells, cell c becomes c XOR (2^k - 1).
      const auto backwards = hn::And(hn::Neg(hn::And(number, one)), last_[i]);
      number = hn::Add(hn::ShiftLeftSame(number, bits_[i]), hn::Xor(along(center, i), backwards));
    }
    return number;
  }

 private:
  HWY_INLINE Cells along(const Lanes<T>* center, Dim i) const {
    const auto place = hn::Mul(hn::Sub(center[i], origin_[i]), scale_[i]);
    return truncated(hn::Min(hn::Max(place, hn::Zero(Tag<T>())), last_place_[i]));
  }
  static HWY_INLINE Cells truncated(hn::Vec<Tag<float>> place) { return hn::ConvertTo(Half(), place); }
  static HWY_INLINE Cells truncated(hn::Vec<Tag<double>> place) { return hn::DemoteTo(Half(), place); }

  Lanes<T> origin_[N];
  Lanes<T> scale_[N];
  Lanes<T> last_place_[N];
  Cells last_[N];
  int bits_[N];
};

template <Dim N, class T>
HWY_INLINE std::uint16_t cell_of_box(const Aabb<N, T>& box, const CellGrid<N, T>& grid, T largest,
                                     std::uint16_t unusual) {
  for (Dim i = 0; i < N; ++i) {
    const T extent = box.max[i] - box.min[i];
    if (!(extent >= 0 && extent <= largest && std::isfinite(extent))) return unusual;
  }
  return nearest_cell_of(box.center(), grid);
}

template <Dim N, class T>
// NOLINTNEXTLINE(readability-function-size): arrays, one by one, as the loop needs them
void cells_of_boxes(const Aabb<N, T>* boxes, std::size_t count, const CellGrid<N, T>& grid, T largest,
                    std::uint16_t unusual, std::uint16_t* cell) {
  const Tag<T> d;
  const CellNumbers<N, T> numbers(grid);
  const auto half = hn::Set(d, T(0.5));
  const auto most = hn::Set(d, std::min(largest, std::numeric_limits<T>::max()));
  std::size_t k = 0;
  for (; k + lanes_of<T> <= count; k += lanes_of<T>) {
    const BoxLanes<N, T> box = load_boxes(boxes + k);
    Lanes<T> center[N];
    auto usual = hn::FirstN(d, lanes_of<T>);
    for (Dim i = 0; i < N; ++i) {
      const auto min = box.min[i];
      const auto max = box.max[i];
      usual = hn::And(usual, hn::And(hn::Le(min, max), hn::Le(hn::Sub(max, min), most)));
      center[i] = hn::Add(hn::Mul(min, half), hn::Mul(max, half));
    }
    if (HWY_LIKELY(hn::AllTrue(d, usual))) {
      const typename CellNumbers<N, T>::Half di;
      hn::StoreU(hn::DemoteTo(hn::Rebind<std::uint16_t, Tag<T>>(), numbers(center)),
                 hn::Rebind<std::uint16_t, decltype(di)>(), cell + k);
    } else {
      for (std::size_t j = k; j < k + lanes_of<T>; ++j) cell[j] = cell_of_box(boxes[j], grid, largest, unusual);
    }
  }
  for (; k < count; ++k) cell[k] = cell_of_box(boxes[k], grid, largest, unusual);
}

/// The centers of one vector of consecutive boxes.
template <Dim N, class T>
HWY_INLINE void load_centers(const Aabb<N, T>* boxes, Lanes<T> (&center)[N]) {
  const auto half = hn::Set(Tag<T>(), T(0.5));
  const BoxLanes<N, T> box = load_boxes(boxes);
  for (Dim i = 0; i < N; ++i) center[i] = hn::Add(hn::Mul(box.min[i], half), hn::Mul(box.max[i], half));
}

template <Dim N, class T>
Aabb<N, T> bounds_of_centers(const Aabb<N, T>* boxes, std::size_t count) {
  const Tag<T> d;
  Lanes<T> low[N];
  Lanes<T> high[N];
  for (Dim i = 0; i < N; ++i) {
    low[i] = hn::Set(d, std::numeric_limits<T>::infinity());
    high[i] = hn::Neg(low[i]);
  }
  std::size_t k = 0;
  for (; k + lanes_of<T> <= count; k += lanes_of<T>) {
    Lanes<T> center[N];
    load_centers(boxes + k, center);
    for (Dim i = 0; i < N; ++i) {
      low[i] = hn::Min(low[i], center[i]);
      high[i] = hn::Max(high[i], center[i]);
    }
  }
  Aabb<N, T> bounds;
  for (Dim i = 0; i < N; ++i) {
    bounds.min[i] = hn::GetLane(hn::MinOfLanes(d, low[i]));
    bounds.max[i] = hn::GetLane(hn::MaxOfLanes(d, high[i]));
  }
  for (; k < count; ++k) bounds.grow(boxes[k].center());
  return bounds;
}

template <Dim N, class T>
void cells_of_centers(const Aabb<N, T>* boxes, std::size_t count, const CellGrid<N, T>& grid, std::uint16_t* cell) {
  const CellNumbers<N, T> numbers(grid);
  std::size_t k = 0;
  for (; k + lanes_of<T> <= count; k += lanes_of<T>) {
    Lanes<T> center[N];
    load_centers(boxes + k, center);
    const typename CellNumbers<N, T>::Half di;
    hn::StoreU(hn::DemoteTo(hn::Rebind<std::uint16_t, Tag<T>>(), numbers(center)),
               hn::Rebind<std::uint16_t, decltype(di)>(), cell + k);
  }
  for (; k < count; ++k) cell[k] = nearest_cell_of(boxes[k].center(), grid);
}

template <Dim N, class T>
void fill_with_nan(Block<N, T>& block) {
  for (Dim i = 0; i < N; ++i) {
    std::fill(block.min[i], block.min[i] + block_size, std::numeric_limits<T>::quiet_NaN());
    std::fill(block.max[i], block.max[i] + block_size, std::numeric_limits<T>::quiet_NaN());
  }
}

/// Whether the boxes in the first lanes are all non-empty.
template <Dim N, class T>
HWY_INLINE bool are_boxes(const Block<N, T>& block, std::uint32_t lanes) {
  const Tag<T> d;
  std::uint32_t boxes = 0;
  for (std::uint32_t lane = 0; lane < block_size; lane += lanes_of<T>) {
    auto is_box = hn::FirstN(d, lanes_of<T>);
    for (Dim i = 0; i < N; ++i) {
      is_box = hn::And(is_box, hn::Le(hn::Load(d, block.min[i] + lane), hn::Load(d, block.max[i] + lane)));
    }
    boxes |= bits_of<T>(is_box) << lane;
  }
  return boxes == (1U << lanes) - 1U;
}

template <Dim N, class T>
HWY_INLINE void grow(Block<N, T>& block, T margin) {
  const Tag<T> d;
  const auto by = hn::Set(d, margin);
  for (Dim i = 0; i < N; ++i) {
    for (std::uint32_t lane = 0; lane < block_size; lane += lanes_of<T>) {
      hn::Store(hn::Sub(hn::Load(d, block.min[i] + lane), by), d, block.min[i] + lane);
      hn::Store(hn::Add(hn::Load(d, block.max[i] + lane), by), d, block.max[i] + lane);
    }
  }
}

/// Fills blocks with consecutive boxes.
template <Dim N, class T>
HWY_INLINE void fill_in_order(const Aabb<N, T>* boxes, std::size_t count, Block<N, T>* blocks) {
  const Tag<T> d;
  for (std::size_t k = 0; k < count; ++k, boxes += block_size) {
    for (std::uint32_t lane = 0; lane < block_size; lane += lanes_of<T>) {
      const BoxLanes<N, T> box = load_boxes(boxes + lane);
      for (Dim i = 0; i < N; ++i) {
        hn::Store(box.min[i], d, blocks[k].min[i] + lane);
        hn::Store(box.max[i], d, blocks[k].max[i] + lane);
      }
    }
  }
}

template <Dim N, class T>
// NOLINTNEXTLINE(readability-function-size): arrays, one by one, as the loop needs them
void fill_blocks(const Aabb<N, T>* boxes, const std::uint16_t* order, std::size_t count, T margin,
                 Block<N, T>* blocks) {
  // This many blocks are stored before they are read: loading a vector right after narrower stores would stall.
  constexpr std::size_t blocks_at_once = 8;
  Aabb<N, T> ordered[blocks_at_once * block_size];
  const std::size_t full = count / block_size;
  for (std::size_t first = 0; first < full; first += blocks_at_once) {
    const std::size_t some = std::min(blocks_at_once, full - first);
    for (std::size_t k = 0; k < some * block_size; ++k) {
      std::memcpy(&ordered[k], &boxes[order[first * block_size + k]], sizeof(Aabb<N, T>));
    }
    fill_in_order(ordered, some, blocks + first);
  }
  if (full * block_size < count) {
    fill_with_nan(blocks[full]);
    for (std::size_t k = full * block_size; k < count; ++k) {
      for (Dim i = 0; i < N; ++i) {
        blocks[full].min[i][k % block_size] = boxes[order[k]].min[i];
        blocks[full].max[i][k % block_size] = boxes[order[k]].max[i];
      }
    }
  }
  if (margin == T(0)) return;
  for (std::size_t k = 0; k * block_size < count; ++k) grow(blocks[k], margin);
}

template <Dim N, class T>
// NOLINTNEXTLINE(readability-function-size): arrays, one by one, as the loop needs them
bool refill_blocks(const Aabb<N, T>* boxes, T margin, const std::uint32_t* ids, std::size_t count,
                   Block<N, T>* blocks) {
  constexpr std::size_t ahead = std::size_t{2} * block_size;  // prefetch distance, in boxes
  const std::uint32_t* const end = ids + count * block_size;
  for (std::size_t k = 0; k < count; ++k, ids += block_size) {
    Block<N, T>& block = blocks[k];
    const std::uint32_t* const next = end - ids > std::ptrdiff_t{ahead} ? ids + ahead : ids;
    if (HWY_UNLIKELY(ids[block_size - 1] == no_box)) fill_with_nan(block);
    std::uint32_t lanes = 0;
    for (; lanes < block_size && ids[lanes] != no_box; ++lanes) {
      const Aabb<N, T>& box = boxes[ids[lanes]];
      prefetch(boxes + (next[lanes] != no_box ? next[lanes] : ids[lanes]));
      for (Dim i = 0; i < N; ++i) {
        block.min[i][lanes] = box.min[i];
        block.max[i][lanes] = box.max[i];
      }
    }
    if (!are_boxes(block, lanes)) return false;
    if (margin != T(0)) grow(block, margin);
  }
  return true;
}

template <Dim N, class T>
void close_level(const Block<N, T>* blocks, std::size_t count, Block<N, T>* above) {
  const Tag<T> d;
  const auto infinity = hn::Set(d, std::numeric_limits<T>::infinity());
  for (std::size_t k = 0; k < count; ++k) {
    Block<N, T>& parent = above[k / block_size];
    const std::size_t lane = k % block_size;
    for (Dim i = 0; i < N; ++i) {
      auto low = infinity;
      auto high = hn::Neg(infinity);
      for (std::uint32_t j = 0; j < block_size; j += lanes_of<T>) {
        const auto min = hn::Load(d, blocks[k].min[i] + j);
        const auto max = hn::Load(d, blocks[k].max[i] + j);
        const auto full = hn::Eq(min, min);
        low = hn::Min(low, hn::IfThenElse(full, min, infinity));
        high = hn::Max(high, hn::IfThenElse(full, max, hn::Neg(infinity)));
      }
      parent.min[i][lane] = hn::GetLane(hn::MinOfLanes(d, low));
      parent.max[i][lane] = hn::GetLane(hn::MaxOfLanes(d, high));
    }
  }
  const std::size_t last = (count - 1) / block_size;
  for (Dim i = 0; i < N; ++i) {
    for (std::size_t lane = (count - 1) % block_size + 1; lane < block_size; ++lane) {
      above[last].min[i][lane] = std::numeric_limits<T>::quiet_NaN();
      above[last].max[i][lane] = std::numeric_limits<T>::quiet_NaN();
    }
  }
}

template <Dim N, class T>
BlockKernels<N, T> kernels() {
  return {hwy::TargetName(HWY_TARGET), survey_boxes<N, T>, cells_of_boxes<N, T>, bounds_of_centers<N, T>,
          cells_of_centers<N, T>,      fill_blocks<N, T>,  refill_blocks<N, T>,  close_level<N, T>};
}

}  // namespace

const AllBlockKernels& all_block_kernels() {
  static const AllBlockKernels all{kernels<2, float>(), kernels<3, float>(), kernels<2, double>(),
                                   kernels<3, double>()};
  return all;
}

}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graze::detail {
namespace {
HWY_EXPORT(all_block_kernels);
}

std::int64_t block_kernel_targets() { return HWY_TARGETS; }

template <Dim N, class T>
const BlockKernels<N, T>& block_kernels() {
  return HWY_DYNAMIC_DISPATCH(all_block_kernels)().template of<N, T>();
}

template const BlockKernels<2, float>& block_kernels();
template const BlockKernels<3, float>& block_kernels();
template const BlockKernels<2, double>& block_kernels();
template const BlockKernels<3, double>& block_kernels();

}  // namespace graze::detail
#endif
