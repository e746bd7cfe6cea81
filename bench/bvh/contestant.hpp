// SPDX-License-Identifier: MIT
// The interface of a library in the comparison, and the list of contestants.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "course.hpp"

namespace bench {

enum class Work {
  build,
  regions,
  rays,
  nearest_1,  ///< Box.
  nearest_8,
  nearest_point_1,  ///< Of points, each a box without extent for libraries that support only boxes.
  nearest_point_8,
  update_all,  ///< Boxes move a little; pairs are not requested.
  update_one_percent,
};

/// Which boxes move: the first, and every step-th after it.
struct Share {
  std::size_t first;
  std::size_t step;
};

/// An index of numbered boxes. It supports the works in `can`, and writes one answer for each query: for regions a
/// digest of the numbers of the boxes found; for rays the t at which the first box is entered (infinity if none is);
/// for points the squared distance of the k-th nearest.
template <Dim N>
class Contestant {
 public:
  Contestant() = default;
  Contestant(const Contestant&) = delete;
  Contestant& operator=(const Contestant&) = delete;
  virtual ~Contestant() = default;

  virtual void build(std::span<const Box<N>> boxes) = 0;
  virtual void move(std::span<const Box<N>> boxes, const Share& share) = 0;
  virtual void ask_regions(const Trajectory<N>& course, std::span<std::uint64_t> digests) = 0;
  virtual void ask_rays(const Trajectory<N>& course, std::span<double> first) = 0;
  virtual void ask_nearest(const Trajectory<N>& course, std::size_t k, std::span<double> distances) = 0;
};

/// Adding this for each number gives one number for a set of numbers.
inline std::uint64_t digest_of(std::size_t number) {
  const std::uint64_t product = (std::uint64_t{number} + 1) * 0x9e37'79b9'7f4a'7c15U;
  return product ^ (product >> 29U);
}

/// A Contestant from an index that has some of the members
/// build(boxes), move(boxes, share), query(region, visit), first_hit(ray), nearest(point, k).
template <Dim N, class Index>
class Racing final : public Contestant<N> {
 public:
  static constexpr bool moves = requires(Index index, std::span<const Box<N>> boxes) { index.move(boxes, Share{}); };
  static constexpr bool has_regions = requires(Index index, void (*visit)(std::size_t)) {
    index.query(Box<N>{}, visit);
  };
  static constexpr bool has_rays = requires(Index index) { index.first_hit(Ray<N>{}); };
  static constexpr bool has_nearest = requires(Index index) { index.nearest(Point<N>{}, std::size_t{1}); };

  void build(std::span<const Box<N>> boxes) override { index_.build(boxes); }
  void move([[maybe_unused]] std::span<const Box<N>> boxes, [[maybe_unused]] const Share& share) override {
    if constexpr (moves) index_.move(boxes, share);
  }
  void ask_regions([[maybe_unused]] const Trajectory<N>& course,
                   [[maybe_unused]] std::span<std::uint64_t> digests) override {
    if constexpr (has_regions) {
      for (std::size_t k = 0; k < digests.size(); ++k) {
        std::uint64_t digest = 0;
        index_.query(course.regions[k], [&digest](std::size_t number) { digest += digest_of(number); });
        digests[k] = digest;
      }
    }
  }
  void ask_rays([[maybe_unused]] const Trajectory<N>& course, [[maybe_unused]] std::span<double> first) override {
    if constexpr (has_rays) {
      for (std::size_t k = 0; k < first.size(); ++k) first[k] = index_.first_hit(course.rays[k]);
    }
  }
  void ask_nearest([[maybe_unused]] const Trajectory<N>& course, [[maybe_unused]] std::size_t wanted,
                   [[maybe_unused]] std::span<double> distances) override {
    if constexpr (has_nearest) {
      for (std::size_t k = 0; k < distances.size(); ++k) distances[k] = index_.nearest(course.points[k], wanted);
    }
  }

 private:
  Index index_;
};

constexpr unsigned bit_of(Work work) { return 1U << static_cast<unsigned>(work); }

/// A contestant and the works that it supports.
template <Dim N>
struct Entrant {
  std::string name;
  bool is_graze = false;
  bool is_judged = false;  ///< Whether its lead over the peers is compared with the targets.
  unsigned works = 0;      ///< One bit per work.
  std::function<std::unique_ptr<Contestant<N>>()> make;
};

template <Dim N>
using Entrants = std::vector<Entrant<N>>;

/// What an index stores: boxes, or only points.
enum class Keeps { boxes, points, both };

template <Dim N, class Index>
Entrant<N> entrant(std::string name, Keeps keeps = Keeps::boxes) {
  using Contestant = Racing<N, Index>;
  Entrant<N> result;
  result.name = std::move(name);
  const auto add = [&result](bool can, std::initializer_list<Work> works) {
    for (const Work work : works) result.works |= can ? bit_of(work) : 0;
  };
  const bool keeps_boxes = keeps != Keeps::points;
  add(keeps_boxes, {Work::build});
  add(keeps_boxes && Contestant::has_regions, {Work::regions});
  add(keeps_boxes && Contestant::has_rays, {Work::rays});
  add(keeps_boxes && Contestant::has_nearest, {Work::nearest_1, Work::nearest_8});
  add(keeps != Keeps::boxes && Contestant::has_nearest, {Work::nearest_point_1, Work::nearest_point_8});
  add(keeps_boxes && Contestant::moves, {Work::update_all, Work::update_one_percent});
  result.make = [] { return std::make_unique<Contestant>(); };
  return result;
}

// Each adds the library's contestants for a dimension.
template <Dim N>
void enter_graze(Entrants<N>& field);
template <Dim N>
void enter_boost(Entrants<N>& field);
template <Dim N>
void enter_box2d(Entrants<N>& field);
template <Dim N>
void enter_bullet(Entrants<N>& field);
template <Dim N>
void enter_embree(Entrants<N>& field);
template <Dim N>
void enter_fcl(Entrants<N>& field);
template <Dim N>
void enter_nanoflann(Entrants<N>& field);

}  // namespace bench
