// SPDX-License-Identifier: MIT
// 3D points most of which are on a few lines or planes, up to the rounding of their coordinates.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <rapidcheck.h>

#include <graze/math/pose.hpp>
#include <graze/math/vec.hpp>

#include "catalogue.hpp"

namespace graze::test {

/// Where the points of a thin cloud are.
enum class ThinCloud {
  lines,
  planes,
  cube_edges,
  cube_faces,
  lattice,
  rulings,  ///< Of a cylinder and a cone.
  box,      ///< Thinner than wide and wider than long, by up to 1e20 each.
};
inline constexpr std::size_t thin_clouds = 7;

/// A cloud after generation: rotated and moved, because axis alignment hides rounding.
class ThinCrowdSource {
 public:
  ThinCrowdSource(ThinCloud cluster, rc::Random& random)
      : crowd_(cluster),
        random_(random),
        turn_(rotation_matrix(Vec<3, double>(number(), number(), 2), 90 * number())),
        offset_(whole(random, 0, 2) == 0 ? vector() * 1e6 : Vec<3, double>(0.0)),
        steps_(std::exp2(whole(random, 1, 4))),
        thickness_(std::pow(10.0, whole(random, -20, 0))) {
    for (std::array<Vec<3, double>, 3>& part : parts_) part = {vector(), vector(), vector()};
  }

  Vec<3, double> next() {
    const std::array<Vec<3, double>, 3>& part = parts_[below(parts_.size())];
    if (crowd_ == ThinCloud::lines) return offset_ + part[0] + part[1] * number();
    if (crowd_ == ThinCloud::planes) return offset_ + part[0] + part[1] * number() + part[2] * number();
    return offset_ + turn_ * untilted();
  }

 private:
  Vec<3, double> untilted() {
    Vec<3, double> point = vector();
    const double angle = 0.5 * whole(random_, 0, 12);
    switch (crowd_) {
      case ThinCloud::cube_edges:
        point[static_cast<Dim>(below(3))] = below(2) == 0 ? 1 : -1;
        [[fallthrough]];
      case ThinCloud::cube_faces:
        point[static_cast<Dim>(below(3))] = below(2) == 0 ? 1 : -1;
        return point;
      case ThinCloud::lattice:
        for (Dim i = 0; i < 3; ++i) point[i] = std::round(point[i] * steps_) / steps_;
        return point;
      case ThinCloud::rulings:
        if (point.x > 0) return {std::cos(angle), std::sin(angle), point.z};
        return {std::cos(angle) * point.z, std::sin(angle) * point.z, point.z};
      default:
        return point * Vec<3, double>(1, thickness_, thickness_ * thickness_);
    }
  }

  double number() { return between(random_, -1, 1); }
  Vec<3, double> vector() {
    const double x = number();
    const double y = number();
    return {x, y, number()};
  }
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(random_.next() % count); }

  ThinCloud crowd_;
  rc::Random& random_;
  Mat<3, double> turn_;
  Vec<3, double> offset_;
  double steps_;
  double thickness_;
  std::array<std::array<Vec<3, double>, 3>, 4> parts_;
};

/// About one in eight of the points duplicates an earlier one.
template <class T>
std::vector<Vec<3, T>> thin_crowd(ThinCloud cluster, std::size_t count, std::uint64_t seed) {
  rc::Random random(seed);
  ThinCrowdSource source(cluster, random);
  std::vector<Vec<3, T>> points;
  while (points.size() < count) {
    const bool is_repeated = !points.empty() && whole(random, 0, 7) == 0;
    points.push_back(is_repeated ? points[random.next() % points.size()] : Vec<3, T>(source.next()));
  }
  return points;
}

}  // namespace graze::test
