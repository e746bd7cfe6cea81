// SPDX-License-Identifier: MIT
#include <algorithm>
#include <atomic>
#include <bit>
#include <mutex>
#include <numeric>

#include <graze/broad/pairs/block_kernels.hpp>
#include <graze/broad/pairs/block_tree.hpp>
#include <graze/broad/pairs/cluster.hpp>
#include <graze/broad/pairs/near_cluster.hpp>

namespace graze::detail {
namespace {

constexpr std::size_t cluster_size = 64;  // a fine cell with more boxes is divided again
constexpr std::uint32_t row_cells = 8;    // this many fine cells in a row contain a block, which is then roughly a cube
constexpr std::size_t boxes_per_task = 6144;
constexpr std::size_t sample_stride = 128;  // one in this many blocks is tested before all are refilled

/// Groups runs into tasks: the first run of each, and the end.
std::vector<std::size_t> tasks_of(std::span<const SpatialRun> runs) {
  std::vector<std::size_t> first_run(1, 0);
  std::size_t boxes = 0;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    boxes += runs[k].count;
    if (boxes < boxes_per_task && k + 1 < runs.size()) continue;
    first_run.push_back(k + 1);
    boxes = 0;
  }
  return first_run;
}

}  // namespace

/// The boxes of one run, and their order.
template <Dim N, class T>
class BlockTree<N, T>::Scratch {
 public:
  Buffer<Aabb<N, T>> boxes;
  Buffer<std::uint16_t> order;

  /// Gathers boxes from scattered positions.
  void load(std::span<const Aabb<N, T>> from, const std::uint32_t* ids, std::size_t count) {
    require(count);
    fetch_boxes(from, ids, count, boxes.data());
  }

  /// Orders the boxes by the cells of a grid: columns as wide as a block, finely divided along their length.
  void sort(std::size_t count) {
    const BlockKernels<N, T>& kernels = block_kernels<N, T>();
    const Aabb<N, T> bounds = kernels.center_bounds(boxes.data(), count);
    const CellGrid<N, T> grid = with_finer_rows(grid_over(bounds, count / block_size), bounds, row_cells);
    const std::size_t cell_count = grid.count();
    ends_.require(cell_count);
    kernels.center_cells(boxes.data(), count, grid, cells_.data());
    std::fill_n(ends_.data(), cell_count, std::uint16_t{0});
    for (std::size_t k = 0; k < count; ++k) ++ends_[cells_[k]];
    std::uint16_t next = 0;
    bool crowded = false;
    for (std::size_t c = 0; c < cell_count; ++c) {
      crowded = crowded || ends_[c] > cluster_size;
      next = static_cast<std::uint16_t>(next + std::exchange(ends_[c], next));
    }
    for (std::size_t k = 0; k < count; ++k) order[ends_[cells_[k]]++] = static_cast<std::uint16_t>(k);
    if (!crowded) return;
    std::size_t begin = 0;
    for (std::size_t c = 0; c < cell_count; ++c) {
      sort_cluster<N, T>(order.data() + begin, ends_[c] - begin, cluster_size, NearCenters<N, T>{boxes.data()},
                         cells_.data() + begin, spare_.data() + begin);
      begin = ends_[c];
    }
  }

  std::size_t bytes() const { return boxes.bytes() + order.bytes() + cells_.bytes() + spare_.bytes() + ends_.bytes(); }

 private:
  void require(std::size_t count) {
    constexpr std::size_t least_room = 1024;  // so that memory seldom grows
    const std::size_t room = std::bit_ceil(std::max(count, least_room));
    boxes.require(room);
    order.require(room);
    cells_.require(room);
    spare_.require(room);
  }

  Buffer<std::uint16_t> cells_;
  Buffer<std::uint16_t> spare_;
  Buffer<std::uint16_t> ends_;  // of every cell in the order
};

