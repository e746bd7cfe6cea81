// SPDX-License-Identifier: MIT
// Single queries: `intersects` for pairs of primitives in 3D, compared with FCL (double), Bullet (float) and, for
// oriented boxes, the textbook separating-axis test in float; and the point queries of each primitive. A thousand
// random pairs each, in cache. Every peer's answers are compared with graze's before timing; a peer that disagrees is
// reported by name, with the count.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCapsuleShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/CollisionShapes/btTriangleShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpa2.h>
#include <benchmark/benchmark.h>
#include <fcl/narrowphase/collision.h>

#include <graze/math/pose.hpp>
#include <graze/query/closest_boundary_point.hpp>
#include <graze/query/closest_point.hpp>
#include <graze/query/contains.hpp>
#include <graze/query/intersects.hpp>
#include <graze/query/signed_distance.hpp>

#include "../tests/exam/textbook.hpp"

namespace {

using graze::Dim;
using graze::Mat;
using graze::Vec;

constexpr std::size_t pair_count = 1024;

// ---- Random shapes of about unit size

class Random {
 public:
  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }

  Vec<3, double> vector(double size) { return {number(-size, size), number(-size, size), number(-size, size)}; }

  Mat<3, double> rotation() {
    Vec<3, double> axis = vector(1);
    while (dot(axis, axis) > 1 || dot(axis, axis) < 0.01) axis = vector(1);
    return graze::rotation_matrix(axis / std::sqrt(dot(axis, axis)), number(0, 360));
  }

 private:
  std::mt19937 engine_{20261121};
};

template <class T>
Mat<3, T> narrow(const Mat<3, double>& m) {
  Mat<3, T> result;
  for (Dim i = 0; i < 3; ++i) result[i] = Vec<3, T>(m[i]);
  return result;
}

template <class T>
void draw(Random& random, Vec<3, T>& point) {
  point = Vec<3, T>(random.vector(0.9));
}
template <class T>
void draw(Random& random, graze::Segment<3, T>& segment) {
  const Vec<3, double> start = random.vector(0.8);
  segment = {Vec<3, T>(start), Vec<3, T>(start + random.vector(1.5))};
}
template <class T>
void draw(Random& random, graze::Ray<3, T>& ray) {
  ray = {Vec<3, T>(random.vector(2)), Vec<3, T>(random.vector(1))};
}
template <class T>
void draw(Random& random, graze::Sphere<3, T>& sphere) {
  sphere = {Vec<3, T>(random.vector(1)), static_cast<T>(random.number(0.3, 1))};
}
template <class T>
void draw(Random& random, graze::Aabb<3, T>& box) {
  box = graze::Aabb<3, T>::from_center(Vec<3, T>(random.vector(1)), Vec<3, T>(abs(random.vector(1))));
}
template <class T>
void draw(Random& random, graze::Obb<3, T>& box) {
  box = {Vec<3, T>(random.vector(1)), Vec<3, T>(abs(random.vector(1))), narrow<T>(random.rotation())};
}
template <class T>
void draw(Random& random, graze::Triangle<3, T>& triangle) {
  const Vec<3, double> a = random.vector(0.7);
  triangle = {Vec<3, T>(a), Vec<3, T>(a + random.vector(1.5)), Vec<3, T>(a + random.vector(1.5))};
}
template <class T>
void draw(Random& random, graze::Capsule<3, T>& capsule) {
  const Vec<3, double> a = random.vector(1);
  capsule = {Vec<3, T>(a), Vec<3, T>(a + random.vector(1)), static_cast<T>(random.number(0.2, 0.6))};
}
template <class T>
void draw(Random& random, graze::Plane<3, T>& plane) {
  plane = {Vec<3, T>(random.vector(1)), static_cast<T>(random.number(-0.5, 0.5))};
}
template <class T>
void draw(Random& random, graze::HalfSpace<3, T>& solid) {
  solid = {Vec<3, T>(random.vector(1)), static_cast<T>(random.number(-0.5, 0.5))};
}

/// The pairs, and graze's answers.
template <class A, class B>
struct Work {
  std::vector<std::pair<A, B>> pairs = std::vector<std::pair<A, B>>(pair_count);
  std::vector<bool> answers;

  Work() {
    Random random;
    for (auto& [a, b] : pairs) {
      draw(random, a);
      draw(random, b);
      answers.push_back(intersects(a, b));
    }
  }

