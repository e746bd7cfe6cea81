// SPDX-License-Identifier: MIT
// Finds errors of manifold(a, b): compares its contact with the oracle's, every point with both shapes and its depth,
// according to the contract of manifold.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string_view>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/manifold.hpp>
#include <graze/shape/any_shape.hpp>

#include "exact.hpp"
#include "exact/verdict.hpp"
#include "query/contact_judgement.hpp"
#include "query/contacts.hpp"
#include "query/manifolds.hpp"
#include "query/verdict_band.hpp"

namespace graze::test {

/// The errors of one answer.
struct ManifoldErrors {
  Judgement judgement = Judgement::right;  ///< Never `within_band`.
  std::string_view fault;                  ///< The first fault; empty if there is none.
  /// The depth of the deepest point, rounded to T, in epsilon of T times the size that contact.hpp names.
  double depth = 0;
  double points = 0;  ///< How far a point is from its shape, or the two of a pair from its depth, relative to the size.
};

template <Dim N, class T>
class ManifoldJudge {
 public:
  using Any = AnyShape<N, T>;

  /// `truth` with gap and sizes.
  ManifoldJudge(const Any& a, const Any& b, const ExactVerdict& truth)
      : a_(a), b_(b), truth_(truth), found_(manifold_of<N, T>(a, b)) {}

  ManifoldErrors run() {
    const std::optional<Contact<N, T>> contact = contact_of<N, T>(a_, b_);
    const ContactErrors of_contact = contact_errors<N, T>(a_, b_, truth_, contact);
    expect(contact.has_value() == (found_.size > 0), "points without a contact, or a contact without points");
    expect(found_.size <= Manifold<N, T>::most_points, "there are too many points");
    expect((manifold_of<N, T>(b_, a_).size == found_.size), "another number of points in the other order");
    expect(of_contact.judgement != Judgement::wrong, "the contact is wrong");
    if (!contact || !errors_.fault.empty()) return errors_;
    expect(found_.normal == contact->normal, "the normal differs from the contact's");
    if (of_contact.judgement == Judgement::outside_range) errors_.judgement = Judgement::outside_range;
    if (errors_.judgement == Judgement::outside_range || std::isinf(contact->depth)) return errors_;
    judge_depth(static_cast<double>(contact->depth));
    for (const ManifoldPoint<N, T>& point : found_.contacts()) judge_point(point);
    return errors_;
  }

 private:
  static constexpr double epsilon = static_cast<double>(std::numeric_limits<T>::epsilon());

  void expect(bool holds, std::string_view fault) {
    if (holds || !errors_.fault.empty()) return;
    errors_.judgement = Judgement::wrong;
    errors_.fault = fault;
  }

  /// The tolerance of points and depths for shapes of size `size`, down to the smallest number of T.
  double allowed(double size) const {
    constexpr auto least = static_cast<double>(std::numeric_limits<T>::denorm_min());
    return 4 * (found_.error + least) + (16 * epsilon + 4 * tolerance::aligned) * size;
  }

  double size_with(double other) const { return std::max({truth_.own_size, truth_.largest, other}); }

  void judge_depth(double depth_of_contact) {
    double deepest = 0;
    for (const ManifoldPoint<N, T>& point : found_.contacts())
      deepest = std::max(deepest, static_cast<double>(point.depth));
    expect(std::fabs(deepest - depth_of_contact) <= allowed(size_with(0) + depth_of_contact),
           "the deepest point is not as deep as the contact");
    const double size = documented_size(truth_.own_size, truth_.largest, a_.index(), b_.index());
    errors_.depth = std::fabs(deepest - std::max(0.0, -truth_.gap)) / (epsilon * size);
  }

  void judge_point(const ManifoldPoint<N, T>& point) {
    const auto depth = static_cast<double>(point.depth);
    const double size = size_with(std::max(static_cast<double>(max_abs(point.point_a)), depth));
    const Vec<N, double> rest =
        (wide<N, T>(point.point_a) - wide<N, T>(point.point_b)) - wide<N, T>(found_.normal) * depth;
    const double worst = std::max({off(point.point_a, a_), off(point.point_b, b_), max_abs(rest)});
    expect(depth >= 0, "a depth is negative");
    expect(worst <= allowed(size), "a point is off its shape, or has a wrong depth");
    errors_.points = std::max(errors_.points, worst / size);
  }

  /// How far a point is from a shape, exactly.
  static double off(const Vec<N, T>& point, const Any& shape) {
    return std::max(0.0, exact_verdict<N, T>(Any(point), shape, Measure::distance).gap);
  }

  const Any& a_;
  const Any& b_;
  const ExactVerdict& truth_;
  Manifold<N, T> found_;
  ManifoldErrors errors_;
};

/// `truth` with gap and sizes.
template <Dim N, class T>
ManifoldErrors manifold_errors(const AnyShape<N, T>& a, const AnyShape<N, T>& b, const ExactVerdict& truth) {
  return ManifoldJudge<N, T>(a, b, truth).run();
}

}  // namespace graze::test
