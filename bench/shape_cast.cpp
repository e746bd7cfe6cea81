// SPDX-License-Identifier: MIT
// Compares shape_cast and time_of_impact in 3D (double) with Bullet's btGjkConvexCast and btContinuousConvexCollision
// (float) and FCL's conservative advancement (double). A thousand random pairs each, all in cache: a moves past b or
// into it, without rotation or rotating by up to 40 degrees. Before timing, every answer is tested by the distance of
// the shapes at that time: for graze, depth and gap must be within its error; for the others, the largest gap and depth
// are printed. Bullet stops 1e-3 before contact, FCL at the requested distance, here 1e-6; both miss some hits, and
// each may be wrong as often as Allowance states. Otherwise the program fails.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
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
#include <BulletCollision/NarrowPhaseCollision/btContinuousConvexCollision.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkConvexCast.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>
#include <benchmark/benchmark.h>
#include <fcl/narrowphase/continuous_collision.h>

#include <graze/math/motion.hpp>
#include <graze/math/pose.hpp>
#include <graze/query/closest_points.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/intersects.hpp>
#include <graze/query/shape_cast.hpp>
#include <graze/query/time_of_impact.hpp>
#include <graze/query/transformed.hpp>

#include "ratios.hpp"

namespace {

using graze::Dim;
using graze::Mat;
using graze::Pose;
using graze::Vec;

constexpr std::size_t pair_count = 1024;

using Point = Vec<3, double>;
using Motion = graze::Motion<3, double>;
using Sphere = graze::Sphere<3, double>;
using Obb = graze::Obb<3, double>;
using Capsule = graze::Capsule<3, double>;
using Polytope = graze::Polytope<3, double>;

const Motion rest;

// ---- Random shapes of about unit size, and their motions

class Random {
 public:
  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }

  Point vector(double size) { return {number(-size, size), number(-size, size), number(-size, size)}; }

  Point direction() {
    Point way = vector(1);
    while (dot(way, way) > 1 || dot(way, way) < 0.01) way = vector(1);
    return way / std::sqrt(dot(way, way));
  }

  Mat<3, double> rotation() { return graze::rotation_matrix(direction(), number(0, 360)); }

 private:
  std::mt19937 engine_{20261122};
};

/// A shape for another library: one at its own origin, and its pose.
template <class S>
struct Placed {
  S shape;  ///< In world coordinates.
  Pose<3, double> pose;
};

template <class S>
Placed<S> draw(Random& random, const Point& center);

template <>
Placed<Sphere> draw(Random& random, const Point& center) {
  return {{center, random.number(0.2, 0.8)}, {random.rotation(), center}};
}
template <>
Placed<Obb> draw(Random& random, const Point& center) {
  const Mat<3, double> axes = random.rotation();
  return {{center, abs(random.vector(0.8)) + 0.05, axes}, {axes, center}};
}
/// Capsules are parallel to the z axis of their pose.
template <>
Placed<Capsule> draw(Random& random, const Point& center) {
  const Mat<3, double> axes = random.rotation();
  const Point half = axes[2] * random.number(0.1, 0.7);
  return {{center - half, center + half, random.number(0.1, 0.4)}, {axes, center}};
}
template <>
Placed<Polytope> draw(Random& random, const Point& center) {
  std::vector<Point> points(16);
  for (Point& point : points) point = center + random.direction() * 0.7;
  return {graze::convex_hull<3, double>(points), {Mat<3, double>(1.0), center}};
}

template <class A, class B>
struct Flight {
  Placed<A> a;
  Motion motion;  ///< Of a, about its pose's position.
  Placed<B> b;
};

/// About two of three hit.
template <class A, class B>
std::vector<Flight<A, B>> flights(bool turning) {
  std::vector<Flight<A, B>> result;
  Random random;
  while (result.size() < pair_count) {
    const Point start = random.direction() * 4.0;
    Flight<A, B> flight{draw<A>(random, start), rest, draw<B>(random, random.vector(0.3))};
    flight.motion.linear = (random.vector(0.7) - start) * 1.5;
    flight.motion.center = start;
    if (turning) flight.motion.angular = random.direction() * random.number(0.1, 0.7);
    if (!intersects(flight.a.shape, flight.b.shape)) result.push_back(std::move(flight));
  }
  return result;
}

