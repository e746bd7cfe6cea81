// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include <graze/broad/scene_generators.hpp>
#include <graze/math/rounding.hpp>

namespace graze {
namespace {

using detail::MovingBody;

constexpr std::array<std::pair<std::string_view, World>, 8> names{{{"brownian", World::brownian},
                                                                   {"heavy", World::heavy},
                                                                   {"cluster", World::cluster},
                                                                   {"line", World::line},
                                                                   {"plane", World::plane},
                                                                   {"lattice", World::lattice},
                                                                   {"giants", World::giants},
                                                                   {"point", World::point}}};

/// Random numbers by splitmix64 (Steele, Lea and Flood 2014, "Fast splittable pseudorandom number generators").
/// Everything derived from them uses only + - * / and sqrt, which round alike everywhere; log, pow and the
/// distributions of the standard library do not.
class Random {
 public:
  /// Stores in `state` where the next generator continues.
  explicit Random(std::uint64_t& state) : state_(state) {}

  std::uint64_t bits() {
    state_ += 0x9e3779b97f4a7c15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31U);
  }

  /// Uniform in [0, 1).
  double fraction() { return static_cast<double>(bits() >> 11U) * 0x1p-53; }

  /// Uniform between two numbers.
  double between(double low, double high) { return low + (high - low) * fraction(); }

  /// Uniform in the unit disc without its center, by rejection.
  Vec<2, double> point_in_disc() {
    for (;;) {
      const double x = between(-1, 1);
      const double y = between(-1, 1);
      const double square = x * x + y * y;
      if (square > 0 && square < 1) return {x, y};
    }
  }

 private:
  std::uint64_t& state_;
};

/// The cube root. The last bits of std::cbrt differ between systems. Newton's method converges to the root from above.
double cube_root(double x) {
  double root = std::max(x, 1.0);
  for (;;) {
    const double next = (2 * root + x / (root * root)) / 3;
    if (!(next < root)) return root;
    root = next;
  }
}

/// The edge of a square or cube of that area or volume.
template <Dim N>
double edge_of(double volume) {
  return N == 2 ? std::sqrt(volume) : cube_root(volume);
}

Vec<2, double> half_extents_of_turned_square(Random& random) {
  const Vec<2, double> point = random.point_in_disc();
  const double length = std::sqrt(point.x * point.x + point.y * point.y);
  return Vec<2, double>((std::fabs(point.x) + std::fabs(point.y)) / (2 * length));
}

/// Half the row sums of the absolute values of a rotation, from a quaternion uniform on its sphere (Marsaglia 1972,
/// "Choosing a point from the surface of a sphere").
Vec<3, double> half_extents_of_turned_cube(Random& random) {
  const Vec<2, double> first = random.point_in_disc();
  const Vec<2, double> second = random.point_in_disc();
  const double rest = 1 - (first.x * first.x + first.y * first.y);
  const double scale = std::sqrt(rest / (second.x * second.x + second.y * second.y));
  const double x = first.x;
  const double y = first.y;
  const double z = second.x * scale;
  const double w = second.y * scale;
  const auto half = [](double a, double b, double c) { return (std::fabs(a) + std::fabs(b) + std::fabs(c)) / 2; };
  return {half(1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)),
          half(2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)),
          half(2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y))};
}

/// The half extents of the bounding box of a unit cube in a random orientation.
template <Dim N>
Vec<N, double> turned_half_extents(Random& random) {
  if constexpr (N == 2) {
    return half_extents_of_turned_square(random);
  } else {
    return half_extents_of_turned_cube(random);
  }
}

/// The ratio of the region where another cube's center must be for two rotated unit cubes' boxes to overlap to the box
/// itself: the mean of the product of (width of one + width of the other) over the axes; in 3D determined
/// experimentally.
template <Dim N>
constexpr double reach = N == 2 ? 6.515 : 26.8;

/// A scene under construction.
template <Dim N>
class WorldMaker {
 public:
  WorldMaker(std::size_t count, Random& random) : random_(random), bodies_(count) {}

  void make(World world) {
    if (world == World::lattice) return make_lattice();
    for (MovingBody<N>& body : bodies_) body.half_extents = turned_half_extents<N>(random_);
    if (world == World::heavy) spread_sizes();
    if (world == World::cluster) return gather_in_clouds();
    set_walls(widths_of(world));
    for (MovingBody<N>& body : bodies_) body.center = random_point(walls_);
    if (world == World::giants) add_giants();
  }

