// SPDX-License-Identifier: MIT
// Compares contact, manifold and contacts of circles, capsules and boxes in 2D, in float, with Box2D's b2Collide... and
// the world points of its manifolds. All pairs overlap: a thousand, which the branch predictor learns, and sixteen
// thousand, which it does not. Before timing, depths are compared: graze's is the minimum, so Box2D's may be more, by
// its preference for the first polygon's sides and by rounding, but not less.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <random>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>
#include <box2d/b2_circle_shape.h>
#include <box2d/b2_collision.h>
#include <box2d/b2_polygon_shape.h>

#include <graze/broad/contacts.hpp>
#include <graze/broad/executor.hpp>
#include <graze/math/pose.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/intersects.hpp>
#include <graze/query/manifold.hpp>
#include <graze/shape/any_shape.hpp>

namespace {

using Point = graze::Vec<2, float>;
using Circle = graze::Sphere<2, float>;
using Capsule = graze::Capsule<2, float>;
using Aabb = graze::Aabb<2, float>;
using Obb = graze::Obb<2, float>;

// ---- Random shapes of about unit size

class Random {
 public:
  float number(float low, float high) { return std::uniform_real_distribution<float>(low, high)(engine_); }
  Point vector(float size) { return {number(-size, size), number(-size, size)}; }
  Point place() { return vector(0.6F); }

 private:
  std::mt19937 engine_{20261127};
};

void draw(Random& random, Circle& circle) { circle = {random.place(), random.number(0.2F, 0.8F)}; }
void draw(Random& random, Capsule& capsule) {
  capsule.a = random.place();
  capsule.b = capsule.a + random.vector(1);
  capsule.radius = random.number(0.1F, 0.4F);
}
void draw(Random& random, Aabb& box) {
  const Point center = random.place();
  const Point half = abs(random.vector(0.8F)) + 0.01F;
  box = {center - half, center + half};
}
void draw(Random& random, Obb& box) {
  box = {random.place(), abs(random.vector(0.8F)) + 0.01F,
         graze::Mat<2, float>(graze::rotation_matrix(random.number(0, 360)))};
}

template <class A, class B>
std::vector<std::pair<A, B>> meeting_pairs(std::size_t count) {
  std::vector<std::pair<A, B>> pairs;
  Random random;
  while (pairs.size() < count) {
    std::pair<A, B> pair;
    draw(random, pair.first);
    draw(random, pair.second);
    if (intersects(pair.first, pair.second)) pairs.push_back(pair);
  }
  return pairs;
}

// ---- Box2D

b2Vec2 box2d(const Point& v) { return {v.x, v.y}; }

b2CircleShape box2d_shape(const Circle& circle) {
  b2CircleShape shape;
  shape.m_p.SetZero();
  shape.m_radius = circle.radius;
  return shape;
}
b2Transform box2d_pose(const Circle& circle) { return {box2d(circle.center), b2Rot(0)}; }

/// Without the polygon skin of Box2D.
b2PolygonShape box2d_box(const Point& half) {
  b2PolygonShape shape;
  shape.SetAsBox(half.x, half.y);
  shape.m_radius = 0;
  return shape;
}
b2PolygonShape box2d_shape(const Obb& box) { return box2d_box(box.half_extents); }
b2Transform box2d_pose(const Obb& box) {
  b2Transform pose{box2d(box.center), b2Rot(0)};
  pose.q.c = box.axes[0].x;
  pose.q.s = box.axes[0].y;
  return pose;
}
b2PolygonShape box2d_shape(const Aabb& box) { return box2d_box((box.max - box.min) * 0.5F); }
b2Transform box2d_pose(const Aabb& box) { return {box2d((box.min + box.max) * 0.5F), b2Rot(0)}; }

void collide(b2Manifold& manifold, const b2CircleShape& a, const b2Transform& at_a, const b2CircleShape& b,
             const b2Transform& at_b) {
  b2CollideCircles(&manifold, &a, at_a, &b, at_b);
}
void collide(b2Manifold& manifold, const b2PolygonShape& a, const b2Transform& at_a, const b2CircleShape& b,
             const b2Transform& at_b) {
  b2CollidePolygonAndCircle(&manifold, &a, at_a, &b, at_b);
}
void collide(b2Manifold& manifold, const b2PolygonShape& a, const b2Transform& at_a, const b2PolygonShape& b,
             const b2Transform& at_b) {
  b2CollidePolygons(&manifold, &a, at_a, &b, at_b);
}

/// Two shapes in Box2D's form.
template <class A, class B>
class Box2DPair {
 public:
  Box2DPair(const A& a, const B& b)
      : a_(box2d_shape(a)), b_(box2d_shape(b)), at_a_(box2d_pose(a)), at_b_(box2d_pose(b)) {}

  /// The depth of the deepest world point; negative if there is none.
  float find() const {
    b2Manifold manifold;
    collide(manifold, a_, at_a_, b_, at_b_);
    if (manifold.pointCount == 0) return -1;
    b2WorldManifold world;
    world.Initialize(&manifold, at_a_, a_.m_radius, at_b_, b_.m_radius);
    benchmark::DoNotOptimize(world);
    float depth = -world.separations[0];
    if (manifold.pointCount == 2) depth = std::max(depth, -world.separations[1]);
    return depth;
  }