template <class A, class B>
Pose<3, double> end_of(const Flight<A, B>& flight) {
  const Pose<3, double> moved = pose_at(flight.motion, 1);
  return {moved.rotation * flight.a.pose.rotation, moved.rotation * flight.a.pose.position + moved.position};
}

// ---- Bullet

btVector3 bullet_vector(const Point& v) {
  return {static_cast<btScalar>(v.x), static_cast<btScalar>(v.y), static_cast<btScalar>(v.z)};
}

btTransform bullet_pose(const Pose<3, double>& pose) {
  btMatrix3x3 basis;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) basis[row][column] = static_cast<btScalar>(pose.rotation[column][row]);
  }
  return btTransform(basis, bullet_vector(pose.position));
}

std::unique_ptr<btConvexShape> bullet_shape(const Placed<Sphere>& placed) {
  return std::make_unique<btSphereShape>(static_cast<btScalar>(placed.shape.radius));
}
std::unique_ptr<btConvexShape> bullet_shape(const Placed<Obb>& placed) {
  auto shape = std::make_unique<btBoxShape>(bullet_vector(placed.shape.half_extents));
  shape->setMargin(0);  // otherwise its corners are rounded
  return shape;
}
std::unique_ptr<btConvexShape> bullet_shape(const Placed<Capsule>& placed) {
  const Point way = placed.shape.b - placed.shape.a;
  return std::make_unique<btCapsuleShapeZ>(static_cast<btScalar>(placed.shape.radius),
                                           static_cast<btScalar>(std::sqrt(dot(way, way))));
}
std::unique_ptr<btConvexShape> bullet_shape(const Placed<Polytope>& placed) {
  auto shape = std::make_unique<btConvexHullShape>();
  for (const Point& vertex : placed.shape.vertices()) shape->addPoint(bullet_vector(vertex - placed.pose.position));
  shape->setMargin(0);
  return shape;
}

struct BulletFlight {
  std::unique_ptr<btConvexShape> a;
  std::unique_ptr<btConvexShape> b;
  btTransform start;
  btTransform end;
  btTransform at;
};

template <class A, class B>
BulletFlight bullet_flight(const Flight<A, B>& flight) {
  return {bullet_shape(flight.a), bullet_shape(flight.b), bullet_pose(flight.a.pose), bullet_pose(end_of(flight)),
          bullet_pose(flight.b.pose)};
}

std::optional<double> time_of(btConvexCast&& cast, const BulletFlight& flight) {
  btConvexCast::CastResult result;
  if (!cast.calcTimeOfImpact(flight.start, flight.end, flight.at, flight.at, result)) return std::nullopt;
  return static_cast<double>(result.m_fraction);
}

std::optional<double> bullet_cast(const BulletFlight& flight) {
  btVoronoiSimplexSolver simplex;
  return time_of(btGjkConvexCast(flight.a.get(), flight.b.get(), &simplex), flight);
}

std::optional<double> bullet_continuous(const BulletFlight& flight) {
  btVoronoiSimplexSolver simplex;
  btGjkEpaPenetrationDepthSolver depth;
  return time_of(btContinuousConvexCollision(flight.a.get(), flight.b.get(), &simplex, &depth), flight);
}

// ---- FCL

fcl::Transform3d fcl_pose(const Pose<3, double>& pose) {
  fcl::Transform3d result = fcl::Transform3d::Identity();
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) result.linear()(k, i) = pose.rotation[i][k];
    result.translation()[i] = pose.position[i];
  }
  return result;
}

std::unique_ptr<fcl::CollisionGeometryd> fcl_shape(const Placed<Sphere>& placed) {
  return std::make_unique<fcl::Sphered>(placed.shape.radius);
}
std::unique_ptr<fcl::CollisionGeometryd> fcl_shape(const Placed<Obb>& placed) {
  const Point size = 2.0 * placed.shape.half_extents;
  return std::make_unique<fcl::Boxd>(size.x, size.y, size.z);
}
std::unique_ptr<fcl::CollisionGeometryd> fcl_shape(const Placed<Capsule>& placed) {
  const Point way = placed.shape.b - placed.shape.a;
  return std::make_unique<fcl::Capsuled>(placed.shape.radius, std::sqrt(dot(way, way)));
}

