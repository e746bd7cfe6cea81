// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <graze/broad/closest_points.hpp>
#include <graze/broad/ray_casts.hpp>
#include <graze/broad/touching_faces.hpp>
#include <graze/broad/winding_numbers.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/contains.hpp>
#include <graze/query/distance.hpp>
#include <graze/query/intersects.hpp>
#include <graze/query/ray_cast.hpp>
#include <graze/shape/mesh.hpp>

#include "contestant.hpp"

namespace mesh_bench {
namespace {

using graze::MeshKind;

template <class T>
graze::Sphere<3, T> converted(const graze::Sphere<3>& sphere) {
  return {graze::Vec<3, T>(sphere.center), static_cast<T>(sphere.radius)};
}
template <class T>
graze::Obb<3, T> converted(const graze::Obb<3>& box) {
  return {graze::Vec<3, T>(box.center), graze::Vec<3, T>(box.half_extents), graze::Mat<3, T>(box.axes)};
}
template <class T>
graze::Capsule<3, T> converted(const graze::Capsule<3>& capsule) {
  return {graze::Vec<3, T>(capsule.a), graze::Vec<3, T>(capsule.b), static_cast<T>(capsule.radius)};
}
template <class T>
graze::Ray<3, T> converted(const Ray& ray) {
  return {graze::Vec<3, T>(ray.origin), graze::Vec<3, T>(ray.direction)};
}
template <class T>
graze::Pose<3, T> converted(const Pose& pose) {
  return {graze::Mat<3, T>(pose.rotation), graze::Vec<3, T>(pose.position)};
}
template <class T>
graze::Vec<3, T> converted(const Point& point) {
  return graze::Vec<3, T>(point);
}

template <class T, class Value>
auto all_converted(const std::vector<Value>& values) {
  std::vector<decltype(converted<T>(values[0]))> result;
  result.reserve(values.size());
  for (const Value& value : values) result.push_back(converted<T>(value));
  return result;
}

/// Everything of the course in T. One thread.
template <class T>
class OfGraze {
 public:
  using Mesh = graze::Mesh<3, T>;

  explicit OfGraze(const Course& course)
      : faces_(course.surface.faces),
        vertices_(all_converted<T>(course.surface.vertices)),
        moved_{all_converted<T>(course.moved[0]), all_converted<T>(course.moved[1])},
        rays_(all_converted<T>(course.rays)),
        points_(all_converted<T>(course.points)),
        places_(all_converted<T>(course.places)),
        places_apart_(all_converted<T>(course.places_apart)),
        spheres_(all_converted<T>(course.spheres)),
        boxes_(all_converted<T>(course.boxes)),
        capsules_(all_converted<T>(course.capsules)) {
    options_.executor = &graze::serial_executor();
  }

  void clear() { surface_.reset(); }
  void build() { surface_ = mesh(vertices_, MeshKind::surface); }
  void build_if_needed() {
    if (!surface_) build();
  }
  void build_solid_if_needed() {
    if (!solid_) solid_ = mesh(vertices_, MeshKind::solid);
  }
  void build_moving_if_needed() {
    if (!moving_) moving_ = mesh(moved_[0], MeshKind::surface);
  }

  // The vertices move to and fro.
  void refit() { moving_ = moved(*moving_, moved_[++frame_ % 2]); }
  void rebuild() { moving_ = mesh(moved_[++frame_ % 2], MeshKind::surface); }
  void end_refit() {
    moving_ = mesh(moved_[0], MeshKind::surface);
    frame_ = 0;
    refit();
  }
  void end_rebuild() {
    frame_ = 0;
    rebuild();
  }

  void moved_rays(Answers& answers) const { cast(*moving_, answers); }
  void rays(Answers& answers) const { cast(*surface_, answers); }
  void rays_batch(Answers& answers) const {
    const auto hits = ray_casts(*surface_, std::span(rays_), options_);
    answer_each(hits, answers, t_of);
  }

  void closest(Answers& answers) const {
    answer_each(points_, answers,
                [this](const auto& point) { return length(closest_point(*surface_, point) - point); });
  }
  void closest_batch(Answers& answers) const {
    const auto nearest = closest_points(*surface_, std::span(points_), options_);
    answers.numbers.resize(points_.size());
    for (std::size_t k = 0; k < points_.size(); ++k) answers.numbers[k] = length(nearest[k] - points_[k]);
  }

  void inside(Answers& answers) const {
    answer_each(points_, answers, [this](const auto& point) { return contains(*solid_, point); });
  }
  void inside_batch(Answers& answers) const {
    const std::vector<double> numbers = winding_numbers(*solid_, std::span(points_), options_);
    answer_each(numbers, answers, [](double number) { return number > 0.5; });
  }

