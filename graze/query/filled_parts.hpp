// SPDX-License-Identifier: MIT
/// @file
/// filled_parts(polygon): any closed polygon, filled by the nonzero rule, as a union of convex ones. A simple polygon
/// is split by convex_parts. For any other, edges are cut where they meet until they share only ends. Then a vertical
/// line sweeps over them (Bentley and Ottmann, 1979), and the filled area between the lines through two neighbouring
/// ends is split into trapezoids.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <graze/math/orientation.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/convex_parts.hpp>
#include <graze/shape/segment.hpp>

namespace graze {

/// The largest number of pieces into which `filled_parts` cuts edges that meet; it returns std::nullopt beyond.
inline constexpr std::size_t max_filled_pieces = 50'000;

namespace detail {

/// Less by x, then by y.
template <class T>
bool is_left_of(const Vec<2, T>& a, const Vec<2, T>& b) {
  return a.x != b.x ? a.x < b.x : a.y < b.y;
}

/// An edge from left to right; of a vertical one, from bottom to top (y up).
template <class T>
struct FilledEdge {
  Vec<2, T> left;
  Vec<2, T> right;
  int winding = 0;  ///< The winding number just above it less that just below it.
};

/// The point where two edges cross, rounded; it lies in the boxes of both.
template <class T>
Vec<2, T> rounded_crossing(const FilledEdge<T>& a, const FilledEdge<T>& b) {
  const Vec<2, double> start = wide<2, T>(a.left);
  const Vec<2, double> along_a = wide<2, T>(a.right) - start;
  const Vec<2, double> along_b = wide<2, T>(b.right) - wide<2, T>(b.left);
  const double sine = along_a.x * along_b.y - along_a.y * along_b.x;
  const Vec<2, double> between = wide<2, T>(b.left) - start;
  // Zero only by rounding: the lines are so close to each other that any point of the edges' common box will do.
  const double part = sine == 0 ? 0.5 : (between.x * along_b.y - between.y * along_b.x) / sine;
  const Vec<2, T> point = Vec<2, T>(start + part * along_a);
  const Vec<2, T> low = glm::max(glm::min(a.left, a.right), glm::min(b.left, b.right));
  const Vec<2, T> high = glm::min(glm::max(a.left, a.right), glm::max(b.left, b.right));
  return glm::clamp(point, low, high);
}

/// Merges edges between the same two points; edges that do not change the winding number stay, with 0.
template <class T>
void unite_equal_edges(std::vector<FilledEdge<T>>& edges) {
  const auto key = [](const FilledEdge<T>& edge) {
    return std::tuple(edge.left.x, edge.left.y, edge.right.x, edge.right.y);
  };
  std::sort(edges.begin(), edges.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (kept > 0 && key(edges[kept - 1]) == key(edges[i])) {
      edges[kept - 1].winding += edges[i].winding;
    } else {
      edges[kept++] = edges[i];
    }
  }
  edges.resize(kept);
}

/// For each edge, the points at which to cut it.
template <class T>
struct Cuts {
  explicit Cuts(std::size_t edges) : points(edges) {}

  void add(std::size_t edge, const Vec<2, T>& point) {
    points[edge].push_back(point);
    ++count;
  }