/// Scratch memory, one for each running task.
template <Dim N, class T>
class BlockTree<N, T>::ScratchPool {
 public:
  std::unique_ptr<Scratch> take() {
    const std::lock_guard lock(mutex_);
    if (free_.empty()) return std::make_unique<Scratch>();
    std::unique_ptr<Scratch> scratch = std::move(free_.back());
    free_.pop_back();
    return scratch;
  }
  void give_back(std::unique_ptr<Scratch> scratch) {
    const std::lock_guard lock(mutex_);
    free_.push_back(std::move(scratch));
  }
  std::size_t bytes() const {
    std::size_t result = 0;
    for (const auto& scratch : free_) result += sizeof(Scratch) + scratch->bytes();
    return result;
  }

 private:
  std::mutex mutex_;
  std::vector<std::unique_ptr<Scratch>> free_;
};

template <Dim N, class T>
BlockTree<N, T>::BlockTree() : scratches_(std::make_unique<ScratchPool>()) {}

template <Dim N, class T>
BlockTree<N, T>::~BlockTree() = default;

/// Allocates all levels.
template <Dim N, class T>
void BlockTree<N, T>::lay_out() {
  level_first_.assign(1, 0);
  std::size_t blocks = 0;
  for (const SpatialRun& run : order_.runs()) blocks += (run.count + block_size - 1) / block_size;
  if (blocks == 0) return;
  ids_.require(blocks * block_size);
  level_first_.push_back(blocks);
  do {
    blocks = (blocks + block_size - 1) / block_size;
    level_first_.push_back(level_first_.back() + blocks);
  } while (blocks > 1);
  constexpr std::size_t room_to_raise = 8;  // 2^32 boxes make eight levels
  blocks_.require(level_first_.back() + room_to_raise);
}

template <Dim N, class T>
void BlockTree<N, T>::close(std::size_t level, const Executor& executor) {
  constexpr std::size_t blocks_per_task = std::size_t{64} * block_size;  // so that no two tasks share a block above
  const std::size_t count = level_size(level);
  executor.parallel_for((count + blocks_per_task - 1) / blocks_per_task, [&](std::size_t task) {
    const std::size_t first = task * blocks_per_task;
    block_kernels<N, T>().close(this->level(level) + first, std::min(blocks_per_task, count - first),
                                blocks_.data() + level_first_[level + 1] + first / block_size);
  });
}

template <Dim N, class T>
void BlockTree<N, T>::fill_run(std::span<const Aabb<N, T>> boxes, T margin, const SpatialRun& run,
                               std::size_t first_block, Scratch& scratch) {
  const std::uint32_t* const run_ids = order_.order() + run.first;
  scratch.load(boxes, run_ids, run.count);
  if (run.finite) {
    scratch.sort(run.count);
  } else {
    std::iota(scratch.order.data(), scratch.order.data() + run.count, std::uint16_t{0});
  }
  block_kernels<N, T>().fill(scratch.boxes.data(), scratch.order.data(), run.count, margin,
                             blocks_.data() + first_block);
  std::uint32_t* const ids = ids_.data() + first_block * block_size;
  for (std::size_t k = 0; k < run.count; ++k) ids[k] = run_ids[scratch.order[k]];
  const std::size_t lanes = (run.count + block_size - 1) / block_size * block_size;
  std::fill(ids + run.count, ids + lanes, no_box);
}

template <Dim N, class T>
void BlockTree<N, T>::build(std::span<const Aabb<N, T>> boxes, T margin, const Executor& executor, BoxSet set) {
  box_count_ = 0;
  order_.sort(boxes, executor, set);
  lay_out();
  if (height() == 0) return;
  const std::span<const SpatialRun> runs = order_.runs();
  std::vector<std::size_t> first_block(1, 0);
  for (const SpatialRun& run : runs) {
    first_block.push_back(first_block.back() + (run.count + block_size - 1) / block_size);
  }
  const std::vector<std::size_t> first_run = tasks_of(runs);
  executor.parallel_for(first_run.size() - 1, [&](std::size_t task) {
    std::unique_ptr<Scratch> scratch = scratches_->take();
    for (std::size_t k = first_run[task]; k < first_run[task + 1]; ++k) {
      fill_run(boxes, margin, runs[k], first_block[k], *scratch);
    }
    scratches_->give_back(std::move(scratch));
  });
  for (std::size_t k = 0; k + 1 < height(); ++k) close(k, executor);
  built_height_ = height();
  knows_spread_ = false;
  std::size_t held = 0;
  for (const SpatialRun& run : runs) held += run.count;
  if (held == boxes.size()) box_count_ = held;  // last, so that an incomplete build is never refitted
}

