// SPDX-License-Identifier: MIT
// Bullet, in float, for two oriented boxes: its detector alone, with its points stored as they come; and what its
// worlds use, btBoxBoxCollisionAlgorithm with a persistent manifold that recognises points of the previous frame, which
// graze supports by ids.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>

#include <BulletCollision/CollisionDispatch/btBoxBoxCollisionAlgorithm.h>
#include <BulletCollision/CollisionDispatch/btBoxBoxDetector.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <benchmark/benchmark.h>

#include "../bench/contact/answer.hpp"

namespace graze::contact_bench {

struct BulletBox {
  std::unique_ptr<btBoxShape> shape;
  btTransform pose = btTransform::getIdentity();

  explicit BulletBox(const Obb& box) : shape(std::make_unique<btBoxShape>(vector(box.half_extents))) {
    const btVector3 x = vector(box.axes[0]);
    const btVector3 y = vector(box.axes[1]);
    const btVector3 z = vector(box.axes[2]);
    pose.setBasis(btMatrix3x3(x.x(), y.x(), z.x(), x.y(), y.y(), z.y(), x.z(), y.z(), z.z()));
    pose.setOrigin(vector(box.center));
  }

 private:
  static btVector3 vector(const Point& v) {
    return {static_cast<btScalar>(v.x), static_cast<btScalar>(v.y), static_cast<btScalar>(v.z)};
  }
};

/// Stores the detector's points.
class BulletPoints : public btDiscreteCollisionDetectorInterface::Result {
 public:
  struct Contact {
    btVector3 on_a;
    btVector3 on_b;
    btScalar depth;
  };

  void setShapeIdentifiersA(int, int) override {}
  void setShapeIdentifiersB(int, int) override {}
  void addContactPoint(const btVector3& normal_on_b, const btVector3& point_on_b, btScalar distance) override {
    normal = normal_on_b;
    if (size < points.size()) points[size++] = {point_on_b + normal_on_b * distance, point_on_b, -distance};
  }

  std::array<Contact, 8> points;
  std::size_t size = 0;
  btVector3 normal;
};

class BulletDetectorPair {
 public:
  static constexpr const char* name = "Bullet";

  BulletDetectorPair(const Obb& a, const Obb& b) : a_(a), b_(b) {}

  Answer find() const {
    btBoxBoxDetector detector(a_.shape.get(), b_.shape.get());
    btDiscreteCollisionDetectorInterface::ClosestPointInput input;
    input.m_transformA = a_.pose;
    input.m_transformB = b_.pose;
    BulletPoints found;
    detector.getClosestPoints(input, found, nullptr);
    benchmark::DoNotOptimize(found.points);
    Answer answer{found.size, 0};
    for (std::size_t i = 0; i < found.size; ++i) {
      answer.depth = std::max(answer.depth, static_cast<double>(found.points[i].depth));
    }
    return answer;
  }

 private:
  BulletBox a_;
  BulletBox b_;
};

/// Like a pair in a world: its objects, algorithm and manifold persist between frames.
class BulletManifoldPair {
 public:
  static constexpr const char* name = "Bullet manifold";

  BulletManifoldPair(const Obb& a, const Obb& b) : objects_(std::make_unique<Objects>(a, b)) {}

  Answer find() const {
    Objects& objects = *objects_;
    btManifoldResult result(&objects.wrapper_a, &objects.wrapper_b);
    objects.algorithm->processCollision(&objects.wrapper_a, &objects.wrapper_b, objects.info, &result);
    const btPersistentManifold& manifold = *objects.manifold;
    Answer answer{static_cast<std::size_t>(manifold.getNumContacts()), 0};
    for (int i = 0; i < manifold.getNumContacts(); ++i) {
      answer.depth = std::max(answer.depth, -static_cast<double>(manifold.getContactPoint(i).getDistance()));
    }
    return answer;
  }

 private:
  /// Pairs live as long as the registered benchmarks, until the program ends.
  struct World {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{&configuration};
  };

  static std::shared_ptr<World> shared_world() {
    static const auto world = std::make_shared<World>();
    return world;
  }

  struct Objects {
    std::shared_ptr<World> world = shared_world();
    BulletBox box_a;
    BulletBox box_b;
    btCollisionObject object_a;
    btCollisionObject object_b;
    btCollisionObjectWrapper wrapper_a{nullptr, box_a.shape.get(), &object_a, object_a.getWorldTransform(), -1, -1};
    btCollisionObjectWrapper wrapper_b{nullptr, box_b.shape.get(), &object_b, object_b.getWorldTransform(), -1, -1};
    btPersistentManifold* manifold = nullptr;
    std::unique_ptr<btBoxBoxCollisionAlgorithm> algorithm;
    btDispatcherInfo info;

    Objects(const Obb& a, const Obb& b) : box_a(a), box_b(b) {
      object_a.setCollisionShape(box_a.shape.get());
      object_b.setCollisionShape(box_b.shape.get());
      object_a.setWorldTransform(box_a.pose);
      object_b.setWorldTransform(box_b.pose);
      manifold = world->dispatcher.getNewManifold(&object_a, &object_b);
      const btCollisionAlgorithmConstructionInfo construction(&world->dispatcher, 0);
      algorithm = std::make_unique<btBoxBoxCollisionAlgorithm>(manifold, construction, &wrapper_a, &wrapper_b);
    }
    ~Objects() {
      algorithm.reset();
      world->dispatcher.releaseManifold(manifold);
    }
    Objects(const Objects&) = delete;
    Objects& operator=(const Objects&) = delete;
  };

  std::unique_ptr<Objects> objects_;
};

}  // namespace graze::contact_bench