  std::vector<std::vector<Vec<2, T>>> points;
  std::size_t count = 0;
};

/// Where edges meet, other than in a common end.
template <class T>
struct Meetings {
  Cuts<T> ends;       ///< Cuts at an end of another edge: exact.
  Cuts<T> crossings;  ///< Cuts where two edges cross: rounded.
};

/// Records where two edges meet, other than in a common end.
template <class T>
void note_meeting(const std::vector<FilledEdge<T>>& edges, std::size_t i, std::size_t j, Meetings<T>& found) {
  const FilledEdge<T>& a = edges[i];
  const FilledEdge<T>& b = edges[j];
  const int left = orientation(a.left, a.right, b.left);
  const int right = orientation(a.left, a.right, b.right);
  if (left * right > 0) return;
  const int left_of_b = orientation(b.left, b.right, a.left);
  const int right_of_b = orientation(b.left, b.right, a.right);
  if (left_of_b * right_of_b > 0) return;
  if (left * right < 0 && left_of_b * right_of_b < 0) {
    const Vec<2, T> point = rounded_crossing(a, b);
    found.crossings.add(i, point);
    found.crossings.add(j, point);
    return;
  }
  // An end on the other's line, between its ends, cuts the other. The order along a line is that of is_left_of.
  const auto note_inner = [&](const Vec<2, T>& point, std::size_t edge) {
    if (is_left_of(edges[edge].left, point) && is_left_of(point, edges[edge].right)) found.ends.add(edge, point);
  };
  if (left == 0) note_inner(b.left, i);
  if (right == 0) note_inner(b.right, i);
  if (left_of_b == 0) note_inner(a.left, j);
  if (right_of_b == 0) note_inner(a.right, j);
}

/// All points where two edges meet, other than in a common end.
template <class T>
Meetings<T> meetings(const std::vector<FilledEdge<T>>& edges) {
  Meetings<T> found{Cuts<T>(edges.size()), Cuts<T>(edges.size())};
  std::vector<std::size_t> active;
  for (std::size_t i = 0; i < edges.size(); ++i) {  // by x of their left ends
    const T low = std::min(edges[i].left.y, edges[i].right.y);
    const T high = std::max(edges[i].left.y, edges[i].right.y);
    std::erase_if(active, [&](std::size_t j) { return edges[j].right.x < edges[i].left.x; });
    for (const std::size_t j : active) {
      if (std::max(edges[j].left.y, edges[j].right.y) < low || std::min(edges[j].left.y, edges[j].right.y) > high) {
        continue;
      }
      note_meeting(edges, i, j, found);
    }
    active.push_back(i);
    if (found.ends.count + found.crossings.count > 2 * max_filled_pieces) break;
  }
  return found;
}

/// Appends an edge's pieces to `pieces`. Cuts that rounding has moved off the edge bend it.
template <class T>
void add_pieces(const FilledEdge<T>& edge, std::vector<Vec<2, T>>& points, std::vector<FilledEdge<T>>& pieces) {
  std::sort(points.begin(), points.end(), is_left_of<T>);
  points.push_back(edge.right);
  Vec<2, T> at = edge.left;
  for (const Vec<2, T>& next : points) {
    // Rounding may move a cut of an almost vertical edge to the wrong side of its end.
    if (is_left_of(at, next)) pieces.push_back({at, next, edge.winding});
    if (is_left_of(next, at)) pieces.push_back({next, at, -edge.winding});
    at = next;
  }
}

/// Cuts edges where they meet until they share only ends. Returns false if that makes too many pieces or takes too
/// long. Exact cuts come first: edges that lie on each other then become one, with one rounded crossing with a third.
template <class T>
bool cut_where_they_meet(std::vector<FilledEdge<T>>& edges) {
  constexpr int rounds = 32;  // rounding bends pieces, which may meet others; a few are enough
  for (int round = 0; round < rounds; ++round) {
    unite_equal_edges(edges);
    Meetings<T> found = meetings(edges);
    Cuts<T>& cuts = found.ends.count > 0 ? found.ends : found.crossings;
    if (cuts.count == 0) return true;
    if (edges.size() + cuts.count > 2 * max_filled_pieces) return false;
    std::vector<FilledEdge<T>> pieces;
    for (std::size_t i = 0; i < edges.size(); ++i) add_pieces(edges[i], cuts.points[i], pieces);
    edges = std::move(pieces);
  }
  return false;
}

/// The y of an edge that is not vertical, at an x between those of its ends.
template <class T>
T height_at(const FilledEdge<T>& edge, T x) {
  if (x == edge.left.x) return edge.left.y;
  if (x == edge.right.x) return edge.right.y;
  const double slope = (double(edge.right.y) - double(edge.left.y)) / (double(edge.right.x) - double(edge.left.x));
  const T y = static_cast<T>(double(edge.left.y) + (double(x) - double(edge.left.x)) * slope);
  return std::clamp(y, std::min(edge.left.y, edge.right.y), std::max(edge.left.y, edge.right.y));
}

/// Sweeps over edges that share only ends, and collects trapezoids with vertical sides.
template <class T>
class TrapezoidSweep {
 public:
  /// Corners along the bottom and the top, from left to right; the vertical sides connect the first two and the last
  /// two.
  struct Part {
    std::vector<Vec<2, T>> bottom;
    std::vector<Vec<2, T>> top;
  };

  explicit TrapezoidSweep(const std::vector<FilledEdge<T>>& edges)
      : edges_(edges), is_covered_(edges.size(), false), open_on_(edges.size()) {}

