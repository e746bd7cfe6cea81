// SPDX-License-Identifier: MIT
// Random walks through the scenes in data/ and, if they are there, through the maps of a published game, in
// GRAZE_SHARED_DATA or in ../shared/data beside the project. No step may end in an overlap.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <random>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include <graze/io/scene_file.hpp>
#include <graze/query/bounds.hpp>
#include <graze/scene/scene.hpp>

#include "io/scene_text.hpp"
#include "number_of_cases.hpp"
#include "scene/slide_walks.hpp"

namespace graze::io::slide_in_levels_test {
namespace {

namespace fs = std::filesystem;

/// Walkers of three shapes that begin anywhere in a level where they overlap nothing.
template <Dim N, class T>
class Walkers {
 public:
  using V = Vec<N, T>;

  explicit Walkers(const Scene<N, T>& scene) : scene_(scene) {
    Aabb<N, T> around = Aabb<N, T>::nothing();
    for (const ObjectId id : scene.ids()) {
      const Aabb<N, T> box = bounds(scene.object(id).shape);
      if (is_finite(box.min) && is_finite(box.max)) around.grow(box);
    }
    level_ = around;
    size_ = max_abs(around.max - around.min) / T(60);
  }

  /// In walks of a hundred steps.
  void expect_no_overlap(std::size_t steps) {
    const double size = static_cast<double>(size_);
    const std::array<SlideOptions, 2> options = {
        SlideOptions{.clearance = size / 1000},
        SlideOptions{.max_slope = 0.8, .step_height = size / 2, .clearance = size / 100}};
    constexpr std::size_t walk_steps = 100;
    std::size_t touches = 0;
    for (std::size_t walk = 0; walk * walk_steps < steps; ++walk) {
      const V motion = vector(size_);  // most steps lead the same way
      const auto motion_of = [&](std::size_t step) {
        return step % 8 == 7 ? vector(4 * size_) : motion + vector(size_);
      };
      touches +=
          test::expect_a_walk_without_overlap<N, T>(scene_, start(walk % 3), walk_steps, options[walk % 2], motion_of)
              .touches;
      if (::testing::Test::HasFailure()) return;
    }
    EXPECT_GT(touches, steps / 20) << "they hardly meet anything";
  }

 private:
  T number(T low, T high) { return std::uniform_real_distribution<T>(low, high)(random_); }

  V vector(T size) {
    V result;
    for (Dim axis = 0; axis < N; ++axis) result[axis] = number(-size, size);
    return result;
  }

  AnyShape<N, T> start(std::size_t kind) {
    for (int attempt = 0; attempt < 10'000; ++attempt) {
      V center;
      for (Dim axis = 0; axis < N; ++axis) center[axis] = number(level_.min[axis], level_.max[axis]);
      const T size = size_ * number(T(0.3), T(1));
      AnyShape<N, T> shape = Sphere<N, T>{center, size};
      if (kind == 1) shape = Capsule<N, T>{center, center + vector(size), size / 2};
      if (kind == 2) shape = Aabb<N, T>::from_center(center, V(size));
      if (!test::overlaps_an_object<N, T>(scene_, shape)) return shape;
    }
    ADD_FAILURE() << "there is no free place";
    return Sphere<N, T>{V(T(0)), T(0)};
  }

  const Scene<N, T>& scene_;
  std::mt19937 random_{46};
  Aabb<N, T> level_;
  T size_ = 0;  ///< About that of a walker.
};

void expect_walks_in(const fs::path& path) {
  SCOPED_TRACE(path.filename().string());
  const SceneFile file = read_scene(path);
  std::visit([](const auto& scene) { Walkers(scene).expect_no_overlap(test::number_of_cases(100'000)); }, file.scene);
}

TEST(SlideInLevels, OfTheProjectOverlapsNothing) {
  expect_walks_in(project_file("data/platform_level.tmx"));
  expect_walks_in(project_file("data/workshop.json"));
}

TEST(SlideInLevels, OfAPublishedGameOverlapsNothing) {
  for (const char* const name : {"sandbox.tmx", "sandbox2.tmx"}) {
    const fs::path path = shared_file(std::string("sticker-knight/") + name);
    if (!fs::exists(path)) GTEST_SKIP() << "there is no " << path << "; set GRAZE_SHARED_DATA to the folder";
    expect_walks_in(path);
  }
}

}  // namespace
}  // namespace graze::io::slide_in_levels_test
