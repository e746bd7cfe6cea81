// SPDX-License-Identifier: MIT
// ray_cast against each primitive in 3D, with point and normal, beside Bullet (float): its own tests of a ray against a
// box along the axes and a triangle, and its convex cast, which is what it has for all others. About one random ray in
// three hits, and all are in cache. A thousand rays, cast again and again, are so few that the processor learns by
// heart what each branch does; of many that it guesses wrong as often as in a program that never casts the same ray
// twice. Bullet's answers are compared with graze's before anything is timed, and the differences are printed.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCapsuleShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/NarrowPhaseCollision/btRaycastCallback.h>
#include <BulletCollision/NarrowPhaseCollision/btSubSimplexConvexCast.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>
#include <LinearMath/btAabbUtil2.h>
#include <benchmark/benchmark.h>

#include <graze/math/pose.hpp>
#include <graze/query/ray_cast.hpp>

namespace {

using graze::Dim;
using graze::Mat;
using graze::Vec;

constexpr std::size_t few_rays = 1024;
constexpr std::size_t many_rays = 16384;
constexpr float t_max = 2;

// ---- Random shapes of about unit size about the origin, and rays from outside towards them

class Random {
 public:
  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }

  Vec<3, double> vector(double size) { return {number(-size, size), number(-size, size), number(-size, size)}; }

  /// Of at least a tenth of the size.
  Vec<3, double> way(double size) {
    Vec<3, double> v = vector(size);
    while (dot(v, v) < 0.01 * size * size) v = vector(size);
    return v;
  }

 private:
  std::mt19937 engine_{20261122};
};

template <class T>
void draw(Random& random, graze::Ray<3, T>& ray) {
  const Vec<3, double> way = random.way(1);
  const Vec<3, double> origin = way * (3 / std::sqrt(dot(way, way)));
  ray = {Vec<3, T>(origin), Vec<3, T>(random.vector(1) - origin)};
}
template <class T>
void draw(Random& random, graze::Sphere<3, T>& sphere) {
  sphere = {Vec<3, T>(random.vector(1)), static_cast<T>(random.number(0.3, 1))};
}
template <class T>
void draw(Random& random, graze::Aabb<3, T>& box) {
  box = graze::Aabb<3, T>::from_center(Vec<3, T>(random.vector(1)), Vec<3, T>(abs(random.way(1))));
}
template <class T>
void draw(Random& random, graze::Obb<3, T>& box) {
  const Mat<3, double> rotation = graze::rotation_matrix(random.way(1), random.number(0, 360));
  box = {Vec<3, T>(random.vector(1)), Vec<3, T>(abs(random.way(1))), {}};
  for (Dim i = 0; i < 3; ++i) box.axes[i] = Vec<3, T>(rotation[i]);
}
template <class T>
void draw(Random& random, graze::Plane<3, T>& plane) {
  plane = {Vec<3, T>(random.way(1)), static_cast<T>(random.number(-0.5, 0.5))};
}
template <class T>
void draw(Random& random, graze::HalfSpace<3, T>& solid) {
  solid = {Vec<3, T>(random.way(1)), static_cast<T>(random.number(-0.5, 0.5))};
}
template <class T>
void draw(Random& random, graze::Triangle<3, T>& triangle) {
  triangle = {Vec<3, T>(random.vector(1.5)), Vec<3, T>(random.vector(1.5)), Vec<3, T>(random.vector(1.5))};
}
template <class T>
void draw(Random& random, graze::Capsule<3, T>& capsule) {
  const Vec<3, double> a = random.vector(1);
  capsule = {Vec<3, T>(a), Vec<3, T>(a + random.way(1)), static_cast<T>(random.number(0.2, 0.6))};
}
template <class T>
void draw(Random& random, graze::Polytope<3, T>& polytope) {
  std::vector<Vec<3, T>> points(32);
  for (Vec<3, T>& point : points) {
    const Vec<3, double> way = random.way(1);
    point = Vec<3, T>(way / std::sqrt(dot(way, way)));
  }
  polytope = graze::convex_hull<3, T>(points);
}