  void run() {
    std::vector<T> lines;
    for (const FilledEdge<T>& edge : edges_) lines.insert(lines.end(), {edge.left.x, edge.right.x});
    std::sort(lines.begin(), lines.end());
    lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
    std::size_t next = 0;
    for (const T x : lines) {
      std::erase_if(active_, [&](std::size_t i) { return edges_[i].right.x == x; });
      for (; next < edges_.size() && edges_[next].left.x == x; ++next) {
        if (edges_[next].right.x == x) continue;  // vertical
        active_.insert(std::upper_bound(active_.begin(), active_.end(), next,
                                        [&](std::size_t a, std::size_t b) { return is_below(edges_[a], edges_[b]); }),
                       next);
      }
      pass(x);
    }
  }

  std::vector<Part>& parts() { return parts_; }

  /// True if an edge bounds the filled area, from below or above, or lies in it.
  bool is_covered(std::size_t edge) const { return is_covered_[edge]; }

 private:
  /// A trapezoid whose right side has not been found yet.
  struct Open {
    std::size_t bottom;
    std::size_t top;
    T left;
  };

  /// For two edges whose ranges of x overlap in more than an end.
  static bool is_below(const FilledEdge<T>& a, const FilledEdge<T>& b) {
    const bool a_first = !is_left_of(b.left, a.left);
    const FilledEdge<T>& first = a_first ? a : b;
    const FilledEdge<T>& later = a_first ? b : a;
    int side = orientation(first.left, first.right, later.left);
    if (side == 0) side = orientation(first.left, first.right, later.right);
    return a_first ? side > 0 : side < 0;
  }

  /// The state at the line through x: the filled intervals to its right, and the parts that end there.
  void pass(T x) {
    std::vector<Open> open;
    int winding = 0;
    std::size_t bottom = 0;
    for (const std::size_t i : active_) {
      const int above = winding + edges_[i].winding;
      if (winding != 0 || above != 0) is_covered_[i] = true;
      if (winding == 0 && above != 0) bottom = i;
      if (winding != 0 && above == 0) open.push_back({bottom, i, x});
      winding = above;
    }
    for (Open& now : open) {
      std::optional<Open>& before = open_on_[now.bottom];
      if (!before || before->top != now.top) continue;
      now.left = before->left;
      before.reset();
    }
    for (const Open& known : open_) {
      std::optional<Open>& ended = open_on_[known.bottom];
      if (ended) close(*ended, x);
      ended.reset();
    }
    for (const Open& now : open) open_on_[now.bottom] = now;
    open_ = std::move(open);
  }

  void close(const Open& ended, T x) {
    const auto side = [&](T at) {
      const T low = height_at(edges_[ended.bottom], at);
      return std::pair(low, std::max(low, height_at(edges_[ended.top], at)));
    };
    const auto [left_low, left_high] = side(ended.left);
    const auto [right_low, right_high] = side(x);
    parts_.push_back({{{ended.left, left_low}, {x, right_low}}, {{ended.left, left_high}, {x, right_high}}});
  }

  const std::vector<FilledEdge<T>>& edges_;
  std::vector<bool> is_covered_;
  std::vector<std::size_t> active_;           ///< The edges that the line crosses, from the bottom up.
  std::vector<Open> open_;                    ///< Likewise.
  std::vector<std::optional<Open>> open_on_;  ///< Those of `open_`, by the edge at their bottom.
  std::vector<Part> parts_;
};

/// Merges parts that share a whole side if the result is convex.
template <class T, class Part>
void join_neighbours(std::vector<Part>& parts) {
  std::sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) {
    return std::pair(a.bottom[0].x, a.bottom[0].y) < std::pair(b.bottom[0].x, b.bottom[0].y);
  });
  std::map<std::tuple<T, T, T>, std::size_t> by_right_side;
  std::vector<Part> joined;
  for (Part& part : parts) {
    const auto left = by_right_side.find({part.bottom[0].x, part.bottom[0].y, part.top[0].y});
    if (left != by_right_side.end() && part.bottom[0].y < part.top[0].y) {
      Part& other = joined[left->second];
      const auto turn = [](const std::vector<Vec<2, T>>& before, const std::vector<Vec<2, T>>& after) {
        return orientation(before[before.size() - 2], before.back(), after[1]);
      };
      if (turn(other.bottom, part.bottom) >= 0 && turn(other.top, part.top) <= 0) {
        other.bottom.push_back(part.bottom[1]);
        other.top.push_back(part.top[1]);
        const std::size_t index = left->second;
        by_right_side.erase(left);
        by_right_side[{part.bottom[1].x, part.bottom[1].y, part.top[1].y}] = index;
        continue;
      }
    }
    by_right_side[{part.bottom[1].x, part.bottom[1].y, part.top[1].y}] = joined.size();
    joined.push_back(std::move(part));
  }
  parts = std::move(joined);
}

