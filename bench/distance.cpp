// SPDX-License-Identifier: MIT
// Compares closest_points for pairs of bounded primitives in 3D with FCL's distance with nearest points (double). A
// thousand random pairs each, at most one in four of them overlapping, all in cache. FCL's answers are compared with
// graze's before timing, and the largest difference on pairs that are apart is printed.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>
#include <fcl/narrowphase/distance.h>

#include <graze/math/pose.hpp>
#include <graze/query/closest_points.hpp>

namespace {

using graze::Dim;
using graze::Mat;
using graze::Vec;

constexpr std::size_t pair_count = 1024;

// ---- Random shapes of about unit size, at most `spread` from the origin

class Random {
 public:
  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }

  Vec<3, double> vector(double size) { return {number(-size, size), number(-size, size), number(-size, size)}; }

  Vec<3, double> place() { return vector(2); }

  Mat<3, double> rotation() {
    Vec<3, double> axis = vector(1);
    while (dot(axis, axis) > 1 || dot(axis, axis) < 0.01) axis = vector(1);
    return graze::rotation_matrix(axis, number(0, 360));
  }

 private:
  std::mt19937 engine_{20261121};
};

using Point = Vec<3, double>;
using Segment = graze::Segment<3, double>;
using Ray = graze::Ray<3, double>;
using Sphere = graze::Sphere<3, double>;
using Aabb = graze::Aabb<3, double>;
using Obb = graze::Obb<3, double>;
using Plane = graze::Plane<3, double>;
using Triangle = graze::Triangle<3, double>;
using Capsule = graze::Capsule<3, double>;
using Polytope = graze::Polytope<3, double>;

void draw(Random& random, Point& point) { point = random.place(); }
void draw(Random& random, Segment& segment) {
  segment.start = random.place();
  segment.end = segment.start + random.vector(1);
}
void draw(Random& random, Ray& ray) { ray = {random.place(), random.vector(1)}; }
void draw(Random& random, Sphere& sphere) { sphere = {random.place(), random.number(0.2, 0.8)}; }
void draw(Random& random, Aabb& box) { box = Aabb::from_center(random.place(), abs(random.vector(0.8))); }
void draw(Random& random, Obb& box) { box = {random.place(), abs(random.vector(0.8)), random.rotation()}; }
void draw(Random& random, Plane& plane) { plane = {random.vector(1), random.number(-2, 2)}; }
void draw(Random& random, Triangle& triangle) {
  triangle.a = random.place();
  triangle.b = triangle.a + random.vector(1);
  triangle.c = triangle.a + random.vector(1);
}
void draw(Random& random, Capsule& capsule) {
  capsule.a = random.place();
  capsule.b = capsule.a + random.vector(1);
  capsule.radius = random.number(0.1, 0.4);
}

/// A hull of this many points on a sphere.
template <std::size_t Count>
struct HullOf {
  Polytope shape;
};

template <std::size_t Count>
void draw(Random& random, HullOf<Count>& hull) {
  const Point center = random.place();
  std::vector<Point> points;
  for (std::size_t i = 0; i < Count; ++i) {
    const Point way = random.vector(1);
    points.push_back(center + way * (0.7 / std::sqrt(dot(way, way))));
  }
  hull.shape = graze::convex_hull<3, double>(points);
}

template <class S>
const S& shape_of(const S& shape) {
  return shape;
}
template <std::size_t Count>
const Polytope& shape_of(const HullOf<Count>& hull) {
  return hull.shape;
}

// ---- The same shapes for FCL

struct FclShape {
  std::shared_ptr<fcl::CollisionGeometryd> geometry;
  fcl::Transform3d pose = fcl::Transform3d::Identity();
};

fcl::Vector3d fcl_vector(const Point& v) { return {v.x, v.y, v.z}; }

FclShape fcl_shape(const Sphere& sphere) {
  FclShape shape{std::make_shared<fcl::Sphered>(sphere.radius)};
  shape.pose.translation() = fcl_vector(sphere.center);
  return shape;
}

FclShape fcl_shape(const Obb& box) {
  FclShape shape{std::make_shared<fcl::Boxd>(fcl_vector(2.0 * box.half_extents))};
  for (Dim i = 0; i < 3; ++i) shape.pose.linear().col(static_cast<int>(i)) = fcl_vector(box.axes[i]);
  shape.pose.translation() = fcl_vector(box.center);
  return shape;
}

