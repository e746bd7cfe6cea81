// SPDX-License-Identifier: MIT
// How spheres touch boxes in the plane, a lane for each pair: SphereContact2d of query/fast_contact/sphere_2d.hpp, to
// the bit. Included once for each instruction set, hence no ordinary guard.
#if defined(GRAZE_BROAD_CONTACTS_2D_SPHERE_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BROAD_CONTACTS_2D_SPHERE_INL_HPP
#undef GRAZE_BROAD_CONTACTS_2D_SPHERE_INL_HPP
#else
#define GRAZE_BROAD_CONTACTS_2D_SPHERE_INL_HPP
#endif

#include <hwy/highway.h>

#include <graze/broad/contacts/2d/cores-inl.hpp>
#include <graze/broad/contacts/fast_contact-inl.hpp>
#include <graze/broad/contacts/manifold_lanes-inl.hpp>
#include <graze/math/tolerance.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {
#if HWY_TARGET != HWY_SCALAR  // which has no vectors of two groups of pairs

/// A box is seen from the sphere's center.
class SphereLanes2d {
 public:
  HWY_INLINE SphereLanes2d(const SphereNumbers<Point2d>& sphere, const CoreLanes2d<2>& box)
      : sphere_(sphere),
        box_(box),
        way_(-box.center),
        size_(hn::Add(box.size(), sphere.radius)),
        doubt_(hn::Mul(both(tolerance::coarse), size_)),
        margin_(hn::Mul(both(tolerance::known_direction), size_)) {}

  HWY_INLINE RoundContact<Point2d> run() const {
    const Doubles ahead[2] = {dot(way_, box_.normal[0]), dot(way_, box_.normal[1])};
    const Doubles gaps[2] = {gap_of(0, ahead[0]), gap_of(1, ahead[1])};
    const DoublesMask is_y = hn::Gt(gaps[1], hn::Add(gaps[0], hn::Mul(both(tolerance::rounding), size_)));
    const Doubles gap = hn::IfThenElse(is_y, gaps[1], gaps[0]);
    const Doubles side = side_of(hn::IfThenElse(is_y, ahead[1], ahead[0]));
    const Point2d half_edge = one_of(is_y, box_.half_edge[1], box_.half_edge[0]);
    const Point2d along = one_of(is_y, box_.along[0], box_.along[1]);
    const Doubles half = hn::IfThenElse(is_y, box_.half_length[0], box_.half_length[1]);
    const Doubles place = dot(way_ - half_edge * side, along);
    const DoublesMask is_over = hn::Lt(hn::Abs(place), hn::Sub(half, margin_));
    const Corner corner(*this);
    RoundContact<Point2d> touch =
        touch_at(one_of(is_over, one_of(is_y, box_.normal[1], box_.normal[0]) * side, corner.up),
                 hn::IfThenElse(is_over, gap, corner.distance));
    touch.of_second = hn::IfThenElse(is_over, side_feature_2d(is_y, side), corner.feature);
    touch.meets = hn::And(is_plain(gap), hn::Or(is_over, hn::And(hn::Gt(gap, margin_), corner.is_known)));
    return touch;
  }

 private:
  HWY_INLINE Doubles gap_of(std::size_t axis, Doubles ahead) const {
    return hn::Sub(hn::Abs(ahead), dot(box_.half_edge[axis], box_.normal[axis]));
  }

  HWY_INLINE DoublesMask is_plain(Doubles gap) const {
    const DoublesMask is_moderate = hn::And(hn::Gt(size_, both(0x1p-400)), hn::Lt(size_, both(0x1p400)));
    return hn::And(hn::And(hn::Gt(box_.shortest(), margin_), is_moderate),
                   hn::Gt(hn::Sub(sphere_.radius, gap), doubt_));
  }

  /// The one on the center's side of both axes.
  struct Corner {
    Point2d up;  ///< From there to the center, of length 1.
    Doubles distance;
    Doubles feature;
    DoublesMask is_known;

    HWY_INLINE explicit Corner(const SphereLanes2d& of) {
      constexpr double least_cosine = 16 * tolerance::aligned;
      const Point2d sides{{side_of(dot(of.way_, of.box_.half_edge[0])), side_of(dot(of.way_, of.box_.half_edge[1]))}};
      const Point2d whole_up = -of.box_.corner(sides);
      distance = hn::Sqrt(dot(whole_up, whole_up));
      const Doubles least = hn::Mul(both(least_cosine), distance);
      const auto is_beyond = [&](std::size_t axis) HWY_ATTR {
        return hn::Gt(hn::Mul(dot(whole_up, of.box_.along[axis]), sides.at[axis]), least);
      };
      is_known = hn::And(hn::And(is_beyond(0), is_beyond(1)), hn::Gt(hn::Sub(of.sphere_.radius, distance), of.doubt_));
      up = whole_up * hn::Div(both(1), distance);
      feature = corner_feature_2d(sides);
    }
  };

  /// From the box' surface, `gap` below the center, up to that.
  HWY_INLINE RoundContact<Point2d> touch_at(const Point2d& up, Doubles gap) const {
    RoundContact<Point2d> touch;
    touch.normal = -up;
    touch.depth = hn::Sub(sphere_.radius, gap);
    touch.on_first = sphere_.center - up * sphere_.radius;
    touch.on_second = sphere_.center - up * gap;
    touch.error = hn::Mul(both(2 * tolerance::rounding), size_);
    touch.of_first = both(0);
    touch.is_single = all(true);
    return touch;
  }

  const SphereNumbers<Point2d>& sphere_;
  const CoreLanes2d<2>& box_;
  Point2d way_;
  Doubles size_;
  Doubles doubt_;
  Doubles margin_;
};

#endif
}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