  std::size_t hits() const { return static_cast<std::size_t>(std::count(answers.begin(), answers.end(), true)); }
};

// ---- The same shapes for the peers

struct FclShape {
  std::shared_ptr<fcl::CollisionGeometryd> geometry;
  fcl::Transform3d pose = fcl::Transform3d::Identity();
};

fcl::Vector3d fcl_vector(const Vec<3, double>& v) { return {v.x, v.y, v.z}; }

FclShape fcl_shape(const graze::Sphere<3, double>& sphere) {
  FclShape shape{std::make_shared<fcl::Sphered>(sphere.radius)};
  shape.pose.translation() = fcl_vector(sphere.center);
  return shape;
}

FclShape fcl_shape(const graze::Obb<3, double>& box) {
  const Vec<3, double> sides = 2.0 * box.half_extents;
  FclShape shape{std::make_shared<fcl::Boxd>(fcl_vector(sides))};
  for (Dim i = 0; i < 3; ++i) shape.pose.linear().col(static_cast<int>(i)) = fcl_vector(box.axes[i]);
  shape.pose.translation() = fcl_vector(box.center);
  return shape;
}

using FclTriangle = std::array<fcl::Vector3d, 3>;

FclTriangle fcl_shape(const graze::Triangle<3, double>& triangle) {
  return {fcl_vector(triangle.a), fcl_vector(triangle.b), fcl_vector(triangle.c)};
}

/// FCL's capsules are parallel to z.
FclShape fcl_shape(const graze::Capsule<3, double>& capsule) {
  const fcl::Vector3d way = fcl_vector(capsule.b - capsule.a);
  FclShape shape{std::make_shared<fcl::Capsuled>(capsule.radius, way.norm())};
  shape.pose.linear() = Eigen::Quaterniond::FromTwoVectors(fcl::Vector3d::UnitZ(), way).toRotationMatrix();
  shape.pose.translation() = 0.5 * fcl_vector(capsule.a + capsule.b);
  return shape;
}

bool fcl_intersects(const FclShape& a, const FclShape& b) {
  static const fcl::CollisionRequestd request;
  fcl::CollisionResultd result;
  return fcl::collide(a.geometry.get(), a.pose, b.geometry.get(), b.pose, request, result) > 0;
}

/// FCL supports triangles only as parts of meshes: these are the tests that it runs on them.
bool fcl_intersects(const FclShape& solid, const FclTriangle& triangle) {
  static const fcl::detail::GJKSolver_libccdd solver;
  const auto test = [&](const auto& geometry) {
    return solver.shapeTriangleIntersect(geometry, solid.pose, triangle[0], triangle[1], triangle[2], nullptr, nullptr,
                                         nullptr);
  };
  switch (solid.geometry->getNodeType()) {
    case fcl::GEOM_SPHERE:
      return test(static_cast<const fcl::Sphered&>(*solid.geometry));
    case fcl::GEOM_BOX:
      return test(static_cast<const fcl::Boxd&>(*solid.geometry));
    default:
      return test(static_cast<const fcl::Capsuled&>(*solid.geometry));
  }
}

bool fcl_intersects(const FclTriangle& triangle, const FclShape& solid) { return fcl_intersects(solid, triangle); }

bool fcl_intersects(const FclTriangle& a, const FclTriangle& b) {
  return fcl::detail::Intersectd::intersect_Triangle(a[0], a[1], a[2], b[0], b[1], b[2]);
}

struct BulletShape {
  std::unique_ptr<btConvexShape> geometry;
  btTransform pose = btTransform::getIdentity();
};

btVector3 bullet_vector(const Vec<3, float>& v) { return {v.x, v.y, v.z}; }

BulletShape bullet_shape(const graze::Sphere<3, float>& sphere) {
  BulletShape shape{std::make_unique<btSphereShape>(sphere.radius)};
  shape.pose.setOrigin(bullet_vector(sphere.center));
  return shape;
}

BulletShape bullet_shape(const graze::Obb<3, float>& box) {
  BulletShape shape{std::make_unique<btBoxShape>(bullet_vector(box.half_extents))};
  shape.geometry->setMargin(0);
  const auto& m = box.axes;
  shape.pose.setBasis(btMatrix3x3(m[0].x, m[1].x, m[2].x, m[0].y, m[1].y, m[2].y, m[0].z, m[1].z, m[2].z));
  shape.pose.setOrigin(bullet_vector(box.center));
  return shape;
}

