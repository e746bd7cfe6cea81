// SPDX-License-Identifier: MIT
// Bullet's distances of two convex hulls, in float and without margins: btGjkPairDetector, which its worlds use and
// which caches the last separating axis; and btGjkEpaSolver2::Distance, which takes an initial guess.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpa2.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include "../bench/hull_distance/pairs.hpp"

namespace graze::hull_bench {

class BulletHulls {
 public:
  explicit BulletHulls(const MovingPair& pair) {
    for (std::size_t k = 0; k < 2; ++k) {
      shapes_[k] = std::make_unique<btConvexHullShape>();
      for (const Point& corner : pair.hulls[k].vertices()) shapes_[k]->addPoint(vector(corner), false);
      shapes_[k]->recalcLocalAabb();
      shapes_[k]->setMargin(0);
    }
    for (const auto& places : pair.frames) frames_.push_back({transform(places[0]), transform(places[1])});
  }

 protected:
  const btConvexHullShape& shape(std::size_t k) const { return *shapes_[k]; }
  const std::array<btTransform, 2>& frame(std::size_t i) const { return frames_[i]; }

 private:
  static btVector3 vector(const Point& v) {
    return {static_cast<btScalar>(v.x), static_cast<btScalar>(v.y), static_cast<btScalar>(v.z)};
  }
  static btTransform transform(const Place& place) {
    btMatrix3x3 basis;
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        basis[row][column] = static_cast<btScalar>(place.rotation[column][row]);
      }
    }
    return btTransform(basis, vector(place.position));
  }

  std::array<std::unique_ptr<btConvexHullShape>, 2> shapes_;
  std::vector<std::array<btTransform, 2>> frames_;
};

class BulletDetector : BulletHulls {
 public:
  static constexpr const char* name = "Bullet btGjkPairDetector";

  explicit BulletDetector(const MovingPair& pair)
      : BulletHulls(pair), detector_(&shape(0), &shape(1), &simplex_, nullptr) {}

  double find(std::size_t i) {
    detector_.setCachedSeparatingAxis(btVector3(0, 1, 0));  // the initial value in Bullet
    return follow(i);
  }
  double follow(std::size_t i) {
    btGjkPairDetector::ClosestPointInput input;
    input.m_transformA = frame(i)[0];
    input.m_transformB = frame(i)[1];
    btPointCollector nearest;
    detector_.getClosestPoints(input, nearest, nullptr);
    return nearest.m_distance;
  }

 private:
  btVoronoiSimplexSolver simplex_;
  btGjkPairDetector detector_;
};

class BulletSolver : BulletHulls {
 public:
  static constexpr const char* name = "Bullet btGjkEpaSolver2";

  explicit BulletSolver(const MovingPair& pair) : BulletHulls(pair) {}

  double find(std::size_t i) {
    guess_ = btVector3(1, 0, 0);
    return follow(i);
  }
  double follow(std::size_t i) {
    btGjkEpaSolver2::sResults nearest;
    const bool are_apart = btGjkEpaSolver2::Distance(&shape(0), frame(i)[0], &shape(1), frame(i)[1], guess_, nearest);
    if (are_apart) guess_ = nearest.witnesses[0] - nearest.witnesses[1];
    return are_apart ? nearest.distance : 0;
  }

 private:
  btVector3 guess_{1, 0, 0};
};

}  // namespace graze::hull_bench
