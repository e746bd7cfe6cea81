// SPDX-License-Identifier: MIT
#include "exam.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <random>

#include <fmt/format.h>

#include <graze/broad/self_intersections.hpp>
#include <graze/broad/touching_faces.hpp>
#include <graze/math/pose.hpp>
#include <graze/query/closest_point.hpp>
#include <graze/query/ray_cast.hpp>
#include <graze/query/transformed.hpp>
#include <graze/query/winding_number.hpp>
#include <graze/shape/mesh.hpp>
#include <graze/shape/mesh_report.hpp>

namespace graze::mesh_exam {
namespace {

/// What the answers may differ by, in epsilon of T times the largest coordinate of ray, point and mesh: see
/// tolerance::coarse.
constexpr double most_error = 64;

std::vector<Point> exact_vertices(std::span<const Vec<3, float>> vertices) {
  return {vertices.begin(), vertices.end()};
}
std::vector<Point> exact_vertices(std::span<const Vec<3, double>> vertices) {
  return {vertices.begin(), vertices.end()};
}

template <class T>
std::string text_of(const Vec<3, T>& v) {
  return fmt::format("({}, {}, {})", v.x, v.y, v.z);
}

template <class T>
class Examination {
 public:
  using Vector = Vec<3, T>;

  Examination(std::span<const Point> vertices, std::span<const Face> faces, const Settings& settings)
      : settings_(settings),
        random_(settings.seed),
        mesh_(mesh_of<3, T>(std::vector<Vector>(vertices.begin(), vertices.end()), {faces.begin(), faces.end()})),
        box_(bounds(mesh_)),
        exact_(exact_vertices(mesh_.vertices()), mesh_.faces()) {}

  Tally run() {
    for (std::size_t k = 0; k < settings_.rays; ++k) ask_ray(random_ray(k));
    const bool is_closed = report(mesh_).is_closed;
    for (std::size_t k = 0; k < settings_.points; ++k) {
      const Vector point = k % 2 == 0 ? random_point(1.5) : near_a_face();
      ask_distance(point);
      if (is_closed) ask_winding_number(point);
    }
    if (mesh_.faces().size() <= settings_.most_faces) {
      for (std::size_t k = 0; k < settings_.places; ++k) ask_pairs(random_pose());
      ask_own_pairs();
    }
    return tally_;
  }

 private:
  double random(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  std::size_t below(std::size_t count) { return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_); }

  /// From the box around the mesh, grown.
  Vector random_point(double factor) {
    const Point center(box_.center());
    const Point reach = Point(box_.max) - center;
    Point point;
    for (int i = 0; i < 3; ++i) point[i] = center[i] + factor * random(-1, 1) * std::max(reach[i], 0.1 * max_of(reach));
    return Vector(point);
  }
  static double max_of(const Point& v) { return std::max({v.x, v.y, v.z}); }

  Vector random_vertex() {
    const Face& face = mesh_.faces()[below(mesh_.faces().size())];
    return mesh_.vertices()[face[below(3)]];
  }
  /// On a face, an edge or a vertex, up to rounding.
  Vector on_a_face() {
    const Triangle<3, T> face = mesh_.triangle(below(mesh_.faces().size()));
    const std::size_t choice = below(4);
    if (choice == 0) return face.a;
    const T share = static_cast<T>(random(0, 1));
    if (choice == 1) return face.a + share * (face.b - face.a);
    return face.a + share * (face.b - face.a) +
           static_cast<T>(random(0, 1 - static_cast<double>(share))) * (face.c - face.a);
  }
  Vector near_a_face() {
    const double size = max_of(Point(box_.max) - Point(box_.min)) * std::pow(2.0, random(-20, -2));
    return on_a_face() + Vector(Point{random(-1, 1), random(-1, 1), random(-1, 1)} * size);
  }

  /// Through the mesh, or from a vertex toward another, or along an axis.
  Ray<3, T> random_ray(std::size_t k) {
    const Vector origin = k % 5 == 4 ? random_vertex() : random_point(2);
    Vector direction = on_a_face() - origin;
    if (k % 7 == 6) {
      const int axis = static_cast<int>(below(3));
      for (int i = 0; i < 3; ++i) direction[i] = i == axis ? direction[i] : T(0);
    }
    if (max_abs(direction) == T(0)) direction.x = 1;
    return {origin, direction};
  }

  Pose<3, T> random_pose() {
    const Point axis{random(-1, 1), random(-1, 1), random(-1, 1)};
    const Point size = Point(box_.max) - Point(box_.min);
    Point motion;
    for (int i = 0; i < 3; ++i) motion[i] = random(-0.3, 0.3) * size[i];
    return Pose<3, T>::from_axis_angle(Vector(motion), Vector(axis), random(0, 0.5));
  }