/// A ray and a shape, and where graze says that they meet.
template <class S>
struct Work {
  using T = graze::scalar_of<S>;

  struct Case {
    S shape;
    graze::Ray<3, T> ray;
  };

  explicit Work(std::size_t count) : cases(count) {
    Random random;
    for (Case& one : cases) {
      draw(random, one.shape);
      draw(random, one.ray);
      answers.push_back(graze::ray_cast(one.shape, one.ray, static_cast<T>(t_max)));
      if (answers.back()) ++hits;
    }
  }

  std::vector<Case> cases;
  std::vector<std::optional<graze::RayHit<3, T>>> answers;
  std::size_t hits = 0;
};

// ---- The same for Bullet: from the origin to the ray's point at t_max, a hit is a fraction of that way

btVector3 bullet(const Vec<3, float>& v) { return {v.x, v.y, v.z}; }

struct BulletRay {
  btVector3 from;
  btVector3 to;
};

struct BulletHit {
  btVector3 normal{0, 0, 0};
  btScalar fraction = 1;
};

/// A convex shape, at rest, and a point that is cast against it, as Bullet's ray tests do.
struct BulletConvex {
  std::shared_ptr<btConvexShape> geometry;
  btTransform pose = btTransform::getIdentity();

  std::optional<BulletHit> cast(const BulletRay& ray) const {
    static btSphereShape point = [] {
      btSphereShape sphere(0);
      sphere.setMargin(0);
      return sphere;
    }();
    btVoronoiSimplexSolver simplex;
    btSubsimplexConvexCast caster(&point, geometry.get(), &simplex);
    btConvexCast::CastResult result;
    result.m_fraction = 1;
    btTransform from = btTransform::getIdentity();
    btTransform to = btTransform::getIdentity();
    from.setOrigin(ray.from);
    to.setOrigin(ray.to);
    if (!caster.calcTimeOfImpact(from, to, pose, pose, result)) return std::nullopt;
    return BulletHit{result.m_normal, result.m_fraction};
  }
};

struct BulletBox {
  btVector3 min;
  btVector3 max;

  std::optional<BulletHit> cast(const BulletRay& ray) const {
    BulletHit hit;
    if (!btRayAabb(ray.from, ray.to, min, max, hit.fraction, hit.normal)) return std::nullopt;
    return hit;
  }
};

struct BulletTriangle {
  std::array<btVector3, 3> corners;

  struct Callback : btTriangleRaycastCallback {
    using btTriangleRaycastCallback::btTriangleRaycastCallback;
    btScalar reportHit(const btVector3& normal, btScalar fraction, int, int) override {
      hit = BulletHit{normal, fraction};
      return fraction;
    }
    std::optional<BulletHit> hit;
  };

  std::optional<BulletHit> cast(const BulletRay& ray) const {
    Callback callback(ray.from, ray.to);
    std::array<btVector3, 3> copy = corners;  // processTriangle takes them by a pointer to non-const
    callback.processTriangle(copy.data(), 0, 0);
    return callback.hit;
  }
};

BulletConvex bullet(const graze::Sphere<3, float>& sphere) {
  BulletConvex shape{std::make_shared<btSphereShape>(sphere.radius)};
  shape.pose.setOrigin(bullet(sphere.center));
  return shape;
}
BulletBox bullet(const graze::Aabb<3, float>& box) { return {bullet(box.min), bullet(box.max)}; }
BulletConvex bullet(const graze::Obb<3, float>& box) {
  BulletConvex shape{std::make_shared<btBoxShape>(bullet(box.half_extents))};
  const auto& m = box.axes;
  shape.pose.setBasis(btMatrix3x3(m[0].x, m[1].x, m[2].x, m[0].y, m[1].y, m[2].y, m[0].z, m[1].z, m[2].z));
  shape.pose.setOrigin(bullet(box.center));
  return shape;
}
BulletTriangle bullet(const graze::Triangle<3, float>& triangle) {
  return {{bullet(triangle.a), bullet(triangle.b), bullet(triangle.c)}};
}
/// Bullet's capsules stand along y.
BulletConvex bullet(const graze::Capsule<3, float>& capsule) {
  const btVector3 way = bullet(capsule.b - capsule.a);
  BulletConvex shape{std::make_shared<btCapsuleShape>(capsule.radius, way.length())};
  shape.pose.setRotation(shortestArcQuat(btVector3(0, 1, 0), way.normalized()));
  shape.pose.setOrigin(bullet(capsule.a) + way * 0.5F);
  return shape;
}
BulletConvex bullet(const graze::Polytope<3, float>& polytope) {
  auto hull = std::make_shared<btConvexHullShape>();
  for (const Vec<3, float>& vertex : polytope.vertices()) hull->addPoint(bullet(vertex), false);
  hull->setMargin(0);
  hull->recalcLocalAabb();
  return {hull};
}

