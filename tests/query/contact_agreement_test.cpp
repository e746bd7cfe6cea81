// SPDX-License-Identifier: MIT
// contact(a, b) against the exact oracle: every pair of shape types, eight kinds of cases, four spaces. A contact
// exists exactly if `relation` says that the shapes intersect; the depth is within the reported error, which is at most
// the documented one; both points are in their shapes, and differ by normal * depth; and moving b by that leaves the
// shapes touching.
//
// GRAZE_TEST_SCALE multiplies the number of cases (default 1), GRAZE_TEST_SEED selects others.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>

#include <gtest/gtest.h>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/contact.hpp>
#include <graze/shape/any_shape.hpp>

#include "catalogue.hpp"
#include "exact.hpp"
#include "parts_of.hpp"
#include "query/contacts.hpp"
#include "query/every_pair.hpp"
#include "query/pairs.hpp"
#include "query/placement.hpp"
#include "query/verdict_band.hpp"

namespace graze::test::contact_agreement_test {
namespace {

/// Statistics of a run: the largest errors, each in units of the size that it is relative to.
struct Tally {
  std::size_t cases = 0;
  std::size_t meeting = 0;
  double depth = 0;    ///< In epsilon of double of the documented size.
  double claimed = 0;  ///< The same for the error reported with the depth.
  double points = 0;   ///< In epsilon of T of the points' coordinates and the pair's size.
  double left = 0;     ///< The overlap left after the move, in epsilon of double of the largest coordinate.
  std::string worst_depth;
  std::string worst_points;
  std::string worst_left;
  std::size_t failures = 0;
};

/// "A few epsilon" of sizes that are sums of lengths, and those of up to three coordinates.
constexpr double most_error = 64;
constexpr double most_error_by_search = 128;
constexpr double most_claimed = 1024;
constexpr double most_off = 16;

/// After this many failures, a run prints no more.
constexpr std::size_t most_failures = 5;

template <Dim N, class T>
class PairCheck {
 public:
  using Any = AnyShape<N, T>;

  PairCheck(CaseKind kind, const AnyPair<N, T>& pair, Tally& tally)
      : kind_(kind), a_(pair.first), b_(pair.second), tally_(tally) {}

  void run() {
    const std::optional<Contact<N, T>> found = contact_of<N, T>(a_, b_);
    expect(found.has_value() == (relation_of<N, T>(a_, b_) != Relation::apart), "another relation");
    ++tally_.cases;
    if (!found) return;
    ++tally_.meeting;
    found_ = *found;
    exact_ = *penetration_of<N, T>(a_, b_);
    check_order();
    expect(exact_.status == Status::converged || kind_ != CaseKind::flush_faces, "not converged");
    const ExactVerdict truth = exact_verdict<N, T>(a_, b_);
    const double size = documented_size(truth.own_size, truth.largest, a_.index(), b_.index());
    if (truth.is_nearly_parallel || !(size > least_size)) return;
    size_ = std::max(truth.own_size, truth.largest);
    check_depth(truth, size * tolerance::epsilon);
    if (std::isinf(exact_.depth)) return;
    check_points();
    check_move();
  }

 private:
  void expect(bool holds, const std::string& what) {
    if (holds) return;
    ++tally_.failures;
    ADD_FAILURE() << what << ": " << to_source<N, T>(a_) << ", " << to_source<N, T>(b_) << "; depth " << exact_.depth
                  << " along " << to_source(exact_.normal) << " at " << to_source(exact_.point_a) << ", "
                  << to_source(exact_.point_b) << ", error " << exact_.error;
  }

  /// Records the largest error of a kind, and the case.
  void keep(double error, double& largest, std::string& worst) {
    if (!(error > largest)) return;
    largest = error;
    worst = to_source<N, T>(a_) + ", " + to_source<N, T>(b_);
  }

  void check_order() {
    const detail::Penetration<N> swapped = detail::exchanged(*penetration_of<N, T>(b_, a_));
    const bool is_same = swapped.normal == exact_.normal && swapped.depth == exact_.depth &&
                         swapped.point_a == exact_.point_a && swapped.point_b == exact_.point_b &&
                         swapped.error == exact_.error && swapped.status == exact_.status;
    expect(is_same || to_source<N, T>(a_) == to_source<N, T>(b_), "another answer in the other order");
  }

  bool is_closed() const { return is_relative_to_own_size(a_.index(), b_.index()); }