struct FclFlight {
  std::unique_ptr<fcl::CollisionGeometryd> a;
  std::unique_ptr<fcl::CollisionGeometryd> b;
  fcl::Transform3d start;
  fcl::Transform3d end;
  fcl::Transform3d at;
};

template <class A, class B>
FclFlight fcl_flight(const Flight<A, B>& flight) {
  FclFlight result{fcl_shape(flight.a), fcl_shape(flight.b), fcl_pose(flight.a.pose), fcl_pose(end_of(flight)),
                   fcl_pose(flight.b.pose)};
  for (const auto& shape : {result.a.get(), result.b.get()}) shape->computeLocalAABB();
  return result;
}

std::optional<double> fcl_advancement(const FclFlight& flight, fcl::CCDMotionType motion) {
  const fcl::ContinuousCollisionRequestd request(1000, 1e-6, motion, fcl::GST_LIBCCD,
                                                 fcl::CCDC_CONSERVATIVE_ADVANCEMENT);
  fcl::ContinuousCollisionResultd result;
  fcl::continuousCollide(flight.a.get(), flight.start, flight.end, flight.b.get(), flight.at, flight.at, request,
                         result);
  if (!result.is_collide) return std::nullopt;
  return result.time_of_contact;
}

// ---- Checks of the answers

/// The distance of the shapes at t; negative if they overlap.
template <class A, class B>
double gap_at(const Flight<A, B>& flight, double t) {
  const A there = transformed(flight.a.shape, pose_at(flight.motion, t));
  if (const auto touch = contact(there, flight.b.shape)) return -touch->depth;
  return closest_points(there, flight.b.shape).distance;
}

/// Ends the program if graze is late or early.
template <class A, class B, class Ask>
void require_right(const std::string& name, const std::vector<Flight<A, B>>& all, const Ask& ask) {
  for (const Flight<A, B>& flight : all) {
    const auto found = ask(flight);
    const double gap = found ? gap_at(flight, found->t) : gap_at(flight, 1);
    if (found ? std::fabs(gap) <= found->error + 1e-12 : gap >= 0) continue;
    std::fprintf(stderr, "%s: graze leaves a gap of %g\n", name.c_str(), gap);
    std::exit(1);
  }
}

/// The known limits of another library: at its hits, gap and depth are at most `gap`, and it misses at most this share
/// of all hits.
struct Allowance {
  double gap;
  double share_wrong;
};

/// A convex cast stops after 32 steps, which are too few for half of the pairs of hulls and boxes without a margin.
constexpr Allowance of_bullet_cast = {2e-3, 0.7};
constexpr Allowance of_bullet_continuous = {1e-2, 0.005};
/// It misses some contacts of boxes at an edge.
constexpr Allowance of_fcl = {2e-2, 0.2};

/// The quality of another library's answers.
struct Worth {
  std::size_t hits = 0;
  std::size_t misses = 0;
  std::size_t false_hits = 0;
  std::size_t wrong = 0;
  double farthest = 0;
  double deepest = 0;

  void add(bool hit, const std::optional<double>& gap, const Allowance& allowance) {
    hits += hit ? 1U : 0U;
    misses += hit && !gap ? 1U : 0U;
    false_hits += !hit && gap ? 1U : 0U;
    wrong += (gap ? std::fabs(*gap) > allowance.gap : hit) ? 1U : 0U;
    if (!gap) return;
    farthest = std::max(farthest, *gap);
    deepest = std::max(deepest, -*gap);
  }
};

