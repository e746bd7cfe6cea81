// SPDX-License-Identifier: MIT
// The Minkowski difference a - b of two convex hulls in integers: its point nearest to the origin, whether the origin
// is inside, and how deep. Nothing is rounded, so every comparison is a proof.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <vector>

#include <graze/math/vec.hpp>

#include "exact/numbers.hpp"
#include "exact/solid.hpp"

namespace graze::test {

/// The difference of a corner of each.
template <Dim N>
struct CornerPair {
  std::size_t a;
  std::size_t b;
  IntegerVec<N> difference;
};

/// The point `sum / weight` (weight > 0) in the relative interior of the hull of `face`, nearest to the origin.
template <Dim N>
struct NearestDifference {
  IntegerVec<N> sum;
  Integer weight;
  std::vector<CornerPair<N>> face;
};

template <Dim N>
class DifferenceSet {
 public:
  using Vector = IntegerVec<N>;

  /// All coordinates times `unit`, the least power of two that makes them integers.
  DifferenceSet(const Solid<N>& a, const Solid<N>& b) {
    for (const Solid<N>* solid : {&a, &b}) {
      for (const auto* list : {&solid->corners, &solid->edges}) {
        for (const RationalVec<N>& v : *list) {
          for (const Rational& x : v) unit_ = std::max(unit_, Integer(denominator(x)));
        }
      }
    }
    a_ = whole(a.corners);
    b_ = whole(b.corners);
    edges_ = whole(a.edges);
    for (const Vector& edge : whole(b.edges)) edges_.push_back(edge);
  }

  const Integer& unit() const { return unit_; }

  /// Grows a simplex of differences until none is below the supporting plane of its nearest point.
  NearestDifference<N> nearest() const {
    std::vector<CornerPair<N>> simplex{pair(0, 0)};
    while (true) {
      NearestDifference<N> found = nearest_on(simplex);
      if (is_zero(found.sum)) return found;
      const CornerPair<N> next = pair(extreme(a_, found.sum, -1), extreme(b_, found.sum, 1));
      if (is_above(found, next.difference)) return found;
      simplex = found.face;
      simplex.push_back(next);
    }
  }

  /// For a set that contains the origin, given by `nearest`: whether the origin is an interior point. The directions
  /// from the origin into the set are spanned by those from the corners of one pair of the face into either hull, and
  /// by the pair's own difference; the origin is on the boundary if they are all on one side of a plane.
  bool holds_origin_inside(const NearestDifference<N>& origin) const {
    const CornerPair<N>& at = origin.face.front();
    std::vector<Vector> ways{at.difference};
    for (const Vector& corner : a_) ways.push_back(corner - a_[at.a]);
    for (const Vector& corner : b_) ways.push_back(b_[at.b] - corner);
    for (const Vector& normal : normals_of(ways)) {
      if (all_behind(ways, normal) || all_behind(ways, normal * Integer(-1))) return false;
    }
    return !is_flat(ways);
  }

  /// The minimum distance from the origin, which is in the set, to a bounding plane of the set; every such plane is
  /// spanned by edges.
  double depth() const {
    if (is_flat(edges_)) return 0;
    double least = std::numeric_limits<double>::infinity();
    for (const Vector& normal : normals_of(edges_)) {
      for (const int sign : {1, -1}) {
        const Integer height =
            sign * (dot(a_[extreme(a_, normal, sign)], normal) - dot(b_[extreme(b_, normal, -sign)], normal));
        const Wide length = sqrt(Wide(dot(normal, normal))) * Wide(unit_);
        least = std::min(least, static_cast<double>(Wide(height) / length));
      }
    }
    return least;
  }

 private:
  std::vector<Vector> whole(const std::vector<RationalVec<N>>& vectors) const {
    std::vector<Vector> result;
    for (const RationalVec<N>& v : vectors) {
      Vector scaled;
      for (std::size_t i = 0; i < N; ++i) scaled[i] = Integer(numerator(v[i])) * (unit_ / Integer(denominator(v[i])));
      result.push_back(scaled);
    }
    return result;
  }

  CornerPair<N> pair(std::size_t a, std::size_t b) const { return {a, b, a_[a] - b_[b]}; }

