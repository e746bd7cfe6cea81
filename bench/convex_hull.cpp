// SPDX-License-Identifier: MIT
// Convex hulls of points in space, double: convex_hull, which gives the corners, and convex_mesh, which gives faces and
// edges too, beside qhull, which gives faces, with its default options. All on one thread. Before anything is timed,
// corners and volumes are compared: the same corners are required where no four points lie on a plane by chance, the
// same volume everywhere.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>
extern "C" {
#include <libqhull_r/qhull_ra.h>
}

#include <graze/math/pose.hpp>
#include <graze/query/mass_properties.hpp>
#include <graze/shape/convex_mesh.hpp>
#include <graze/shape/polytope.hpp>

namespace {

using Point = graze::Vec<3, double>;
using Points = std::vector<Point>;

// ---- Sets of points

enum class Set { sphere, ball, cube, gauss, grid, decimal_grid, turned_grid };

struct Crowd {
  Set set;
  const char* name;
  bool is_in_general_position;
};

constexpr Crowd crowds[] = {
    {Set::sphere, "on a sphere", true},       {Set::ball, "in a ball", true},
    {Set::cube, "in a cube", true},           {Set::gauss, "gaussian", true},
    {Set::grid, "grid of 1", false},          {Set::decimal_grid, "grid of 0.1", false},
    {Set::turned_grid, "turned grid", false},
};

/// A cube of points a step apart, the number of them rounded to a third power, in random order.
Points grid(std::size_t count, double step, std::mt19937_64& random) {
  const auto side = static_cast<int>(std::lround(std::cbrt(static_cast<double>(count))));
  Points points;
  for (int x = 0; x < side; ++x) {
    for (int y = 0; y < side; ++y) {
      for (int z = 0; z < side; ++z) points.push_back(step * Point(x, y, z));
    }
  }
  std::shuffle(points.begin(), points.end(), random);
  return points;
}

Points points_of(Set set, std::size_t count) {
  std::mt19937_64 random(20261122);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(-1, 1);
  if (set == Set::grid) return grid(count, 1, random);
  if (set == Set::decimal_grid) return grid(count, 0.1, random);
  if (set == Set::turned_grid) {
    Points points = grid(count, 1, random);
    const graze::Mat<3, double> turn = graze::rotation_matrix(Point(1, 2, 3), 40);
    for (Point& point : points) point = turn * point;
    return points;
  }
  Points points;
  points.reserve(count);
  while (points.size() < count) {
    if (set == Set::cube) {
      points.push_back({uniform(random), uniform(random), uniform(random)});
      continue;
    }
    const Point way(normal(random), normal(random), normal(random));
    const double radius = set == Set::ball ? std::cbrt(0.5 + 0.5 * uniform(random)) : 1;
    points.push_back(set == Set::gauss ? way : way * (radius / std::sqrt(dot(way, way))));
  }
  return points;
}

// ---- qhull

class Qhull {
 public:
  /// qhull does not change the points.
  explicit Qhull(const Points& points) : points_(points) {
    qh_zero(&qh_, stderr);
    char command[] = "qhull";
    auto* coordinates = const_cast<double*>(&points.data()->x);  // NOLINT(cppcoreguidelines-pro-type-const-cast)
    if (qh_new_qhull(&qh_, 3, static_cast<int>(points.size()), coordinates, 0, command, nullptr, nullptr) != 0) {
      std::fprintf(stderr, "qhull failed\n");
      std::exit(1);
    }
  }
  Qhull(const Qhull&) = delete;
  Qhull& operator=(const Qhull&) = delete;
  ~Qhull() {
    qh_freeqhull(&qh_, !qh_ALL);
    int blocks = 0;
    int bytes = 0;
    qh_memfreeshort(&qh_, &blocks, &bytes);
  }

  Points corners() {
    Points result;
    for (const vertexT* vertex = qh_.vertex_list; vertex != nullptr && vertex->next != nullptr; vertex = vertex->next) {
      result.push_back(points_[static_cast<std::size_t>(qh_pointid(&qh_, vertex->point))]);
    }
    std::sort(result.begin(), result.end(), graze::detail::lexicographically_less<3, double>);
    return result;
  }

  double volume() {
    qh_getarea(&qh_, qh_.facet_list);
    return qh_.totvol;
  }

  int count() const { return qh_.num_facets; }

 private:
  const Points& points_;
  qhT qh_{};
};

// ---- Comparing and timing

void compare(const std::string& name, const Points& points, bool is_in_general_position) {
  const auto hull = graze::convex_hull<3, double>(points);
  const double volume = graze::mass_properties(hull).volume;
  Qhull peer(points);
  const Points corners = peer.corners();
  const bool are_same = std::equal(corners.begin(), corners.end(), hull.vertices().begin(), hull.vertices().end());
  const double off = std::fabs(peer.volume() - volume) / volume;
  std::printf("%s: %zu corners, qhull %zu, %s; volumes differ by %.1e\n", name.c_str(), hull.vertices().size(),
              corners.size(), are_same ? "the same" : "not the same", off);
  constexpr double rounding = 1e-12;
  if ((!are_same && is_in_general_position) || !(off < rounding)) {
    std::fprintf(stderr, "%s: graze and qhull do not agree\n", name.c_str());
    std::exit(1);
  }
}

template <class Build>
void time_build(const std::string& name, const std::shared_ptr<const Points>& points, Build build) {
  benchmark::RegisterBenchmark(name.c_str(), [points, build](benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(build(*points));
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points->size()));
  })->Unit(benchmark::kMillisecond);
}

void register_crowd(const Crowd& crowd, std::size_t count) {
  const auto points = std::make_shared<const Points>(points_of(crowd.set, count));
  const std::string name = std::string(crowd.name) + "/" + std::to_string(count);
  compare(name, *points, crowd.is_in_general_position);
  time_build(name + "/convex_hull", points, [](const Points& p) { return graze::convex_hull<3, double>(p); });
  time_build(name + "/convex_mesh", points, [](const Points& p) { return graze::convex_mesh<double>(p); });
  time_build(name + "/qhull", points, [](const Points& p) { return Qhull(p).count(); });
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  for (const std::size_t count : {1000UL, 10000UL, 100000UL, 1000000UL}) {
    for (const Crowd& crowd : crowds) register_crowd(crowd, count);
  }
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
