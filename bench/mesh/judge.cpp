// SPDX-License-Identifier: MIT
#include "judge.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

#include <graze/query/distance.hpp>
#include <graze/query/intersects.hpp>
#include <graze/query/ray_cast.hpp>
#include <graze/query/signed_distance.hpp>

namespace mesh_bench {
namespace {

using Wide = graze::Vec<3, double>;
using Mesh = graze::Mesh<3, double>;

Mesh mesh_in_double(const std::vector<Point>& vertices, const std::vector<Face>& faces) {
  const std::vector<Wide> wide(vertices.begin(), vertices.end());
  return graze::mesh_of<3, double>(wide, faces);
}

/// Fourteen directions: along the axes and the diagonals.
std::vector<Wide> directions() {
  std::vector<Wide> result;
  for (int i = 0; i < 27; ++i) {
    const Wide step(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    const double squared = dot(step, step);
    if (squared == 1 || squared == 3) result.push_back(step / std::sqrt(squared));
  }
  return result;
}

graze::Pose<3, double> moved_pose(const Pose& place, const Wide& motion) {
  return {graze::Mat<3, double>(place.rotation), Wide(place.position) + motion};
}

/// Whether a question has both answers, yes and no, for the motions by `error` in all directions.
template <class Question>
bool depends_on_motion(double error, const Question& question) {
  const bool unmoved = question(Wide(0.0));
  for (const Wide& direction : directions()) {
    if (question(direction * error) != unmoved) return true;
  }
  return false;
}

graze::Sphere<3, double> grown(const graze::Sphere<3>& sphere, double by) {
  return {Wide(sphere.center), std::max(0.0, static_cast<double>(sphere.radius) + by)};
}
graze::Obb<3, double> grown(const graze::Obb<3>& box, double by) {
  return {Wide(box.center), max(Wide(0.0), Wide(box.half_extents) + Wide(by)), graze::Mat<3, double>(box.axes)};
}
graze::Capsule<3, double> grown(const graze::Capsule<3>& capsule, double by) {
  return {Wide(capsule.a), Wide(capsule.b), std::max(0.0, static_cast<double>(capsule.radius) + by)};
}

template <class Shape>
bool depends_on_size(double error, const Mesh& mesh, const Shape& shape) {
  return intersects(mesh, grown(shape, error)) && !intersects(mesh, grown(shape, -error));
}

}  // namespace

Judge::Judge(const Course& course) : course_(course), error_(1e-5 * course.reach) {}

const Mesh& Judge::mesh() {
  if (!mesh_) mesh_ = mesh_in_double(course_.surface.vertices, course_.surface.faces);
  return *mesh_;
}

bool Judge::agree_on_ray(Work work, const Ray& ray, double expected, double found) {
  if (std::fabs(expected - found) <= error_) return true;
  if (work == Work::moved_rays && !moved_) moved_ = mesh_in_double(course_.moved[1], course_.surface.faces);
  const Mesh& mesh = work == Work::moved_rays ? *moved_ : this->mesh();
  // The answers of the rays beside it. Where the surface is steep, t changes by more than the error.
  std::array<double, 2> range{expected, expected};
  for (const Wide& direction : directions()) {
    const auto hit = ray_cast(mesh, graze::Ray<3, double>{Wide(ray.origin) + direction * error_, Wide(ray.direction)});
    const double t = hit ? hit->t : std::numeric_limits<double>::infinity();
    range = {std::min(range[0], t), std::max(range[1], t)};
    if (std::fabs(t - found) <= error_) return true;
  }
  return found >= range[0] && found <= range[1];
}

bool Judge::agree_on_place(const Pose& place) {
  return depends_on_motion(
      error_, [&](const Wide& motion) { return intersects(mesh(), transformed(mesh(), moved_pose(place, motion))); });
}

bool Judge::agree_on_pairs(const Pose& place, std::vector<graze::Pair> expected, std::vector<graze::Pair> found) {
  if (expected == found) return true;
  std::sort(expected.begin(), expected.end());
  std::sort(found.begin(), found.end());
  std::vector<graze::Pair> different;
  std::set_symmetric_difference(expected.begin(), expected.end(), found.begin(), found.end(),
                                std::back_inserter(different));
  return std::all_of(different.begin(), different.end(), [&](const graze::Pair& pair) {
    return depends_on_motion(error_, [&](const Wide& motion) {
      return intersects(mesh().triangle(pair.a), transformed(mesh().triangle(pair.b), moved_pose(place, motion)));
    });
  });
}

bool Judge::agree(Work work, std::size_t query, double expected, double found) {
  if (expected == found) return true;
  switch (work) {
    case Work::rays:
    case Work::rays_batch:
    case Work::moved_rays:
      return agree_on_ray(work, course_.rays[query], expected, found);
    case Work::closest:
    case Work::closest_batch:
    case Work::mesh_distance:
      return std::fabs(expected - found) <= error_;
    case Work::inside:
    case Work::inside_batch:
      return std::fabs(signed_distance(mesh(), Wide(course_.points[query]))) <= error_;
    case Work::meshes_touch:
      return agree_on_place(course_.places[query]);
    case Work::sphere:
    case Work::sphere_contact:
      return depends_on_size(error_, mesh(), course_.spheres[query]);
    case Work::box:
    case Work::box_contact:
      return depends_on_size(error_, mesh(), course_.boxes[query]);
    case Work::capsule:
    case Work::capsule_contact:
      return depends_on_size(error_, mesh(), course_.capsules[query]);
    case Work::build:
    case Work::refit:
    case Work::face_pairs:
      break;
  }
  return false;
}

std::vector<std::size_t> Judge::differences(Work work, const Answers& expected, const Answers& found) {
  std::vector<std::size_t> queries;
  for (std::size_t query = 0; query < expected.pairs.size(); ++query) {
    const bool is_right =
        query < found.pairs.size() && agree_on_pairs(course_.places[query], expected.pairs[query], found.pairs[query]);
    if (!is_right) queries.push_back(query);
  }
  for (std::size_t query = 0; query < expected.numbers.size(); ++query) {
    const bool is_right =
        query < found.numbers.size() && agree(work, query, expected.numbers[query], found.numbers[query]);
    if (!is_right) queries.push_back(query);
  }
  return queries;
}

}  // namespace mesh_bench