/// The distance of the shapes without their margins; the margin of a sphere is its radius.
bool bullet_intersects(const BulletShape& a, const BulletShape& b) {
  btGjkEpaSolver2::sResults results;
  const btVector3 guess = b.pose.getOrigin() - a.pose.getOrigin();
  if (!btGjkEpaSolver2::Distance(a.geometry.get(), a.pose, b.geometry.get(), b.pose, guess, results)) return true;
  return results.distance <= a.geometry->getMargin() + b.geometry->getMargin();
}

// ---- Timing

void count_pairs(benchmark::State& state, std::size_t pairs) {
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(pairs));
  state.counters["ns"] = benchmark::Counter(
      1e-9 * static_cast<double>(pairs), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// Times `decide(first, second)` for pairs in any form that correspond to the pairs of `work`.
template <class Pairs, class Decide>
void time_pairs(const std::string& name, const std::vector<bool>& answers, std::shared_ptr<const Pairs> pairs,
                Decide decide) {
  std::size_t differing = 0;
  for (std::size_t i = 0; i < pairs->size(); ++i) {
    if (decide((*pairs)[i].first, (*pairs)[i].second) != answers[i]) ++differing;
  }
  if (differing > 0)
    std::printf("%s differs from graze on %zu of %zu pairs\n", name.c_str(), differing, answers.size());
  benchmark::RegisterBenchmark(name.c_str(), [pairs, decide](benchmark::State& state) {
    for (auto _ : state) {
      for (const auto& [a, b] : *pairs) benchmark::DoNotOptimize(decide(a, b));
    }
    count_pairs(state, pairs->size());
  });
}

template <class A, class B>
void time_graze(const std::string& name, const Work<A, B>& work) {
  auto pairs = std::make_shared<const std::vector<std::pair<A, B>>>(work.pairs);
  time_pairs(name, work.answers, pairs, [](const A& a, const B& b) { return intersects(a, b); });
}

template <class A, class B>
void time_fcl(const std::string& name, const Work<A, B>& work) {
  using First = decltype(fcl_shape(work.pairs[0].first));
  using Second = decltype(fcl_shape(work.pairs[0].second));
  auto pairs = std::make_shared<std::vector<std::pair<First, Second>>>();
  for (const auto& [a, b] : work.pairs) pairs->emplace_back(fcl_shape(a), fcl_shape(b));
  time_pairs<std::vector<std::pair<First, Second>>>(
      name, work.answers, pairs, [](const First& a, const Second& b) { return fcl_intersects(a, b); });
}

template <class A, class B>
void time_bullet(const std::string& name, const Work<A, B>& work) {
  auto pairs = std::make_shared<std::vector<std::pair<BulletShape, BulletShape>>>();
  for (const auto& [a, b] : work.pairs) pairs->emplace_back(bullet_shape(a), bullet_shape(b));
  time_pairs<std::vector<std::pair<BulletShape, BulletShape>>>(name, work.answers, pairs, bullet_intersects);
}

template <template <Dim, class> class A, template <Dim, class> class B>
void register_pair(const std::string& pair) {
  const Work<A<3, float>, B<3, float>> in_float;
  const Work<A<3, double>, B<3, double>> in_double;
  const std::string hits = " (" + std::to_string(100 * in_double.hits() / pair_count) + " % hits)";
  time_graze(pair + hits + "/graze/float", in_float);
  time_graze(pair + hits + "/graze/double", in_double);
  if constexpr (requires { fcl_shape(in_double.pairs[0].first), fcl_shape(in_double.pairs[0].second); }) {
    time_fcl(pair + hits + "/FCL/double", in_double);
  }
  if constexpr (requires { bullet_shape(in_float.pairs[0].first), bullet_shape(in_float.pairs[0].second); }) {
    time_bullet(pair + hits + "/Bullet/float", in_float);
  }
  if constexpr (std::is_same_v<A<3, float>, graze::Obb<3, float>> && std::is_same_v<B<3, float>, A<3, float>>) {
    const auto plain = [](const auto& a, const auto& b) { return graze::exam::textbook::meet(a, b); };
    auto pairs = std::make_shared<const std::vector<std::pair<A<3, float>, B<3, float>>>>(in_float.pairs);
    time_pairs(pair + hits + "/plain/float", in_float.answers, pairs, plain);
  }
}

/// Times `query(shape, point)`, without comparison.
template <class S, class Query>
void time_query(const std::string& name, const std::shared_ptr<const Work<S, graze::Vec<3, graze::scalar_of<S>>>>& work,
                Query query) {
  benchmark::RegisterBenchmark(name.c_str(), [work, query](benchmark::State& state) {
    for (auto _ : state) {
      for (const auto& [shape, point] : work->pairs) benchmark::DoNotOptimize(query(shape, point));
    }
    count_pairs(state, work->pairs.size());
  });
}

template <class S>
void register_point_queries(const std::string& shape, const std::string& number) {
  const auto work = std::make_shared<const Work<S, graze::Vec<3, graze::scalar_of<S>>>>();
  const std::string end = "(" + shape + ", point)/graze/" + number;
  time_query<S>("contains" + end, work, [](const auto& s, const auto& p) { return contains(s, p); });
  time_query<S>("closest_point" + end, work, [](const auto& s, const auto& p) { return closest_point(s, p); });
  time_query<S>("closest_boundary_point" + end, work,
                [](const auto& s, const auto& p) { return closest_boundary_point(s, p); });
  time_query<S>("signed_distance" + end, work, [](const auto& s, const auto& p) { return signed_distance(s, p); });
}

template <template <Dim, class> class S>
void register_point(const std::string& shape) {
  register_point_queries<S<3, float>>(shape, "float");
  register_point_queries<S<3, double>>(shape, "double");
}

}  // namespace