  std::vector<MovingBody<N>>& bodies() { return bodies_; }
  const Aabb<N, double>& walls() const { return walls_; }

 private:
  double count() const { return static_cast<double>(bodies_.size()); }

  void set_walls(const Vec<N, double>& widths) { walls_ = {-widths * 0.5, widths * 0.5}; }

  Vec<N, double> random_point(const Aabb<N, double>& box) {
    Vec<N, double> point;
    for (Dim i = 0; i < N; ++i) point[i] = random_.between(box.min[i], box.max[i]);
    return point;
  }

  /// The extent of a scene along each axis. A line has one unit for each box, a plane three square units.
  Vec<N, double> widths_of(World world) const {
    Vec<N, double> widths(0.0);
    if (world == World::brownian || world == World::giants) {
      constexpr double filled = N == 2 ? 0.3 : 0.1;
      widths = Vec<N, double>(edge_of<N>(count() / filled));
    } else if (world == World::heavy) {
      double volume = 0;
      for (const MovingBody<N>& body : bodies_) volume += volume_of(body.half_extents);
      widths = Vec<N, double>(edge_of<N>(volume));
    } else if (world == World::line || (world == World::plane && N == 2)) {
      widths[0] = count();
    } else if (world == World::plane) {
      widths = Vec<N, double>(std::sqrt(3 * count()));
      widths[N - 1] = 0;
    }
    return widths;
  }

  static double volume_of(const Vec<N, double>& half_extents) {
    double volume = 1;
    for (Dim i = 0; i < N; ++i) volume *= 2 * half_extents[i];
    return volume;
  }

  /// A truncated Pareto distribution with exponent 1: each octave of sizes has half the boxes of the one below.
  void spread_sizes() {
    for (MovingBody<N>& body : bodies_) body.half_extents *= 1 / random_.between(0.001, 1);
  }

  void add_giants() {
    const std::size_t giants = std::min(bodies_.size(), std::max<std::size_t>(3, bodies_.size() / 100000));
    for (std::size_t i = 0; i < giants; ++i) {
      bodies_[i * bodies_.size() / giants].half_extents = walls_.max * 0.5;
    }
  }

  void make_lattice() {
    std::size_t side = 0;
    while (cells(side) < bodies_.size()) ++side;
    set_walls(Vec<N, double>(static_cast<double>(side)));
    const std::size_t below = side / 2;
    const Vec<N, double> first(0.5 - static_cast<double>(below));
    for (std::size_t k = 0; k < bodies_.size(); ++k) {
      bodies_[k] = {place_in_lattice(k, side) + first, Vec<N, double>(0.5)};
    }
  }

  static std::size_t cells(std::size_t side) { return N == 2 ? side * side : side * side * side; }

  /// Position k of a lattice, row by row.
  static Vec<N, double> place_in_lattice(std::size_t k, std::size_t side) {
    Vec<N, double> place;
    for (Dim i = 0; i < N; ++i, k /= side) place[i] = static_cast<double>(k % side);
    return place;
  }

  struct Cloud {
    Vec<N, double> center;
    double width;  ///< Of each of the three uniform numbers whose sum is a coordinate.
  };

  void gather_in_clouds() {
    const std::vector<Cloud> clouds = random_clouds();
    for (MovingBody<N>& body : bodies_) {
      const double u = random_.fraction();
      const Cloud& cloud = clouds[static_cast<std::size_t>(u * u * static_cast<double>(clouds.size()))];
      for (Dim i = 0; i < N; ++i) {
        // Separate statements: a compiler may evaluate the calls in a sum in any order, which changes the last bit.
        double sum = random_.fraction();
        sum += random_.fraction();
        sum += random_.fraction();
        body.center[i] = cloud.center[i] + cloud.width * (sum - 1.5);
      }
    }
  }

