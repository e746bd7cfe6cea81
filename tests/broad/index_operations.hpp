// SPDX-License-Identifier: MIT
// Sequences of operations on a spatial index, and the comparison with the reference. A sequence consists of rows of
// numbers, so that a failing one shrinks, prints, and can be pasted.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <set>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

#include <rapidcheck/gtest.h>

#include <graze/broad/brute_force.hpp>
#include <graze/broad/spatial_index.hpp>
#include <graze/math/pose.hpp>
#include <graze/shape/capsule.hpp>
#include <graze/shape/frustum.hpp>
#include <graze/shape/half_space.hpp>
#include <graze/shape/obb.hpp>
#include <graze/shape/polytope.hpp>
#include <graze/shape/ray.hpp>
#include <graze/shape/segment.hpp>
#include <graze/shape/sphere.hpp>

namespace graze::test {

/// An operation, the box that it affects, and six numbers as parameters.
using Step = std::vector<int>;

inline rc::Gen<std::vector<Step>> any_steps() {
  const auto number = rc::gen::weightedOneOf<int>(
      {{6, rc::gen::inRange(0, 12)}, {2, rc::gen::inRange(-3, 40)}, {1, rc::gen::inRange(0, 1000)}});
  return rc::gen::scale(4.0, rc::gen::container<std::vector<Step>>(rc::gen::container<Step>(8, number)));
}

/// |(x - center) / radii| <= 1, as a user who calculates in T may write it.
template <Dim N, class T>
struct Egg {
  Vec<N, T> center;
  Vec<N, T> radii;
};

template <Dim N, class T>
Vec<N, T> support(const Egg<N, T>& egg, const std::type_identity_t<Vec<N, T>>& direction) {
  const Vec<N, T> scaled = egg.radii * direction;
  return egg.center + egg.radii * scaled / std::sqrt(dot(scaled, scaled));
}

/// An index and BruteForce side by side, with the same operations.
template <SpatialIndex I>
class Trial {
 public:
  using Box = typename I::Box;
  static constexpr Dim N = dimension_of<Box>;
  using T = scalar_of<Box>;

  /// The unit of all lengths: 1 makes touching common, 0.1 causes rounding.
  Trial(I index, double unit) : index_(std::move(index)), unit_(unit) {}

  void run(const std::vector<Step>& steps) {
    for (const Step& step : steps) apply(step);
    compare_all();
    while (!keys_.empty()) erase(keys_.size() / 2);
    RC_ASSERT(index_.size() == 0U);
    compare_query(Box::everything());
  }

 private:
  void apply(const Step& step) {
    const auto pick = keys_.empty() ? 0 : static_cast<std::size_t>(std::abs(step[1])) % keys_.size();
    switch (std::abs(step[0]) % 12) {
      case 0:
        return std::abs(step[1]) % 4 == 1 ? assign(step) : insert(box_of(step));
      case 1:
      case 2:
      case 3:
        return insert(box_of(step));
      case 4:
      case 5:
        return keys_.empty() ? insert(box_of(step)) : update(pick, box_of(step));
      case 6:
        return keys_.empty() ? insert(box_of(step)) : erase(pick);
      case 7:
        return move_all(step);
      case 8:
        return compare_region(step);
      case 9:
        return compare_nearest(point(step, 2), static_cast<std::size_t>(std::abs(step[1])));
      case 10:
        compare_rays(step);
        return compare_casts(step);
      default:
        return refuse_nonsense(step, pick);
    }
  }

  T length(int number) const { return static_cast<T>(unit_ * number); }

  Vec<N, T> point(const Step& step, std::size_t first) const {
    Vec<N, T> result;
    for (Dim i = 0; i < N; ++i) result[i] = length(step[(first + static_cast<std::size_t>(i) - 2) % 6 + 2]);
    return result;
  }

