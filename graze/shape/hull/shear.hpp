// SPDX-License-Identifier: MIT
// sheared_places(points): where points that are all but on a line or a plane are far from it, so that doubles tell on
// which side of planes they are.
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

/// The points of a cloud under a map that keeps what is on a plane, and what on which side of it. It is Gaussian
/// elimination with complete pivoting, among some of the points: of the longest coordinate nothing is taken away, of
/// the others a multiple of that, of the last one then a multiple of the second. What is left of them tells how far
/// points are from a line and from a plane through points of the cloud, and each is measured in a unit of its own. In
/// twice the precision of double, for what is left may be all rounding of the coordinates.
template <class T>
class HullShear {
 public:
  /// Of at least one point, zero or from 1e-90 to 1e90. They must outlive it.
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

  /// With coordinates up to 1, wrong by `tolerance::hull_shear` or less. Each of them is a half or more somewhere,
  /// unless rounding has a part in it, as where all points are on one plane.
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
  using Way = std::array<Rounded, 3>;  // from the first point, or what is left of it, in the order of elimination

  static Vec<3, double> values_of(const Way& way) { return {way[0].value, way[1].value, way[2].value}; }

  Way way_to(const Vec<3, T>& point) const {
    const Vec<3, T>& start = points_.front();
    Way way{};
    for (std::size_t i = 0; i < 3; ++i) {
      way[i] = two_sum(static_cast<double>(point[axes_[i]]), -static_cast<double>(start[axes_[i]]));
    }
    return way;
  }

  /// The longest coordinate that is left becomes that of this step.
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
    if (way[step].value == 0) return;  // nothing is left
    for (std::size_t k = step + 1; k < 3; ++k) slopes_[step][k] = Halves(way[k].value / way[step].value);
  }

  /// Takes the coordinate of a step out of the later ones. The slopes, up to 1, are taken as exact: any give such a
  /// map.
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

  /// A number, and it as a sum of two of 26 bits, rounded, whose products are exact.
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

  /// As two_product, which is a call where the processor may lack an instruction for it. Dekker, "A Floating-Point
  /// Technique for Extending the Available Precision" (1971).
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
  std::array<std::array<Halves, 3>, 2> slopes_{};  // by step and place in that order
};

}  // namespace graze::detail
