// SPDX-License-Identifier: MIT
// A segment relative to a 3D box, for one pair or many (one_pair.hpp): the nearest point, and the direction of least
// depth, by the separating-axis test of separating_axis.hpp in the box's own coordinates, for pairs where all but one
// of the directions are clearly worse.

/// In the box's own coordinates, as far as its axes are orthonormal.
struct WayPastBox {
  Point start;
  Point way;
  Point half;

  [[gnu::always_inline]] Point at(Real t) const { return start + way * t; }

  /// Half the derivative of the squared distance with respect to t, which increases with t.
  [[gnu::always_inline]] Real slope(Real t) const {
    Point terms;
    for (Dim i = 0; i < 3; ++i) {
      const Real x = start[i] + way[i] * t;
      terms[i] = way[i] * (x - min_of(max_of(x, -half[i]), half[i]));
    }
    return terms[0] + terms[1] + terms[2];
  }

  /// The nearest point, from 0 to 1: the slope is linear between the points where the segment crosses a side.
  [[gnu::always_inline]] Real nearest() const {
    Real low = all(0.0);
    Real high = all(1.0);
    Real slope_low = slope(low);
    const Mask is_start = slope_low >= 0.0;
    if (!any_likely(!is_start)) return low;
    Real slope_high = slope(high);
    const Mask is_end = slope_high <= 0.0;
    const Real at_end = select(is_start, low, high);
    if (!any_likely(!(is_start || is_end))) return at_end;
    for (Dim i = 0; i < 3; ++i) {
      const Real per_way = 1.0 / way[i];
      for (const Real& side : {-half[i], half[i]}) {
        const Real t = (side - start[i]) * per_way;
        const Mask is_between = t > low && t < high;
        if (!any_likely(is_between)) continue;
        const Real here = slope(t);
        const Mask is_below = is_between && here < 0.0;
        const Mask is_above = is_between && !is_below;
        low = select(is_below, t, low);
        slope_low = select(is_below, here, slope_low);
        high = select(is_above, t, high);
        slope_high = select(is_above, here, slope_high);
      }
    }
    return select(is_start || is_end, at_end, low - slope_low * (high - low) / (slope_high - slope_low));
  }
};

/// The position of a point relative to a box's faces, by more than the error bound.
struct PlaceByFaces {
  Mask is_beyond[3];
  Mask is_one;    ///< Beyond the faces across one axis only, ...
  Mask is_two;    ///< ... or two.
  Axis last;      ///< The last of them.
  Mask is_clear;  ///< Whether all sides are certain.
  Real squared;   ///< The squared distance from the box.
  Real least_beyond;

  [[gnu::always_inline]] PlaceByFaces(const Point& place, const Point& half, Real doubt)
      : last(axis_number(0)),
        is_clear(all(true)),
        squared(all(0.0)),
        least_beyond(all(std::numeric_limits<double>::infinity())) {
    Real count = all(0.0);
    for (Dim i = 0; i < 3; ++i) {
      const Real beyond = fabs(place[i]) - half[i];
      is_clear = is_clear && fabs(beyond) > doubt;
      const Real off = max_of(beyond, all(0.0));
      squared = squared + off * off;
      is_beyond[i] = beyond > doubt;
      count = count + or_zero(is_beyond[i], all(1.0));
      last = select(is_beyond[i], axis_number(i), last);
      least_beyond = select(is_beyond[i], min_of(least_beyond, beyond), least_beyond);
    }
    is_one = count == 1.0;
    is_two = count == 2.0;
  }
};

/// Across a face, or across an edge of the box and the segment.
class MinimumTranslation {
 public:
  /// `doubt` is the error bound of the depth, `noise` the rounding error of a coordinate. Only for these pairs.
  [[gnu::always_inline]] MinimumTranslation(const WayPastBox& way, Real doubt, Real noise, Mask pairs) {
    if (!any(pairs)) return;
    for (Dim i = 0; i < 3; ++i) look_across_face(way, i);
    is_level = fabs(turned(way.way, face)) <= noise;
    const Real squared_noise = noise * noise;
    const Real least = least_sine_squared * dot(way.way, way.way);
    for (Dim i = 0; i < 3; ++i) look_along_edge(way, i, squared_noise, least);
    is_face = face_gap_ >= edge_gap_;
    const Real best = select(is_face, face_gap_, edge_gap_);
    const Real second = max_of(min_of(face_gap_, edge_gap_), select(is_face, second_face_gap_, second_edge_gap_));
    is_known = !is_in_doubt_ && best < -doubt && best - second > doubt;
    if (any_likely(!is_face)) find_edge_outward(way);
  }

