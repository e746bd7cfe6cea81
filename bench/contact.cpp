// SPDX-License-Identifier: MIT
// contact and manifold for pairs of bounded primitives in 3D, beside FCL's collide with up to four contacts (double)
// and, for two oriented boxes, Bullet's btBoxBoxDetector (float). A thousand random pairs each, all in cache, some of
// them apart; oriented boxes also in one call of `contacts`, in double and in float; of most kinds also pairs that all
// meet, and of oriented boxes some that lie on each other. Before anything is timed the others' depths are compared
// with graze's: graze's is the least, so that none may be less; those of FCL and Bullet may be up to 5 % more where two
// edges meet, because they prefer faces by as much.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <random>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <BulletCollision/CollisionDispatch/btBoxBoxDetector.h>
#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <benchmark/benchmark.h>
#include <fcl/narrowphase/collision.h>

#include <graze/broad/contacts.hpp>
#include <graze/broad/executor.hpp>
#include <graze/broad/manifolds.hpp>
#include <graze/math/pose.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/intersects.hpp>
#include <graze/query/manifold.hpp>

namespace {

using graze::Dim;
using graze::Mat;
using graze::Vec;

constexpr std::size_t pair_count = 1024;

using Point = Vec<3, double>;
using Sphere = graze::Sphere<3, double>;
using Aabb = graze::Aabb<3, double>;
using Obb = graze::Obb<3, double>;
using Triangle = graze::Triangle<3, double>;
using Capsule = graze::Capsule<3, double>;
using Polytope = graze::Polytope<3, double>;

// ---- Random shapes of about unit size, at most `spread` from the origin

class Random {
 public:
  explicit Random(double spread) : spread_(spread) {}

  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }

  Point vector(double size) { return {number(-size, size), number(-size, size), number(-size, size)}; }

  Point place() { return vector(spread_); }

  Mat<3, double> rotation() {
    Point axis = vector(1);
    while (dot(axis, axis) > 1 || dot(axis, axis) < 0.01) axis = vector(1);
    return graze::rotation_matrix(axis, number(0, 360));
  }

 private:
  double spread_;
  std::mt19937 engine_{20261121};
};

void draw(Random& random, Sphere& sphere) { sphere = {random.place(), random.number(0.2, 0.8)}; }
void draw(Random& random, Aabb& box) {
  const Point center = random.place();
  const Point half = abs(random.vector(0.8)) + 0.01;
  box = {center - half, center + half};
}
void draw(Random& random, Obb& box) { box = {random.place(), abs(random.vector(0.8)) + 0.01, random.rotation()}; }
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
void draw(Random& random, Polytope& hull) {
  const Point center = random.place();
  std::vector<Point> points;
  for (int i = 0; i < 8; ++i) {
    const Point way = random.vector(1);
    points.push_back(center + way * (0.7 / std::sqrt(dot(way, way))));
  }
  hull = graze::convex_hull<3, double>(points);
}

template <class A, class B>
using Pairs = std::vector<std::pair<A, B>>;

template <class A, class B>
Pairs<A, B> random_pairs(double spread) {
  Pairs<A, B> pairs(pair_count);
  Random random(spread);
  for (auto& [a, b] : pairs) {
    draw(random, a);
    draw(random, b);
  }
  return pairs;
}

/// Pairs that meet.
template <class A, class B>
Pairs<A, B> meeting_pairs() {
  Pairs<A, B> pairs;
  Random random(0.6);
  while (pairs.size() < pair_count) {
    std::pair<A, B> pair;
    draw(random, pair.first);
    draw(random, pair.second);
    if (contact(pair.first, pair.second)) pairs.push_back(pair);
  }
  return pairs;
}