  /// Mostly small, sometimes huge, far away, a point, or with infinite sides.
  Box box_of(const Step& step) const {
    Box box{point(step, 2), point(step, 2)};
    for (Dim i = 0; i < N; ++i) box.max[i] += length(std::abs(step[static_cast<std::size_t>(7 - i)]) % 5);
    if (step[1] == 11) box.max[0] = std::numeric_limits<T>::infinity();
    if (step[1] == 10) box.min[N - 1] = -std::numeric_limits<T>::infinity();
    if (step[1] == 9) box = {box.min * T(1e4), box.max * T(1e4)};
    if (step[1] == 8) box.min = box.max;
    return box;
  }

  void insert(const Box& box) {
    const Key key = index_.insert(box);
    const Key expected = judge_.insert(box);
    RC_ASSERT(same(key, expected));
    RC_ASSERT(index_.contains(key));
    keys_.emplace_back(key, expected);
    RC_ASSERT(index_.size() == judge_.size());
  }

  /// Replaces all boxes, in bulk if the index supports it: the existing ones, moved, and some more.
  void assign(const Step& step) {
    std::vector<Box> boxes;
    for (const auto& [key, expected] : keys_) boxes.push_back(judge_.box(expected));
    Step other = step;
    for (int k = 0; k < std::abs(step[7]) % 50; ++k) {
      for (std::size_t i = 2; i < other.size(); ++i) other[i] = (other[i] * 7 + k + static_cast<int>(i)) % 41;
      other[1] = k % 16;  // a large, a far and an infinite one among them
      boxes.push_back(box_of(other));
    }
    keys_.clear();
    judge_.clear();
    for (const Box& box : boxes) keys_.emplace_back(Key{}, judge_.insert(box));
    if constexpr (requires { index_.assign(std::span<const Box>(boxes)); }) {
      const std::vector<Key> given = index_.assign(boxes);
      RC_ASSERT(given.size() == boxes.size());
      for (std::size_t k = 0; k < given.size(); ++k) keys_[k].first = given[k];
      refuse_to_assign(boxes);
    } else {
      index_.clear();
      for (std::size_t k = 0; k < boxes.size(); ++k) keys_[k].first = index_.insert(boxes[k]);
    }
    for (const auto& [key, expected] : keys_) {
      RC_ASSERT(same(key, expected));
      RC_ASSERT(index_.box(key) == judge_.box(expected));
    }
    compare_query(Box::everything());
  }

  /// One invalid box among many changes nothing.
  void refuse_to_assign(std::vector<Box> boxes) {
    if (boxes.empty()) return;
    boxes[boxes.size() / 2].max[0] = std::numeric_limits<T>::quiet_NaN();
    RC_ASSERT_THROWS_AS(index_.assign(boxes), std::invalid_argument);
  }

  void update(std::size_t pick, const Box& box) {
    index_.update(keys_[pick].first, box);
    judge_.update(keys_[pick].second, box);
    RC_ASSERT(index_.box(keys_[pick].first) == box);
  }

  void erase(std::size_t pick) {
    const Key key = keys_[pick].first;
    index_.erase(key);
    judge_.erase(keys_[pick].second);
    keys_.erase(keys_.begin() + static_cast<std::ptrdiff_t>(pick));
    RC_ASSERT(!index_.contains(key));
    RC_ASSERT_THROWS_AS(index_.erase(key), std::out_of_range);
    RC_ASSERT(index_.size() == judge_.size());
  }

  void move_all(const Step& step) {
    const Vec<N, T> way = point(step, 3);
    for (std::size_t k = 0; k < keys_.size(); ++k) {
      const Box box = index_.box(keys_[k].first);
      update(k, {box.min + way, box.max + way});
    }
  }

  void refuse_nonsense(const Step& step, std::size_t pick) {
    Box bad = box_of(step);
    bad.min[N - 1] = std::numeric_limits<T>::quiet_NaN();
    RC_ASSERT_THROWS_AS(index_.insert(bad), std::invalid_argument);
    if (!keys_.empty()) RC_ASSERT_THROWS_AS(index_.update(keys_[pick].first, bad), std::invalid_argument);
    if (!keys_.empty()) RC_ASSERT_THROWS_AS(index_.erase(keys_[pick].second), std::out_of_range);
    RC_ASSERT(index_.size() == judge_.size());
    compare_query(Box::everything());
  }