  void check_depth(const ExactVerdict& truth, double size) {
    const double depth = std::max(0.0, -truth.gap);
    expect(std::isinf(depth) == std::isinf(exact_.depth), "the true depth is " + literal(depth));
    if (std::isinf(depth) || std::isinf(exact_.depth)) return;
    const double error = std::fabs(exact_.depth - depth);
    expect(error <= exact_.error, "the depth is off by " + literal(error) + ", from " + literal(depth));
    if (exact_.status == Status::best_bound) return;
    const double gap_of_search = tolerance::gjk_relative_gap * exact_.depth;
    expect(error <= (is_closed() ? most_error : most_error_by_search) * size + gap_of_search,
           "the depth is off by too much");
    keep(error / size, tally_.depth, tally_.worst_depth);
    if (!is_closed()) return;  // for slivers, GJK proves less than it finds
    expect(exact_.error <= most_claimed * size, "the reported error is too large");
    tally_.claimed = std::max(tally_.claimed, exact_.error / size);
  }

  /// How far a point is from a shape, exactly.
  static double off(const Vec<N, T>& point, const Any& shape) {
    return std::max(0.0, exact_verdict<N, T>(Any(point), shape, Measure::distance).gap);
  }

  /// Both points are in their shapes, and differ by depth times normal.
  void check_points() {
    const auto epsilon = static_cast<double>(std::numeric_limits<T>::epsilon());
    const double size = epsilon * std::max({max_abs(exact_.point_a), max_abs(exact_.point_b), size_}) + exact_.error +
                        static_cast<double>(std::numeric_limits<T>::denorm_min());
    const Vec<N, double> rest = (exact_.point_a - exact_.point_b) - exact_.normal * exact_.depth;
    const double worst = std::max({off(found_.point_a, a_), off(found_.point_b, b_), max_abs(rest)}) / size;
    expect(worst <= most_off, "the points are off by " + literal(worst));
    keep(worst, tally_.points, tally_.worst_points);
    expect(std::fabs(dot(exact_.normal, exact_.normal) - 1) <= 4 * tolerance::epsilon,
           "the normal is not a unit vector");
  }

  /// The minimum translation leaves the shapes touching. Only in double, which hardly rounds the shape's coordinates.
  void check_move() {
    if constexpr (std::is_same_v<T, double>) {
      const bool has_parts = is_union<N, T>(a_) || is_union<N, T>(b_);
      if (has_parts) return;
      const ExactVerdict after = exact_verdict<N, T>(a_, moved<N, T>(b_, exact_.normal * exact_.depth));
      if (after.is_nearly_parallel) return;
      const double noise = tolerance::epsilon * std::max(size_, after.largest);
      const double left = (std::fabs(after.gap) - exact_.error) / noise;
      expect(left <= most_off, "the move leaves " + literal(after.gap));
      keep(left, tally_.left, tally_.worst_left);
    }
  }

  CaseKind kind_;
  const Any& a_;
  const Any& b_;
  Tally& tally_;
  Contact<N, T> found_;
  detail::Penetration<N> exact_;
  double size_ = 0;
};

template <class SpaceType>
class ContactAgreement : public ::testing::Test {
 public:
  static void run(CaseKind kind) {
    constexpr Dim N = SpaceType::dimension;
    using T = typename SpaceType::scalar;
    Tally tally;
    for_each_case<N, T>(
        kind, number_of_cases(3), [&](const AnyPair<N, T>& pair) { PairCheck<N, T>(kind, pair, tally).run(); },
        [&tally] { return tally.failures < most_failures; });
    std::cout << "seed " << seed_of_cases() << ": " << tally.cases << " cases, " << tally.meeting
              << " meet; depths are off by " << tally.depth << " epsilon at most and say so up to " << tally.claimed
              << ", points by " << tally.points << ", moves by " << tally.left << "\n"
              << "the worst depth: " << tally.worst_depth << "\nthe worst points: " << tally.worst_points
              << "\nthe worst move: " << tally.worst_left << "\n";
    EXPECT_GE(tally.meeting * 8, tally.cases) << "too few intersect to prove anything";
  }
};

TYPED_TEST_SUITE(ContactAgreement, Spaces);

TYPED_TEST(ContactAgreement, OnUniformNumbers) { TestFixture::run(CaseKind::uniform); }
TYPED_TEST(ContactAgreement, OnSmallWholeNumbers) { TestFixture::run(CaseKind::grid); }
TYPED_TEST(ContactAgreement, OnNumbersOfAllSizes) { TestFixture::run(CaseKind::scales); }
TYPED_TEST(ContactAgreement, FarFromTheOrigin) { TestFixture::run(CaseKind::far); }
TYPED_TEST(ContactAgreement, OnShapesThatShareCorners) { TestFixture::run(CaseKind::shared_points); }
TYPED_TEST(ContactAgreement, WhereTheVerdictChanges) { TestFixture::run(CaseKind::border); }
TYPED_TEST(ContactAgreement, OfNearlyParallelEdges) { TestFixture::run(CaseKind::nearly_parallel); }
TYPED_TEST(ContactAgreement, OfFacesThatAreNearlyFlush) { TestFixture::run(CaseKind::flush_faces); }

}  // namespace
}  // namespace graze::test::contact_agreement_test