  double unit_at(const Point& point, double reach = 0) const {
    const double largest = std::max(
        {static_cast<double>(max_abs(box_.min)), static_cast<double>(max_abs(box_.max)), max_abs(point), reach});
    return largest * static_cast<double>(std::numeric_limits<T>::epsilon());
  }

  void fault(std::string text) { tally_.faults.push_back(std::move(text)); }

  void ask_ray(const Ray<3, T>& ray) {
    const Point origin(ray.origin);
    const Point way(ray.direction);
    const double size = std::sqrt(dot(way, way));
    const std::optional<ExactHit> truth = exact_.first_hit(origin, way);
    const auto hit = ray_cast(mesh_, ray);
    ++tally_.rays;
    const auto name = [&ray] { return "ray from " + text_of(ray.origin) + " along " + text_of(ray.direction); };
    if (!hit) {
      if (truth) fault(fmt::format("{}: hits at {}, graze finds nothing", name(), truth->t));
      return;
    }
    ++tally_.hits;
    const double t = static_cast<double>(hit->t);
    const double unit = unit_at(origin, t * size);
    // A ray that misses a face by a rounding error hits it; so a hit may be nearer than the true one, but not farther.
    double error = exact_.distance_on_ray(origin, way, t, hit->face) / unit;
    if (truth && t > truth->t) error = std::max(error, (t - truth->t) * size / unit * std::max(truth->sine, 1e-6));
    tally_.hit_error = std::max(tally_.hit_error, error);
    if (error > most_error) {
      fault(fmt::format("{}: hits at {}, graze finds {} on face {}", name(), truth ? truth->t : NAN, t, hit->face));
    }
  }

  void ask_distance(const Vector& point) {
    const Point from(point);
    const double truth = exact_.distance(from);
    const Point nearest(closest_point(mesh_, point));
    const double found = std::sqrt(dot(nearest - from, nearest - from));
    const double error = std::fabs(found - truth) / unit_at(from);
    ++tally_.distances;
    tally_.distance_error = std::max(tally_.distance_error, error);
    if (!(error <= most_error))
      fault(fmt::format("point {}: distance {}, graze finds {}", text_of(point), truth, found));
  }

  void ask_winding_number(const Vector& point) {
    const std::optional<int> truth = exact_.winding_number(Point(point));
    if (!truth) return;
    const double found = winding_number(mesh_, point);
    ++tally_.winding_numbers;
    if (*truth != 0) ++tally_.inside;
    if (found != *truth) {
      fault(fmt::format("point {}: winding number {}, graze finds {}", text_of(point), *truth, found));
    }
  }

  void compare(std::string_view title, const std::vector<Pair>& truth, const std::vector<Pair>& found) {
    std::vector<Pair> different;
    std::set_symmetric_difference(truth.begin(), truth.end(), found.begin(), found.end(),
                                  std::back_inserter(different));
    for (const Pair& pair : different) {
      const bool is_missing = std::binary_search(truth.begin(), truth.end(), pair);
      fault(fmt::format("{}: faces {} and {}, {}", title, pair.a, pair.b,
                        is_missing ? "which graze does not find" : "which only graze finds"));
    }
  }

  void ask_pairs(const Pose<3, T>& pose) {
    const Mesh<3, T> moved = transformed(mesh_, pose);
    const ExactMesh exact_moved(exact_vertices(moved.vertices()), moved.faces());
    const std::vector<Pair> truth = exact_.pairs_with(exact_moved);
    tally_.pairs += truth.size();
    compare("a moved copy", truth, touching_faces(mesh_, moved));
  }

  void ask_own_pairs() {
    const std::vector<Pair> truth = exact_.own_pairs();
    std::vector<Pair> found = self_intersections(mesh_);
    std::erase_if(found, [this](const Pair& pair) { return !exact_.decides(pair); });
    tally_.own_pairs += truth.size();
    compare("the mesh itself", truth, found);
  }

  const Settings& settings_;
  std::mt19937_64 random_;
  Mesh<3, T> mesh_;
  Aabb<3, T> box_;
  ExactMesh exact_;
  Tally tally_;
};

}  // namespace

template <class T>
Tally examine(std::span<const Point> vertices, std::span<const Face> faces, const Settings& settings) {
  if (faces.empty()) return {};
  return Examination<T>(vertices, faces, settings).run();
}

template Tally examine<float>(std::span<const Point>, std::span<const Face>, const Settings&);
template Tally examine<double>(std::span<const Point>, std::span<const Face>, const Settings&);

}  // namespace graze::mesh_exam