  static bool same(const Key& key, const Key& expected) {
    return key.index == expected.index && key.generation == expected.generation;
  }

  template <class Visits>
  static bool same_visits(const Visits& visits, const Visits& expected) {
    return std::equal(visits.begin(), visits.end(), expected.begin(), expected.end(),
                      [](const auto& a, const auto& b) { return same(a.first, b.first) && a.second == b.second; });
  }

  template <class Index, class R>
  static std::vector<Key> answers(const Index& index, const R& region) {
    std::vector<Key> keys;
    index.query(region, [&keys](Key key) { keys.push_back(key); });
    return keys;
  }

  template <class R>
  void compare_query(const R& region) const {
    std::vector<Key> found = answers(index_, region);
    const std::vector<Key> expected = answers(judge_, region);
    RC_ASSERT(found == answers(index_, region));
    std::sort(found.begin(), found.end());
    RC_ASSERT(std::equal(found.begin(), found.end(), expected.begin(), expected.end(), same));
    std::size_t visits = 0;
    index_.query(region, [&visits, &expected](Key) { return ++visits < (expected.size() + 1) / 2; });
    RC_ASSERT(visits == (expected.size() + 1) / 2);
  }

  void compare_region(const Step& step) const {
    const Vec<N, T> a = point(step, 2);
    const Vec<N, T> b = point(step, 5);
    const T size = length(std::abs(step[7]) % 4);
    switch (std::abs(step[1]) % 10) {
      case 0:
        return compare_query(Box::from_corners(a, b));
      case 1:
        return compare_query(Sphere<N, T>{a, size});
      case 2:
        return compare_query(Capsule<N, T>{a, b, size});
      case 3:
        return compare_query(obb(a, size, step[6]));
      case 4:
        return compare_query(convex_hull<N, T>(std::array{a, b, point(step, 3), point(step, 4)}));
      case 5:
        return compare_query(HalfSpace<N, T>{unit_axis<N, T>(0) + unit_axis<N, T>(1), size});
      case 6:
        return compare_query(a);
      case 7:
        return compare_query(frustum(a, size, step[6]));
      case 8:
        return compare_query(Egg<N, T>{a, egg_radii(size)});
      default:
        return compare_query(Ray<N, T>{a, direction(step)});
    }
  }

  static Obb<N, T> obb(const Vec<N, T>& center, T size, int degrees) {
    Obb<N, T> box{center, Vec<N, T>(size), Mat<N, T>(T(1))};
    box.half_extents[0] *= 3;
    const Mat<2, double> turn = rotation_matrix(degrees);
    for (Dim i = 0; i < 2; ++i) {
      for (Dim j = 0; j < 2; ++j) box.axes[i][j] = static_cast<T>(turn[i][j]);
    }
    return box;
  }

  /// Along the last axis, rotated about it in 3D, three times as wide at the far end; with size zero it is a point.
  static Frustum<N, T> frustum(const Vec<N, T>& eye, T size, int degrees) {
    const Mat<2, double> turn = rotation_matrix(degrees);
    Frustum<N, T> frustum;
    for (std::size_t k = 0; k < frustum.corner_count; ++k) {
      const bool is_far = (k >> static_cast<unsigned>(N - 1)) != 0;
      Vec<N, T> corner = frustum.corners[k] * (is_far ? 3 * size : size);
      corner[N - 1] = is_far ? 5 * size : size;
      const Vec<2, double> turned = turn * Vec<2, double>(corner[0], corner[1]);
      corner[0] = static_cast<T>(turned.x);
      corner[1] = static_cast<T>(turned.y);
      frustum.corners[k] = eye + corner;
    }
    return frustum;
  }

