// SPDX-License-Identifier: MIT
// The cores of 2D capsules and boxes in a common form, for one pair or many (one_pair.hpp): a rectangle, which may have
// no height.

/// Relative to a point near the pair. The corners are at the center plus or minus a half edge along each axis; a
/// segment has one axis.
template <std::size_t axes>
struct Core2d {
  Point2d center;
  Point2d half_edge[2];
  Point2d along[2];  ///< The same of length 1.
  Real half_length[2];
  Point2d normal[2];  ///< Unit normals: of the sides across each axis, those at half_edge.
  Real radius;

  /// Sets all to zero. Not a constructor: constructors of structs that hold a core would call it, and those for many
  /// pairs are compiled for any machine.
  [[gnu::always_inline]] void clear() {
    center = zero<Point2d>();
    radius = all(0.0);
    half_edge[0] = half_edge[1] = along[0] = along[1] = normal[0] = normal[1] = zero<Point2d>();
    half_length[0] = half_length[1] = all(0.0);
  }

  /// The sum of the coordinates.
  [[gnu::always_inline]] Real size() const {
    Real sum = sum_abs(center) + radius;
    for (std::size_t i = 0; i < axes; ++i) sum = sum + sum_abs(half_edge[i]);
    return sum;
  }

  [[gnu::always_inline]] Real shortest() const {
    return axes == 1 ? half_length[0] : min_of(half_length[0], half_length[1]);
  }

  /// The corner with these signs, 1 or -1, along the axes.
  [[gnu::always_inline]] Point2d corner(const Point2d& sides) const {
    return center + half_edge[0] * sides[0] + half_edge[1] * sides[1];
  }

  /// The side of the center that a point is on, along each axis.
  [[gnu::always_inline]] Point2d sides_of(const Point2d& place) const {
    const Point2d off = place - center;
    return {side_of(dot(off, half_edge[0])), side_of(dot(off, half_edge[1]))};
  }

  [[gnu::always_inline]] void set_edge(std::size_t i, const Point2d& half) {
    half_edge[i] = half;
    half_length[i] = sqrt(dot(half, half));
    along[i] = half * (1.0 / half_length[i]);
  }
};

struct ObbNumbers2d {
  Point2d center;
  Real half[2];
  Point2d axes[2];
};

struct AabbNumbers2d {
  Point2d min;
  Point2d max;
};

[[gnu::always_inline]] inline Core2d<1> core_2d(const CapsuleNumbers<Point2d>& capsule, const Point2d& origin) {
  const Point2d start = capsule.start - origin;
  const Point2d end = capsule.end - origin;
  Core2d<1> core;
  core.clear();
  core.center = (start + end) * all(0.5);
  core.set_edge(0, (end - start) * all(0.5));
  core.normal[1] = perpendicular(core.along[0]);
  core.radius = capsule.radius;
  return core;
}

[[gnu::always_inline]] inline Core2d<2> core_2d(const ObbNumbers2d& box, const Point2d& origin) {
  Core2d<2> core;
  core.center = box.center - origin;
  core.set_edge(0, box.axes[0] * box.half[0]);
  core.set_edge(1, box.axes[1] * box.half[1]);
  const Real turn = side_of(box.axes[0][0] * box.axes[1][1] - box.axes[0][1] * box.axes[1][0]);
  core.normal[0] = perpendicular(core.along[1]) * -turn;
  core.normal[1] = perpendicular(core.along[0]) * turn;
  core.radius = all(0.0);
  return core;
}

[[gnu::always_inline]] inline Core2d<2> core_2d(const AabbNumbers2d& box, const Point2d& origin) {
  const Point2d low = box.min - origin;
  const Point2d high = box.max - origin;
  const Point2d half = (high - low) * all(0.5);
  Core2d<2> core;
  core.center = (low + high) * all(0.5);
  core.half_edge[0] = {half[0], all(0.0)};
  core.half_edge[1] = {all(0.0), half[1]};
  core.half_length[0] = half[0];
  core.half_length[1] = half[1];
  core.along[0] = core.normal[0] = {all(1.0), all(0.0)};
  core.along[1] = core.normal[1] = {all(0.0), all(1.0)};
  core.radius = all(0.0);
  return core;
}

/// The origin for a pair whose first shape is this one.
[[gnu::always_inline]] inline const Point2d& origin_2d(const CapsuleNumbers<Point2d>& capsule) { return capsule.start; }
[[gnu::always_inline]] inline const Point2d& origin_2d(const ObbNumbers2d& box) { return box.center; }
[[gnu::always_inline]] inline const Point2d& origin_2d(const AabbNumbers2d& box) { return box.min; }