int main(int argc, char** argv) {
  using namespace graze;
  register_pair<Vec, Sphere>("point, sphere");
  register_pair<Vec, Aabb>("point, aabb");
  register_pair<Sphere, Sphere>("sphere, sphere");
  register_pair<Sphere, Aabb>("sphere, aabb");
  register_pair<Aabb, Aabb>("aabb, aabb");
  register_pair<Sphere, Obb>("sphere, obb");
  register_pair<Sphere, Capsule>("sphere, capsule");
  register_pair<Sphere, Plane>("sphere, plane");
  register_pair<Sphere, Triangle>("sphere, triangle");
  register_pair<Segment, Segment>("segment, segment");
  register_pair<Segment, Sphere>("segment, sphere");
  register_pair<Segment, Aabb>("segment, aabb");
  register_pair<Segment, Obb>("segment, obb");
  register_pair<Segment, Triangle>("segment, triangle");
  register_pair<Ray, Sphere>("ray, sphere");
  register_pair<Ray, Aabb>("ray, aabb");
  register_pair<Ray, Obb>("ray, obb");
  register_pair<Ray, Triangle>("ray, triangle");
  register_pair<Aabb, Obb>("aabb, obb");
  register_pair<Aabb, Plane>("aabb, plane");
  register_pair<Aabb, Triangle>("aabb, triangle");
  register_pair<Aabb, Capsule>("aabb, capsule");
  register_pair<Obb, Obb>("obb, obb");
  register_pair<Obb, Plane>("obb, plane");
  register_pair<Obb, Triangle>("obb, triangle");
  register_pair<Obb, Capsule>("obb, capsule");
  register_pair<Triangle, Triangle>("triangle, triangle");
  register_pair<Triangle, Capsule>("triangle, capsule");
  register_pair<Capsule, Capsule>("capsule, capsule");
  register_pair<Vec, Obb>("point, obb");
  register_pair<Vec, Plane>("point, plane");
  register_pair<Vec, Triangle>("point, triangle");
  register_pair<Vec, Capsule>("point, capsule");
  register_pair<Segment, Ray>("segment, ray");
  register_pair<Segment, Plane>("segment, plane");
  register_pair<Segment, Capsule>("segment, capsule");
  register_pair<Ray, Ray>("ray, ray");
  register_pair<Ray, Plane>("ray, plane");
  register_pair<Ray, Capsule>("ray, capsule");
  register_pair<Sphere, HalfSpace>("sphere, half-space");
  register_pair<Aabb, HalfSpace>("aabb, half-space");
  register_pair<Obb, HalfSpace>("obb, half-space");
  register_pair<Plane, Plane>("plane, plane");
  register_pair<Plane, Triangle>("plane, triangle");
  register_pair<Plane, Capsule>("plane, capsule");
  register_point<Segment>("segment");
  register_point<Ray>("ray");
  register_point<Sphere>("sphere");
  register_point<Aabb>("aabb");
  register_point<Obb>("obb");
  register_point<Plane>("plane");
  register_point<HalfSpace>("half-space");
  register_point<Triangle>("triangle");
  register_point<Capsule>("capsule");
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