/// How spread out the blocks are; calculated only when boxes move.
template <Dim N, class T>
void BlockTree<N, T>::remember_spread() {
  if (std::exchange(knows_spread_, true)) return;
  spread_.take_as_usual(level(1), level_size(0));
  spread_when_built_ = spread_.of(level(1), 0, level_size(0));
  sample_when_built_ = 0;
  for (std::size_t k = 0; k < level_size(0); k += sample_stride) sample_when_built_ += spread_.of(level(1), k);
  lost_ = 0;
}

/// Tests a few blocks, to detect boxes that have nothing in common with the last ones.
template <Dim N, class T>
bool BlockTree<N, T>::has_drifted(std::span<const Aabb<N, T>> boxes, T margin) const {
  std::uint64_t sample = 0;
  Block<N, T> block;
  Block<N, T> bounds;
  for (std::size_t k = 0; k < level_size(0); k += sample_stride) {
    if (!block_kernels<N, T>().refill(boxes.data(), margin, ids_.data() + k * block_size, 1, &block)) return true;
    block_kernels<N, T>().close(&block, 1, &bounds);
    sample += spread_.of(&bounds, 0);
  }
  return sample > sample_when_built_ + sample_when_built_ / 2;
}

template <Dim N, class T>
bool BlockTree<N, T>::refit(std::span<const Aabb<N, T>> boxes, T margin, const Executor& executor) {
  if (boxes.empty() || boxes.size() != box_count_) return false;
  remember_spread();
  if (lost_ > spread_when_built_ || has_drifted(boxes, margin)) return false;
  level_first_.resize(built_height_ + 1);
  constexpr std::size_t blocks_per_task = std::size_t{16} * block_size;  // no two tasks share a block above
  const std::size_t count = level_size(0);
  std::atomic<std::uint64_t> spread = 0;
  std::atomic<bool> are_boxes = true;
  executor.parallel_for((count + blocks_per_task - 1) / blocks_per_task, [&](std::size_t task) {
    const std::size_t first = task * blocks_per_task;
    const std::size_t some = std::min(blocks_per_task, count - first);
    Block<N, T>* const blocks = blocks_.data() + first;
    Block<N, T>* const above = blocks_.data() + level_first_[1] + first / block_size;
    if (!block_kernels<N, T>().refill(boxes.data(), margin, ids_.data() + first * block_size, some, blocks)) {
      are_boxes = false;
      return;
    }
    block_kernels<N, T>().close(blocks, some, above);
    spread += spread_.of(above, 0, some);
  });
  if (!are_boxes || spread > spread_when_built_ + spread_when_built_ / 2) return false;
  if (spread > spread_when_built_) lost_ += spread - spread_when_built_;
  for (std::size_t k = 1; k + 1 < height(); ++k) close(k, executor);
  return true;
}

template <Dim N, class T>
void BlockTree<N, T>::raise(std::size_t wanted) {
  while (height() < wanted) {
    level_first_.push_back(level_first_.back() + 1);
    close(height() - 2, serial_executor());
  }
}

template <Dim N, class T>
std::size_t BlockTree<N, T>::bytes() const {
  return order_.bytes() + blocks_.bytes() + ids_.bytes() + scratches_->bytes();
}

template class BlockTree<2, float>;
template class BlockTree<3, float>;
template class BlockTree<2, double>;
template class BlockTree<3, double>;

}  // namespace graze::detail
