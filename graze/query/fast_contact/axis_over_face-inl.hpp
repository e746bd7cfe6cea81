// SPDX-License-Identifier: MIT
// The part of a capsule's axis over a face of a box, for one pair or many (one_pair.hpp): the closed form of pairs_over
// in manifold_points.hpp for a segment, which is clipped at the four sides of a rectangle and at one height above it.

/// A capsule and a box, both relative to the start of the capsule's axis.
struct CapsuleAndBox {
  Point origin;  ///< The start itself.
  Point way;     ///< From the start to the end.
  Real radius;
  Point center;
  Point half;
  Point axes[3];
  Real size;  ///< The sum of the coordinates.

  [[gnu::always_inline]] void find_size() { size = sum_abs(way) + sum_abs(center) + sum_abs(half) + radius; }
};

/// A contact point.
struct CapsulePoint {
  Point on_box;
  Point on_capsule;
  Real depth;
  FeatureName of_box;
  FeatureName of_capsule;
};

[[gnu::always_inline]] inline void take_point(Mask pairs, const CapsulePoint& from, CapsulePoint& to) {
  take(pairs, from.on_box, to.on_box);
  take(pairs, from.on_capsule, to.on_capsule);
  take(pairs, from.depth, to.depth);
  take(pairs, from.of_box, to.of_box);
  take(pairs, from.of_capsule, to.of_capsule);
}

/// The part of the axis over the face. For one pair it is clipped only on demand: a single contact needs the lowest
/// point, which is seldom at a clipped end.
class AxisOverFace {
 public:
  /// The face across an axis, on its far or its near side.
  [[gnu::always_inline]] void set(const CapsuleAndBox& pair, Axis axis, Mask is_far) {
    origin_ = pair.origin;
    way_ = pair.way;
    radius_ = pair.radius;
    axis_ = axis;
    is_far_ = is_far;
    margin_ = least_clear * pair.size;
    thin_ = tolerance::known_direction * pair.size;
    const Point& across_axis = turned(pair.axes, axis);
    const Point& next = turned(pair.axes, axis, 1);
    const Point& last = turned(pair.axes, axis, 2);
    const Point adjoint = cross(next, last);
    const Point across = adjoint * (1.0 / sqrt(dot(adjoint, adjoint)));  // about 1
    up_ = select(are_same(dot(across, across_axis) < 0.0, is_far), -across, across);
    const Real height = turned(pair.half, axis);
    const Point middle = pair.center + across_axis * select(is_far, height, -height);
    top_ = dot(up_, middle);
    rise_ = dot(up_, pair.way);
    is_level_ = fabs(rise_) <= tolerance::rounding * pair.size;
    slabs_[0] = slab(cross(last, up_), next, middle, turned(pair.half, axis, 1));
    slabs_[1] = slab(cross(next, up_), last, middle, turned(pair.half, axis, 2));
    find_lowest();
  }

  const Point& up() const { return up_; }
  Mask is_level() const { return is_level_; }

  /// Whether the lowest point of the axis is over the face: an end, or any point if the axis is parallel to the face.
  Mask is_lowest_over() const { return is_lowest_over_; }

  [[gnu::always_inline]] Real lowest_gap() const { return gap(lowest_place_); }

  /// On the face. Its depth is negative if it is above the reach.
  [[gnu::always_inline]] CapsulePoint lowest_point() const {
    CapsulePoint point = point_at(lowest_place_, feature_of_face(axis_, is_far_),
                                  select(is_end_lowest_, all(second_vertex), all(first_vertex)));
    point.depth = radius_ - lowest_gap();
    return point;
  }

  /// Sets the ends of the part, in their order along the axis. Returns whether everything is decided by more than
  /// rounding.
  [[gnu::always_inline]] Mask put_points(CapsulePoint (&points)[2]) {
    if (!any_likely(is_level_)) cut();
    if (!any_likely(is_piece_clear_)) return is_piece_clear_;
    points[0] = end_point(low_, all(first_vertex));
    points[1] = end_point(high_, all(second_vertex));
    return is_piece_clear_;
  }

 private:
  // The general algorithm may find a normal with an error of the square root of rounding: of neighbouring points that
  // are equally near up to rounding, it takes any.
  static constexpr double least_clear = 1e-7;

  /// The coordinate of the axis between two opposite sides of the face; the sides extend along its normal.
  struct Slab {
    Real start;
    Real way;
    Real per_way;  ///< If the offset is zero, the axis crosses the sides at infinity.
    Real half;

    [[gnu::always_inline]] Real enters() const { return (-copysign(half, way) - start) * per_way; }
    [[gnu::always_inline]] Real leaves() const { return (copysign(half, way) - start) * per_way; }
    [[gnu::always_inline]] Real at(Real place) const { return start + way * place; }
    [[gnu::always_inline]] Real room(Real place) const { return half - fabs(at(place)); }
  };

  /// An end of the part over the face, and what it lies on.
  struct End {
    Real place;
    Mask is_vertex;
    Mask is_at_slab[2];  ///< The slab at whose side it is, if it is not at the height of the radius.
    Mask is_clear;
  };

  [[gnu::always_inline]] Slab slab(const Point& along, const Point& axis, const Point& middle, Real half) const {
    const Real scale = 1.0 / dot(along, axis);  // about 1 or -1
    const Real way = dot(along, way_) * scale;
    return {-(dot(along, middle) * scale), way, 1.0 / way, half};
  }

