// SPDX-License-Identifier: MIT
// Certificates for two hulls or rays, from their set of differences D = core a - core b and the sum r of their radii.
//
//   apart         a direction n with n . d > r |n| for every corner d of D, and n . w >= 0 for a ray's direction w
//   gap <= g      weights of some corners whose mean is at most r + g from the origin
//   overlapping   the same with g < 0, or corners of D around the origin
//   gap >= g      a direction n with n . d >= (r + g) |n|
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include <graze/query/verdict.hpp>

#include "exact/body.hpp"
#include "exact/certificate.hpp"
#include "exact/enclosed.hpp"
#include "exact/level_certificate.hpp"
#include "exact/nearest_simplex.hpp"
#include "exact/numbers.hpp"
#include "exact/simplex_on_axes.hpp"

namespace graze::test {

/// The search is in Real; the proofs are not.
template <std::size_t N, class Real>
class HullCertificate {
 public:
  using Point = std::array<Real, N>;
  using Simplex = test::Simplex<N, Real>;
  using Corners = test::Corners<N, Real>;
  using Way = EnclosedVec<N>;

  HullCertificate(const Body<N>& a, const Body<N>& b) : body_a_(a), body_b_(b) {
    const EnclosedVec<N> between = a.anchor - b.anchor;
    for (std::size_t i = 0; i < a.count; ++i) a_.add(between + a.corners[i]);
    for (std::size_t i = 0; i < b.count; ++i) b_.add(b.corners[i]);
    double distance = 0;
    for (const Enclosed& x : between) distance += magnitude(x);
    scale_ = static_cast<double>(N) * (distance + a.size + b.size);
    if (a.form == BodyForm::ray) cut(a_, a.way);
    if (b.form == BodyForm::ray) cut(b_, b.way);
    radius_ = enclosed(a.radius) + enclosed(b.radius);
  }