/// Boxes on boxes, turned about the upright axis and sunk in a little; every stack turned as a whole.
Pairs<Obb, Obb> stacked_boxes() {
  Pairs<Obb, Obb> pairs(pair_count);
  Random random(1);
  for (auto& [below, above] : pairs) {
    const Mat<3, double> whole = random.rotation();
    const Point place = random.place();
    const Point half = abs(random.vector(0.8)) + 0.1;
    const Point other_half = abs(random.vector(0.8)) + 0.1;
    const Point off(random.number(-0.5, 0.5) * half.x, random.number(-0.5, 0.5) * half.y, half.z + other_half.z - 0.01);
    below = {place, half, whole};
    above = {place + whole * off, other_half, whole * graze::rotation_matrix(Point(0, 0, 1), random.number(0, 360))};
  }
  return pairs;
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

FclShape fcl_shape(const Aabb& box) {
  FclShape shape{std::make_shared<fcl::Boxd>(fcl_vector(box.max - box.min))};
  shape.pose.translation() = fcl_vector(box.center());
  return shape;
}

FclShape fcl_shape(const Obb& box) {
  FclShape shape{std::make_shared<fcl::Boxd>(fcl_vector(2.0 * box.half_extents))};
  for (Dim i = 0; i < 3; ++i) shape.pose.linear().col(static_cast<int>(i)) = fcl_vector(box.axes[i]);
  shape.pose.translation() = fcl_vector(box.center);
  return shape;
}

/// FCL's capsules stand along z.
FclShape fcl_shape(const Capsule& capsule) {
  const fcl::Vector3d way = fcl_vector(capsule.b - capsule.a);
  FclShape shape{std::make_shared<fcl::Capsuled>(capsule.radius, way.norm())};
  shape.pose.linear() = Eigen::Quaterniond::FromTwoVectors(fcl::Vector3d::UnitZ(), way).toRotationMatrix();
  shape.pose.translation() = 0.5 * fcl_vector(capsule.a + capsule.b);
  return shape;
}

/// What others answer: how many contacts, and the depth of the deepest.
struct Answer {
  std::size_t count = 0;
  double depth = 0;
};

Answer fcl_contacts(const FclShape& a, const FclShape& b) {
  static const fcl::CollisionRequestd request(4, true);
  fcl::CollisionResultd result;
  fcl::collide(a.geometry.get(), a.pose, b.geometry.get(), b.pose, request, result);
  Answer answer{result.numContacts(), 0};
  for (std::size_t i = 0; i < answer.count; ++i) {
    answer.depth = std::max(answer.depth, result.getContact(i).penetration_depth);
  }
  return answer;
}

// ---- The same boxes for Bullet

struct BulletBox {
  std::unique_ptr<btBoxShape> shape;
  btTransform pose = btTransform::getIdentity();
};

btVector3 bullet_vector(const Point& v) {
  return {static_cast<btScalar>(v.x), static_cast<btScalar>(v.y), static_cast<btScalar>(v.z)};
}

BulletBox bullet_shape(const Obb& box) {
  BulletBox result{std::make_unique<btBoxShape>(bullet_vector(box.half_extents))};
  const btVector3 x = bullet_vector(box.axes[0]);
  const btVector3 y = bullet_vector(box.axes[1]);
  const btVector3 z = bullet_vector(box.axes[2]);
  result.pose.setBasis(btMatrix3x3(x.x(), y.x(), z.x(), x.y(), y.y(), z.y(), x.z(), y.z(), z.z()));
  result.pose.setOrigin(bullet_vector(box.center));
  return result;
}

class BulletContacts : public btDiscreteCollisionDetectorInterface::Result {
 public:
  void setShapeIdentifiersA(int, int) override {}
  void setShapeIdentifiersB(int, int) override {}
  void addContactPoint(const btVector3&, const btVector3&, btScalar distance) override {
    ++answer.count;
    answer.depth = std::max(answer.depth, -static_cast<double>(distance));
  }

  Answer answer;
};

Answer bullet_contacts(const BulletBox& a, const BulletBox& b) {
  btBoxBoxDetector detector(a.shape.get(), b.shape.get());
  btDiscreteCollisionDetectorInterface::ClosestPointInput input;
  input.m_transformA = a.pose;
  input.m_transformB = b.pose;
  BulletContacts contacts;
  detector.getClosestPoints(input, contacts, nullptr);
  return contacts.answer;
}

// ---- Timing

template <class A, class B, class Measure>
void time_pairs(const std::string& name, std::shared_ptr<const Pairs<A, B>> pairs, Measure measure) {
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

/// Compares, prints, and times another library, given shapes made by `make`.
template <class A, class B, class Make, class Measure>
void time_other(const std::string& name, const Pairs<A, B>& pairs, Make make, Measure measure) {
  using Theirs = decltype(make(pairs[0].first));
  auto copies = std::make_shared<Pairs<Theirs, Theirs>>();
  std::size_t hits = 0;
  std::size_t disagree = 0;
  std::size_t less = 0;
  double most = 0;
  for (const auto& [a, b] : pairs) {
    copies->emplace_back(make(a), make(b));
    const auto ours = contact(a, b);
    const Answer theirs = measure(copies->back().first, copies->back().second);
    if (ours.has_value() != (theirs.count > 0)) ++disagree;
    if (!ours || theirs.count == 0) continue;
    ++hits;
    if (theirs.depth < ours->depth - 1e-4) ++less;
    most = std::max(most, theirs.depth - ours->depth);
  }
  std::printf("%s: of %zu contacts %zu are less deep than graze's, none by more than %.1e deeper; %zu other verdicts\n",
              name.c_str(), hits, less, most, disagree);
  time_pairs<Theirs, Theirs>(name, copies, measure);
}

/// `contacts` of all pairs as candidates, in one call. Before they are timed, the answers are compared with those of
/// single calls.
template <class T>
void time_batch(const std::string& name, const Pairs<Obb, Obb>& pairs) {
  using Any = graze::AnyShape<3, T>;
  const auto stored = [](const Obb& box) {
    return graze::Obb<3, T>{Vec<3, T>(box.center), Vec<3, T>(box.half_extents), Mat<3, T>(box.axes)};
  };
  const auto shapes = std::make_shared<std::vector<Any>>();
  const auto candidates = std::make_shared<std::vector<graze::Pair>>();
  for (const auto& [a, b] : pairs) {
    const auto place = static_cast<std::uint32_t>(shapes->size());
    candidates->push_back({place, place + 1});
    shapes->insert(shapes->end(), {stored(a), stored(b)});
  }
  const graze::TouchOptions alone{&graze::serial_executor()};
  std::size_t others = 0;
  for (const auto& found : graze::contacts(*shapes, *candidates, alone)) {
    if (!(found.manifold == manifold((*shapes)[found.pair.a], (*shapes)[found.pair.b]))) ++others;
  }
  std::printf("%s: %zu are not those of single calls\n", name.c_str(), others);
  benchmark::RegisterBenchmark(name.c_str(), [shapes, candidates, alone](benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(graze::contacts(*shapes, *candidates, alone));
    const auto count = static_cast<double>(candidates->size());
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(candidates->size()));
    state.counters["ns"] =
        benchmark::Counter(1e-9 * count, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  });
}

template <class A, class B>
void register_pairs(const std::string& name, const Pairs<A, B>& drawn) {
  const auto pairs = std::make_shared<Pairs<A, B>>(drawn);
  const auto hits = static_cast<std::size_t>(std::count_if(
      pairs->begin(), pairs->end(), [](const auto& pair) { return intersects(pair.first, pair.second); }));
  const std::string title = name + " (" + std::to_string(100 * hits / pairs->size()) + " % hits)";
  time_pairs<A, B>(title + "/contact", pairs, [](const A& a, const B& b) { return contact(a, b); });
  time_pairs<A, B>(title + "/manifold", pairs, [](const A& a, const B& b) { return manifold(a, b); });
  if constexpr (std::is_same_v<A, Obb> && std::is_same_v<B, Obb>) {
    time_batch<double>(title + "/contacts", *pairs);
    time_batch<float>(title + "/contacts of floats", *pairs);
  }
  if constexpr (requires { fcl_shape(drawn[0].first), fcl_shape(drawn[0].second); }) {
    time_other(
        title + "/FCL", *pairs, [](const auto& shape) { return fcl_shape(shape); }, fcl_contacts);
  }
  if constexpr (requires { bullet_shape(drawn[0].first), bullet_shape(drawn[0].second); }) {
    time_other(
        title + "/Bullet", *pairs, [](const auto& shape) { return bullet_shape(shape); }, bullet_contacts);
  }
}

}  // namespace

int main(int argc, char** argv) {
  register_pairs("sphere, sphere", random_pairs<Sphere, Sphere>(1));
  register_pairs("sphere, aabb", random_pairs<Sphere, Aabb>(1));
  register_pairs("sphere, aabb that meet", meeting_pairs<Sphere, Aabb>());
  register_pairs("sphere, obb", random_pairs<Sphere, Obb>(1));
  register_pairs("sphere, obb that meet", meeting_pairs<Sphere, Obb>());
  register_pairs("sphere, capsule", random_pairs<Sphere, Capsule>(1));
  register_pairs("aabb, aabb", random_pairs<Aabb, Aabb>(1));
  register_pairs("obb, obb", random_pairs<Obb, Obb>(1));
  register_pairs("obb, obb that meet", meeting_pairs<Obb, Obb>());
  register_pairs("obb on obb", stacked_boxes());
  register_pairs("obb, capsule", random_pairs<Obb, Capsule>(1));
  register_pairs("obb, capsule that meet", meeting_pairs<Obb, Capsule>());
  register_pairs("obb, triangle", random_pairs<Obb, Triangle>(1));
  register_pairs("obb, triangle that meet", meeting_pairs<Obb, Triangle>());
  register_pairs("triangle, triangle", random_pairs<Triangle, Triangle>(0.5));
  register_pairs("capsule, capsule", random_pairs<Capsule, Capsule>(1));
  register_pairs("capsule, capsule that meet", meeting_pairs<Capsule, Capsule>());
  register_pairs("hull of 8, hull of 8", random_pairs<Polytope, Polytope>(1));
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
