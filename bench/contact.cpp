// SPDX-License-Identifier: MIT
// Compares contact and manifold for pairs of bounded primitives in 3D with FCL's collide with up to four contacts
// (double), ODE's dCollide (double) and, for two oriented boxes, Bullet's detector and its persistent manifold (float)
// and, where it is installed, Jolt (float); each library has a file in bench/contact. A thousand
// random pairs each, all in cache, some of them apart. Spheres, capsules and boxes also in one call of `contacts`, in
// double and in float; most kinds also with overlapping pairs only, and oriented boxes also resting on each other. The
// branch predictor learns a thousand pairs that are queried repeatedly; so oriented boxes are also timed with sixteen
// thousand pairs, which it does not learn, as in a simulation where no two frames are alike. The contacts of a scene of
// towers of oriented boxes are also compared with a call of manifold for each of its pairs. Before timing, depths are
// compared: graze's is the minimum, so no other may be less; others may be up to 5 % more where two edges meet, because
// they prefer faces by that much.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include <graze/broad/contacts.hpp>
#include <graze/broad/executor.hpp>
#include <graze/math/pose.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/intersects.hpp>
#include <graze/query/manifold.hpp>
#include <graze/scene/scene.hpp>

#include "contact/answer.hpp"
#include "contact/of_bullet.hpp"
#include "contact/of_fcl.hpp"
#include "contact/of_ode.hpp"
#ifdef GRAZE_BENCH_JOLT
#include "contact/of_jolt.hpp"
#endif