/// FCL's capsules are parallel to z.
FclShape fcl_shape(const Capsule& capsule) {
  const fcl::Vector3d way = fcl_vector(capsule.b - capsule.a);
  FclShape shape{std::make_shared<fcl::Capsuled>(capsule.radius, way.norm())};
  shape.pose.linear() = Eigen::Quaterniond::FromTwoVectors(fcl::Vector3d::UnitZ(), way).toRotationMatrix();
  shape.pose.translation() = 0.5 * fcl_vector(capsule.a + capsule.b);
  return shape;
}

double fcl_distance(const FclShape& a, const FclShape& b) {
  static const fcl::DistanceRequestd request(true);  // with nearest points
  fcl::DistanceResultd result;
  return std::max(0.0, fcl::distance(a.geometry.get(), a.pose, b.geometry.get(), b.pose, request, result));
}

// ---- Timing

template <class Pairs, class Measure>
void time_pairs(const std::string& name, std::shared_ptr<const Pairs> pairs, Measure measure) {
  benchmark::RegisterBenchmark(name.c_str(), [pairs, measure](benchmark::State& state) {
    for (auto _ : state) {
      for (const auto& [a, b] : *pairs) benchmark::DoNotOptimize(measure(a, b));
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(pairs->size()));
    state.counters["ns"] =
        benchmark::Counter(1e-9 * static_cast<double>(pairs->size()),
                           benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  });
}

template <class A, class B>
void time_fcl(const std::string& name, const std::vector<std::pair<A, B>>& pairs) {
  auto copies = std::make_shared<std::vector<std::pair<FclShape, FclShape>>>();
  double worst = 0;
  for (const auto& [a, b] : pairs) {
    copies->emplace_back(fcl_shape(a), fcl_shape(b));
    const double ours = closest_points(a, b).distance;
    if (ours > 0) worst = std::max(worst, std::fabs(ours - fcl_distance(copies->back().first, copies->back().second)));
  }
  std::printf("%s differs from graze by %.1e at most\n", name.c_str(), worst);
  time_pairs<std::vector<std::pair<FclShape, FclShape>>>(name, copies, fcl_distance);
}

template <class A, class B>
void register_pair(const std::string& name) {
  auto pairs = std::make_shared<std::vector<std::pair<A, B>>>(pair_count);
  Random random;
  std::size_t hits = 0;
  for (auto& [a, b] : *pairs) {
    draw(random, a);
    draw(random, b);
    if (closest_points(shape_of(a), shape_of(b)).distance == 0) ++hits;
  }
  const std::string title = name + " (" + std::to_string(100 * hits / pair_count) + " % hits)";
  time_pairs<std::vector<std::pair<A, B>>>(
      title + "/graze", pairs, [](const A& a, const B& b) { return closest_points(shape_of(a), shape_of(b)); });
  if constexpr (requires { fcl_shape((*pairs)[0].first), fcl_shape((*pairs)[0].second); }) {
    time_fcl(title + "/FCL", *pairs);
  }
}

}  // namespace

int main(int argc, char** argv) {
  register_pair<Point, Triangle>("point, triangle");
  register_pair<Sphere, Sphere>("sphere, sphere");
  register_pair<Sphere, Obb>("sphere, obb");
  register_pair<Sphere, Capsule>("sphere, capsule");
  register_pair<Segment, Segment>("segment, segment");
  register_pair<Segment, Triangle>("segment, triangle");
  register_pair<Segment, Obb>("segment, obb");
  register_pair<Ray, Triangle>("ray, triangle");
  register_pair<Aabb, Aabb>("aabb, aabb");
  register_pair<Aabb, Obb>("aabb, obb");
  register_pair<Obb, Obb>("obb, obb");
  register_pair<Obb, Plane>("obb, plane");
  register_pair<Obb, Triangle>("obb, triangle");
  register_pair<Obb, Capsule>("obb, capsule");
  register_pair<Triangle, Triangle>("triangle, triangle");
  register_pair<Triangle, Capsule>("triangle, capsule");
  register_pair<Capsule, Capsule>("capsule, capsule");
  register_pair<HullOf<8>, HullOf<8>>("hull of 8, hull of 8");
  register_pair<HullOf<64>, HullOf<64>>("hull of 64, hull of 64");
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
