// SPDX-License-Identifier: MIT
#include "surface.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace mesh_bench {
namespace {

using Lattice = graze::Vec<3, int>;
using Wide = graze::Vec<3, double>;

/// A number from -1 to 1 for each point of the lattice.
double random_at(const Lattice& place) {
  std::uint64_t bits = 0x9e37'79b9'7f4a'7c15U;
  for (int i = 0; i < 3; ++i) {
    bits ^= static_cast<std::uint64_t>(static_cast<std::int64_t>(place[i])) + (bits << 6U) + (bits >> 2U);
    bits *= 0xbf58'476d'1ce4'e5b9U;
    bits ^= bits >> 31U;
  }
  return static_cast<double>(bits >> 11U) * 0x1p-52 - 1;
}

/// Random numbers at the points of the lattice, interpolated smoothly.
double noise(const Wide& at) {
  const Wide floor{std::floor(at.x), std::floor(at.y), std::floor(at.z)};
  const Wide share = at - floor;
  const Wide weight = share * share * (Wide(3.0) - 2.0 * share);
  double sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const Lattice step{corner & 1, (corner >> 1) & 1, (corner >> 2) & 1};
    double part = random_at(Lattice(floor) + step);
    for (int i = 0; i < 3; ++i) part *= step[i] == 1 ? weight[i] : 1 - weight[i];
    sum += part;
  }
  return sum;
}

Point displaced(const Lattice& corner, int divisions) {
  const Wide place(corner);
  const Wide direction = place / std::sqrt(dot(place, place));
  double radius = 1;
  double amplitude = 0.3;
  for (int frequency = 2; frequency <= divisions; frequency *= 2, amplitude *= 0.45) {
    radius += amplitude * noise(direction * static_cast<double>(frequency) + Wide(0.37));
  }
  return Point(direction * radius);
}

/// Divides the faces of the octahedron |x| + |y| + |z| = divisions along the lattice.
class Octahedron {
 public:
  explicit Octahedron(int divisions) : divisions_(divisions) {
    for (const int x : {1, -1}) {
      for (const int y : {1, -1}) {
        for (const int z : {1, -1}) divide({x, y, z});
      }
    }
  }

  Surface surface() && { return std::move(surface_); }

 private:
  void divide(const Lattice& signs) {
    for (int i = 0; i < divisions_; ++i) {
      for (int j = 0; i + j < divisions_; ++j) {
        const int k = divisions_ - i - j;
        add(signs, {i + 1, j, k - 1}, {i, j + 1, k - 1}, {i, j, k});
        if (k > 1) add(signs, {i + 1, j, k - 1}, {i + 1, j + 1, k - 2}, {i, j + 1, k - 1});
      }
    }
  }
  void add(const Lattice& signs, const Lattice& a, const Lattice& b, const Lattice& c) {
    Face face{vertex(signs * a), vertex(signs * b), vertex(signs * c)};
    if (signs.x * signs.y * signs.z < 0) std::swap(face[1], face[2]);
    surface_.faces.push_back(face);
  }
  std::uint32_t vertex(const Lattice& corner) {
    const auto [found, is_new] =
        numbers_.try_emplace({corner.x, corner.y, corner.z}, static_cast<std::uint32_t>(surface_.vertices.size()));
    if (is_new) surface_.vertices.push_back(displaced(corner, divisions_));
    return found->second;
  }

  int divisions_;
  std::map<std::array<int, 3>, std::uint32_t> numbers_;
  Surface surface_;
};

}  // namespace

Surface potato(std::size_t faces) {
  const double divisions = std::sqrt(static_cast<double>(faces) / 8);
  Surface surface = Octahedron(std::max(1, static_cast<int>(std::lround(divisions)))).surface();
  surface.name = "potato";
  return surface;
}

}  // namespace mesh_bench
