// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <graze/scene/scene.hpp>

#include "../bench/scene_queries/work.hpp"

namespace bench {

template <Dim N>
class OfGraze {
 public:
  static constexpr const char* name = "graze Scene";
  using Mover = Cast<N>;
  using Region = Any<N>;

  explicit OfGraze(const Work<N>& work) : scene_(work.scene()) {}

  Mover mover(const Cast<N>& cast) const { return cast; }
  Region region(const Any<N>& shape) const { return shape; }

  /// The time of the first touch.
  std::optional<float> cast(const Mover& mover) const {
    const auto found = scene_.shape_cast(mover.shape, mover.motion);
    if (!found) return std::nullopt;
    return found->impact.t;
  }

  /// The number of each object that a region touches, with its contact points; returns how many points there are.
  std::size_t touch(const Region& region, std::vector<std::uint32_t>& objects) const {
    objects.clear();
    std::size_t points = 0;
    for (const auto& touch : scene_.contacts_with(region)) {
      objects.push_back(touch.id.index);
      points += touch.manifold.size;
    }
    return points;
  }

 private:
  const graze::Scene<N>& scene_;
};

}  // namespace bench