  void meshes_touch(Answers& answers) const {
    answer_each(places_, answers,
                [this](const auto& pose) { return intersects(*surface_, transformed(*surface_, pose)); });
  }
  void face_pairs(Answers& answers) const {
    answers.pairs.clear();
    for (const auto& pose : places_) answers.pairs.push_back(touching_faces(*surface_, transformed(*surface_, pose)));
  }
  void mesh_distance(Answers& answers) const {
    answer_each(places_apart_, answers,
                [this](const auto& pose) { return distance(*surface_, transformed(*surface_, pose)); });
  }

  void sphere(Answers& answers) const { touch(spheres_, answers); }
  void box(Answers& answers) const { touch(boxes_, answers); }
  void capsule(Answers& answers) const { touch(capsules_, answers); }
  void sphere_contact(Answers& answers) const { find_contact(spheres_, answers); }
  void box_contact(Answers& answers) const { find_contact(boxes_, answers); }
  void capsule_contact(Answers& answers) const { find_contact(capsules_, answers); }

 private:
  Mesh mesh(const std::vector<graze::Vec<3, T>>& vertices, MeshKind kind) const {
    return graze::mesh_of<3, T>(vertices, faces_, kind);
  }
  static double length(const graze::Vec<3, T>& vector) {
    const graze::Vec<3, double> wide(vector);
    return std::sqrt(dot(wide, wide));
  }
  static double t_of(const std::optional<graze::MeshHit<3, T>>& hit) {
    return hit ? static_cast<double>(hit->t) : std::numeric_limits<double>::infinity();
  }
  void cast(const Mesh& mesh, Answers& answers) const {
    answer_each(rays_, answers, [&mesh](const auto& ray) { return t_of(ray_cast(mesh, ray)); });
  }
  template <class Shape>
  void touch(const std::vector<Shape>& shapes, Answers& answers) const {
    answer_each(shapes, answers, [this](const Shape& shape) { return intersects(*surface_, shape); });
  }
  template <class Shape>
  void find_contact(const std::vector<Shape>& shapes, Answers& answers) const {
    answer_each(shapes, answers, [this](const Shape& shape) { return contact(*surface_, shape).has_value(); });
  }

  std::span<const Face> faces_;
  std::vector<graze::Vec<3, T>> vertices_;
  std::array<std::vector<graze::Vec<3, T>>, 2> moved_;
  std::vector<graze::Ray<3, T>> rays_;
  std::vector<graze::Vec<3, T>> points_;
  std::vector<graze::Pose<3, T>> places_;
  std::vector<graze::Pose<3, T>> places_apart_;
  std::vector<graze::Sphere<3, T>> spheres_;
  std::vector<graze::Obb<3, T>> boxes_;
  std::vector<graze::Capsule<3, T>> capsules_;
  graze::BatchOptions options_;
  std::optional<Mesh> surface_;
  std::optional<Mesh> solid_;
  std::optional<Mesh> moving_;
  std::size_t frame_ = 0;
};

template <class T>
void enter(const Course& course, const std::string& name, Entries& field) {
  using Adapter = OfGraze<T>;
  Enrolment<Adapter> graze(name, true, std::make_shared<Adapter>(course), field);
  graze.add(Work::build, &Adapter::clear, &Adapter::build);
  graze.add(Work::refit, &Adapter::build_moving_if_needed, &Adapter::refit, "moved");
  graze.add(Work::refit, &Adapter::build_moving_if_needed, &Adapter::rebuild, "mesh_of");
  graze.add(Work::moved_rays, &Adapter::end_refit, &Adapter::moved_rays, "moved");
  graze.add(Work::moved_rays, &Adapter::end_rebuild, &Adapter::moved_rays, "mesh_of");
  graze.add(Work::inside, &Adapter::build_solid_if_needed, &Adapter::inside);
  graze.add(Work::inside_batch, &Adapter::build_solid_if_needed, &Adapter::inside_batch);
  const auto ask = [&](Work work, auto run) { graze.add(work, &Adapter::build_if_needed, run); };
  ask(Work::rays, &Adapter::rays);
  ask(Work::rays_batch, &Adapter::rays_batch);
  ask(Work::closest, &Adapter::closest);
  ask(Work::closest_batch, &Adapter::closest_batch);
  ask(Work::meshes_touch, &Adapter::meshes_touch);
  ask(Work::face_pairs, &Adapter::face_pairs);
  ask(Work::mesh_distance, &Adapter::mesh_distance);
  ask(Work::sphere, &Adapter::sphere);
  ask(Work::box, &Adapter::box);
  ask(Work::capsule, &Adapter::capsule);
  ask(Work::sphere_contact, &Adapter::sphere_contact);
  ask(Work::box_contact, &Adapter::box_contact);
  ask(Work::capsule_contact, &Adapter::capsule_contact);
}

}  // namespace

void enter_graze(const Course& course, Entries& field) {
  enter<float>(course, "graze", field);
  enter<double>(course, "graze, double", field);
}

}  // namespace mesh_bench