  Vec<N, T> egg_radii(T size) const {
    Vec<N, T> radii(size + length(1));
    radii[0] *= 2;
    return radii;
  }

  Vec<N, T> direction(const Step& step) const {
    const Vec<N, T> way = point(step, 4) - point(step, 2);
    return way == Vec<N, T>(T(0)) ? unit_axis<N, T>(step[7] % 2 == 0 ? 0 : 1) : way;
  }

  void compare_nearest(const Vec<N, T>& from, std::size_t k) const {
    const std::vector<Neighbour> found = index_.nearest(from, k);
    const std::vector<Neighbour> expected = judge_.nearest(from, k);
    RC_ASSERT(found.size() == std::min(k, keys_.size()));
    RC_ASSERT(std::equal(
        found.begin(), found.end(), expected.begin(), expected.end(),
        [](const auto& a, const auto& b) { return same(a.key, b.key) && a.distance_squared == b.distance_squared; }));
  }

  void compare_rays(const Step& step) const {
    const auto hits_of = [](const auto& index, const Ray<N, T>& ray, std::size_t most) {
      std::vector<std::pair<Key, double>> hits;
      index.ray_cast(ray, [&hits, most](Key key, double t) {
        hits.emplace_back(key, t);
        return hits.size() < most;
      });
      return hits;
    };
    for (const Vec<N, T>& along : {direction(step), unit_axis<N, T>(N - 1), -unit_axis<N, T>(0)}) {
      const Ray<N, T> ray{point(step, 2), along};
      RC_ASSERT(same_visits(hits_of(index_, ray, keys_.size() + 1), hits_of(judge_, ray, keys_.size() + 1)));
      RC_ASSERT(same_visits(hits_of(index_, ray, 1), hits_of(judge_, ray, 1)));
    }
  }

  void compare_casts(const Step& step) const {
    const auto hits_of = [](const auto& index, const Box& box, const Vec<N, T>& motion, std::size_t most) {
      std::vector<std::pair<Key, double>> hits;
      index.cast(box, motion, [&hits, most](Key key, double t) {
        hits.emplace_back(key, t);
        return hits.size() < most;
      });
      return hits;
    };
    const Vec<N, T> corner = point(step, 2);
    for (const Box& box : {Box{corner, corner}, Box{corner, corner + egg_radii(T(0))}}) {
      for (const Vec<N, T>& motion : {direction(step), unit_axis<N, T>(N - 1) * length(9), Vec<N, T>(T(0))}) {
        RC_ASSERT(same_visits(hits_of(index_, box, motion, keys_.size() + 1),
                              hits_of(judge_, box, motion, keys_.size() + 1)));
        RC_ASSERT(same_visits(hits_of(index_, box, motion, 1), hits_of(judge_, box, motion, 1)));
      }
    }
  }

  void compare_all() const {
    const auto pairs_of = [](const auto& index, std::size_t most) {
      std::vector<std::pair<Key, Key>> pairs;
      index.pairs([&pairs, most](Key a, Key b) {
        pairs.emplace_back(a, b);
        return pairs.size() < most;
      });
      return pairs;
    };
    const auto same_pairs = [](const auto& pairs, const auto& expected) {
      return std::equal(pairs.begin(), pairs.end(), expected.begin(), expected.end(), [](const auto& p, const auto& q) {
        return same(p.first, q.first) && same(p.second, q.second);
      });
    };
    constexpr std::size_t all = std::numeric_limits<std::size_t>::max();
    RC_ASSERT(same_pairs(pairs_of(index_, all), pairs_of(judge_, all)));
    RC_ASSERT(same_pairs(pairs_of(index_, 2), pairs_of(judge_, 2)));
    compare_query(Box::everything());
    compare_query(Box::nothing());
    compare_nearest(Vec<N, T>(T(0)), keys_.size());
  }

  I index_;
  BruteForce<N, T> judge_;
  double unit_;
  std::vector<std::pair<Key, Key>> keys_;  // the index's and the reference's
};

}  // namespace graze::test