/// Ends the program if another library is wrong more often than its allowance.
template <class A, class B, class Theirs, class Ours, class Ask>
void require_worth(const std::string& name, const std::vector<Flight<A, B>>& all, const std::vector<Theirs>& copies,
                   const Ours& ours, const Ask& ask, const Allowance& allowance) {
  Worth worth;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::optional<double> t = ask(copies[i]);
    worth.add(ours(all[i]).has_value(), t ? std::optional(gap_at(all[i], *t)) : std::nullopt, allowance);
  }
  std::printf(
      "%s: misses %zu of %zu hits, hits %zu times what is missed; at its times the shapes are up to %.1e apart "
      "and up to %.1e deep; %zu are wrong by more than %.1e\n",
      name.c_str(), worth.misses, worth.hits, worth.false_hits, worth.farthest, worth.deepest, worth.wrong,
      allowance.gap);
  const auto most = static_cast<std::size_t>(allowance.share_wrong * static_cast<double>(all.size()));
  if (worth.wrong <= most) return;
  std::fprintf(stderr, "%s: no more than %zu may be wrong\n", name.c_str(), most);
  std::exit(1);
}

// ---- Timing

template <class Work, class Ask>
void time_all(const std::string& name, std::shared_ptr<const std::vector<Work>> work, Ask ask) {
  benchmark::RegisterBenchmark(name.c_str(), [work, ask](benchmark::State& state) {
    for (auto _ : state) {
      for (const Work& each : *work) benchmark::DoNotOptimize(ask(each));
    }
    graze::bench::count_things(state, work->size());
  });
}

/// Another library's copies of the motions, compared and timed.
template <class A, class B, class Make, class Ours, class Ask>
void add_other(const std::string& name, const std::vector<Flight<A, B>>& all, Make make, const Ours& ours, Ask ask,
               const Allowance& allowance) {
  using Theirs = decltype(make(all[0]));
  auto copies = std::make_shared<std::vector<Theirs>>();
  for (const Flight<A, B>& flight : all) copies->push_back(make(flight));
  require_worth(name, all, *copies, ours, ask, allowance);
  time_all<Theirs>(name, copies, ask);
}

template <class A, class B>
void register_pairs(const std::string& pair, bool turning) {
  const auto all = std::make_shared<std::vector<Flight<A, B>>>(flights<A, B>(turning));
  const std::string title = pair + (turning ? ", turning" : "");
  const auto cast = [](const Flight<A, B>& flight) {
    return shape_cast(flight.a.shape, flight.motion.linear, flight.b.shape);
  };
  const auto impact = [](const Flight<A, B>& flight) {
    return time_of_impact(flight.a.shape, flight.motion, flight.b.shape, rest);
  };
  if (!turning) {
    require_right(title + "/graze shape_cast", *all, cast);
    time_all<Flight<A, B>>(title + "/graze shape_cast", all, cast);
  }
  require_right(title + "/graze time_of_impact", *all, impact);
  time_all<Flight<A, B>>(title + "/graze time_of_impact", all, impact);
  const auto to_bullet = [](const auto& flight) { return bullet_flight(flight); };
  if (!turning) add_other(title + "/Bullet btGjkConvexCast", *all, to_bullet, impact, bullet_cast, of_bullet_cast);
  add_other(title + "/Bullet btContinuousConvexCollision", *all, to_bullet, impact, bullet_continuous,
            of_bullet_continuous);
  if constexpr (requires(const Flight<A, B>& flight) {
                  fcl_flight(flight), fcl_shape(flight.a), fcl_shape(flight.b);
                }) {
    const fcl::CCDMotionType motion = turning ? fcl::CCDM_LINEAR : fcl::CCDM_TRANS;
    add_other(
        title + "/FCL", *all, [](const auto& flight) { return fcl_flight(flight); }, impact,
        [motion](const FclFlight& flight) { return fcl_advancement(flight, motion); }, of_fcl);
  }
}

}  // namespace

int main(int argc, char** argv) {
  register_pairs<Sphere, Sphere>("sphere, sphere", false);
  register_pairs<Sphere, Obb>("sphere, obb", false);
  register_pairs<Capsule, Capsule>("capsule, capsule", false);
  register_pairs<Obb, Capsule>("obb, capsule", false);
  register_pairs<Obb, Obb>("obb, obb", false);
  register_pairs<Polytope, Polytope>("hull of 16, hull of 16", false);
  register_pairs<Capsule, Sphere>("capsule, sphere", true);
  register_pairs<Obb, Capsule>("obb, capsule", true);
  register_pairs<Obb, Obb>("obb, obb", true);
  register_pairs<Polytope, Polytope>("hull of 16, hull of 16", true);
  return graze::bench::run_races(argc, argv);
}