  GapBounds bounds(Relation claim) {
    const Simplex nearest = search(Point{});
    if (claim == Relation::apart && is_clearly_apart(nearest)) return with_gap(least_, infinity);
    if (claim == Relation::overlapping && is_clearly_overlapping(nearest)) return overlapping();
    GapBounds result = bounds_from_point(nearest);
    if (!nearest.holds_target()) raise(result, nearest);
    if (claim == Relation::overlapping && !result.is_overlapping) result.is_overlapping = holds_neighbourhood();
    if (claim == Relation::touching || (claim == Relation::apart && result.low <= 0)) raise_by_neighbours(result);
    if (result.low == 0 && result.high > 0 && holds_origin_on_axes<N>(corners_of(nearest))) result.high = 0;
    if (claim == Relation::touching) measure(result);
    return result;
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  /// The error of corners in double, relative to `scale_`, and of their heights along a unit vector: each is calculated
  /// from at most four numbers in four operations. With a reserve for the subsequent operations here.
  static constexpr double coarse = 1e-13;

  /// The cubes of anything larger are far above the smallest doubles.
  static constexpr double least_scale = 1e-60;

  /// The squares of anything longer are far above the smallest doubles.
  static constexpr double least_length = 1e-120;

  /// The distance of a perturbed position, relative to `scale_`.
  static constexpr double beside = 0x1p-20;

  /// Depths below this, relative to `scale_`, are not refined.
  static constexpr double settled = 0.05 * coarse;

  static GapBounds with_gap(double low, double high) {
    GapBounds result;
    result.low = low;
    result.high = high;
    return result;
  }

  static GapBounds overlapping() {
    GapBounds result;
    result.is_overlapping = true;
    result.high = 0;
    return result;
  }

  /// Adds a second corner, far out on the ray, for points and simplices. Directions are compared with the whole ray.
  void cut(Corners& corners, const Way& way) {
    constexpr double far_out = 64;
    double largest = 0;
    for (const Enclosed& x : way) largest = std::max(largest, std::fabs(x.high));
    if (largest == 0) return;
    int exponent = 0;
    std::frexp(far_out * std::max(scale_, std::numeric_limits<double>::min()) / largest, &exponent);
    const EnclosedVec<N> end = corners.exact[0] + way * enclosed(std::ldexp(1.0, exponent));
    corners.add(end);
    for (const Enclosed& x : end) scale_ += magnitude(x);
  }

  Simplex search(const Point& target) const { return NearestSearch<N, Real>(a_, b_, target).run(); }

  // ---- In double, with a margin for all rounding

  bool is_clearly_apart(const Simplex& nearest) {
    if (nearest.holds_target() || scale_ < least_scale) return false;
    const Point& n = nearest.normal;
    Real low_a = infinity;
    Real high_b = -infinity;
    for (std::size_t i = 0; i < a_.count; ++i) low_a = std::min(low_a, dot(a_.near[i], n));
    for (std::size_t i = 0; i < b_.count; ++i) high_b = std::max(high_b, dot(b_.near[i], n));
    const auto length = static_cast<double>(std::sqrt(dot(n, n)));
    if (!is_open(body_a_, n, 1, length) || !is_open(body_b_, n, -1, length)) return false;
    least_ = static_cast<double>(low_a - high_b) / length - radius_.high - coarse * (scale_ + radius_.high);
    return length > least_length && least_ > 0;
  }

  /// Whether no ray has a component against n.
  static bool is_open(const Body<N>& body, const Point& n, double sign, double length) {
    if (body.form != BodyForm::ray) return true;
    double climb = 0;
    double reach = 0;
    for (std::size_t i = 0; i < N; ++i) {
      climb += sign * static_cast<double>(n[i]) * body.way[i].high;
      reach += std::fabs(body.way[i].high);
    }
    return climb > coarse * length * reach;
  }

  bool is_clearly_overlapping(const Simplex& nearest) const {
    if (scale_ < least_scale) return false;
    if (!nearest.holds_target()) {
      return static_cast<double>(std::sqrt(nearest.squared)) + coarse * scale_ < radius_.high * (1 - coarse);
    }
    const Shares<Real, N> shares = shares_of<Real, N>(nearest.x, nearest.count);
    const double margin = coarse * 16 * std::pow(scale_, static_cast<double>(N));
    return std::all_of(shares.begin(), shares.end(), [margin](Real x) { return x > margin; }) ||
           std::all_of(shares.begin(), shares.end(), [margin](Real x) { return x < -margin; });
  }

  // ---- In numbers with error bounds

  EnclosedVec<N> difference(const std::array<std::size_t, 2>& pair) const {
    return a_.exact[pair[0]] - b_.exact[pair[1]];
  }

  std::array<EnclosedVec<N>, N + 1> differences(const Simplex& simplex) const {
    std::array<EnclosedVec<N>, N + 1> x;
    for (std::size_t i = 0; i <= N; ++i) x[i] = difference(simplex.pairs[i]);
    return x;
  }

  std::vector<EnclosedVec<N>> corners_of(const Simplex& simplex) const {
    const std::array<EnclosedVec<N>, N + 1> x = differences(simplex);
    return {x.begin(), x.begin() + static_cast<std::ptrdiff_t>(simplex.count)};
  }

  static bool all_surely_positive(const Shares<Enclosed, N>& shares) {
    return std::all_of(shares.begin(), shares.end(), is_surely_positive);
  }
  static bool all_surely_negative(const Shares<Enclosed, N>& shares) {
    return std::all_of(shares.begin(), shares.end(), is_surely_negative);
  }

  /// What the simplex's point nearest to the origin proves.
  GapBounds bounds_from_point(const Simplex& simplex) const {
    const std::array<EnclosedVec<N>, N + 1> x = differences(simplex);
    const Shares<Enclosed, N> shares = shares_of<Enclosed, N>(x, simplex.count);
    if (simplex.holds_target() && (all_surely_positive(shares) || all_surely_negative(shares))) return overlapping();
    double direction = 0;
    for (const Enclosed& share : shares) direction += share.high;
    EnclosedVec<N> sum{};
    Enclosed whole{};
    for (std::size_t i = 0; i < simplex.count; ++i) {
      Enclosed share = taken_as_exact(shares[i]);
      if (direction < 0) share = -share;
      if (share.high < 0) continue;
      sum = sum + x[i] * share;
      whole = whole + share;
    }
    GapBounds result;
    if (!is_surely_positive(whole)) return result;
    const Enclosed reach = radius_ * whole;
    const Enclosed beyond = dot(sum, sum) - reach * reach;
    if (is_surely_negative(beyond)) return overlapping();
    const double above = upper_bound(beyond);
    const double length = std::sqrt(std::max(0.0, lower_bound(dot(sum, sum)))) / outward;
    const double divisor = (length + lower_bound(reach)) * lower_bound(whole) / outward;
    if (above == 0) {
      result.high = 0;
    } else if (is_surely_zero(radius_)) {
      result.high = std::sqrt(upper_bound(dot(sum, sum))) * outward / lower_bound(whole) * outward;
    } else {
      result.high = above / divisor * outward;
    }
    if (above != 0) result.high = std::nextafter(result.high, infinity);  // quotients may underflow
    return result;
  }

  /// Perpendicular to the simplex, towards it from the target; approximately so for an edge in 3D.
  Way normal_of(const Simplex& simplex) const {
    const std::array<EnclosedVec<N>, N + 1> x = differences(simplex);
    EnclosedVec<N> from_target = x[0];
    for (std::size_t i = 0; i < N; ++i)
      from_target[i] = from_target[i] - enclosed(static_cast<double>(simplex.target[i]));
    return taken_as_exact(test::normal_of<Enclosed, N>(x, simplex.count, from_target));
  }

  /// The heights of corners along a direction in double.
  struct Heights {
    std::array<double, Body<N>::most_corners + 1> of_corner{};
    double least = infinity;
  };

  static Heights heights_of(const Corners& corners, std::size_t count, const Way& normal, double sign) {
    Point n;
    for (std::size_t i = 0; i < N; ++i) n[i] = static_cast<Real>(sign) * rounded_to<Real>(normal[i]);
    Heights heights;
    for (std::size_t i = 0; i < count; ++i) {
      heights.of_corner[i] = static_cast<double>(dot(corners.near[i], n));
      heights.least = std::min(heights.least, heights.of_corner[i]);
    }
    return heights;
  }

  /// The lowest corner of a or, with sign -1, of minus b. Evaluates only those that double cannot exclude.
  static Enclosed lowest(const Corners& corners, std::size_t count, const Way& normal, const Heights& heights,
                         double doubt) {
    std::optional<Enclosed> result;
    for (std::size_t i = 0; i < count; ++i) {
      if (heights.of_corner[i] > heights.least + doubt) continue;
      const Enclosed height = dot(corners.exact[i], normal);
      result = result ? lesser(*result, height) : height;
    }
    return result.value_or(Enclosed{0, 0, infinity});
  }

  static bool is_surely_open(const Body<N>& body, const Way& normal, double sign) {
    return body.form != BodyForm::ray || is_surely_not_negative(dot(body.way, normal) * enclosed(sign));
  }

  /// An edge's normal is perpendicular to a ray up to rounding: tilted slightly towards the ray, no ray has a component
  /// against it.
  Way leant(const Way& normal) const {
    constexpr double very_little = 0x1p-92;
    Way result = normal;
    for (const Body<N>* body : {&body_a_, &body_b_}) {
      const double sign = body == &body_a_ ? 1 : -1;
      if (is_surely_open(*body, normal, sign)) continue;
      double length = 0;
      double largest = 0;
      for (std::size_t i = 0; i < N; ++i) {
        length = std::max(length, std::fabs(normal[i].high));
        largest = std::max(largest, std::fabs(body->way[i].high));
      }
      result = taken_as_exact(EnclosedVec<N>(result + body->way * enclosed(sign * very_little * length / largest)));
    }
    return result;
  }

  /// Raises the lower bound to what the simplex's normal proves, and returns that normal.
  Way raise(GapBounds& result, const Simplex& simplex) const {
    if (simplex.holds_target()) return {};
    const Way normal = leant(normal_of(simplex));
    raise_along(result, normal);
    if (result.low < 0 && !result.is_overlapping && simplex.count == N) {
      result.is_overlapping = holds_origin_behind(simplex, normal);
    }
    result.high = std::min(result.high, bounds_from_point(simplex).high);
    return normal;
  }

  /// Whether the origin is inside the simplex of a face and the corner farthest behind it.
  bool holds_origin_behind(const Simplex& face, const Way& normal) const {
    Point n;
    for (std::size_t i = 0; i < N; ++i) n[i] = rounded_to<Real>(normal[i]);
    const auto higher = [&n](const Point& p, const Point& q) { return dot(p, n) < dot(q, n); };
    const auto begin_a = a_.near.begin();
    const auto begin_b = b_.near.begin();
    const auto on_a = std::max_element(begin_a, begin_a + static_cast<std::ptrdiff_t>(a_.count), higher);
    const auto on_b = std::min_element(begin_b, begin_b + static_cast<std::ptrdiff_t>(b_.count), higher);
    Simplex whole = face;
    whole.pairs[N] = {static_cast<std::size_t>(on_a - begin_a), static_cast<std::size_t>(on_b - begin_b)};
    const Shares<Enclosed, N> shares = shares_of<Enclosed, N>(differences(whole), N + 1);
    return all_surely_positive(shares) || all_surely_negative(shares);
  }

  void raise_along(GapBounds& result, const Way& normal) const {
    if (!is_surely_open(body_a_, normal, 1) || !is_surely_open(body_b_, normal, -1)) return;
    double length = 0;
    for (const Enclosed& x : normal) length += magnitude(x);
    if (!(length > 0)) return;
    const double doubt = 2 * coarse * length * scale_;
    const Heights of_a = heights_of(a_, body_a_.count, normal, 1);
    const Heights of_b = heights_of(b_, body_b_.count, normal, -1);
    const double most = of_a.least + of_b.least + 2 * doubt;
    if (most < 0 && most <= (result.low + radius_.high) * length) return;  // too low to raise anything
    Way down;
    for (std::size_t i = 0; i < N; ++i) down[i] = -normal[i];
    const Enclosed height =
        lowest(a_, body_a_.count, normal, of_a, doubt) + lowest(b_, body_b_.count, down, of_b, doubt);
    const GapBounds along = bounds_of_height(height, dot(normal, normal), radius_);
    if (along.low > result.low) result.low = along.low;
  }

  // ---- If the origin is on the boundary: what holds for nearby positions holds there, too

  bool is_settled(const GapBounds& result) const {
    return result.low == result.high || (result.low > 0 && result.high < 2 * result.low + settled * scale_) ||
           (result.is_overlapping && result.low > -scale_ * settled);
  }

  void raise_by_neighbours(GapBounds& result) const {
    if (is_settled(result)) return;
    for (std::size_t axis = 0; axis < N; ++axis) {
      for (const double sign : {1.0, -1.0}) {
        Way normal{};
        normal[axis] = enclosed(sign);
        raise_along(result, normal);
      }
    }
    const double step = scale_ > 0 ? beside * scale_ : 1;
    Point middle{};
    if (!is_settled(result)) add_unit(middle, raise(result, search(scaled_to(outward_way(), step))));
    for (std::size_t axis = 0; axis < N && !is_settled(result); ++axis) {
      for (const double sign : {1.0, -1.0}) {
        Point target{};
        target[axis] = static_cast<Real>(sign * step);
        add_unit(middle, raise(result, search(target)));
      }
    }
    if (is_settled(result) || result.high != 0) return;
    // A corner at the origin: among the normals there, the middle one has no other corner as low.
    Way normal{};
    for (std::size_t i = 0; i < N; ++i) normal[i] = enclosed(static_cast<double>(middle[i]));
    raise_along(result, normal);
  }

  static void add_unit(Point& sum, const Way& way) {
    Point unit;
    for (std::size_t i = 0; i < N; ++i) unit[i] = rounded_to<Real>(way[i]);
    const Real squared = dot(unit, unit);
    if (squared > 0) sum = sum + unit * (1 / std::sqrt(squared));
  }

  /// From the center of the differences to the origin.
  Point outward_way() const {
    Point way{};
    for (std::size_t i = 0; i < a_.count; ++i) way = way - a_.near[i] * (1 / static_cast<Real>(a_.count));
    for (std::size_t i = 0; i < b_.count; ++i) way = way + b_.near[i] * (1 / static_cast<Real>(b_.count));
    return way;
  }

  /// With few digits, so that results calculated from it are exact.
  static Point scaled_to(const Point& way, double length) {
    constexpr Real steps = 16;
    Real largest = 0;
    for (const Real x : way) largest = std::max(largest, std::fabs(x));
    int exponent = 0;
    std::frexp(length / static_cast<double>(steps), &exponent);
    Point result{};
    for (std::size_t i = 0; i < N; ++i) {
      if (largest > 0) result[i] = std::ldexp(std::round(way[i] / largest * steps), exponent);
    }
    return result;
  }

  /// Whether the set of differences contains a small simplex around the origin.
  bool holds_neighbourhood() const {
    for (const double step : {0x1p-12, 0x1p-24, 0x1p-36, 0x1p-44}) {
      if (holds_simplex(step * scale_)) return true;
    }
    return false;
  }

  bool holds_simplex(double step) const {
    for (std::size_t corner = 0; corner <= N; ++corner) {
      Point target;
      target.fill(static_cast<Real>(corner == N ? -step : -step / 8));
      if (corner < N) target[corner] = static_cast<Real>(step);
      if (!holds(target)) return false;
    }
    return true;
  }

  bool holds(const Point& target) const {
    const Simplex simplex = search(target);
    if (!simplex.holds_target()) return false;
    std::array<EnclosedVec<N>, N + 1> x = differences(simplex);
    for (std::size_t i = 0; i <= N; ++i) {
      for (std::size_t j = 0; j < N; ++j) x[i][j] = x[i][j] - enclosed(static_cast<double>(target[j]));
    }
    const Shares<Enclosed, N> shares = shares_of<Enclosed, N>(x, simplex.count);
    return all_surely_positive(shares) || all_surely_negative(shares);
  }

  // ---- Sizes

  /// At most the sizes that the bands are relative to.
  void measure(GapBounds& result) const {
    result.largest = std::max(least_largest_coordinate(body_a_), least_largest_coordinate(body_b_));
    for (std::size_t i = 0; i < body_a_.count; ++i) {
      for (std::size_t j = 0; j < body_b_.count; ++j) {
        for (const Real x : a_.near[i] - b_.near[j]) {
          result.own_size = std::max(result.own_size, static_cast<double>(std::fabs(x)));
        }
      }
    }
    result.own_size = (result.own_size + radius_.high) * (1 - 1e-9) - coarse * 1e-3 * scale_;
    if (body_a_.form == BodyForm::ray && body_b_.form == BodyForm::ray) {
      result.may_be_parallel = !is_clearly_not_parallel<N>(body_a_.way, body_b_.way);
    }
  }

  const Body<N>& body_a_;
  const Body<N>& body_b_;
  Corners a_;
  Corners b_;
  Enclosed radius_;
  double scale_ = 0;  ///< At least N times any coordinate of a difference, or of its operands.
  double least_ = 0;
};

}  // namespace graze::test
