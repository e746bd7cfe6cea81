// SPDX-License-Identifier: MIT
// FCL's BVHModel<OBBRSS> in double, as Debian's library is compiled, with the default solver for shapes. A point is a
// sphere of radius 0.
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/math/bv/OBBRSS.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include "contestant.hpp"

namespace mesh_bench {
namespace {

using Model = fcl::BVHModel<fcl::OBBRSSd>;

fcl::Vector3d vector_of(const Point& point) {
  const graze::Vec<3, double> wide(point);
  return {wide.x, wide.y, wide.z};
}

fcl::Transform3d transform_of(const graze::Mat<3, float>& rotation, const Point& position) {
  fcl::Transform3d result = fcl::Transform3d::Identity();
  for (int column = 0; column < 3; ++column) result.linear().col(column) = vector_of(rotation[column]);
  result.translation() = vector_of(position);
  return result;
}

fcl::Transform3d pose_of(const Pose& pose) { return transform_of(pose.rotation, pose.position); }
fcl::Transform3d pose_of(const graze::Sphere<3>& sphere) {
  return transform_of(graze::Mat<3, float>(1.0F), sphere.center);
}
fcl::Transform3d pose_of(const graze::Obb<3>& box) { return transform_of(box.axes, box.center); }
/// FCL's capsules are parallel to the z axis.
fcl::Transform3d pose_of(const graze::Capsule<3>& capsule) {
  fcl::Transform3d result = fcl::Transform3d::Identity();
  const fcl::Vector3d a = vector_of(capsule.a);
  const fcl::Vector3d b = vector_of(capsule.b);
  result.linear() = Eigen::Quaterniond::FromTwoVectors(fcl::Vector3d::UnitZ(), b - a).toRotationMatrix();
  result.translation() = (a + b) / 2;
  return result;
}

fcl::Sphered shape_of(const graze::Sphere<3>& sphere) { return fcl::Sphered(static_cast<double>(sphere.radius)); }
fcl::Boxd shape_of(const graze::Obb<3>& box) { return fcl::Boxd(2 * vector_of(box.half_extents)); }
fcl::Capsuled shape_of(const graze::Capsule<3>& capsule) {
  return {static_cast<double>(capsule.radius), (vector_of(capsule.b) - vector_of(capsule.a)).norm()};
}

class OfFcl {
 public:
  explicit OfFcl(const Course& course) : course_(course) {}

  void clear() { model_.reset(); }
  void build() {
    const Surface& surface = course_.surface;
    std::vector<fcl::Vector3d> vertices;
    std::vector<fcl::Triangle> faces;
    vertices.reserve(surface.vertices.size());
    faces.reserve(surface.faces.size());
    for (const Point& vertex : surface.vertices) vertices.push_back(vector_of(vertex));
    for (const Face& face : surface.faces) faces.emplace_back(face[0], face[1], face[2]);
    model_ = std::make_unique<Model>();
    model_->beginModel(static_cast<int>(faces.size()), static_cast<int>(vertices.size()));
    model_->addSubModel(vertices, faces);
    model_->endModel();
  }
  void build_if_needed() {
    if (!model_) build();
  }

  void closest(Answers& answers) const {
    const fcl::Sphered point(0);
    answer_each(course_.points, answers, [&](const Point& place) {
      return distance(point, fcl::Transform3d(Eigen::Translation3d(vector_of(place))));
    });
  }

  void meshes_touch(Answers& answers) const {
    answer_each(course_.places, answers,
                [this](const Pose& pose) { return collide(*model_, pose_of(pose), yes_or_no()).isCollision(); });
  }
  void face_pairs(Answers& answers) const {
    answers.pairs.clear();
    for (const Pose& pose : course_.places) answers.pairs.push_back(pairs_with(pose_of(pose)));
  }
  void mesh_distance(Answers& answers) const {
    answer_each(course_.places_apart, answers, [this](const Pose& pose) { return distance(*model_, pose_of(pose)); });
  }

  void sphere(Answers& answers) const { touch(course_.spheres, yes_or_no(), answers); }
  void box(Answers& answers) const { touch(course_.boxes, yes_or_no(), answers); }
  void capsule(Answers& answers) const { touch(course_.capsules, yes_or_no(), answers); }
  void sphere_contact(Answers& answers) const { touch(course_.spheres, all_contacts(), answers); }
  void box_contact(Answers& answers) const { touch(course_.boxes, all_contacts(), answers); }
  void capsule_contact(Answers& answers) const { touch(course_.capsules, all_contacts(), answers); }

 private:
  static fcl::CollisionRequestd yes_or_no() { return fcl::CollisionRequestd(); }
  static fcl::CollisionRequestd all_pairs() { return fcl::CollisionRequestd(std::numeric_limits<std::size_t>::max()); }
  static fcl::CollisionRequestd all_contacts() {
    return fcl::CollisionRequestd(std::numeric_limits<std::size_t>::max(), true);
  }
  fcl::CollisionResultd collide(const fcl::CollisionGeometryd& other, const fcl::Transform3d& pose,
                                const fcl::CollisionRequestd& request) const {
    fcl::CollisionResultd result;
    fcl::collide<double>(model_.get(), fcl::Transform3d::Identity(), &other, pose, request, result);
    return result;
  }
  double distance(const fcl::CollisionGeometryd& other, const fcl::Transform3d& pose) const {
    const fcl::DistanceRequestd request;
    fcl::DistanceResultd result;
    return fcl::distance<double>(model_.get(), fcl::Transform3d::Identity(), &other, pose, request, result);
  }
  std::vector<graze::Pair> pairs_with(const fcl::Transform3d& pose) const {
    const fcl::CollisionResultd result = collide(*model_, pose, all_pairs());
    std::vector<graze::Pair> pairs;
    for (std::size_t k = 0; k < result.numContacts(); ++k) {
      const fcl::Contactd& contact = result.getContact(k);
      pairs.push_back({static_cast<std::uint32_t>(contact.b1), static_cast<std::uint32_t>(contact.b2)});
    }
    return pairs;
  }
  template <class Shape>
  void touch(const std::vector<Shape>& shapes, const fcl::CollisionRequestd& request, Answers& answers) const {
    answer_each(shapes, answers,
                [&](const Shape& shape) { return collide(shape_of(shape), pose_of(shape), request).isCollision(); });
  }

  const Course& course_;
  std::unique_ptr<Model> model_;
};

}  // namespace

void enter_fcl(const Course& course, Entries& field) {
  Enrolment<OfFcl> fcl("FCL", false, std::make_shared<OfFcl>(course), field);
  fcl.add(Work::build, &OfFcl::clear, &OfFcl::build);
  const auto ask = [&](Work work, auto run) { fcl.add(work, &OfFcl::build_if_needed, run); };
  ask(Work::closest, &OfFcl::closest);
  ask(Work::closest_batch, &OfFcl::closest);
  ask(Work::meshes_touch, &OfFcl::meshes_touch);
  ask(Work::face_pairs, &OfFcl::face_pairs);
  ask(Work::mesh_distance, &OfFcl::mesh_distance);
  ask(Work::sphere, &OfFcl::sphere);
  ask(Work::box, &OfFcl::box);
  ask(Work::capsule, &OfFcl::capsule);
  ask(Work::sphere_contact, &OfFcl::sphere_contact);
  ask(Work::box_contact, &OfFcl::box_contact);
  ask(Work::capsule_contact, &OfFcl::capsule_contact);
}

}  // namespace mesh_bench
