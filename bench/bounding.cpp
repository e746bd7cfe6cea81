// SPDX-License-Identifier: MIT
// Compares graze's bounding volumes of n points with the usual methods on the same points, in float and double, 2D and
// 3D: the sphere around the centroid, and Ritter's sphere (1990). These calculate in T, so points may be outside of
// their volumes. Before timing, every volume of graze is checked to contain all points, and sizes are checked: smallest
// sphere <= fast sphere, other methods; oriented box <= axis-aligned box.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include <graze/query/bounding.hpp>

namespace {

using graze::Dim;
using graze::Sphere;
using graze::Vec;

/// How points are distributed: in a cube, normally, on a sphere, on a line not parallel to an axis.
enum class Spread { cube, normal, shell, line };
constexpr std::array<const char*, 4> spread_names = {"cube", "normal", "shell", "line"};

template <Dim N, class T>
std::vector<Vec<N, T>> random_points(std::size_t count, Spread spread) {
  std::mt19937_64 random(20);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::normal_distribution<double> normal;
  std::vector<Vec<N, T>> points;
  points.reserve(count);
  while (points.size() < count) {
    Vec<N, double> point;
    for (Dim i = 0; i < N; ++i) point[i] = spread == Spread::cube ? uniform(random) : normal(random);
    if (spread == Spread::shell) point /= std::sqrt(dot(point, point));
    if (spread == Spread::line) point = Vec<N, double>(1.0) * point[0] + graze::unit_axis<N>(0) * (0.3 * point[0]);
    points.push_back(Vec<N, T>(point));
  }
  return points;
}

/// The usual textbook method: centered at the centroid, with the distance of the farthest point as radius.
template <Dim N, class T>
Sphere<N, T> centroid_sphere(const std::vector<Vec<N, T>>& points) {
  Vec<N, T> sum(T(0));
  for (const Vec<N, T>& point : points) sum += point;
  Sphere<N, T> sphere{sum / static_cast<T>(points.size()), 0};
  T squared = 0;
  for (const Vec<N, T>& point : points)
    squared = std::max<T>(squared, dot(point - sphere.center, point - sphere.center));
  sphere.radius = std::sqrt(squared);
  return sphere;
}

/// The point farthest from another.
template <Dim N, class T>
Vec<N, T> farthest_point(const std::vector<Vec<N, T>>& points, const Vec<N, T>& from) {
  return *std::max_element(points.begin(), points.end(), [&from](const Vec<N, T>& a, const Vec<N, T>& b) {
    return dot(a - from, a - from) < dot(b - from, b - from);
  });
}

/// Ritter's sphere: spans two points far apart, and grows to contain each point outside.
template <Dim N, class T>
Sphere<N, T> ritter_sphere(const std::vector<Vec<N, T>>& points) {
  const Vec<N, T> a = farthest_point(points, points.front());
  const Vec<N, T> b = farthest_point(points, a);
  Sphere<N, T> sphere{(a + b) * T(0.5), std::sqrt(dot(b - a, b - a)) * T(0.5)};
  for (const Vec<N, T>& point : points) {
    const Vec<N, T> to_point = point - sphere.center;
    const T squared = dot(to_point, to_point);
    if (squared <= sphere.radius * sphere.radius) continue;
    const T distance = std::sqrt(squared);
    const T radius = (sphere.radius + distance) * T(0.5);
    sphere.center += to_point * ((distance - radius) / distance);
    sphere.radius = radius;
  }
  return sphere;
}

/// How far points are outside of a sphere, relative to its radius, in double.
template <Dim N, class T>
double overhang(const Sphere<N, T>& sphere, const std::vector<Vec<N, T>>& points) {
  const Vec<N, double> center = graze::wide<N, T>(sphere.center);
  double squared = 0;
  for (const Vec<N, T>& point : points) {
    const Vec<N, double> to_point = graze::wide<N, T>(point) - center;
    squared = std::max(squared, dot(to_point, to_point));
  }
  return std::sqrt(squared) / static_cast<double>(sphere.radius) - 1;
}

void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "bounding: %s\n", what);
  std::exit(1);
}