  /// The square of a uniform number selects a box's cluster, so that the first of K clusters has one box in sqrt(K),
  /// the last one in 2 K. A cluster of m boxes has m * reach / 2 * (0.55 / width)^N pairs per box, as 0.55 / width is
  /// the integral of the squared density along an axis. Its width makes that two, and is then varied. Clusters are at
  /// least half a spacing apart, which is 20 widths.
  std::vector<Cloud> random_clouds() {
    const std::size_t clouds = std::max<std::size_t>(8, bodies_.size() / 10000);
    std::vector<Cloud> result(clouds);
    double widest = 0;
    double below = 0;
    for (std::size_t k = 0; k < clouds; ++k) {
      const double up_to = std::sqrt(static_cast<double>(k + 1) / static_cast<double>(clouds));
      const double boxes = count() * (up_to - below);
      below = up_to;
      result[k].width = 0.55 * edge_of<N>(boxes * reach<N> / 4) * random_.between(0.75, 1.5);
      widest = std::max(widest, result[k].width);
    }
    std::size_t side = 0;
    while (cells(side) < clouds) ++side;
    const double spacing = 40 * widest;
    set_walls(Vec<N, double>(static_cast<double>(side) * spacing));
    for (std::size_t k = 0; k < clouds; ++k) {
      const Vec<N, double> place =
          place_in_lattice(k, side) + 0.25 + 0.5 * random_point({Vec<N, double>(0.0), Vec<N, double>(1.0)});
      result[k].center = walls_.min + place * spacing;
    }
    return result;
  }

  Random& random_;
  std::vector<MovingBody<N>> bodies_;
  Aabb<N, double> walls_;
};

/// A step of at most a tenth along each axis, in multiples of 2^-10, so that integer positions stay exact also in
/// float. It is reflected by the walls; if these leave no space, there is no step.
template <Dim N>
void move(Vec<N, double>& place, const Aabb<N, double>& walls, Random& random) {
  for (Dim i = 0; i < N; ++i) {
    if (walls.min[i] == walls.max[i]) continue;
    place[i] += (static_cast<double>(random.bits() % 205) - 102) * 0x1p-10;
    if (place[i] > walls.max[i]) place[i] = 2 * walls.max[i] - place[i];
    if (place[i] < walls.min[i]) place[i] = 2 * walls.min[i] - place[i];
  }
}

/// Boxes that move together stay within one unit of their start.
template <Dim N>
Aabb<N, double> walls_of_offset() {
  return {Vec<N, double>(-1.0), Vec<N, double>(1.0)};
}

}  // namespace

std::string_view name_of(World world) { return names[static_cast<std::size_t>(world)].first; }

std::optional<World> world_named(std::string_view name) {
  for (const auto& [known, world] : names) {
    if (known == name) return world;
  }
  return std::nullopt;
}

std::span<const World> all_worlds() {
  static constexpr auto worlds = [] {
    std::array<World, names.size()> result{};
    for (std::size_t i = 0; i < names.size(); ++i) result[i] = names[i].second;
    return result;
  }();
  return worlds;
}

template <Dim N, class T>
MovingBoxes<N, T>::MovingBoxes(World world, std::size_t count, std::uint64_t seed)
    : boxes_(count), state_(seed), moves_as_one_(world == World::lattice || world == World::point) {
  Random random(state_);
  WorldMaker<N> maker(count, random);
  maker.make(world);
  bodies_ = std::move(maker.bodies());
  walls_ = maker.walls();
  place_boxes();
}

template <Dim N, class T>
void MovingBoxes<N, T>::step() {
  Random random(state_);
  if (moves_as_one_) {
    move(common_offset_, walls_of_offset<N>(), random);
  } else {
    for (detail::MovingBody<N>& body : bodies_) move(body.center, walls_, random);
  }
  place_boxes();
}

template <Dim N, class T>
void MovingBoxes<N, T>::place_boxes() {
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    const Vec<N, double> center = bodies_[k].center + common_offset_;
    boxes_[k] = {Vec<N, T>(center - bodies_[k].half_extents), Vec<N, T>(center + bodies_[k].half_extents)};
  }
}

template <Dim N, class T>
Aabb<N, T> MovingBoxes<N, T>::bounds() const {
  Vec<N, double> largest(0.0);
  for (const detail::MovingBody<N>& body : bodies_) {
    for (Dim i = 0; i < N; ++i) largest[i] = std::max(largest[i], body.half_extents[i]);
  }
  const Vec<N, double> around = largest + (moves_as_one_ ? 1.0 : 0.0);
  Aabb<N, T> bounds;
  for (Dim i = 0; i < N; ++i) {
    bounds.min[i] = round_down<T>(walls_.min[i] - around[i]);
    bounds.max[i] = round_up<T>(walls_.max[i] + around[i]);
  }
  return bounds;
}

template class MovingBoxes<2, float>;
template class MovingBoxes<3, float>;
template class MovingBoxes<2, double>;
template class MovingBoxes<3, double>;

}  // namespace graze
