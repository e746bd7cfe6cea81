// SPDX-License-Identifier: MIT
#include "course.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <utility>

#include <graze/query/distance.hpp>
#include <graze/shape/mesh.hpp>

namespace mesh_bench {
namespace {

using Wide = graze::Vec<3, double>;

/// The same numbers on every platform, unlike the distributions of <random>.
class Random {
 public:
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(numbers_() >> 11U) * 0x1p-53);
  }
  std::size_t below(std::size_t count) { return numbers_() % count; }
  Wide in_ball(double radius) {
    for (;;) {
      const Wide point{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
      if (dot(point, point) <= 1) return point * radius;
    }
  }
  Wide direction() {
    for (;;) {
      const Wide point = in_ball(1);
      if (dot(point, point) > 0.01) return point / std::sqrt(dot(point, point));
    }
  }
  /// Each factor of ten is as likely.
  double size(double least, double most) { return least * std::pow(most / least, uniform(0, 1)); }
  graze::Mat<3, float> rotation() {
    const double angle = uniform(0, 3.1);
    return Pose::from_axis_angle(Point(0.0F), Point(direction()), angle).rotation;
  }

 private:
  std::mt19937_64 numbers_{1};
};

void measure(Course& course) {
  graze::Aabb<3> box = graze::Aabb<3>::nothing();
  for (const Point& vertex : course.surface.vertices) box.grow(vertex);
  course.center = box.center();
  double sum = 0;
  for (const Point& vertex : course.surface.vertices) {
    const Wide from_center = Wide(vertex) - Wide(course.center);
    const double distance = std::sqrt(dot(from_center, from_center));
    course.reach = std::max(course.reach, distance);
    sum += distance;
  }
  course.radius = sum / static_cast<double>(course.surface.vertices.size());
}

void add_points_and_rays(Course& course, const Counts& counts, Random& random) {
  const Wide center(course.center);
  for (std::size_t k = 0; k < counts.rays; ++k) {
    const Wide from = random.in_ball(2 * course.reach);
    const Wide way = random.in_ball(course.reach) - from;
    course.rays.push_back({Point(center + from), Point(way / std::sqrt(dot(way, way)))});
  }
  for (std::size_t k = 0; k < counts.points; ++k) {
    course.points.emplace_back(center + random.in_ball(course.reach));
  }
}

/// The pose that turns about the center and then moves.
Pose placed(const Course& course, const graze::Mat<3, float>& rotation, const Wide& motion) {
  const Pose turn{rotation, Point(0.0F)};
  return {rotation, Point(Wide(course.center) + motion - Wide(graze::rotated<3, float>(course.center, turn)))};
}

void add_places(Course& course, std::size_t count, Random& random) {
  const auto mesh = graze::mesh_of<3, float>(course.surface.vertices, course.surface.faces);
  for (std::size_t k = 0; k < count; ++k) {
    const graze::Mat<3, float> rotation = random.rotation();
    const Wide direction = random.direction();
    course.places.push_back(placed(course, rotation, direction * random.uniform(course.radius, 2 * course.reach)));
    double away = random.uniform(2.01, 3) * course.reach;
    if (k % 2 == 1) {  // moves toward the other one by less than the gap
      const Pose far_away = placed(course, rotation, direction * away);
      away -= 0.95 * static_cast<double>(distance(mesh, transformed(mesh, far_away)));
    }
    course.places_apart.push_back(placed(course, rotation, direction * away));
  }
}

void add_shapes(Course& course, std::size_t count, Random& random) {
  const auto spot = [&](double size) {
    const Wide vertex(course.surface.vertices[random.below(course.surface.vertices.size())]);
    return Point(vertex + random.in_ball(2 * size));
  };
  for (std::size_t k = 0; k < count; ++k) {
    const double size = random.size(0.01, 0.1) * course.radius;
    course.spheres.push_back({spot(size), static_cast<float>(size)});
    const Wide half{size * random.uniform(0.3, 1), size * random.uniform(0.3, 1), size};
    course.boxes.push_back({spot(size), Point(half), random.rotation()});
    const Point middle = spot(size);
    const Point half_axis(random.direction() * (0.7 * size));
    course.capsules.push_back({middle - half_axis, middle + half_axis, static_cast<float>(0.3 * size)});
  }
}

void add_motion(Course& course) {
  for (const Point& vertex : course.surface.vertices) {
    const Wide place = (Wide(vertex) - Wide(course.center)) * (3 / course.radius);
    const Wide shift = Wide{std::sin(place.y), std::sin(place.z), std::sin(place.x)} * (0.01 * course.radius);
    course.moved[0].push_back(Point(Wide(vertex) + shift));
    course.moved[1].push_back(Point(Wide(vertex) - shift));
  }
}

}  // namespace

Course::Course(Surface asked, const Counts& counts) : surface(std::move(asked)) {
  Random random;
  measure(*this);
  add_points_and_rays(*this, counts, random);
  add_shapes(*this, counts.shapes, random);
  add_places(*this, counts.places, random);
  add_motion(*this);
}

}  // namespace mesh_bench
