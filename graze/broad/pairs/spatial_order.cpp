// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <utility>

#include <graze/broad/brute_force_pairs.hpp>
#include <graze/broad/memory/pool.hpp>
#include <graze/broad/pairs/block_kernels.hpp>
#include <graze/broad/pairs/cluster.hpp>
#include <graze/broad/pairs/near_cluster.hpp>
#include <graze/broad/pairs/spatial_order.hpp>
#include <graze/math/random/linear_congruential.hpp>

namespace graze::detail {
namespace {

constexpr std::size_t chunk_size = 1U << 16U;   // boxes per task
constexpr std::size_t boxes_per_bucket = 1024;  // between this and twice as many, if boxes are evenly distributed
constexpr std::size_t long_enough = 2 * boxes_per_bucket;  // for a run of several buckets
constexpr std::size_t most_buckets_in_order = 16384;

// Size classes: class 0 contains ordinary boxes, sorted by cells; each further class reaches four times as far; the
// last contains infinite boxes.
constexpr std::size_t class_count = 16;

std::size_t chunks_of(std::size_t count) { return (count + chunk_size - 1) / chunk_size; }

template <Dim N, class T>
T extent_of(const Aabb<N, T>& box) {
  T extent = box.max[0] - box.min[0];
  for (Dim i = 1; i < N; ++i) extent = std::max(extent, box.max[i] - box.min[i]);
  return extent;
}

template <Dim N, class T>
std::size_t class_of(const Aabb<N, T>& box, T usual) {
  const T extent = extent_of(box);
  if (!(is_finite(box.min) && is_finite(box.max))) return class_count - 1;
  std::size_t result = 0;
  for (T limit = usual; extent > limit && result < class_count - 2; limit *= T(4)) ++result;
  return result;
}

void lower(std::atomic<std::size_t>& to_least, std::size_t value) {
  std::size_t known = to_least;
  while (value < known && !to_least.compare_exchange_weak(known, value)) {
  }
}

/// Centers of boxes, for sort_cluster.
template <Dim N, class T>
struct Centers {
  std::span<const Aabb<N, T>> boxes;

  Vec<N, T> operator()(std::uint32_t i) const { return boxes[i].center(); }
  void prefetch(std::uint32_t i) const { detail::prefetch(&boxes[i]); }
};

}  // namespace

/// The buckets of the order: the cells of ordinary boxes, one bucket for each further class, one for empty boxes.
template <Dim N, class T>
struct SpatialOrder<N, T>::Buckets {
  CellGrid<N, T> grid;
  T usual = 0;
  std::size_t cells = 1;

