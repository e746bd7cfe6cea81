// SPDX-License-Identifier: MIT
// relation(a, b) against the exact oracle: every pair of shape types, seven kinds of cases, four spaces. A verdict may
// differ from the true one only where gap or depth are within the documented band, and `apart` and `overlapping` are
// promises: only `touching` may stand for something else.
//
// GRAZE_TEST_SCALE multiplies the number of cases (default 1), GRAZE_TEST_SEED chooses others.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <initializer_list>
#include <iostream>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include <graze/math/pose.hpp>
#include <graze/query/transformed.hpp>

#include "catalogue.hpp"
#include "query/pairs.hpp"
#include "query/placement.hpp"

namespace graze::test {
namespace {

double number_from_environment(const char* name, double otherwise) {
  const char* text = std::getenv(name);
  return text != nullptr ? std::strtod(text, nullptr) : otherwise;
}

/// The band in which graze may say touching, in units of the sizes that relation.hpp names: "a few epsilon" of a sum of
/// several lengths, and those of at most three coordinates each.
constexpr double band = 128 * std::numeric_limits<double>::epsilon();

/// Squares of anything smaller leave the range of double.
constexpr double least_size = 1e-140;

/// Which size the error of a pair is relative to: the letters in relation.hpp's table.
bool is_relative_to_own_size(std::size_t a, std::size_t b) {
  const auto is_one_of = [](std::string_view name, std::initializer_list<std::string_view> names) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  const auto has_closed_form = [&](std::size_t type) {
    return is_one_of(shape_type_names[type], {"point", "segment", "ray", "sphere", "aabb", "obb", "capsule"});
  };
  return has_closed_form(a) && has_closed_form(b);
}

/// What a run has seen.
struct Tally {
  std::size_t cases = 0;
  std::size_t hits = 0;
  std::size_t other_verdicts = 0;  ///< Within the band.
  double worst = 0;                ///< The largest gap or depth called touching, in units of the band's size.
  std::string worst_case;
  std::size_t failures = 0;
};

/// A run that has failed this often says no more.
constexpr std::size_t most_failures = 5;

template <Dim N, class T>
std::string describe(const AnyShape<N, T>& a, const AnyShape<N, T>& b) {
  return to_source<N, T>(a) + ", " + to_source<N, T>(b);
}

/// Checks one case, in both orders.
template <Dim N, class T>
void check(const AnyPair<N, T>& pair, Tally& tally) {
  const auto& [a, b] = pair;
  const Relation claim = relation_of<N, T>(a, b);
  if (relation_of<N, T>(b, a) != claim) {
    ++tally.failures;
    ADD_FAILURE() << name_of(claim) << ", but not in the other order: " << describe<N, T>(a, b);
  }
  const ExactVerdict truth = true_verdict<N, T>(a, b, claim);
  ++tally.cases;
  if (truth.relation != Relation::apart) ++tally.hits;
  const bool underflows = truth.relation != Relation::touching && std::fabs(truth.gap) < least_size;
  if (truth.relation == claim || truth.is_nearly_parallel || underflows) return;
  const double size = is_relative_to_own_size(a.index(), b.index()) ? truth.own_size : truth.largest;
  const double error = std::fabs(truth.gap) / size;
  ++tally.other_verdicts;
  if (claim != Relation::touching || !(error <= band)) {
    ++tally.failures;
    ADD_FAILURE() << name_of(claim) << " is " << name_of(truth.relation) << " by " << truth.gap << ", " << error
                  << " of the size: " << describe<N, T>(a, b);
  }
  if (error > tally.worst) {
    tally.worst = error;
    tally.worst_case = describe<N, T>(a, b);
  }
}

template <Dim N, class T, std::size_t... Indices>
AnyShape<N, T> draw(std::size_t type, const Source<N, T>& source, const rc::Random& random,
                    std::index_sequence<Indices...>) {
  using Any = AnyShape<N, T>;
  Any result;
  const auto draw_one = [&](auto index) {
    using S = std::variant_alternative_t<index, Any>;
    if (type == index) result = rc::Gen<S>(Entry<S>::any(source))(random, 100).value();
  };
  (draw_one(std::integral_constant<std::size_t, Indices>()), ...);
  return result;
}

/// A random shape of the type with this index in AnyShape.
template <Dim N, class T>
AnyShape<N, T> draw(std::size_t type, const Source<N, T>& source, const rc::Random& random) {
  return draw<N, T>(type, source, random, std::make_index_sequence<std::variant_size_v<AnyShape<N, T>>>());
}

enum class CaseKind { uniform, grid, scales, far, shared_points, border, nearly_parallel };

/// Makes the cases of one kind for one pair of types.
template <Dim N, class T>
class CaseMaker {
 public:
  using Any = AnyShape<N, T>;
  using Pair = AnyPair<N, T>;

