// SPDX-License-Identifier: MIT
// Bullet's btBvhTriangleMeshShape in float, without margins. Its question about a shape and a mesh, contactPairTest,
// calculates contacts; yes means that one has no positive distance. Bullet has absolute tolerances, with which it
// misses contacts of shapes of a hundredth; so everything is scaled by a power of two, to a reach of 512 to 1024.
#include <array>
#include <cmath>
#include <memory>
#include <type_traits>
#include <vector>

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btBvhTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btCapsuleShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/CollisionShapes/btTriangleIndexVertexArray.h>

#include "contestant.hpp"

namespace mesh_bench {
namespace {

btVector3 vector_of(const Point& point) { return {point.x, point.y, point.z}; }

btTransform pose_of(const graze::Sphere<3>& sphere) {
  return btTransform(btMatrix3x3::getIdentity(), vector_of(sphere.center));
}
btTransform pose_of(const graze::Obb<3>& box) {
  btMatrix3x3 basis;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) basis[row][column] = box.axes[column][row];
  }
  return btTransform(basis, vector_of(box.center));
}
/// Bullet's capsules are parallel to the y axis.
btTransform pose_of(const graze::Capsule<3>& capsule) {
  const btVector3 a = vector_of(capsule.a);
  const btVector3 b = vector_of(capsule.b);
  return btTransform(shortestArcQuat(btVector3(0, 1, 0), (b - a).normalized()), (a + b) / 2);
}

btSphereShape shape_of(const graze::Sphere<3>& sphere) { return btSphereShape(sphere.radius); }
btBoxShape shape_of(const graze::Obb<3>& box) {
  btBoxShape shape(vector_of(box.half_extents));
  shape.setMargin(0);
  return shape;
}
btCapsuleShape shape_of(const graze::Capsule<3>& capsule) {
  return btCapsuleShape(capsule.radius, (vector_of(capsule.b) - vector_of(capsule.a)).length());
}

graze::Sphere<3> scaled(const graze::Sphere<3>& sphere, float factor) {
  return {sphere.center * factor, sphere.radius * factor};
}
graze::Obb<3> scaled(const graze::Obb<3>& box, float factor) {
  return {box.center * factor, box.half_extents * factor, box.axes};
}
graze::Capsule<3> scaled(const graze::Capsule<3>& capsule, float factor) {
  return {capsule.a * factor, capsule.b * factor, capsule.radius * factor};
}

template <class Value>
std::vector<Value> all_scaled(std::vector<Value> values, float factor) {
  for (Value& value : values) {
    if constexpr (std::is_same_v<Value, Point>) {
      value *= factor;
    } else {
      value = scaled(value, factor);
    }
  }
  return values;
}

/// A mesh on vertices and faces, which it does not copy.
struct Mesh {
  Mesh(std::vector<Point>& vertices, std::vector<std::array<int, 3>>& faces)
      : triangles(static_cast<int>(faces.size()), faces.front().data(), sizeof(faces.front()),
                  static_cast<int>(vertices.size()), &vertices.front().x, sizeof(Point)),
        shape(&triangles, true) {
    shape.setMargin(0);
    object.setCollisionShape(&shape);
  }

  btTriangleIndexVertexArray triangles;
  btBvhTriangleMeshShape shape;
  btCollisionObject object;
};

struct Touch final : btCollisionWorld::ContactResultCallback {
  // NOLINTNEXTLINE(readability-function-size): Bullet's parameters
  btScalar addSingleResult(btManifoldPoint& point, const btCollisionObjectWrapper* /*a*/, int /*part_a*/,
                           int /*index_a*/, const btCollisionObjectWrapper* /*b*/, int /*part_b*/,
                           int /*index_b*/) override {
    is_found = is_found || point.getDistance() <= 0;
    return 0;
  }

  bool is_found = false;
};

class OfBullet {
 public:
  explicit OfBullet(const Course& course)
      : factor_(static_cast<float>(std::exp2(9 - std::floor(std::log2(course.reach))))),
        vertices_(all_scaled(course.surface.vertices, factor_)),
        spheres_(all_scaled(course.spheres, factor_)),
        boxes_(all_scaled(course.boxes, factor_)),
        capsules_(all_scaled(course.capsules, factor_)) {
    faces_.reserve(course.surface.faces.size());
    for (const Face& face : course.surface.faces) {
      faces_.push_back({static_cast<int>(face[0]), static_cast<int>(face[1]), static_cast<int>(face[2])});
    }
  }

  void clear() { mesh_.reset(); }
  void build() { mesh_ = std::make_unique<Mesh>(vertices_, faces_); }
  void build_if_needed() {
    if (!mesh_) build();
  }

  void sphere(Answers& answers) { touch(spheres_, answers); }
  void box(Answers& answers) { touch(boxes_, answers); }
  void capsule(Answers& answers) { touch(capsules_, answers); }

 private:
  template <class Shape>
  void touch(const std::vector<Shape>& shapes, Answers& answers) {
    answer_each(shapes, answers, [this](const Shape& shape) {
      auto placed = shape_of(shape);
      btCollisionObject object;
      object.setCollisionShape(&placed);
      object.setWorldTransform(pose_of(shape));
      Touch touch;
      world_.contactPairTest(&object, &mesh_->object, touch);
      return touch.is_found;
    });
  }

  float factor_;
  std::vector<Point> vertices_;
  std::vector<graze::Sphere<3>> spheres_;
  std::vector<graze::Obb<3>> boxes_;
  std::vector<graze::Capsule<3>> capsules_;
  std::vector<std::array<int, 3>> faces_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btCollisionWorld world_{&dispatcher_, &broadphase_, &configuration_};
  std::unique_ptr<Mesh> mesh_;
};

}  // namespace

void enter_bullet(const Course& course, Entries& field) {
  Enrolment<OfBullet> bullet("Bullet", false, std::make_shared<OfBullet>(course), field);
  bullet.add(Work::build, &OfBullet::clear, &OfBullet::build);
  const auto ask = [&](Work work, auto run) { bullet.add(work, &OfBullet::build_if_needed, run); };
  ask(Work::sphere, &OfBullet::sphere);
  ask(Work::box, &OfBullet::box);
  ask(Work::capsule, &OfBullet::capsule);
  ask(Work::sphere_contact, &OfBullet::sphere);
  ask(Work::box_contact, &OfBullet::box);
  ask(Work::capsule_contact, &OfBullet::capsule);
}

}  // namespace mesh_bench