  Mask is_known = all(false);  ///< If not, nothing else is valid.
  Mask is_face = all(false);
  Mask is_level = all(false);  ///< For a face: whether the depth is the same along the whole segment, up to rounding.
  Mask is_far = all(false);    ///< For a face: whether it is the one on the axis's far side.
  /// For an edge: whether the direction deviates from the faces' normals by more than the angle of flat contacts.
  Mask is_oblique = all(false);
  Axis face = axis_number(0);     ///< The axis that the face is across.
  Axis edge = axis_number(0);     ///< The axis that the edge is along.
  Point outward = zero<Point>();  ///< For an edge: in the box's coordinates, of any length.

 private:
  static constexpr double least_sine_squared = 1e-8;  // below this, rounding destroys the direction
  static constexpr double nowhere = -std::numeric_limits<double>::infinity();

  [[gnu::always_inline]] void look_across_face(const WayPastBox& way, Dim i) {
    const Real end = way.start[i] + way.way[i];
    const Real ahead = min_of(way.start[i], end) - way.half[i];
    const Real behind = -way.half[i] - max_of(way.start[i], end);
    const Real gap = max_of(ahead, behind);
    second_face_gap_ = max_of(second_face_gap_, max_of(min_of(gap, face_gap_), min_of(ahead, behind)));
    const Mask is_better = gap > face_gap_;
    face_gap_ = select(is_better, gap, face_gap_);
    face = select(is_better, axis_number(i), face);
    is_far = select(is_better, ahead >= behind, is_far);
  }

  /// The normal of a face is also perpendicular to all its edges and a segment parallel to it.
  [[gnu::always_inline]] void look_along_edge(const WayPastBox& way, Dim i, Real squared_noise, Real least) {
    const Dim next = (i + 1) % 3;
    const Dim last = (i + 2) % 3;
    const Real x = way.way[next];
    const Real y = way.way[last];
    const Real squared = x * x + y * y;
    const Mask is_of_face = is_level && !is_axis(face, i);
    const Mask counts = !(is_of_face || squared <= squared_noise);
    if (!any_likely(counts)) return;
    is_in_doubt_ = is_in_doubt_ || (counts && !(squared > least));
    const Real height = way.start[next] * y - way.start[last] * x;
    const Real reach = way.half[next] * fabs(y) + way.half[last] * fabs(x);
    const Real per_length = 1.0 / sqrt(squared);
    const Real gap = (fabs(height) - reach) * per_length;
    const Real other = (-fabs(height) - reach) * per_length;
    take(counts, max_of(second_edge_gap_, max_of(min_of(gap, edge_gap_), other)), second_edge_gap_);
    const Mask is_better = counts && gap > edge_gap_;
    edge_gap_ = select(is_better, gap, edge_gap_);
    edge = select(is_better, axis_number(i), edge);
    height_ = select(is_better, height, height_);
  }

  [[gnu::always_inline]] void find_edge_outward(const WayPastBox& way) {
    const Real side = select(height_ > 0.0, all(1.0), all(-1.0));
    const Real on_next = side * turned(way.way, edge, 2);
    const Real on_last = -side * turned(way.way, edge, 1);
    outward = placed(edge, all(0.0), on_next, on_last);
    constexpr double least_cosine = 16 * tolerance::aligned;
    const Real a = fabs(on_next);
    const Real b = fabs(on_last);
    is_oblique = min_of(a, b) > least_cosine * max_of(a, b);
  }

  Real face_gap_ = all(nowhere);
  Real second_face_gap_ = all(nowhere);
  Real edge_gap_ = all(nowhere);
  Real second_edge_gap_ = all(nowhere);
  Real height_ = all(0.0);
  Mask is_in_doubt_ = all(false);
};
