// SPDX-License-Identifier: MIT
// Compares ray_cast against each primitive in 2D and 3D, with point and normal, with Bullet and Embree (float), ODE
// (double) and Box2D (float, 2D); and intersects, which only tells whether there is a hit, with CGAL's do_intersect.
// About one random ray in three hits, and all are in cache; in 3D, none hits segments and points. The branch predictor
// learns a thousand rays that are cast repeatedly; with many rays it mispredicts as often as in a program that never
// casts the same ray twice.
//
// Before timing, all answers are compared with graze's, and the differences are printed. If one exceeds the tolerance
// of a library, which its file in bench/ray_cast states, the program fails; only Bullet's convex cast may be wrong at
// times, as stated there.
#include <cstddef>
#include <cstdio>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include <graze/query/intersects.hpp>
#include <graze/query/ray_cast.hpp>

#include "ratios.hpp"
#include "ray_cast/cases.hpp"
#include "ray_cast/comparison.hpp"
#include "ray_cast/of_box2d.hpp"
#include "ray_cast/of_bullet.hpp"
#include "ray_cast/of_cgal.hpp"
#include "ray_cast/of_embree.hpp"
#include "ray_cast/of_ode.hpp"

namespace {

using graze::Dim;
using graze::ray_bench::Case;

constexpr std::size_t few_rays = 1024;
constexpr std::size_t many_rays = 16384;

template <class S>
using Cases = std::vector<Case<S>>;

/// Whether all answers so far are within their tolerance.
bool do_all_agree = true;

/// graze's answer, for a path that ends where the rays of the others do.
template <class S>
auto cast(const Case<S>& asked) {
  return graze::ray_cast(asked.shape, asked.ray, static_cast<graze::scalar_of<S>>(graze::ray_bench::t_max));
}

/// Many rays hit a plane beyond t_max, so the segment is queried instead.
template <class S>
bool meets(const Case<S>& asked) {
  constexpr Dim N = graze::dimension_of<S>;
  using T = graze::scalar_of<S>;
  if constexpr (std::is_same_v<S, graze::Plane<N, T>>) {
    const graze::Segment<N, T> path{asked.ray.origin,
                                    asked.ray.origin + asked.ray.direction * static_cast<T>(graze::ray_bench::t_max)};
    return intersects(path, asked.shape);
  } else {
    return intersects(asked.shape, asked.ray);
  }
}

template <class Asked, class Ask>
void time_all(const std::string& name, std::shared_ptr<const std::vector<Asked>> all, Ask ask) {
  benchmark::RegisterBenchmark(name.c_str(), [all, ask](benchmark::State& state) {
    for (auto _ : state) {
      for (const Asked& asked : *all) benchmark::DoNotOptimize(ask(asked));
    }
    graze::bench::count_things(state, all->size());
  });
}

/// Compares a library's answers, and times it.
template <class Peer, class S, class Ask>
void add_peer(const std::string& title, const Cases<S>& cases, const Ask& ask) {
  auto peers = std::make_shared<std::vector<Peer>>();
  auto comparison = [] {
    if constexpr (requires { Peer::share_wrong; }) {
      return graze::ray_bench::Comparison(Peer::tolerance, Peer::share_wrong);
    } else {
      return graze::ray_bench::Comparison(Peer::tolerance);
    }
  }();
  for (const Case<S>& asked : cases) {
    peers->emplace_back(asked);
    comparison.add(asked, ask(asked), peers->back().cast());
  }
  const std::string name = title + "/" + Peer::name;
  if (!comparison.report(name, cases.size())) do_all_agree = false;
  time_all<Peer>(name, peers, [](const Peer& peer) { return peer.cast(); });
}

template <class Peer, class S>
void add_peer_that_casts(const std::string& title, const Cases<S>& cases) {
  if constexpr (std::is_constructible_v<Peer, const Case<S>&>) {
    add_peer<Peer>(title, cases, [](const Case<S>& asked) { return cast(asked); });
  }
}

template <class S>
void register_casts(const std::string& title, const std::shared_ptr<const Cases<S>>& cases) {
  namespace peers = graze::ray_bench;
  time_all<Case<S>>(title + "/graze ray_cast", cases, [](const Case<S>& asked) { return cast(asked); });
  add_peer_that_casts<peers::BulletConvexCast>(title, *cases);
  add_peer_that_casts<peers::BulletObjectCast>(title, *cases);
  add_peer_that_casts<peers::BulletBoxCast>(title, *cases);
  add_peer_that_casts<peers::BulletSlabs>(title, *cases);
  add_peer_that_casts<peers::BulletTriangleCast>(title, *cases);
  add_peer_that_casts<peers::OdeRay>(title, *cases);
  if constexpr (requires(const S& shape) { peers::box2d_shape(shape); }) {
    add_peer_that_casts<peers::Box2dRay<S>>(title, *cases);
  }
  // A scene for each of many rays would exceed the cache.
  if (cases->size() == few_rays) add_peer_that_casts<peers::EmbreeRay>(title, *cases);
}

template <class S>
void register_tests(const std::string& title, const std::shared_ptr<const Cases<S>>& cases) {
  if constexpr (requires(const S& shape) { graze::ray_bench::cgal(shape); }) {
    const auto ask = [](const Case<S>& asked) { return meets(asked); };
    time_all<Case<S>>(title + "/graze intersects", cases, ask);
    add_peer<graze::ray_bench::CgalTest<S>>(title, *cases, ask);
  }
}

template <class S>
void register_shape(const std::string& shape, std::size_t rays) {
  const auto cases = std::make_shared<const Cases<S>>(graze::ray_bench::random_cases<S>(rays));
  std::size_t hits = 0;
  for (const Case<S>& asked : *cases) hits += cast(asked) ? 1U : 0U;
  const std::string title = shape + (std::is_same_v<graze::scalar_of<S>, float> ? ", float, " : ", double, ") +
                            std::to_string(rays) + " rays, " + std::to_string(100 * hits / rays) + " % hit";
  register_casts<S>(title, cases);
  register_tests<S>(title + ", whether", cases);
}

template <template <Dim, class> class S, Dim N>
void register_in(const std::string& shape, std::size_t rays) {
  register_shape<S<N, float>>(shape, rays);
  register_shape<S<N, double>>(shape, rays);
}

void register_in_space(std::size_t rays) {
  register_in<graze::Sphere, 3>("ball", rays);
  register_in<graze::Aabb, 3>("box", rays);
  register_in<graze::Obb, 3>("oriented box", rays);
  register_in<graze::Capsule, 3>("capsule", rays);
  register_in<graze::Triangle, 3>("triangle", rays);
  register_in<graze::Plane, 3>("plane", rays);
  register_in<graze::HalfSpace, 3>("half-space", rays);
  register_in<graze::Segment, 3>("segment", rays);
  register_in<graze::Vec, 3>("point", rays);
}

void register_in_the_plane(std::size_t rays) {
  register_in<graze::Sphere, 2>("circle", rays);
  register_in<graze::Aabb, 2>("rectangle", rays);
  register_in<graze::Obb, 2>("oriented rectangle", rays);
  register_in<graze::Triangle, 2>("flat triangle", rays);
  register_in<graze::Segment, 2>("flat segment", rays);
  register_in<graze::Polytope, 2>("polygon of 8", rays);
}

}  // namespace

int main(int argc, char** argv) {
  for (const std::size_t rays : {few_rays, many_rays}) {
    register_in_space(rays);
    register_in_the_plane(rays);
  }
  register_in<graze::Polytope, 3>("hull of 32", few_rays);
  register_in<graze::Compound, 3>("compound of 6", few_rays);
  if (!do_all_agree) {
    std::fprintf(stderr, "ray_cast: answers differ by more than the tolerance, see above\n");
    return 1;
  }
  return graze::bench::run_races(argc, argv);
}