namespace {

using graze::Dim;
using graze::Mat;
using graze::Vec;

constexpr std::size_t few_pairs = 1024;
constexpr std::size_t many_pairs = 16384;

using graze::contact_bench::Aabb;
using graze::contact_bench::Answer;
using graze::contact_bench::BulletDetectorPair;
using graze::contact_bench::BulletManifoldPair;
using graze::contact_bench::Capsule;
using graze::contact_bench::FclPair;
using graze::contact_bench::FclShape;
using graze::contact_bench::Obb;
using graze::contact_bench::OdePair;
using graze::contact_bench::OdeShape;
using graze::contact_bench::Point;
using graze::contact_bench::Sphere;
#ifdef GRAZE_BENCH_JOLT
using graze::contact_bench::JoltEdges;
using graze::contact_bench::JoltPair;
#endif
using Triangle = graze::Triangle<3, double>;
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
Pairs<A, B> random_pairs(double spread, std::size_t count = few_pairs) {
  Pairs<A, B> pairs(count);
  Random random(spread);
  for (auto& [a, b] : pairs) {
    draw(random, a);
    draw(random, b);
  }
  return pairs;
}

/// Pairs that overlap by up to `most_depth`.
template <class A, class B>
Pairs<A, B> meeting_pairs(double most_depth = std::numeric_limits<double>::infinity(), std::size_t count = few_pairs) {
  Pairs<A, B> pairs;
  Random random(0.6);
  while (pairs.size() < count) {
    std::pair<A, B> pair;
    draw(random, pair.first);
    draw(random, pair.second);
    const auto met = contact(pair.first, pair.second);
    if (met && met->depth <= most_depth) pairs.push_back(pair);
  }
  return pairs;
}

/// Boxes stacked on boxes, rotated about the vertical axis and slightly overlapping; every stack is rotated as a whole.
Pairs<Obb, Obb> stacked_boxes(std::size_t count) {
  Pairs<Obb, Obb> pairs(count);
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

// ---- Timing

/// Times `measure` for each of some items, which are pairs of shapes.
template <class Item, class Measure>
void time_each(const std::string& name, std::shared_ptr<const std::vector<Item>> items, Measure measure) {
  benchmark::RegisterBenchmark(name.c_str(), [items, measure](benchmark::State& state) {
    for (auto _ : state) {
      for (const Item& item : *items) benchmark::DoNotOptimize(measure(item));
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(items->size()));
    state.counters["ns"] =
        benchmark::Counter(1e-9 * static_cast<double>(items->size()),
                           benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  });
}

/// Compares, prints, and times another library; Theirs is a pair of shapes in its form.
template <class Theirs, class A, class B>
void time_other(const std::string& title, const Pairs<A, B>& pairs) {
  const std::string name = title + "/" + Theirs::name;
  const auto copies = std::make_shared<std::vector<Theirs>>();
  std::size_t hits = 0;
  std::size_t disagree = 0;
  std::size_t less = 0;
  double most = 0;
  for (const auto& [a, b] : pairs) {
    copies->emplace_back(a, b);
    const auto ours = contact(a, b);
    const Answer theirs = copies->back().find();
    if (ours.has_value() != (theirs.count > 0)) ++disagree;
    if (!ours || theirs.count == 0) continue;
    ++hits;
    if (theirs.depth < ours->depth - 1e-4) ++less;
    most = std::max(most, theirs.depth - ours->depth);
  }
  std::printf("%s: of %zu contacts %zu are less deep than graze's, none by more than %.1e deeper; %zu other verdicts\n",
              name.c_str(), hits, less, most, disagree);
  time_each<Theirs>(name, copies, [](const Theirs& pair) { return pair.find(); });
}

// ---- The shapes in another number type

template <class T>
Vec<3, T> stored(const Point& point) {
  return Vec<3, T>(point);
}
template <class T>
graze::Sphere<3, T> stored(const Sphere& sphere) {
  return {stored<T>(sphere.center), static_cast<T>(sphere.radius)};
}
template <class T>
graze::Aabb<3, T> stored(const Aabb& box) {
  return {stored<T>(box.min), stored<T>(box.max)};
}
template <class T>
graze::Obb<3, T> stored(const Obb& box) {
  return {stored<T>(box.center), stored<T>(box.half_extents), Mat<3, T>(box.axes)};
}
template <class T>
graze::Capsule<3, T> stored(const Capsule& capsule) {
  return {stored<T>(capsule.a), stored<T>(capsule.b), static_cast<T>(capsule.radius)};
}

/// `contacts` of all pairs as candidates, in one call. Before timing, its answers are compared with those of single
/// calls.
template <class T, class A, class B>
void time_batch(const std::string& name, const Pairs<A, B>& pairs) {
  using Any = graze::AnyShape<3, T>;
  const auto shapes = std::make_shared<std::vector<Any>>();
  const auto candidates = std::make_shared<std::vector<graze::Pair>>();
  for (const auto& [a, b] : pairs) {
    const auto place = static_cast<std::uint32_t>(shapes->size());
    candidates->push_back({place, place + 1});
    shapes->insert(shapes->end(), {Any(stored<T>(a)), Any(stored<T>(b))});
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

// ---- A scene

using Scene = graze::Scene<3, double>;
using ObjectContacts = std::vector<graze::ObjectContact<3, double>>;

/// Towers of boxes resting on each other, rotated about the vertical axis and slightly overlapping.
std::shared_ptr<const Scene> towers() {
  constexpr std::size_t tower_count = 32;
  constexpr std::size_t boxes_in_tower = 32;
  const auto scene = std::make_shared<Scene>();
  Random random(1);
  for (std::size_t tower = 0; tower < tower_count; ++tower) {
    for (std::size_t level = 0; level < boxes_in_tower; ++level) {
      const Point place(4.0 * static_cast<double>(tower), 0, 0.99 * static_cast<double>(level));
      const Point half(random.number(0.4, 0.9), random.number(0.4, 0.9), 0.5);
      scene->add(Obb{place, half, graze::rotation_matrix(Point(0, 0, 1), random.number(0, 360))});
    }
  }
  scene->update(graze::serial_executor());
  return scene;
}

ObjectContacts contacts_by_pairs(const Scene& scene) {
  const std::vector<graze::ObjectPair> pairs = scene.pairs();
  ObjectContacts found(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    found[i] = {pairs[i], manifold(scene.object(pairs[i].a).shape, scene.object(pairs[i].b).shape)};
  }
  return found;
}

void register_scene() {
  const std::shared_ptr<const Scene> scene = towers();
  const ObjectContacts expected = contacts_by_pairs(*scene);
  const std::string title = "scene of " + std::to_string(scene->size()) + " obbs in towers (" +
                            std::to_string(expected.size()) + " contacts)";
  const bool is_same = scene->contacts(graze::serial_executor()) == expected;
  std::printf("%s: contacts are %sthose of single calls\n", title.c_str(), is_same ? "" : "not ");
  const auto time = [&](const char* name, auto find) {
    benchmark::RegisterBenchmark((title + "/" + name).c_str(), [scene, find, count = expected.size()](auto& state) {
      for (auto _ : state) benchmark::DoNotOptimize(find(*scene));
      state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(count));
      state.counters["ns"] =
          benchmark::Counter(1e-9 * static_cast<double>(count),
                             benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
    });
  };
  time("Scene::contacts", [](const Scene& of) { return of.contacts(graze::serial_executor()); });
  time("manifold of each of Scene::pairs", [](const Scene& of) { return contacts_by_pairs(of); });
}

template <class A, class B>
void register_pairs(const std::string& name, const Pairs<A, B>& drawn) {
  const auto pairs = std::make_shared<Pairs<A, B>>(drawn);
  const auto hits = static_cast<std::size_t>(std::count_if(
      pairs->begin(), pairs->end(), [](const auto& pair) { return intersects(pair.first, pair.second); }));
  const std::string title = name + " (" + std::to_string(100 * hits / pairs->size()) + " % hits)";
  using Ours = std::pair<A, B>;
  time_each<Ours>(title + "/contact", pairs, [](const Ours& pair) { return contact(pair.first, pair.second); });
  time_each<Ours>(title + "/manifold", pairs, [](const Ours& pair) { return manifold(pair.first, pair.second); });
  constexpr bool are_boxes = std::is_same_v<A, Obb> && std::is_same_v<B, Obb>;
  if constexpr (requires { stored<float>(A()), stored<float>(B()); }) {
    time_batch<double>(title + "/contacts", *pairs);
    time_batch<float>(title + "/contacts of floats", *pairs);
  }
  if constexpr (std::is_constructible_v<FclShape, A> && std::is_constructible_v<FclShape, B>) {
    time_other<FclPair>(title, *pairs);
  }
  if constexpr (are_boxes) {
    time_other<BulletDetectorPair>(title, *pairs);
    time_other<BulletManifoldPair>(title, *pairs);
#ifdef GRAZE_BENCH_JOLT
    time_other<JoltPair<JoltEdges::sharp>>(title, *pairs);
    time_other<JoltPair<JoltEdges::rounded>>(title, *pairs);
#endif
  }
  if constexpr (std::is_constructible_v<OdeShape, A> && std::is_constructible_v<OdeShape, B>) {
    time_other<OdePair>(title, *pairs);
  }
}

void register_obbs(const std::string& which, std::size_t count) {
  register_pairs(which + "obb, obb", random_pairs<Obb, Obb>(1, count));
  register_pairs(which + "obb, obb that meet", meeting_pairs<Obb, Obb>(std::numeric_limits<double>::infinity(), count));
  register_pairs(which + "obb on obb", stacked_boxes(count));
}

}  // namespace

int main(int argc, char** argv) {
  register_pairs("sphere, sphere", random_pairs<Sphere, Sphere>(1));
  register_pairs("sphere, sphere that meet", meeting_pairs<Sphere, Sphere>());
  register_pairs("sphere, aabb", random_pairs<Sphere, Aabb>(1));
  register_pairs("sphere, aabb that meet", meeting_pairs<Sphere, Aabb>());
  register_pairs("sphere, obb", random_pairs<Sphere, Obb>(1));
  register_pairs("sphere, obb that meet", meeting_pairs<Sphere, Obb>());
  register_pairs("sphere, capsule", random_pairs<Sphere, Capsule>(1));
  register_pairs("sphere, capsule that meet", meeting_pairs<Sphere, Capsule>());
  register_pairs("aabb, aabb", random_pairs<Aabb, Aabb>(1));
  register_pairs("aabb, aabb that meet", meeting_pairs<Aabb, Aabb>());
  register_pairs("aabb, obb that meet", meeting_pairs<Aabb, Obb>());
  register_obbs("", few_pairs);
  register_obbs("many: ", many_pairs);
  register_scene();
  register_pairs("aabb, capsule that meet", meeting_pairs<Aabb, Capsule>());
  register_pairs("obb, capsule", random_pairs<Obb, Capsule>(1));
  register_pairs("obb, capsule that meet", meeting_pairs<Obb, Capsule>());
  constexpr double hardly = 0.1;  // as shapes in a simulation do
  register_pairs("obb, capsule that meet by up to 0.1", meeting_pairs<Obb, Capsule>(hardly));
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
