// SPDX-License-Identifier: MIT
// Contacts of capsules and 3D boxes, for one pair or many (one_pair.hpp): the same results as the general
// penetration_of_simple and the patches of manifold.hpp, for capsules whose axis is clearly outside or clearly inside
// of the box, and nearest to its surface over a face or at a single point of an edge or a corner.

struct CapsuleContact {
  Mask is_apart;   ///< Certainly; then only the error is valid besides.
  Mask meets;      ///< Certainly, as described below. If neither, nothing is valid.
  Mask is_over;    ///< Whether the contact is on a face.
  Mask is_single;  ///< If it is not on a face: whether the manifold is only the point below.
  Point normal;    ///< From the box to the capsule.
  Real error;
  CapsulePoint point;  ///< Only if it is not on a face.
  AxisOverFace over;   ///< Only if it is on a face.
};

/// With many pairs, a group takes every path that any of its pairs needs, and each pair keeps its own result.
class CapsuleOnBox {
 public:
  [[gnu::always_inline]] CapsuleOnBox(const CapsuleAndBox& pair, CapsuleContact& contact)
      : pair_(pair), contact_(contact) {
    for (Dim i = 0; i < 3; ++i) {
      way_.start[i] = -dot(pair.center, pair.axes[i]);
      way_.way[i] = dot(pair.way, pair.axes[i]);
    }
    way_.half = pair.half;
    // Error bound of points due to the axes: twice the tolerance of the filter for spheres, and far above rounding.
    constexpr double least_orthonormality_error = 1e-10;
    doubt_ =
        2 * tolerance::box_filter * (orthonormality_error_of_axes(pair.axes) + least_orthonormality_error) * pair.size;
  }

  [[gnu::always_inline]] void run() {
    contact_.error = 2 * tolerance::rounding * pair_.size;
    contact_.is_over = contact_.is_single = contact_.meets = all(false);
    const Real t = way_.nearest();
    const Point place = way_.at(t);
    const PlaceByFaces by_faces(place, pair_.half, doubt_);
    const Real reach = pair_.radius + doubt_;
    const Mask is_apart = by_faces.squared > reach * reach;
    contact_.is_apart = is_apart;
    const Mask is_open = !is_apart && min_of(min_of(pair_.half[0], pair_.half[1]), pair_.half[2]) > doubt_;
    if (!any_likely(is_open)) return;
    const Mask is_in = by_faces.squared <= doubt_ * doubt_;
    const MinimumTranslation out(way_, doubt_, tolerance::rounding * pair_.size, is_in);
    const Mask is_at_end = t <= 0.0 || t >= 1.0;
    const Mask is_beside = !is_in && !by_faces.is_one && by_faces.is_clear;
    const Mask is_past_edge = is_beside && !is_at_end && by_faces.is_two;
    const Mask crosses = select(is_in, out.is_known && !out.is_face, is_past_edge);
    const Mask is_over = select(is_in, out.is_known && out.is_face, by_faces.is_one);
    const Mask passes = is_beside && !is_past_edge;
    const Seen seen{t, place, by_faces, is_in, out};
    if (any(passes)) pass_by(passes, seen);
    if (any(crosses)) cross_edge(crosses, seen);
    if (any(is_over)) lie_on_face(is_over, seen);
    contact_.meets = contact_.meets && is_open;
  }

 private:
  /// The position of the axis relative to the box: nearest at t, where it is at this point.
  struct Seen {
    Real t;
    const Point& place;
    const PlaceByFaces& by_faces;
    Mask is_in;
    const MinimumTranslation& out;
  };

  /// The middle of the edge between the sides that a point is beyond, or a corner.
  struct BoxFeature {
    Point middle;
    FeatureName name;
    Point edge;
    Real half;

    [[gnu::always_inline]] BoxFeature(const CapsuleAndBox& pair, const Point& place, const Mask (&is_beyond)[3])
        : middle(pair.center), name(feature_of_box(place, is_beyond)) {
      for (Dim i = 0; i < 3; ++i) {
        middle = middle + pair.axes[i] * or_zero(is_beyond[i], copysign(pair.half[i], place[i]));
      }
      const Axis not_x = select(is_beyond[1], axis_number(2), axis_number(1));
      const Axis along = select(is_beyond[0], not_x, axis_number(0));
      edge = turned(pair.axes, along);
      half = turned(pair.half, along);
    }
  };

  /// Whether the normal deviates from a face's normal by more than the angle within which a capsule lies flat on the
  /// face.
  [[gnu::always_inline]] static Mask is_steep(const PlaceByFaces& by_faces) {
    constexpr double least_cosine = 16 * tolerance::aligned;
    return by_faces.least_beyond > least_cosine * sqrt(by_faces.squared);
  }

  /// Whether a point of the axis is clearly between its ends.
  [[gnu::always_inline]] Mask is_between_ends(Real t) const {
    const Real length = max_abs(pair_.way);
    const Real along = t * length;
    return along > doubt_ && length - along > doubt_;
  }

