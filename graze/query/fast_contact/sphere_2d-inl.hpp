// SPDX-License-Identifier: MIT
// Contacts of spheres and boxes in 2D, for one pair or many (one_pair.hpp): the same results as the general
// penetration_of_simple and the patches of manifold.hpp, for spheres whose center is clearly inside of the box or
// clearly outside of it, over a side or beyond a corner.

/// A sphere, and a box relative to the sphere's center.
class SphereOnBox2d {
 public:
  [[gnu::always_inline]] SphereOnBox2d(const SphereNumbers<Point2d>& sphere, const Core2d<2>& box)
      : sphere_(sphere),
        box_(box),
        way_(-box.center),
        size_(box.size() + sphere.radius),
        doubt_(tolerance::coarse * size_),
        margin_(tolerance::known_direction * size_) {}

  [[gnu::always_inline]] RoundContact<Point2d> run() const {
    const Real ahead_x = dot(way_, box_.normal[0]);
    const Real ahead_y = dot(way_, box_.normal[1]);
    const Real gap_x = fabs(ahead_x) - dot(box_.half_edge[0], box_.normal[0]);
    const Real gap_y = fabs(ahead_y) - dot(box_.half_edge[1], box_.normal[1]);
    const Mask is_y = gap_y > gap_x + tolerance::rounding * size_;  // the first of equally near sides
    const Real gap = select(is_y, gap_y, gap_x);
    RoundContact<Point2d> contact;
    contact.error = 2 * tolerance::rounding * size_;
    contact.is_apart = gap - sphere_.radius > doubt_;
    contact.meets = box_.shortest() > margin_ && size_ > 0x1p-400 && size_ < 0x1p400 && sphere_.radius - gap > doubt_;
    contact.is_single = all(true);
    contact.of_first = all(first_vertex);
    if (!any_likely(contact.meets)) return no_contact<Point2d>(contact.is_apart, contact.error);
    const Real side = side_of(select(is_y, ahead_y, ahead_x));
    const Point2d half_edge = select(is_y, box_.half_edge[1], box_.half_edge[0]);
    const Point2d along = select(is_y, box_.along[0], box_.along[1]);
    const Real half = select(is_y, box_.half_length[0], box_.half_length[1]);
    const Mask is_over = fabs(dot(way_ - half_edge * side, along)) < half - margin_;
    Place place{select(is_y, box_.normal[1], box_.normal[0]) * side, gap, side_feature_2d(is_y, side)};
    if (any(!is_over)) {
      contact.meets = contact.meets && (is_over || gap > margin_);
      find_corner(!is_over, place, contact);
    }
    contact.normal = -place.up;
    contact.depth = sphere_.radius - place.gap;
    contact.on_first = sphere_.center - place.up * sphere_.radius;
    contact.on_second = sphere_.center - place.up * place.gap;
    contact.of_second = place.of_box;
    return contact;
  }

 private:
  /// On the box's surface, `gap` below the center.
  struct Place {
    Point2d up;  ///< The unit vector from there to the center.
    Real gap;
    FeatureName of_box;
  };

  /// Sets those beyond both sides at a corner by more than the angle of flat contacts.
  [[gnu::always_inline]] void find_corner(Mask pairs, Place& place, RoundContact<Point2d>& contact) const {
    constexpr double least_cosine = 16 * tolerance::aligned;
    const Point2d sides{side_of(dot(way_, box_.half_edge[0])), side_of(dot(way_, box_.half_edge[1]))};
    const Point2d up = -box_.corner(sides);
    const Real distance = sqrt(dot(up, up));
    const Real least = least_cosine * distance;
    const Real depth = sphere_.radius - distance;
    const Mask is_beyond = dot(up, box_.along[0]) * sides[0] > least && dot(up, box_.along[1]) * sides[1] > least;
    take(pairs, contact.meets && is_beyond && depth < -doubt_, contact.is_apart);
    take(pairs, contact.meets && is_beyond && depth > doubt_, contact.meets);
    take(pairs, up * (1.0 / distance), place.up);
    take(pairs, distance, place.gap);
    take(pairs, corner_feature_2d(sides), place.of_box);
  }

  const SphereNumbers<Point2d>& sphere_;
  const Core2d<2>& box_;
  Point2d way_;
  Real size_;
  Real doubt_;
  Real margin_;
};