 private:
  decltype(box2d_shape(A())) a_;
  decltype(box2d_shape(B())) b_;
  b2Transform at_a_;
  b2Transform at_b_;
};

// ---- Timing

template <class Item, class Measure>
void time_each(const std::string& name, std::shared_ptr<const std::vector<Item>> items, Measure measure) {
  benchmark::RegisterBenchmark(name.c_str(), [items, measure](benchmark::State& state) {
    for (auto _ : state) {
      for (const Item& item : *items) benchmark::DoNotOptimize(measure(item));
    }
    state.counters["ns"] =
        benchmark::Counter(1e-9 * static_cast<double>(items->size()),
                           benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  });
}

/// All pairs in one call, on one thread.
template <class A, class B>
bool time_batch(const std::string& title, const std::vector<std::pair<A, B>>& pairs) {
  using Any = graze::AnyShape<2, float>;
  const auto shapes = std::make_shared<std::vector<Any>>();
  std::vector<graze::Pair> candidates;
  for (const auto& [a, b] : pairs) {
    const auto place = static_cast<std::uint32_t>(shapes->size());
    shapes->insert(shapes->end(), {a, b});
    candidates.push_back({place, place + 1});
  }
  const auto find = [shapes, candidates] {
    return graze::contacts(std::span<const Any>(*shapes), candidates, {&graze::serial_executor()});
  };
  const auto all = find();
  bool is_right = all.size() == pairs.size();
  for (const auto& found : all) {
    const auto& [a, b] = pairs[found.pair.a / 2];
    is_right = is_right && found.manifold == manifold(a, b);
  }
  benchmark::RegisterBenchmark((title + "/contacts").c_str(), [find, count = pairs.size()](benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(find());
    state.counters["ns"] = benchmark::Counter(
        1e-9 * static_cast<double>(count), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  });
  return is_right;
}

/// Compares, prints, and times Box2D.
template <class A, class B>
bool time_box2d(const std::string& title, const std::vector<std::pair<A, B>>& pairs) {
  constexpr float rounding = 1e-5F;
  const auto copies = std::make_shared<std::vector<Box2DPair<A, B>>>();
  std::size_t none = 0;
  std::size_t less = 0;
  float most = 0;
  for (const auto& [a, b] : pairs) {
    copies->emplace_back(a, b);
    const float ours = contact(a, b)->depth;
    const float theirs = copies->back().find();
    if (theirs < 0 && ours > rounding) ++none;
    if (theirs >= 0 && theirs < ours - rounding) ++less;
    if (theirs >= 0) most = std::max(most, theirs - ours);
  }
  std::printf("%s: Box2D finds %zu of %zu not, %zu less deep than graze, none by more than %.1e deeper\n",
              title.c_str(), none, pairs.size(), less, static_cast<double>(most));
  time_each<Box2DPair<A, B>>(title + "/Box2D", copies, [](const auto& pair) { return pair.find(); });
  return none == 0 && less == 0;
}

template <class A, class B>
bool register_pairs(const std::string& name) {
  bool is_right = true;
  for (const std::size_t count : {1024U, 16384U}) {
    using Pair = std::pair<A, B>;
    const auto pairs = std::make_shared<std::vector<Pair>>(meeting_pairs<A, B>(count));
    const std::string title = (count > 1024 ? "many: " : "") + name;
    time_each<Pair>(title + "/contact", pairs, [](const Pair& pair) { return contact(pair.first, pair.second); });
    time_each<Pair>(title + "/manifold", pairs, [](const Pair& pair) { return manifold(pair.first, pair.second); });
    is_right &= time_batch(title, *pairs);
    if constexpr (requires { box2d_shape(A()), box2d_shape(B()); }) is_right &= time_box2d(title, *pairs);
  }
  return is_right;
}

}  // namespace

int main(int argc, char** argv) {
  bool is_right = register_pairs<Circle, Circle>("circle, circle");
  is_right &= register_pairs<Aabb, Circle>("aabb, circle");
  is_right &= register_pairs<Obb, Circle>("obb, circle");
  is_right &= register_pairs<Aabb, Aabb>("aabb, aabb");
  is_right &= register_pairs<Aabb, Obb>("aabb, obb");
  is_right &= register_pairs<Obb, Obb>("obb, obb");
  is_right &= register_pairs<Circle, Capsule>("circle, capsule");
  is_right &= register_pairs<Capsule, Capsule>("capsule, capsule");
  is_right &= register_pairs<Aabb, Capsule>("aabb, capsule");
  is_right &= register_pairs<Obb, Capsule>("obb, capsule");
  if (!is_right) {
    std::fprintf(stderr,
                 "flat_contact: contacts are not those of single calls, or Box2D's depth is less than the least\n");
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return is_right ? 0 : 1;
}
