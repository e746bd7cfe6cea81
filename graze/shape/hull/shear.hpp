// SPDX-License-Identifier: MIT
// sheared_places(points): maps points that are collinear or coplanar up to rounding so that doubles decide on which
// side of planes they are.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <graze/math/platform/bit_cast.hpp>
#include <graze/math/rounding.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>

namespace graze::detail {

/// Maps points by a linear map that preserves planes and their sides. The map is Gaussian elimination with complete
/// pivoting on a sample of the points: the coordinate with the largest extent stays, a multiple of it is subtracted
/// from the other two, then a multiple of the second from the third. The remainders measure the distance from a line
/// and from a plane through points of the cloud, and each is scaled to a unit of its own. Calculated in twice the
/// precision of double, because the remainders may be pure rounding of the coordinates.
template <class T>
class HullShear {
 public:
  /// At least one point; coordinates must be zero or have a magnitude from 1e-90 to 1e90. The points must outlive this
  /// object.
  explicit HullShear(std::span<const Vec<3, T>> points) : points_(points) {
    constexpr std::size_t enough = 32;
    const std::size_t stride = points.size() / enough + 1;
    std::vector<Way> ways;
    for (std::size_t i = 0; i < points.size(); i += stride) ways.push_back(way_to(points[i]));
    for (std::size_t step = 0; step < 2; ++step) {
      choose_pivot(step, ways);
      for (Way& way : ways) eliminate(step, way);
    }
  }

  /// The images, with coordinates up to 1 and an error of at most `tolerance::hull_shear`. Some coordinate along each
  /// axis is at least a half, unless all points are coplanar or the remainder is pure rounding.
  std::vector<Vec<3, double>> places() const {
    std::vector<Vec<3, double>> places;
    places.reserve(points_.size());
    std::array<Vec<3, double>, 3> lengths = {Vec<3, double>(0.0), Vec<3, double>(0.0), Vec<3, double>(0.0)};
    for (const Vec<3, T>& point : points_) {
      Way way = way_to(point);
      for (std::size_t step = 0; step < 3; ++step) {
        lengths[step] = max(lengths[step], abs(values_of(way)));
        if (step < 2) eliminate(step, way);
      }
      places.push_back(values_of(way));
    }
    const Vec<3, double> scales = scales_for(lengths);
    for (Vec<3, double>& place : places) {
      const Vec<3, double> scaled = place * scales;
      for (Dim i = 0; i < 3; ++i) place[axes_[static_cast<std::size_t>(i)]] = scaled[i];
    }
    return places;
  }

 private:
  using Way = std::array<Rounded, 3>;  // relative to the first point, in the order of elimination

  static Vec<3, double> values_of(const Way& way) { return {way[0].value, way[1].value, way[2].value}; }

  Way way_to(const Vec<3, T>& point) const {
    const Vec<3, T>& start = points_.front();
    Way way{};
    for (std::size_t i = 0; i < 3; ++i) {
      way[i] = two_sum(static_cast<double>(point[axes_[i]]), -static_cast<double>(start[axes_[i]]));
    }
    return way;
  }

  /// Makes the coordinate with the largest remainder the pivot of this step.
  void choose_pivot(std::size_t step, std::vector<Way>& ways) {
    std::size_t pivot = 0;
    std::size_t longest = step;
    for (std::size_t i = 0; i < ways.size(); ++i) {
      for (std::size_t k = step; k < 3; ++k) {
        if (!(std::fabs(ways[i][k].value) > std::fabs(ways[pivot][longest].value))) continue;
        longest = k;
        pivot = i;
      }
    }
    std::swap(axes_[step], axes_[longest]);
    if (step == 1) std::swap(slopes_[0][1], slopes_[0][longest]);
    for (Way& way : ways) std::swap(way[step], way[longest]);
    const Way& way = ways[pivot];
    if (way[step].value == 0) return;  // nothing remains
    for (std::size_t k = step + 1; k < 3; ++k) slopes_[step][k] = Halves(way[k].value / way[step].value);
  }

  /// Eliminates the coordinate of a step from the later ones. The slopes, at most 1, are taken as exact: the map has
  /// the required properties for any slopes.
  void eliminate(std::size_t step, Way& way) const {
    const Rounded from = way[step];
    const Halves halves(from.value);
    for (std::size_t k = step + 1; k < 3; ++k) {
      const Halves& slope = slopes_[step][k];
      const Rounded product = product_of(slope, halves);
      const Rounded difference = two_sum(way[k].value, -product.value);
      way[k] =
          two_sum(difference.value, difference.error + (way[k].error - (product.error + slope.whole * from.error)));
    }
  }

  /// A number and its split into two rounded numbers of 26 bits, whose products are exact.
  struct Halves {
    double whole = 0;
    double high = 0;
    double low = 0;

    Halves() = default;
    explicit Halves(double number)
        : whole(number),
          high(bit_cast<double>((bit_cast<std::uint64_t>(number) + (low_bits + 1) / 2) & ~low_bits)),
          low(number - high) {}

   private:
    static constexpr std::uint64_t low_bits = (std::uint64_t{1} << 27U) - 1;
  };

  /// Like two_product, which is a function call if the processor may lack FMA. Dekker, "A Floating-Point Technique for
  /// Extending the Available Precision" (1971).
  static Rounded product_of(const Halves& a, const Halves& b) {
    const double product = a.whole * b.whole;
    return {product, (((a.high * b.high - product) + a.high * b.low) + a.low * b.high) + a.low * b.low};
  }

  /// Powers of two, from the largest coordinates before each step and after the last one.
  Vec<3, double> scales_for(const std::array<Vec<3, double>, 3>& lengths) const {
    Vec<3, double> errors(0.0);
    for (std::size_t step = 0; step < 2; ++step) {
      const auto from = static_cast<Dim>(step);
      for (std::size_t k = step + 1; k < 3; ++k) {
        const auto to = static_cast<Dim>(k);
        const double slope = std::fabs(slopes_[step][k].whole);
        const double length = std::max(lengths[step][to], slope * lengths[step][from]);
        errors[to] += slope * errors[from] + tolerance::hull_shear_step * length;
      }
    }
    const Vec<3, double> units = max(lengths[2], errors / (tolerance::hull_shear - tolerance::epsilon));
    Vec<3, double> scales(1.0);
    for (Dim i = 0; i < 3; ++i) {
      if (units[i] > 0) scales[i] = std::ldexp(1.0, -std::ilogb(units[i]) - 1);
    }
    return scales;
  }

  std::span<const Vec<3, T>> points_;
  std::array<Dim, 3> axes_ = {0, 1, 2};            // in the order of elimination
  std::array<std::array<Halves, 3>, 2> slopes_{};  // by step and index in that order
};

}  // namespace graze::detail