/// The edges of a closed polygon, without those of zero length.
template <class T>
std::vector<FilledEdge<T>> edges_of(std::span<const Vec<2, T>> polygon) {
  std::vector<FilledEdge<T>> edges;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec<2, T>& start = polygon[i];
    const Vec<2, T>& end = polygon[(i + 1) % polygon.size()];
    if (is_left_of(start, end)) edges.push_back({start, end, 1});
    if (is_left_of(end, start)) edges.push_back({end, start, -1});
  }
  return edges;
}

/// `filled_parts` of a polygon that meets itself.
template <class T>
std::optional<std::vector<std::vector<Vec<2, T>>>> filled_parts_of_crossing(std::span<const Vec<2, T>> polygon) {
  std::vector<FilledEdge<T>> edges = edges_of(polygon);
  if (!cut_where_they_meet(edges)) return std::nullopt;
  TrapezoidSweep<T> sweep(edges);
  sweep.run();
  join_neighbours<T>(sweep.parts());
  std::vector<std::vector<Vec<2, T>>> result;
  for (const auto& part : sweep.parts()) {
    std::vector<Vec<2, T>> corners = part.bottom;
    corners.insert(corners.end(), part.top.rbegin(), part.top.rend());
    if (auto flat = ends_of_2d<T>(corners)) {
      result.push_back(*std::move(flat));
    } else {
      result.push_back(true_corners<T>(corners));
    }
  }
  // The outline belongs to the polygon even where it bounds nothing, because it goes back on itself there.
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const bool is_vertical = edges[i].left.x == edges[i].right.x;
    if (edges[i].winding == 0 && !is_vertical && !sweep.is_covered(i))
      result.push_back({edges[i].left, edges[i].right});
    if (edges[i].winding == 0 && is_vertical) result.push_back({edges[i].left, edges[i].right});
  }
  return result;
}

}  // namespace detail

/// Splits a closed polygon, filled by the nonzero rule, into convex ones. Filled are the outline and all points with a
/// winding number other than 0. The outline may cross and touch itself. A simple polygon gives its `convex_parts`,
/// exactly. For others the interiors of the parts are disjoint, and the union is off by the rounding of new corners: a
/// few ulp of the largest coordinate. Each part is counter-clockwise (y up); where the outline only goes back on
/// itself, it is the two ends of a segment. Returns std::nullopt if a coordinate is not finite, or edges meet more than
/// `max_filled_pieces` times.
template <class T>
std::optional<std::vector<std::vector<Vec<2, T>>>> filled_parts(
    std::type_identity_t<std::span<const Vec<2, T>>> polygon) {
  using Parts = std::optional<std::vector<std::vector<Vec<2, T>>>>;
  T largest = 0;
  for (const Vec<2, T>& point : polygon) {
    if (!is_finite(point)) return std::nullopt;
    largest = std::max({largest, std::fabs(point.x), std::fabs(point.y)});
  }
  const auto parts_of = [](std::span<const Vec<2, T>> points) -> Parts {
    Parts simple = convex_parts<T>(points);
    return simple ? simple : detail::filled_parts_of_crossing<T>(points);
  };
  // Products of products must not overflow or underflow, so coordinates far from 1 are scaled by a power of two.
  constexpr int farthest = std::numeric_limits<T>::max_exponent / 4;
  if (largest == 0 || std::abs(std::ilogb(largest)) <= farthest) return parts_of(polygon);
  const int exponent = std::ilogb(largest);
  std::vector<Vec<2, T>> near(polygon.begin(), polygon.end());
  for (Vec<2, T>& point : near) point = {std::ldexp(point.x, -exponent), std::ldexp(point.y, -exponent)};
  Parts parts = parts_of(near);
  if (!parts) return std::nullopt;
  for (auto& part : *parts) {
    for (Vec<2, T>& corner : part) corner = {std::ldexp(corner.x, exponent), std::ldexp(corner.y, exponent)};
  }
  return parts;
}

/// The overload for any contiguous range of points.
template <PointRow Row>
auto filled_parts(const Row& polygon) {
  return filled_parts<typename ElementOf<Row>::value_type>(span_of(polygon));
}

}  // namespace graze