  /// An end next to an edge or a corner, or the axis next to a corner. The point at an end is the nearest one if the
  /// axis leads from it away from the nearest point of the box: both are convex.
  [[gnu::always_inline]] void pass_by(Mask pairs, const Seen& seen) {
    const auto& [t, place, by_faces, is_in, out] = seen;
    const Point& way = pair_.way;
    const BoxFeature feature(pair_, place, by_faces.is_beyond);
    const Mask is_start = t <= 0.0;
    const Mask is_at_end = is_start || t >= 1.0;
    const Real end = select(is_start, all(0.0), all(1.0));
    const Real beside_corner = dot(way, feature.middle) / dot(way, way);
    const Point on_axis = way * select(is_at_end, end, beside_corner);
    const Real on_edge = dot(feature.edge, on_axis - feature.middle) / dot(feature.edge, feature.edge);
    const Point on_box = select(by_faces.is_two, feature.middle + feature.edge * on_edge, feature.middle);
    const Point between = on_axis - on_box;
    const Real distance = sqrt(dot(between, between));
    const Point normal = between * (1.0 / distance);

    const Real climb = dot(way, normal);
    const Real away = select(is_start, climb, -climb);
    const Mask is_end_known =
        away >= -tolerance::rounding * sum_abs(way) && (!by_faces.is_two || fabs(on_edge) < feature.half);
    const Mask is_corner_known = beside_corner > 0.0 && beside_corner < 1.0 && is_between_ends(t);
    const Mask is_place_known =
        select(is_at_end, is_end_known, is_corner_known) && distance > tolerance::known_direction * pair_.size;
    const FeatureName of_end = select(is_start, all(first_vertex), all(second_vertex));
    const Real depth = pair_.radius - distance;
    const Real doubt = tolerance::coarse * pair_.size;
    contact_.is_apart = is_place_known && depth < -doubt;
    contact_.meets = pairs && is_place_known && depth > doubt;
    contact_.normal = normal;
    contact_.point = {pair_.origin + on_box, pair_.origin + (on_axis - normal * pair_.radius), depth, feature.name,
                      select(is_at_end, of_end, all(first_edge))};
    contact_.is_single = is_steep(by_faces);
  }

  /// The axis is nearest to an edge between its ends, or has its least depth there. The nearest points of two lines, as
  /// in segment_filter.hpp. The normal is perpendicular to both and points outwards at the edge; the axis need not be
  /// on that side.
  [[gnu::always_inline]] void cross_edge(Mask pairs, const Seen& seen) {
    const auto& [t, outer_place, by_faces, is_in, out] = seen;
    constexpr double least_sine_squared = 1.0 / 64;
    const Point place = select(is_in, out.outward, outer_place);
    Mask is_beyond[3];
    for (Dim i = 0; i < 3; ++i) is_beyond[i] = select(is_in, !is_axis(out.edge, i), by_faces.is_beyond[i]);
    const BoxFeature feature(pair_, place, is_beyond);
    const Point& way = pair_.way;
    const Real uu = dot(way, way);
    const Real vv = dot(feature.edge, feature.edge);
    const Real uv = dot(way, feature.edge);
    const Real uw = dot(way, feature.middle);
    const Real vw = dot(feature.edge, feature.middle);
    const Real det = uu * vv - uv * uv;
    const Real per_det = 1.0 / det;
    const Real on_axis = (uw * vv - vw * uv) * per_det;
    const Real on_edge = (uw * uv - vw * uu) * per_det;
    const Point across = cross(way, feature.edge);
    const Real length = sqrt(dot(across, across));
    const Point normal = across * (copysign(all(1.0), dot(across, feature.middle - pair_.center)) / length);
    const Real depth = pair_.radius - -dot(normal, feature.middle);
    const Mask is_place_known = det > least_sine_squared * (uu * vv) && is_between_ends(on_axis) &&
                                feature.half - fabs(on_edge) > doubt_ && (is_in || is_between_ends(t));
    put(pairs, normal, depth, is_place_known);
    take_point(pairs,
               {pair_.origin + (feature.middle + feature.edge * on_edge),
                pair_.origin + (way * on_axis - normal * pair_.radius), depth, feature.name, all(first_edge)},
               contact_.point);
    take(pairs, select(is_in, out.is_oblique, is_steep(by_faces)), contact_.is_single);
  }

  /// On a face: the least distance or depth is across it. The lowest point is the nearest or deepest one if it is over
  /// the face.
  [[gnu::always_inline]] void lie_on_face(Mask pairs, const Seen& seen) {
    const auto& [t, place, by_faces, is_in, out] = seen;
    const Axis axis = select(is_in, out.face, by_faces.last);
    const Mask is_far = select(is_in, out.is_far, turned(place, by_faces.last) > 0.0);
    AxisOverFace& over = contact_.over;
    over.set(pair_, axis, is_far);
    const Mask is_level_enough = over.is_level() || !(is_in && out.is_level);
    put(pairs, over.up(), pair_.radius - over.lowest_gap(), over.is_lowest_over() && is_level_enough);
    contact_.is_over = pairs;
  }

  /// Sets the normal for these pairs, and the verdict if the contact point is known.
  [[gnu::always_inline]] void put(Mask pairs, const Point& normal, Real depth, Mask is_place_known) {
    const Real doubt = tolerance::coarse * pair_.size;
    take(pairs, is_place_known && depth < -doubt, contact_.is_apart);
    take(pairs, is_place_known && depth > doubt, contact_.meets);
    take(pairs, normal, contact_.normal);
  }

  const CapsuleAndBox& pair_;
  CapsuleContact& contact_;
  WayPastBox way_;
  Real doubt_;
};
