// SPDX-License-Identifier: MIT
// Contacts of spheres and 3D boxes, in the box's own coordinates, for one pair or many (one_pair.hpp): the same results
// as the general penetration_of_simple and the patches of manifold.hpp, for spheres whose center is clearly inside or
// clearly outside of the box, and not nearly above the boundary between two of its features.

/// A box; its axes are the coordinate axes if it is `along` them.
template <bool along>
struct BoxNumbers {
  Point center;
  Point half;
  Point axes[3];  ///< Not set if the box is along the coordinate axes.

  /// A coordinate along an axis.
  [[gnu::always_inline]] Real along_axis(const Point& v, Dim i) const {
    if constexpr (along) return v[i];
    return dot(v, axes[i]);
  }
};

/// A sphere, and a box relative to the sphere's center.
template <bool along>
class SphereOnBox {
 public:
  [[gnu::always_inline]] SphereOnBox(const SphereNumbers<Point>& sphere, const BoxNumbers<along>& box)
      : sphere_(sphere),
        box_(box),
        size_(sum_abs(box.center) + sum_abs(box.half)),
        whole_(size_ + sphere.radius),
        doubt_(tolerance::coarse * whole_),
        margin_(tolerance::known_direction * size_),
        place_(zero<Point>()),
        off_(-box.center) {}

  [[gnu::always_inline]] RoundContact<Point> run() {
    Real moved = descend(all(true));
    // The error of the point in the first round due to the axes, as in filter_of_sphere.
    const Real first_undecided = tolerance::box_filter * tolerance::orthonormal * whole_;
    const Real reach = sphere_.radius + (along ? doubt_ : first_undecided);
    const Mask is_far = dot(off_, off_) > reach * reach;
    const Real error = 2 * tolerance::rounding * whole_;
    if (!any_likely(!is_far)) return no_contact<Point>(is_far, error);
    if constexpr (!along) descend_to_noise(moved);
    const Real squared = dot(off_, off_);
    RoundContact<Point> contact;
    contact.error = error;
    contact.is_apart = all(false);
    contact.is_single = all(true);
    contact.of_first = all(first_vertex);
    const Mask is_outside = squared > margin_ * margin_;
    if (any_likely(is_outside)) touch_outside(sqrt(squared), contact);
    if (any(!is_outside)) touch_inside(!is_outside, contact);
    contact.meets = contact.meets && !is_far;
    return contact;
  }

  /// The sum of the coordinates.
  Real size() const { return whole_; }

 private:
  // place_in without divisions: a round reduces the error as much if the axes are not of length 1. Measuring how far
  // they are from that, mostly by rounding, saves one of two rounds, but not always: it takes longer.
  static constexpr int rounds = 5;
  static constexpr double shrinks_to = 4 * tolerance::orthonormal;

  /// One iteration, for these pairs; returns how far the point has moved.
  [[gnu::always_inline]] Real descend(Mask pairs) {
    Point step;
    for (Dim i = 0; i < 3; ++i) {
      const Real wanted = place_[i] + box_.along_axis(off_, i);
      step[i] = min_of(max_of(wanted, -box_.half[i]), box_.half[i]) - place_[i];
    }
    take(pairs, place_ + step, place_);
    if constexpr (along) {
      off_ = off_ - step;
    } else {
      take(pairs, off_ - box_.axes[0] * step[0] - box_.axes[1] * step[1] - box_.axes[2] * step[2], off_);
    }
    return sum_abs(step);
  }

  [[gnu::always_inline]] void descend_to_noise(Real moved) {
    const Real noise = tolerance::epsilon * sum_abs(box_.center);
    Mask pairs = moved * shrinks_to > noise;
    for (int round = 1; round < rounds && any(pairs); ++round) {
      moved = descend(pairs);
      pairs = pairs && moved * shrinks_to > noise;
    }
  }

  /// The center is clearly outside of the box: this far, if at all, along one, two or three axes, or between the faces
  /// across one by more than rounding.
  [[gnu::always_inline]] void touch_outside(Real distance, RoundContact<Point>& contact) const {
    constexpr double least_cosine = 16 * tolerance::aligned;  // otherwise the sphere would lie flat on a face or edge
    contact.depth = sphere_.radius - distance;
    contact.is_apart = contact.depth < -doubt_;
    contact.meets = contact.depth > doubt_;
    Mask is_beyond[3];
    for (Dim i = 0; i < 3; ++i) {
      const Real room = box_.half[i] - fabs(place_[i]);
      is_beyond[i] = room <= 0.0;
      const Mask is_steep = fabs(box_.along_axis(off_, i)) > least_cosine * distance;
      const Mask is_out = both_of(both_of(is_beyond[i], box_.half[i] > margin_), is_steep);
      contact.meets = both_of(contact.meets, either_of(room > margin_, is_out));
    }
    contact.of_second = feature_of_box(place_, is_beyond);
    contact.normal = off_ * (-1.0 / distance);
    contact.on_first = sphere_.center + contact.normal * sphere_.radius;
    contact.on_second = sphere_.center - off_;
  }

  /// Sets those whose center is inside of the box. Of faces that are equally near up to the skew of the box, the
  /// general algorithm selects one.
  [[gnu::always_inline]] void touch_inside(Mask pairs, RoundContact<Point>& contact) const {
    const Point room = box_.half - abs(place_);
    const Mask is_y = room[1] < room[0];
    const Axis axis_of_two = select(is_y, axis_number(1), axis_number(0));
    const Axis axis = select(room[2] < select(is_y, room[1], room[0]), axis_number(2), axis_of_two);
    const Real least = turned(room, axis);
    const Real second = min_of(turned(room, axis, 1), turned(room, axis, 2));
    const Real place = turned(place_, axis);
    const Real doubt = 8 * tolerance::orthonormal * size_;
    take(pairs, least > margin_ && second - least > doubt && fabs(place) > margin_, contact.meets);
    const Point across = across_face(axis);
    const Real ahead = dot(across, box_.center);
    const Real gap = fabs(ahead) - reach_along(across, axis);
    const Point normal = select(ahead < 0.0, -across, across);
    take(pairs, normal, contact.normal);
    take(pairs, sphere_.radius - gap, contact.depth);
    take(pairs, sphere_.center + normal * sphere_.radius, contact.on_first);
    take(pairs, sphere_.center + normal * gap, contact.on_second);
    take(pairs, feature_of_face(axis, place > 0.0), contact.of_second);
  }

  [[gnu::always_inline]] Point across_face(Axis axis) const {
    if constexpr (along) return unit_point(axis);
    const Point adjoint = across_others(box_.axes, axis);
    return adjoint / sqrt(dot(adjoint, adjoint));  // about 1
  }

  [[gnu::always_inline]] Real reach_along(const Point& across, Axis axis) const {
    if constexpr (along) return turned(box_.half, axis);
    return fabs(dot(across, box_.axes[0] * box_.half[0])) + fabs(dot(across, box_.axes[1] * box_.half[1])) +
           fabs(dot(across, box_.axes[2] * box_.half[2]));
  }

  const SphereNumbers<Point>& sphere_;
  const BoxNumbers<along>& box_;
  Real size_;
  Real whole_;
  Real doubt_;
  Real margin_;
  Point place_;
  Point off_;
};