  std::size_t of_class(std::size_t k) const { return cells + k - 1; }
  std::size_t left_out() const { return cells + class_count - 1; }
  std::size_t count() const { return cells + class_count; }
};

/// The bounds of the centers, estimated from a sample if there are many boxes; centers beyond go to the outermost
/// cells. Reading all boxes takes as long as finding their cells.
template <Dim N, class T>
void SpatialOrder<N, T>::survey(std::span<const Aabb<N, T>> boxes) {
  constexpr std::size_t sample_size = 1024;
  if (boxes.size() <= 8 * sample_size) {
    centers_ = block_kernels<N, T>().survey(boxes.data(), boxes.size());
  } else {
    std::array<Aabb<N, T>, sample_size> sample;
    LinearCongruential random;
    for (Aabb<N, T>& box : sample) box = boxes[random.below(boxes.size())];
    centers_ = block_kernels<N, T>().survey(sample.data(), sample.size());
  }
  if (is_nothing(centers_)) centers_ = {Vec<N, T>(T(0)), Vec<N, T>(T(0))};
}

/// The largest extent of an ordinary box: the space of sixteen evenly distributed boxes, which is the size of a block
/// anyway, or twice the common extent of the smaller ones.
template <Dim N, class T>
T SpatialOrder<N, T>::usual_size(std::span<const Aabb<N, T>> boxes) const {
  constexpr std::size_t most_samples = 256;
  const std::size_t stride = std::max<std::size_t>(1, boxes.size() / most_samples);
  std::vector<T> extents;
  extents.reserve(boxes.size() / stride + 1);
  for (std::size_t k = 0; k < boxes.size(); k += stride) {
    if (!is_nothing(boxes[k]) && std::isfinite(extent_of(boxes[k]))) extents.push_back(extent_of(boxes[k]));
  }
  if (extents.empty()) return T(0);
  const auto quarter = extents.begin() + static_cast<std::ptrdiff_t>(extents.size() / 4);
  std::nth_element(extents.begin(), quarter, extents.end());
  const CellGrid<N, T> blocks = grid_over(centers_, boxes.size() / block_size + 1);
  T block = std::numeric_limits<T>::infinity();
  for (Dim i = 0; i < N; ++i) {
    if (blocks.cells[i] > 1) block = std::min(block, T(1) / blocks.cells_per_unit[i]);
  }
  return std::isfinite(block) ? std::max(block, T(2) * *quarter) : T(2) * *quarter;
}

/// Returns the index of the first box with a NaN; the number of boxes if there is none.
template <Dim N, class T>
std::size_t SpatialOrder<N, T>::find_cells(std::span<const Aabb<N, T>> boxes, const Buckets& buckets,
                                           const Executor& executor) {
  cells_.require(boxes.size());
  counts_.assign(chunks_of(boxes.size()) * buckets.count(), 0);
  constexpr auto unusual = std::numeric_limits<std::uint16_t>::max();
  std::atomic<std::size_t> first_nan = boxes.size();
  executor.parallel_for(chunks_of(boxes.size()), [&](std::size_t chunk) {
    const std::size_t first = chunk * chunk_size;
    const std::size_t last = std::min(first + chunk_size, boxes.size());
    std::uint32_t* const counts = counts_.data() + chunk * buckets.count();
    std::uint16_t* const cells = cells_.data();
    block_kernels<N, T>().cells(boxes.data() + first, last - first, buckets.grid, buckets.usual, unusual,
                                cells + first);
    for (std::size_t k = first; k < last; ++k) {
      if (cells[k] == unusual) {
        if (has_nan(boxes[k])) lower(first_nan, k);
        const std::size_t size_class = is_nothing(boxes[k]) ? class_count : class_of(boxes[k], buckets.usual);
        cells[k] = static_cast<std::uint16_t>(buckets.of_class(size_class));
      }
      ++counts[cells[k]];
    }
  });
  return first_nan;
}

template <Dim N, class T>
void SpatialOrder<N, T>::scatter(std::span<const Aabb<N, T>> boxes, const Buckets& buckets, const Executor& executor) {
  const std::size_t chunks = chunks_of(boxes.size());
  ends_.assign(buckets.count(), 0);
  std::uint32_t next = 0;
  for (std::size_t bucket = 0; bucket < buckets.count(); ++bucket) {
    for (std::size_t chunk = 0; chunk < chunks; ++chunk) {
      std::uint32_t& count = counts_[chunk * buckets.count() + bucket];
      next += std::exchange(count, next);
    }
    ends_[bucket] = next;
  }
  order_.require(boxes.size());
  executor.parallel_for(chunks, [&](std::size_t chunk) {
    const std::size_t first = chunk * chunk_size;
    const std::size_t last = std::min(first + chunk_size, boxes.size());
    std::uint32_t* const places = counts_.data() + chunk * buckets.count();
    for (std::size_t k = first; k < last; ++k) order_[places[cells_[k]]++] = static_cast<std::uint32_t>(k);
  });
}

template <Dim N, class T>
void SpatialOrder<N, T>::divide_clusters(std::span<const Aabb<N, T>> boxes, const Buckets& buckets,
                                         const Executor& executor) {
  std::vector<std::size_t> clusters;
  std::size_t largest = 0;
  for (std::size_t bucket = 0; bucket < buckets.of_class(class_count - 1); ++bucket) {
    const std::size_t count = ends_[bucket] - (bucket == 0 ? 0 : ends_[bucket - 1]);
    if (count > run_limit()) clusters.push_back(bucket);
    largest = std::max(largest, count);
  }
  passing_bytes_ = 0;
  if (clusters.empty()) return;
  if (largest > NearCluster<N, T>::most) spare_.require(boxes.size());
  Pool<NearCluster<N, T>> near_clusters;  // temporary: with many threads they are as large as everything else
  executor.parallel_for(clusters.size(), [&](std::size_t k) {
    const std::size_t begin = clusters[k] == 0 ? 0 : ends_[clusters[k] - 1];
    const std::size_t count = ends_[clusters[k]] - begin;
    if (count <= NearCluster<N, T>::most) {
      const typename Pool<NearCluster<N, T>>::Loan near(near_clusters);
      near->sort(boxes, order_.data() + begin, count, boxes_per_bucket, cells_.data() + begin);
      return;
    }
    sort_cluster<N, T>(order_.data() + begin, count, boxes_per_bucket, Centers<N, T>{boxes}, cells_.data() + begin,
                       spare_.data() + begin);
  });
  for (const auto& near : near_clusters.all()) passing_bytes_ += near->bytes();
}

template <Dim N, class T>
void SpatialOrder<N, T>::sort(std::span<const Aabb<N, T>> boxes, const Executor& executor, BoxSet set) {
  box_count_ = boxes.size();
  survey(boxes);
  Buckets buckets;
  buckets.usual = usual_size(boxes);
  buckets.grid = grid_over(centers_, std::min(most_buckets_in_order / 2, boxes.size() / (2 * boxes_per_bucket) + 1));
  buckets.cells = buckets.grid.count();
  const std::size_t first_nan = find_cells(boxes, buckets, executor);
  if (first_nan < boxes.size()) refuse_nan(first_nan, set);
  scatter(boxes, buckets, executor);
  divide_clusters(boxes, buckets, executor);
  cut_runs(buckets);
}

template <Dim N, class T>
std::size_t SpatialOrder<N, T>::run_limit() const {
  constexpr std::size_t shortest = 16384;
  return std::clamp(box_count_ / 3, shortest, longest_run);
}

/// Adds a range of the order, as runs of equal length if it is too long for one.
template <Dim N, class T>
void SpatialOrder<N, T>::add_runs(std::size_t first, std::size_t count, bool finite) {
  const std::size_t pieces = (count + run_limit() - 1) / run_limit();
  for (std::size_t k = 0; k < pieces; ++k) {
    const std::size_t begin = k * count / pieces;
    runs_.push_back({first + begin, (k + 1) * count / pieces - begin, finite});
  }
}

template <Dim N, class T>
void SpatialOrder<N, T>::cut_runs(const Buckets& buckets) {
  runs_.clear();
  std::size_t first = 0;
  const auto flush = [&](std::size_t end, bool finite) {
    add_runs(first, end - first, finite);
    first = end;
  };
  for (std::size_t bucket = 0; bucket + 1 < buckets.count(); ++bucket) {
    const std::size_t end = ends_[bucket];
    const bool is_class = bucket >= buckets.cells;
    // Cells with few boxes share a run with the next; size classes do not.
    if (end - first > long_enough && first < (bucket == 0 ? 0 : ends_[bucket - 1])) flush(ends_[bucket - 1], true);
    if (end - first >= boxes_per_bucket / 2 || is_class || bucket + 1 == buckets.cells) {
      flush(end, bucket != buckets.of_class(class_count - 1));
    }
  }
}

template <Dim N, class T>
std::size_t SpatialOrder<N, T>::bytes() const {
  return cells_.bytes() + order_.bytes() + spare_.bytes() + counts_.capacity() * sizeof(counts_[0]) +
         ends_.capacity() * sizeof(ends_[0]) + runs_.capacity() * sizeof(runs_[0]) + passing_bytes_;
}

template class SpatialOrder<2, float>;
template class SpatialOrder<3, float>;
template class SpatialOrder<2, double>;
template class SpatialOrder<3, double>;

}  // namespace graze::detail