  [[gnu::always_inline]] Real gap(Real place) const { return rise_ * place - top_; }
  /// Where the axis crosses the height of the radius: at infinity or nowhere if its rise is zero.
  [[gnu::always_inline]] Real at_height() const { return (radius_ + top_) / rise_; }

  /// If the axis is parallel to the face, an end that is over the face; the start is preferred.
  [[gnu::always_inline]] void find_lowest() {
    if (any_likely(is_level_)) cut();
    is_end_lowest_ = rise_ < 0.0;
    lowest_place_ = select(is_end_lowest_, all(1.0), all(0.0));
    if (any_likely(!is_level_)) is_lowest_over_ = is_clear_at(lowest_place_);
    if (!any(is_level_)) return;
    take(is_level_, high_.is_vertex && !low_.is_vertex, is_end_lowest_);
    take(is_level_, select(is_end_lowest_, high_.place, low_.place), lowest_place_);
    take(is_level_, is_piece_clear_, is_lowest_over_);
  }

  [[gnu::always_inline]] Mask is_clear_at(Real place) const {
    return slabs_[0].room(place) > margin_ && slabs_[1].room(place) > margin_ && radius_ - gap(place) > margin_;
  }

  /// If a box is nearly flat, the features of clipped ends are different.
  [[gnu::always_inline]] void cut() {
    find_low();
    find_high();
    is_piece_clear_ = low_.is_clear && high_.is_clear && slabs_[0].half > thin_ && slabs_[1].half > thin_;
  }

  [[gnu::always_inline]] void find_low() {
    const Real a = slabs_[0].enters();
    const Real b = slabs_[1].enters();
    const Real c = select(rise_ < 0.0, at_height(), all(-1.0));
    const Real last = max_of(max_of(a, b), c);
    set_end(max_of(last, all(0.0)), !(last > 0.0), b, c, low_);
    // The second last, so that the last one clips.
    const Real before = max_of(max_of(min_of(a, b), min_of(max_of(a, b), c)), all(0.0));
    low_.is_clear = low_.is_clear && (low_.is_vertex || is_cut_clear(last - before, low_));
  }

  [[gnu::always_inline]] void find_high() {
    const Real a = slabs_[0].leaves();
    const Real b = slabs_[1].leaves();
    const Real c = select(rise_ > 0.0, at_height(), all(2.0));
    const Real first = min_of(min_of(a, b), c);
    set_end(min_of(first, all(1.0)), !(first < 1.0), b, c, high_);
    const Real next = min_of(min_of(max_of(a, b), max_of(min_of(a, b), c)), all(1.0));
    high_.is_clear = high_.is_clear && (high_.is_vertex || is_cut_clear(next - first, high_));
  }

  /// Certain if it is below all other clipping planes.
  [[gnu::always_inline]] void set_end(Real place, Mask is_vertex, Real second, Real third, End& end) const {
    end.place = place;
    end.is_vertex = is_vertex;
    const Mask is_at_height = place == third;
    end.is_at_slab[1] = !is_at_height && place == second;
    end.is_at_slab[0] = !is_at_height && !end.is_at_slab[1];
    end.is_clear = ((!is_vertex && end.is_at_slab[0]) || slabs_[0].room(place) > margin_) &&
                   ((!is_vertex && end.is_at_slab[1]) || slabs_[1].room(place) > margin_) &&
                   ((!is_vertex && is_at_height) || radius_ - gap(place) > margin_);
  }

  /// Whether a plane clips at least such a share, and the angle is not so small that rounding moves the intersection.
  [[gnu::always_inline]] Mask is_cut_clear(Real share, const End& end) const {
    const Real rate = fabs(select(end.is_at_slab[0], slabs_[0].way, select(end.is_at_slab[1], slabs_[1].way, rise_)));
    return share * rate > margin_ && rate > thin_;
  }

  [[gnu::always_inline]] CapsulePoint point_at(Real place, const FeatureName& of_box,
                                               const FeatureName& of_capsule) const {
    const Point on_axis = way_ * place;
    const Real its_gap = gap(place);
    return {origin_ + (on_axis - up_ * its_gap), origin_ + (on_axis - up_ * radius_),
            max_of(all(0.0), radius_ - its_gap), of_box, of_capsule};
  }

  [[gnu::always_inline]] CapsulePoint end_point(const End& end, const FeatureName& vertex) const {
    const Real coordinate = select(end.is_at_slab[1], slabs_[1].at(end.place), slabs_[0].at(end.place));
    const Mask is_at_side = !end.is_vertex && (end.is_at_slab[0] || end.is_at_slab[1]);
    const FeatureName of_side = feature_of_side(axis_, is_far_, end.is_at_slab[1], coordinate > 0.0);
    return point_at(end.place, select(is_at_side, of_side, feature_of_face(axis_, is_far_)),
                    select(end.is_vertex, vertex, all(first_edge)));
  }

  Point origin_;
  Point way_;
  Real radius_;
  Axis axis_;
  Mask is_far_;
  Real margin_;  ///< The error bound for a point over the face.
  Real thin_;
  Point up_;
  Real top_;   ///< The height of the face.
  Real rise_;  ///< How much higher the end of the axis is than its start.
  Slab slabs_[2];
  Mask is_level_;
  Mask is_end_lowest_;
  Mask is_lowest_over_;
  Real lowest_place_;
  End low_;
  End high_;
  Mask is_piece_clear_;
};
