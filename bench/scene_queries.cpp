// SPDX-License-Identifier: MIT
// Compares queries of a scene of 100,000 objects (float): casts of spheres, capsules and boxes, in 3D with Bullet's
// convexSweepTest, in 2D with Box2D's QueryAABB and a cast at each fixture; and the contacts of a shape, in 3D with
// Bullet's contactTest. Before timing, graze's casts are compared with casts at every single object, bit for bit, and
// the others' answers with graze's: an answer is another one if only one of the two hits, or their shapes have moved
// different ways by more than `tolerance`, which covers Bullet's stop 1e-3 before contact and the skin of Box2D's
// polygons; of contacts, if an object is missing or added. If more than `most_different` of the answers are, the
// program ends.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include <graze/query/shape_cast.hpp>

#include "ratios.hpp"
#include "scene_queries/of_box2d.hpp"
#include "scene_queries/of_bullet.hpp"
#include "scene_queries/of_graze.hpp"
#include "scene_queries/work.hpp"

namespace {

using namespace bench;

constexpr float tolerance = 0.05F;
constexpr double most_different = 0.05;
constexpr float long_way = 8;   // most casts hit something
constexpr float short_way = 1;  // as in a frame of a game
constexpr Kind all_kinds[] = {Kind::sphere, Kind::capsule, Kind::box};

// ---- Checks

[[noreturn]] void fail(const std::string& what) {
  std::fprintf(stderr, "scene_queries: %s\n", what.c_str());
  std::exit(1);
}

/// Of some of the casts.
template <Dim N>
void require_the_first_of_all(const Work<N>& work, const std::vector<Cast<N>>& casts) {
  for (std::size_t i = 0; i < casts.size(); i += 64) {
    std::optional<float> first;
    for (const Any<N>& object : work.objects()) {
      const auto impact = graze::shape_cast(casts[i].shape, casts[i].motion, object);
      if (impact && (!first || impact->t < *first)) first = impact->t;
    }
    if (OfGraze<N>(work).cast(casts[i]) != first) fail("graze misses the first object");
  }
}

void report(const std::string& name, std::size_t different, std::size_t count, const char* what) {
  std::printf("%s: %zu of %zu answers differ %s\n", name.c_str(), different, count, what);
  if (static_cast<double>(different) > most_different * static_cast<double>(count)) fail(name + " differs too often");
}

template <Dim N, class Contestant>
void compare_casts(const std::string& name, const OfGraze<N>& graze, const Contestant& contestant,
                   const std::vector<Cast<N>>& casts, const std::vector<typename Contestant::Mover>& movers) {
  std::size_t different = 0;
  std::size_t hits = 0;
  for (std::size_t i = 0; i < casts.size(); ++i) {
    const std::optional<float> ours = graze.cast(casts[i]);
    const std::optional<float> theirs = contestant.cast(movers[i]);
    hits += ours ? 1U : 0U;
    const float way = std::sqrt(dot(casts[i].motion, casts[i].motion));
    const bool is_same = ours && theirs ? std::fabs(*ours - *theirs) * way <= tolerance : !ours && !theirs;
    different += is_same ? 0U : 1U;
  }
  report(name + " (" + std::to_string(hits) + " hits)", different, casts.size(), "by more than the tolerance");
}

template <class Contestant>
void compare_contacts(const std::string& name, const OfGraze<3>& graze, Contestant& contestant,
                      const std::vector<Any<3>>& shapes, const std::vector<typename Contestant::Region>& regions) {
  std::size_t different = 0;
  std::size_t total = 0;
  std::vector<std::uint32_t> ours;
  std::vector<std::uint32_t> theirs;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    graze.touch(shapes[i], ours);
    contestant.touch(regions[i], theirs);
    std::sort(theirs.begin(), theirs.end());
    total += ours.size();
    different += ours == theirs ? 0U : 1U;
  }
  report(name + " (" + std::to_string(total) + " objects)", different, shapes.size(), "in an object");
}

// ---- Timing

template <class Contestant, class Question, class Ask>
void time_all(const std::string& name, const std::shared_ptr<Contestant>& contestant,
              const std::shared_ptr<const std::vector<Question>>& questions, const Ask& ask) {
  benchmark::RegisterBenchmark(name.c_str(), [contestant, questions, ask](benchmark::State& state) {
    for (auto _ : state) {
      for (const Question& question : *questions) benchmark::DoNotOptimize(ask(*contestant, question));
    }
    graze::bench::count_things(state, questions->size());
  });
}

template <Dim N, class Contestant>
void add_casts(const std::string& work, const std::shared_ptr<Contestant>& contestant, const OfGraze<N>& graze,
               const std::vector<Cast<N>>& casts) {
  using Mover = typename Contestant::Mover;
  std::vector<Mover> movers;
  for (const Cast<N>& cast : casts) movers.push_back(contestant->mover(cast));
  const std::string name = work + "/" + Contestant::name;
  compare_casts(name, graze, *contestant, casts, movers);
  time_all(name, contestant, std::make_shared<const std::vector<Mover>>(std::move(movers)),
           [](const Contestant& asked, const Mover& mover) { return asked.cast(mover); });
}

template <class Contestant>
void add_contacts(const std::string& work, const std::shared_ptr<Contestant>& contestant, const OfGraze<3>& graze,
                  const std::vector<Any<3>>& shapes) {
  using Region = typename Contestant::Region;
  std::vector<Region> regions;
  for (const Any<3>& shape : shapes) regions.push_back(contestant->region(shape));
  const std::string name = work + "/" + Contestant::name;
  compare_contacts(name, graze, *contestant, shapes, regions);
  time_all(name, contestant, std::make_shared<const std::vector<Region>>(std::move(regions)),
           [found = std::make_shared<std::vector<std::uint32_t>>()](Contestant& asked, const Region& region) {
             return asked.touch(region, *found);
           });
}

template <Dim N, class... Peers>
void enter_casts(Work<N>& work, const std::shared_ptr<Peers>&... peers) {
  const auto graze = std::make_shared<OfGraze<N>>(work);
  for (const Kind kind : all_kinds) {
    for (const float way : {long_way, short_way}) {
      const std::vector<Cast<N>> casts = work.casts(kind, way);
      require_the_first_of_all(work, casts);
      const std::string name = std::to_string(N) + (way == long_way ? "D cast, " : "D short cast, ") + name_of(kind);
      add_casts<N>(name, graze, *graze, casts);
      (add_casts<N>(name, peers, *graze, casts), ...);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  Work<3> solid;
  const auto bullet = std::make_shared<OfBullet>(solid);
  enter_casts<3>(solid, bullet);
  const auto graze = std::make_shared<OfGraze<3>>(solid);
  for (const Kind kind : all_kinds) {
    const std::vector<Any<3>> regions = solid.regions(kind);
    const std::string name = std::string("3D contacts, ") + name_of(kind);
    add_contacts(name, graze, *graze, regions);
    add_contacts(name, bullet, *graze, regions);
  }
  Work<2> flat;
  enter_casts<2>(flat, std::make_shared<OfBox2d<false>>(flat), std::make_shared<OfBox2d<true>>(flat));
  return graze::bench::run_races(argc, argv);
}