// ---- Timing

void count_rays(benchmark::State& state, std::size_t count) {
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(count));
  state.counters["ns"] = benchmark::Counter(
      1e-9 * static_cast<double>(count), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

template <class S>
void time_graze(const std::string& name, std::shared_ptr<const Work<S>> work) {
  benchmark::RegisterBenchmark(name.c_str(), [work](benchmark::State& state) {
    constexpr auto end = static_cast<typename Work<S>::T>(t_max);
    for (auto _ : state) {
      for (const auto& [shape, ray] : work->cases) benchmark::DoNotOptimize(graze::ray_cast(shape, ray, end));
    }
    count_rays(state, work->cases.size());
  });
}

template <class S>
void time_bullet(const std::string& name, const Work<S>& work) {
  using Peer = decltype(bullet(work.cases[0].shape));
  auto cases = std::make_shared<std::vector<std::pair<Peer, BulletRay>>>();
  std::size_t differing = 0;
  double farthest = 0;
  for (std::size_t i = 0; i < work.cases.size(); ++i) {
    const auto& [shape, ray] = work.cases[i];
    cases->emplace_back(bullet(shape), BulletRay{bullet(ray.origin), bullet(ray.origin + ray.direction * t_max)});
    const std::optional<BulletHit> hit = cases->back().first.cast(cases->back().second);
    if (hit.has_value() != work.answers[i].has_value()) ++differing;
    if (!hit || !work.answers[i]) continue;
    farthest = std::max(farthest, std::fabs(static_cast<double>(hit->fraction * t_max - work.answers[i]->t)));
  }
  std::printf("%s: %zu of %zu rays hit for one and miss for the other, t differs by up to %.1e\n", name.c_str(),
              differing, work.cases.size(), farthest);
  benchmark::RegisterBenchmark(name.c_str(), [cases](benchmark::State& state) {
    for (auto _ : state) {
      for (const auto& [shape, ray] : *cases) benchmark::DoNotOptimize(shape.cast(ray));
    }
    count_rays(state, cases->size());
  });
}

template <template <Dim, class> class S>
void register_shape(const std::string& shape, std::size_t rays) {
  const auto in_float = std::make_shared<const Work<S<3, float>>>(rays);
  const auto in_double = std::make_shared<const Work<S<3, double>>>(rays);
  const std::string hits =
      " (" + std::to_string(rays) + " rays, " + std::to_string(100 * in_double->hits / rays) + " % hits)";
  time_graze<S<3, float>>(shape + hits + "/graze/float", in_float);
  time_graze<S<3, double>>(shape + hits + "/graze/double", in_double);
  if constexpr (requires { bullet(in_float->cases[0].shape); }) time_bullet(shape + hits + "/Bullet/float", *in_float);
}

}  // namespace

int main(int argc, char** argv) {
  for (const std::size_t rays : {few_rays, many_rays}) {
    register_shape<graze::Sphere>("sphere", rays);
    register_shape<graze::Aabb>("aabb", rays);
    register_shape<graze::Obb>("obb", rays);
    register_shape<graze::Capsule>("capsule", rays);
    register_shape<graze::Triangle>("triangle", rays);
    register_shape<graze::Plane>("plane", rays);
    register_shape<graze::HalfSpace>("half-space", rays);
  }
  register_shape<graze::Polytope>("polytope, 32 corners", few_rays);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
