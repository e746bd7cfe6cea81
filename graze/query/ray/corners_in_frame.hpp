// SPDX-License-Identifier: MIT
// CornersInFrame(corners, origin): a few corners relative to a point, in rows for repeated searches.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

#include <graze/math/lanes/lanes.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::detail {

/// Up to `room` corners, at least one, in double and relative to a point. Searching them is branch-free: a branch on
/// the result would be mispredicted every few corners and take longer than all products together.
class CornersInFrame {
 public:
  static constexpr std::size_t room = 64;

  template <class T>
  CornersInFrame(std::span<const Vec<3, T>> corners, const Vec<3, double>& origin) {
    const Vec<3, double> first = wide<3, T>(corners.front()) - origin;
    for (std::size_t i = 0; i < together; ++i) put(i, first);
    for (std::size_t i = 1; i < corners.size(); ++i) put(i, wide<3, T>(corners[i]) - origin);
    for (count_ = std::max(together, corners.size()); count_ % together != 0; ++count_) put(count_, first);
  }

  Vec<3, double> operator[](std::size_t i) const { return {x_[i], y_[i], z_[i]}; }

  /// The box around them.
  Aabb<3, double> bounds() const {
    const auto [min_x, max_x] = range(x_);
    const auto [min_y, max_y] = range(y_);
    const auto [min_z, max_z] = range(z_);
    return {{min_x, min_y, min_z}, {max_x, max_y, max_z}};
  }

  /// The farthest in a direction; the first of several.
  Vec<3, double> farthest(const Vec<3, double>& direction) const {
    Best best;
#ifdef GRAZE_HAS_LANES
    const Two direction_x = {direction.x, direction.x};
    const Two direction_y = {direction.y, direction.y};
    const Two direction_z = {direction.z, direction.z};
    const auto heights = [&](std::size_t i) {
      return two(x_, i) * direction_x + two(y_, i) * direction_y + two(z_, i) * direction_z;
    };
    Two even = heights(0);
    Two odd = heights(2);
    Places even_place = {0, 1};
    Places odd_place = {2, 3};
    Places places = even_place;
    for (std::size_t i = together; i < count_; i += together) {
      places += static_cast<std::int64_t>(together);
      const Two next = heights(i);
      const Two after = heights(i + 2);
      even_place = next > even ? places : even_place;
      odd_place = after > odd ? places + 2 : odd_place;
      even = next > even ? next : even;
      odd = after > odd ? after : odd;
    }
    best = {even[0], even_place[0]};
    best.meet({even[1], even_place[1]});
    best.meet({odd[0], odd_place[0]});
    best.meet({odd[1], odd_place[1]});
#else
    best = {dot((*this)[0], direction), 0};
    for (std::size_t i = 1; i < count_; ++i) {
      best.meet({dot((*this)[i], direction), static_cast<std::int64_t>(i)});
    }
#endif
    return (*this)[static_cast<std::size_t>(best.place)];
  }

 private:
  static constexpr std::size_t together = 4;
  using Row = std::array<double, room>;

  struct Best {
    double height = 0;
    std::int64_t place = 0;

    void meet(const Best& other) {
      const bool is_behind = other.height > height || (other.height == height && other.place < place);
      *this = is_behind ? other : *this;
    }
  };

  struct Range {
    double min;
    double max;
  };

#ifdef GRAZE_HAS_LANES
  using Two = double __attribute__((vector_size(16)));
  using Places = std::int64_t __attribute__((vector_size(16)));

  static Two two(const Row& row, std::size_t i) {
    Two result;
    std::memcpy(&result, row.data() + i, sizeof(result));
    return result;
  }

  Range range(const Row& row) const {
    Two min = two(row, 0);
    Two max = min;
    for (std::size_t i = 2; i < count_; i += 2) {
      const Two next = two(row, i);
      min = next < min ? next : min;
      max = next > max ? next : max;
    }
    return {std::min(min[0], min[1]), std::max(max[0], max[1])};
  }
#else
  Range range(const Row& row) const {
    const auto [min, max] = std::minmax_element(row.begin(), row.begin() + count_);
    return {*min, *max};
  }
#endif

  void put(std::size_t i, const Vec<3, double>& corner) {
    x_[i] = corner.x;
    y_[i] = corner.y;
    z_[i] = corner.z;
  }

  std::size_t count_;  ///< A multiple of `together`: the first corner is repeated after the last.
  Row x_, y_, z_;
};

}  // namespace graze::detail
