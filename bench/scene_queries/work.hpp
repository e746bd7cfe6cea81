// SPDX-License-Identifier: MIT
// A scene of objects that do not move, and what is asked about it.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include <graze/math/rotation.hpp>
#include <graze/math/vec.hpp>
#include <graze/scene/scene.hpp>
#include <graze/shape/any_shape.hpp>

namespace bench {

using graze::Dim;
template <Dim N>
using Any = graze::AnyShape<N, float>;
template <Dim N>
using Point = graze::Vec<N, float>;

enum class Kind { sphere, capsule, box };

inline const char* name_of(Kind kind) {
  return kind == Kind::sphere ? "sphere" : kind == Kind::capsule ? "capsule" : "box";
}

/// A shape that moves.
template <Dim N>
struct Cast {
  Any<N> shape;
  Point<N> motion;
};

/// Spheres, capsules and oriented boxes of about unit size that fill a tenth of a cube or square.
template <Dim N>
class Work {
 public:
  static constexpr std::size_t object_count = 100'000;
  static constexpr std::size_t question_count = 1'024;
  static constexpr float side = N == 3 ? 80 : 800;

  Work() {
    for (std::size_t i = 0; i < object_count; ++i) {
      objects_.push_back(draw(static_cast<Kind>(i % 3), point(side), 1));
      scene_.add(objects_.back());
    }
  }

  const graze::Scene<N>& scene() const { return scene_; }
  const std::vector<Any<N>>& objects() const { return objects_; }

  /// Casts over a distance that touch nothing at the start.
  std::vector<Cast<N>> casts(Kind kind, float distance) {
    std::vector<Cast<N>> result;
    while (result.size() < question_count) {
      Any<N> shape = draw(kind, point(side), 0.6F);
      if (scene_.overlapping(shape).empty()) result.push_back({std::move(shape), direction() * distance});
    }
    return result;
  }

  /// Shapes that touch a few objects each.
  std::vector<Any<N>> regions(Kind kind) {
    std::vector<Any<N>> result;
    while (result.size() < question_count) result.push_back(draw(kind, point(side), 2));
    return result;
  }

 private:
  float number(float low, float high) { return std::uniform_real_distribution<float>(low, high)(random_); }

  Point<N> point(float size) {
    Point<N> result;
    for (Dim i = 0; i < N; ++i) result[i] = number(0, size);
    return result;
  }

  Point<N> direction() {
    for (;;) {
      const Point<N> vector = point(2) - 1.0F;
      const float squared = dot(vector, vector);
      if (squared > 0.01F && squared <= 1) return vector / std::sqrt(squared);
    }
  }

  graze::Mat<N, float> rotation() {
    const double degrees = static_cast<double>(number(0, 360));
    if constexpr (N == 3) {
      return graze::Mat<3, float>(graze::rotation_matrix(graze::Vec<3, double>(direction()), degrees));
    } else {
      return graze::Mat<2, float>(graze::rotation_matrix(degrees));
    }
  }

  Any<N> draw(Kind kind, const Point<N>& center, float size) {
    if (kind == Kind::sphere) return graze::Sphere<N>{center, size * number(0.3F, 0.6F)};
    if (kind == Kind::capsule) {
      const Point<N> half = direction() * size * number(0.2F, 0.5F);
      return graze::Capsule<N>{center - half, center + half, size * number(0.2F, 0.4F)};
    }
    return graze::Obb<N>{center, (point(0.4F) + 0.2F) * size, rotation()};
  }

  std::mt19937 random_{20261128};
  std::vector<Any<N>> objects_;
  graze::Scene<N> scene_;
};

}  // namespace bench