  CaseMaker(std::size_t a, std::size_t b, std::uint64_t seed) : a_(a), b_(b), random_(seed) {}

  /// One case or a few that belong together.
  std::vector<Pair> make(CaseKind kind) {
    rc::Random random = random_.split();
    switch (kind) {
      case CaseKind::uniform:
        return {draw_pair(Kind::uniform)};
      case CaseKind::grid:
        return {draw_pair(Kind::grid)};
      case CaseKind::scales:
        return {draw_pair(Kind::scales)};
      case CaseKind::far:
        return {draw_pair(Kind::far)};
      case CaseKind::shared_points:
        return {sharing_points()};
      case CaseKind::border:
        return border(placed_together<N, T>(draw_from(source_of<N, T>(any_kind(random))), random));
      case CaseKind::nearly_parallel:
        return border(placed_together<N, T>(nearly_parallel(random), random));
    }
    return {};
  }

 private:
  static Kind any_kind(rc::Random& random) {
    return kinds[static_cast<std::size_t>(whole(random, 0, static_cast<int>(kinds.size()) - 1))];
  }

  Pair draw_from(const Source<N, T>& source) {
    Any first = draw<N, T>(a_, source, random_.split());
    return {std::move(first), draw<N, T>(b_, source, random_.split())};
  }

  /// In two cases of three moved to have a point in common.
  Pair draw_pair(Kind kind) {
    const Pair pair = draw_from(source_of<N, T>(kind));
    rc::Random random = random_.split();
    return whole(random, 0, 2) == 0 ? pair : placed_together<N, T>(pair, random);
  }

  Pair sharing_points() {
    const Source<N, T> source = source_of<N, T>(Kind::uniform);
    const Vec<N, T> p = source.point(random_.split(), 100).value();
    const Vec<N, T> q = source.point(random_.split(), 100).value();
    return draw_from(sharing<N, T>(source, p, q));
  }

  /// Shapes with edges along the axes or diagonals, turned together, and then one by very little. Boxes along the axes
  /// stay what they are.
  Pair nearly_parallel(rc::Random& random) {
    const auto [a, b] = draw_from(source_of<N, T>(Kind::grid));
    const double radians = std::pow(10, std::is_same_v<T, float> ? between(random, -9, -5) : between(random, -17, -6));
    const Mat<N, double> little = turn(random, radians * (180 / 3.14159265358979323846));
    const bool has_box = std::holds_alternative<Aabb<N, T>>(a) || std::holds_alternative<Aabb<N, T>>(b);
    const Mat<N, double> both = has_box ? Mat<N, double>(1.0) : turn(random, between(random, -180, 180));
    return {turned(a, both), skewed(turned(b, both * little), random)};
  }

  static Mat<N, double> turn(rc::Random& random, double degrees) {
    if constexpr (N == 2) {
      return rotation_matrix(degrees);
    } else {
      return rotation_matrix(any_way<3>(random), degrees);
    }
  }