template <Dim N, class T>
void require_valid_answers() {
  for (const Spread spread : {Spread::cube, Spread::normal, Spread::shell, Spread::line}) {
    const std::vector<Vec<N, T>> points = random_points<N, T>(10'000, spread);
    const Sphere<N, T> smallest = graze::bounding_sphere(points);
    const Sphere<N, T> fast = graze::bounding_sphere_fast(points);
    const double slack = 1 + 16 * static_cast<double>(std::numeric_limits<T>::epsilon());
    const double rounding = graze::tolerance::rounding;
    require(overhang(smallest, points) <= rounding && overhang(fast, points) <= rounding, "a point is outside");
    for (const Sphere<N, T>& other : {fast, centroid_sphere(points), ritter_sphere(points)}) {
      const double radius = static_cast<double>(other.radius) * (1 + std::max(0.0, overhang(other, points)));
      require(static_cast<double>(smallest.radius) <= radius * slack, "the smallest sphere is not the smallest");
    }
    const double turned = graze::detail::size_of(graze::bounding_obb(points), 1);
    const double upright = graze::detail::size_of(graze::detail::upright_obb(graze::bounding_box(points)), 1);
    require(turned <= upright, "the oriented box is larger than the axis-aligned one");
  }
}

/// Times `bound(points)` and reports `size_of` of the result.
template <Dim N, class T, class Bound, class Size>
void add(const std::string& name, Bound bound, Size size_of, double unit_of_size) {
  const std::string space = std::to_string(N) + "D " + (sizeof(T) == sizeof(float) ? "float" : "double");
  for (std::size_t spread = 0; spread < spread_names.size(); ++spread) {
    std::string full_name = name;
    full_name.append("/").append(space).append("/").append(spread_names[spread]);
    auto* const entry = benchmark::RegisterBenchmark(full_name.c_str(), [=](benchmark::State& state) {
      const auto points = random_points<N, T>(static_cast<std::size_t>(state.range(0)), static_cast<Spread>(spread));
      double size = 0;
      for (auto _ : state) size = size_of(bound(points));
      state.counters["size"] = size * unit_of_size;
    });
    entry->Arg(1'000)->Arg(30'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);
  }
}

template <Dim N, class T>
void add_all() {
  using Points = std::vector<Vec<N, T>>;
  const auto radius = [](const Sphere<N, T>& sphere) { return static_cast<double>(sphere.radius); };
  const auto box_size = [](const graze::Aabb<N, T>& box) {
    return graze::detail::size_of(graze::detail::upright_obb(box), 1);
  };
  const auto obb_size = [](const graze::Obb<N, T>& box) { return graze::detail::size_of(box, 1); };
  const double whole = N == 2 ? 4 : 8;  // of half extents: area, volume
  add<N, T>(
      "bounding_box", [](const Points& points) { return graze::bounding_box(points); }, box_size, whole);
  add<N, T>(
      "bounding_sphere", [](const Points& points) { return graze::bounding_sphere(points); }, radius, 1);
  add<N, T>(
      "bounding_sphere_fast", [](const Points& points) { return graze::bounding_sphere_fast(points); }, radius, 1);
  add<N, T>(
      "bounding_obb", [](const Points& points) { return graze::bounding_obb(points); }, obb_size, whole);
  add<N, T>(
      "recipe_centroid", [](const Points& points) { return centroid_sphere(points); }, radius, 1);
  add<N, T>(
      "recipe_ritter", [](const Points& points) { return ritter_sphere(points); }, radius, 1);
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  require_valid_answers<2, float>();
  require_valid_answers<3, float>();
  require_valid_answers<2, double>();
  require_valid_answers<3, double>();
  add_all<2, float>();
  add_all<3, float>();
  add_all<2, double>();
  add_all<3, double>();
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
}