  /// The first corner that is farthest along sign * direction.
  static std::size_t extreme(const std::vector<Vector>& corners, const Vector& direction, int sign) {
    std::size_t best = 0;
    Integer best_height = sign * dot(corners[0], direction);
    for (std::size_t i = 1; i < corners.size(); ++i) {
      const Integer height = sign * dot(corners[i], direction);
      if (height > best_height) {
        best = i;
        best_height = height;
      }
    }
    return best;
  }

  /// Whether `difference` is on or above the plane through the point that faces the origin.
  static bool is_above(const NearestDifference<N>& point, const Vector& difference) {
    return point.weight * dot(point.sum, difference) >= dot(point.sum, point.sum);
  }

  /// The nearest point of a simplex: the projection of the origin to the one face that contains it in its interior and
  /// has no other corner below.
  static NearestDifference<N> nearest_on(const std::vector<CornerPair<N>>& simplex) {
    for (unsigned chosen = 1; chosen < 1U << simplex.size(); ++chosen) {
      NearestDifference<N> candidate;
      for (std::size_t i = 0; i < simplex.size(); ++i) {
        if ((chosen >> i & 1U) != 0) candidate.face.push_back(simplex[i]);
      }
      if (!drop_perpendicular(candidate)) continue;
      bool is_nearest = true;
      for (const CornerPair<N>& corner : simplex) is_nearest = is_nearest && is_above(candidate, corner.difference);
      if (is_nearest) return candidate;
    }
    throw std::logic_error("a simplex has a nearest point");
  }

  /// Sets sum and weight to the projection of the origin to the face's span; false if the face is not independent or
  /// the projection is not inside it. With edges e_i = s_i - s_0 the projection is s_0 + sum of m_i e_i where sum_j
  /// (e_i . e_j) m_j = -e_i . s_0, solved by Cramer's rule.
  static bool drop_perpendicular(NearestDifference<N>& candidate) {
    const std::size_t count = candidate.face.size() - 1;
    if (count > N) return false;
    const Vector& start = candidate.face[0].difference;
    std::vector<Vector> edges;
    for (std::size_t i = 1; i <= count; ++i) edges.push_back(candidate.face[i].difference - start);
    const auto determinant_with = [&](std::size_t replaced) {
      std::array<std::array<Integer, 3>, 3> matrix{};
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
          if (i >= count || j >= count) {
            matrix[i][j] = i == j ? 1 : 0;
          } else {
            matrix[i][j] = j == replaced ? Integer(-dot(edges[i], start)) : dot(edges[i], edges[j]);
          }
        }
      }
      return dot(matrix[0], cross(matrix[1], matrix[2]));
    };
    candidate.weight = determinant_with(count);
    if (candidate.weight == 0) return false;
    candidate.sum = start * candidate.weight;
    Integer first_share = candidate.weight;
    for (std::size_t i = 0; i < count; ++i) {
      const Integer share = determinant_with(i);
      if (share <= 0) return false;
      first_share -= share;
      candidate.sum = candidate.sum + edges[i] * share;
    }
    return first_share > 0;
  }

  /// The normals of all planes (in 2D: lines) spanned by these vectors.
  static std::vector<Vector> normals_of(const std::vector<Vector>& ways) {
    std::vector<Vector> normals;
    if constexpr (N == 2) {
      for (const Vector& way : ways) {
        if (!is_zero(way)) normals.push_back({-way[1], way[0]});
      }
    } else {
      for (std::size_t i = 0; i < ways.size(); ++i) {
        for (std::size_t j = i + 1; j < ways.size(); ++j) {
          const Vector normal = cross(ways[i], ways[j]);
          if (!is_zero(normal)) normals.push_back(normal);
        }
      }
    }
    return normals;
  }

  static bool all_behind(const std::vector<Vector>& ways, const Vector& normal) {
    for (const Vector& way : ways) {
      if (dot(way, normal) > 0) return false;
    }
    return true;
  }

  /// Whether the vectors do not span the whole space.
  static bool is_flat(const std::vector<Vector>& ways) {
    const std::vector<Vector> normals = normals_of(ways);
    if (normals.empty()) return true;
    return std::all_of(ways.begin(), ways.end(), [&](const Vector& way) { return dot(way, normals.front()) == 0; });
  }

  Integer unit_ = 1;
  std::vector<Vector> a_;
  std::vector<Vector> b_;
  std::vector<Vector> edges_;
};

}  // namespace graze::test