  static Any turned(const Any& shape, const Mat<N, double>& rotation) {
    if (std::holds_alternative<Aabb<N, T>>(shape)) return shape;
    return transformed(shape, Pose<N, T>{rounded<N, T>(rotation), Vec<N, T>(T(0))});
  }

  /// A box whose axes are as far from orthonormal as is valid, in one case of three.
  static Any skewed(const Any& shape, rc::Random& random) {
    if (!std::holds_alternative<Obb<N, T>>(shape) || whole(random, 0, 2) != 0) return shape;
    Obb<N, T> box = std::get<Obb<N, T>>(shape);
    for (Dim i = 0; i < N; ++i) box.axes[i] += Vec<N, T>(any_way<N>(random) * 3e-5);
    return is_valid(box) ? Any(box) : shape;
  }

  std::vector<Pair> border(const Pair& pair) {
    rc::Random random = random_.split();
    return at_the_border<N, T>(pair, any_way<N>(random), [](const Pair& at) {
      return relation_of<N, T>(at.first, at.second) != Relation::apart;
    });
  }

  std::size_t a_;
  std::size_t b_;
  rc::Random random_;
};

template <Dim N, class T>
Tally check_all(CaseKind kind, std::size_t count, std::uint64_t seed) {
  constexpr std::size_t types = std::variant_size_v<AnyShape<N, T>>;
  Tally tally;
  for (std::size_t a = 0; a < types; ++a) {
    for (std::size_t b = a; b < types; ++b) {
      CaseMaker<N, T> maker(a, b, seed + a * types + b);
      for (std::size_t i = 0; i < count && tally.failures < most_failures; ++i) {
        for (const AnyPair<N, T>& pair : maker.make(kind)) check<N, T>(pair, tally);
      }
    }
  }
  return tally;
}

template <class SpaceType>
class Agreement : public ::testing::Test {
 public:
  static void run(CaseKind kind) {
    constexpr Dim N = SpaceType::dimension;
    using T = typename SpaceType::scalar;
    const auto count = static_cast<std::size_t>(std::ceil(20 * number_from_environment("GRAZE_TEST_SCALE", 1)));
    const auto seed = static_cast<std::uint64_t>(number_from_environment("GRAZE_TEST_SEED", 1));
    const Tally tally = check_all<N, T>(kind, count, seed);
    std::cout << "seed " << seed << ": " << tally.cases << " cases, " << 100 * tally.hits / tally.cases << " % hits, "
              << tally.other_verdicts << " called touching within the band, at most " << tally.worst
              << " of the size\n";
    if (!tally.worst_case.empty()) std::cout << "the worst: " << tally.worst_case << "\n";
    EXPECT_GE(tally.hits * 5, tally.cases) << "too few hits to prove anything";
    EXPECT_LE(tally.hits * 5, tally.cases * 4) << "too many hits to prove anything";
  }
};

using Spaces = ::testing::Types<Space<2, float>, Space<2, double>, Space<3, float>, Space<3, double>>;
TYPED_TEST_SUITE(Agreement, Spaces);

TYPED_TEST(Agreement, OnUniformNumbers) { TestFixture::run(CaseKind::uniform); }
TYPED_TEST(Agreement, OnSmallWholeNumbers) { TestFixture::run(CaseKind::grid); }
TYPED_TEST(Agreement, OnNumbersOfAllSizes) { TestFixture::run(CaseKind::scales); }
TYPED_TEST(Agreement, FarFromTheOrigin) { TestFixture::run(CaseKind::far); }
TYPED_TEST(Agreement, OnShapesThatShareCorners) { TestFixture::run(CaseKind::shared_points); }
TYPED_TEST(Agreement, WhereTheVerdictChanges) { TestFixture::run(CaseKind::border); }
TYPED_TEST(Agreement, WhereTheVerdictOfNearlyParallelEdgesChanges) { TestFixture::run(CaseKind::nearly_parallel); }

}  // namespace
}  // namespace graze::test
