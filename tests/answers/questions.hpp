// SPDX-License-Identifier: MIT
// Asks every query about random shapes, one pair at a time and many at once, and hashes the answers.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

#include <graze/broad/bvh.hpp>
#include <graze/broad/contacts.hpp>
#include <graze/broad/orthtree.hpp>
#include <graze/broad/pairs.hpp>
#include <graze/broad/touching_pairs.hpp>
#include <graze/math/motion.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/closest_boundary_point.hpp>
#include <graze/query/closest_point.hpp>
#include <graze/query/closest_points.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/contains.hpp>
#include <graze/query/distance.hpp>
#include <graze/query/manifold.hpp>
#include <graze/query/mass_properties.hpp>
#include <graze/query/ray_cast.hpp>
#include <graze/query/relation.hpp>
#include <graze/query/separation.hpp>
#include <graze/query/shape_cast.hpp>
#include <graze/query/signed_distance.hpp>
#include <graze/query/time_of_impact.hpp>

#include "answers/draw.hpp"
#include "answers/hash.hpp"

namespace graze::answers {

/// In the order in which `Questions` hashes the answers.
inline constexpr std::array<std::string_view, 22> query_names = {
    "bounds",          "contains",        "closest_point",     "closest_boundary_point",
    "signed_distance", "mass_properties", "ray_cast_entry",    "ray_cast_exit",
    "relation",        "distance",        "closest_points",    "separation",
    "contact",         "manifold",        "shape_cast",        "time_of_impact",
    "relations",       "contacts",        "overlapping_pairs", "bvh",
    "orthtree",        "convex_hull"};

template <Dim N, class T>
class Questions {
 public:
  using Any = AnyShape<N, T>;
  using Point = Vec<N, T>;
  using Hashes = std::array<Hash, query_names.size()>;

  explicit Questions(std::uint64_t seed) : draw_(seed) {}

  /// Adds `count` answers to each hash.
  void answer(std::size_t count, Hashes& hashes) {
    std::vector<Any> shapes;
    std::vector<Aabb<N, T>> boxes;
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < count; ++i) {
      shapes.push_back(draw_.shape());
      const Point center = draw_.point() * T(4);
      boxes.push_back(Aabb<N, T>::from_center(center, Point(draw_.size())));
      const auto place = static_cast<std::uint32_t>(i);
      if (i > 0) pairs.push_back({place - 1, place});
    }
    pairs.push_back({0, static_cast<std::uint32_t>(count - 1)});
    Hash* next = hashes.data();
    for (std::size_t i = 0; i < count; ++i) {
      next = hashes.data();
      ask_one(shapes[i], next);
      ask_two(shapes[i], shapes[i + 1 < count ? i + 1 : 0], next);
    }
    ask_many(shapes, pairs, next);
    ask_boxes(boxes, next);
    ask_hulls(count, *next);
  }

 private:
  void ask_one(const Any& shape, Hash*& next) {
    const Point point = draw_.point();
    const Ray<N, T> ray{draw_.point(), draw_.direction()};
    (next++)->template put<N, T>(bounds(shape));
    (next++)->put(std::uint64_t{contains(shape, point)});
    (next++)->template put<N, T>(closest_point(shape, point));
    (next++)->template put<N, T>(closest_boundary_point(shape, point));
    (next++)->put(signed_distance(shape, point));
    put_mass(mass_properties(shape), *next++);
    for (const RaySide side : {RaySide::entry, RaySide::exit}) {
      (next++)->put_if_any(ray_cast(shape, ray, std::numeric_limits<T>::infinity(), RayOptions{side}));
    }
  }

  void ask_two(const Any& a, const Any& b, Hash*& next) {
    (next++)->put(static_cast<std::uint64_t>(relation(a, b)));
    (next++)->put(distance(a, b));
    (next++)->put(closest_points(a, b));
    (next++)->put(separation(a, b));
    (next++)->put_if_any(contact(a, b));
    (next++)->put(manifold(a, b));
    const Motion<N, T> motion_a = motion();
    const Motion<N, T> motion_b = motion();
    (next++)->put_if_any(shape_cast(a, motion_a.linear, b));
    (next++)->put_if_any(time_of_impact(a, motion_a, b, motion_b));
  }

  void ask_many(const std::vector<Any>& shapes, const std::vector<Pair>& pairs, Hash*& next) {
    for (const Relation each : relations<N, T>(shapes, pairs)) next->put(static_cast<std::uint64_t>(each));
    ++next;
    for (const PairContact<N, T>& each : contacts<N, T>(shapes, pairs)) {
      put_pair(each.pair, *next);
      next->put(each.manifold);
    }
    ++next;
  }

  void ask_boxes(const std::vector<Aabb<N, T>>& boxes, Hash*& next) {
    for (const Pair& pair : overlapping_pairs(boxes)) put_pair(pair, *next);
    ++next;
    ask_index(Bvh<N, T>(), boxes, *next++);
    ask_index(Orthtree<N, T>(), boxes, *next++);
  }

  template <class Index>
  void ask_index(Index index, const std::vector<Aabb<N, T>>& boxes, Hash& hash) {
    for (const Aabb<N, T>& box : boxes) index.insert(box);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      index.query(boxes[i], [&hash](const Key& key) { hash.put(std::uint64_t{key.index}); });
      index.ray_cast(Ray<N, T>{draw_.point(), draw_.direction()}, [&hash](const Key& key, double t) {
        hash.put(std::uint64_t{key.index});
        hash.put(t);
      });
      for (const Neighbour& each : index.nearest(draw_.point(), 4)) {
        hash.put(std::uint64_t{each.key.index});
        hash.put(each.distance_squared);
      }
    }
  }

  void ask_hulls(std::size_t count, Hash& hash) {
    std::vector<Point> points(16);
    for (std::size_t i = 0; i < count; ++i) {
      for (Point& point : points) point = draw_.point();
      const Polytope<N, T> hull = convex_hull<N, T>(points);
      for (const Point& corner : hull.vertices()) hash.put<N, T>(corner);
    }
  }

  Motion<N, T> motion() {
    Motion<N, T> result;
    result.linear = draw_.point();
    result.center = draw_.point();
    if constexpr (N == 2) {
      result.angular = draw_.coordinate();
    } else {
      result.angular = draw_.point();
    }
    return result;
  }

  static void put_mass(const MassProperties<N>& mass, Hash& hash) {
    hash.put(mass.volume);
    hash.put<N, double>(mass.centroid);
    if constexpr (N == 2) {
      hash.put(mass.inertia);
    } else {
      for (Dim i = 0; i < N; ++i) hash.put<N, double>(mass.inertia[i]);
    }
  }

  static void put_pair(const Pair& pair, Hash& hash) {
    hash.put(std::uint64_t{pair.a});
    hash.put(std::uint64_t{pair.b});
  }

  Draw<N, T> draw_;
};

}  // namespace graze::answers
