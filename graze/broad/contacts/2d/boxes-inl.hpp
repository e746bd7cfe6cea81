// SPDX-License-Identifier: MIT
// Contacts of 2D capsules and boxes, one pair per lane: bit-identical to Contact2d of query/fast_contact/boxes_2d.hpp.
// Included once per instruction set, so it has no ordinary include guard.
#if defined(GRAZE_BROAD_CONTACTS_2D_BOXES_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BROAD_CONTACTS_2D_BOXES_INL_HPP
#undef GRAZE_BROAD_CONTACTS_2D_BOXES_INL_HPP
#else
#define GRAZE_BROAD_CONTACTS_2D_BOXES_INL_HPP
#endif

#include <cstddef>
#include <limits>

#include <hwy/highway.h>

#include <graze/broad/contacts/2d/fast_contact_2d-inl.hpp>
#include <graze/broad/contacts/manifold_lanes-inl.hpp>
#include <graze/math/tolerance.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {
#if HWY_TARGET != HWY_SCALAR  // which has no vectors of two groups of pairs

/// One point of a manifold, on the first core and on the second in their contact order; features as indices into
/// `touched_features`.
struct PointLanes2d {
  Point2d on_first;
  Point2d on_second;
  Doubles depth;
  Doubles of_first;
  Doubles of_second;
};

/// As FastContact2d.
struct FastContactLanes2d {
  Point2d normal;  ///< From the first to the second.
  Doubles error;
  PointLanes2d points[2];
  DoublesMask has_two;
  DoublesMask is_clear;
};

/// A core of either kind in each lane.
struct EitherCore {
  Core2d<2> core;
  DoublesMask is_box;

  HWY_INLINE Doubles corner_feature(const Point2d& sides) const {
    return corner_feature_2d({{sides.at[0], hn::IfThenElseZero(is_box, sides.at[1])}});
  }
  HWY_INLINE Doubles side_feature(DoublesMask across_second, Doubles at) const {
    return hn::IfThenElse(is_box, side_feature_2d(across_second, at), both(first_of_2d + 4));
  }
  /// The feature of the corner at one end of a side.
  HWY_INLINE Doubles corner_of_side(DoublesMask across_second, Doubles at, Doubles end) const {
    return corner_feature({{hn::IfThenElse(across_second, end, at), hn::IfThenElse(across_second, at, end)}});
  }
};

HWY_INLINE Doubles one_of_two(DoublesMask is_second, const Doubles (&of_axes)[2]) {
  return hn::IfThenElse(is_second, of_axes[1], of_axes[0]);
}
HWY_INLINE Point2d one_of_two(DoublesMask is_second, const Point2d (&of_axes)[2]) {
  return one_of(is_second, of_axes[1], of_axes[0]);
}

/// Two cores in their contact order, with one or two axes each, relative to `origin`.
template <std::size_t first_axes, std::size_t second_axes>
class ContactLanes2d {
 public:
  HWY_INLINE ContactLanes2d(const Point2d& origin, const Core2d<first_axes>& first, const Core2d<second_axes>& second)
      : origin_(origin),
        first_(first),
        second_(second),
        size_(hn::Add(first.size(), second.size())),
        reach_(hn::Add(first.radius, second.radius)),
        noise_(hn::Mul(both(tolerance::rounding), size_)),
        doubt_(hn::Mul(both(tolerance::coarse), size_)),
        margin_(hn::Mul(both(least_share), size_)),
        gap_(both(-std::numeric_limits<double>::infinity())),
        side_{no_lane(), both(1), {{both(0), both(0)}}},
        is_of_first_(no_lane()) {}

  HWY_INLINE void run(FastContactLanes2d& look) {
    find_side();
    const Doubles shortest = min_of(first_.shortest(), second_.shortest());
    const DoublesMask is_moderate = hn::And(hn::Gt(size_, both(0x1p-400)), hn::Lt(size_, both(0x1p400)));
    look.is_clear = hn::And(hn::And(hn::Gt(shortest, margin_), is_moderate), hn::Gt(hn::Sub(reach_, gap_), doubt_));
    look.error = hn::Mul(both(2), noise_);
    look.normal = side_.up * hn::IfThenElse(is_of_first_, both(1), both(-1));
    over_sides(side_, is_of_first_, no_lane(), look);
    const DoublesMask is_along[2] = {first_axes == 2 ? is_along_side(first_.normal[0]) : no_lane(),
                                     is_along_side(first_.normal[1])};
    const DoublesMask is_on_first = hn::And(hn::AndNot(is_of_first_, look.is_clear), hn::Or(is_along[0], is_along[1]));
    if (!hn::AllFalse(Tag<double>(), is_on_first)) put_on_first(is_on_first, hn::Not(is_along[0]), look);
  }

 private:
  static constexpr double least_share = tolerance::known_direction;
  static constexpr bool are_boxes = first_axes == 2 && second_axes == 2;

  /// A side of a core: the axis it is perpendicular to, whether it is at the half edge or, with -1, opposite, and its
  /// normal.
  struct Side {
    DoublesMask across_second;
    Doubles at;
    Point2d up;
  };

  /// The reference side and the incident side, as in Contact2d.
  struct Cut {
    DoublesMask across_second;
    Doubles at;
    Point2d middle;
    Point2d half_edge;
    Doubles half;  ///< Of the reference side.
    Doubles other_half;
    Doubles along[2];
    Doubles above[2];
    Doubles share[2];
    DoublesMask is_cut[2];
  };

  /// The core with the reference side and the other one.
  struct Cores {
    EitherCore own;
    EitherCore other;
    DoublesMask own_is_first;
  };

  HWY_INLINE Cores cores_by(DoublesMask own_is_first) const {
    Cores cores;
    choose(own_is_first, first_, second_, cores.own.core);
    choose(own_is_first, second_, first_, cores.other.core);
    cores.own_is_first = own_is_first;
    cores.own.is_box = is_box(own_is_first);
    cores.other.is_box = is_box(hn::Not(own_is_first));
    return cores;
  }

  HWY_INLINE static DoublesMask is_box(DoublesMask is_first) {
    if constexpr (are_boxes) return all(true);
    if constexpr (first_axes == 1 && second_axes == 1) return no_lane();
    return first_axes == 2 ? is_first : hn::Not(is_first);
  }

  template <std::size_t yes_axes, std::size_t no_axes>
  HWY_INLINE static void choose(DoublesMask mask, const Core2d<yes_axes>& yes, const Core2d<no_axes>& no,
                                Core2d<2>& to) {
    to.center = one_of(mask, yes.center, no.center);
    to.radius = hn::IfThenElse(mask, yes.radius, no.radius);
    for (std::size_t i = 0; i < 2; ++i) {
      to.half_edge[i] = one_of(mask, yes.half_edge[i], no.half_edge[i]);
      to.along[i] = one_of(mask, yes.along[i], no.along[i]);
      to.half_length[i] = hn::IfThenElse(mask, yes.half_length[i], no.half_length[i]);
      to.normal[i] = one_of(mask, yes.normal[i], no.normal[i]);
    }
  }

  // ---- The side with the least depth

  HWY_INLINE void find_side() {
    if constexpr (first_axes == 2) try_side(first_, second_, 0, true);
    try_side(first_, second_, 1, true);
    if constexpr (second_axes == 2) try_side(second_, first_, 0, false);
    try_side(second_, first_, 1, false);
  }

  template <class Own, class Other>
  HWY_INLINE void try_side(const Own& own, const Other& other, std::size_t axis, bool is_of_first) {
    const Point2d& normal = own.normal[axis];
    const Doubles ahead = dot(normal, other.center - own.center);
    const auto reach_of = [&normal](const Point2d& half_edge) HWY_ATTR { return hn::Abs(dot(normal, half_edge)); };
    const Doubles reach =
        sum(reach_of(own.half_edge[axis]), reach_of(other.half_edge[0]), reach_of(other.half_edge[1]));
    const Doubles gap = hn::Sub(hn::Abs(ahead), reach);
    const DoublesMask is_better = hn::Gt(gap, hn::Add(gap_, noise_));
    const Doubles at = side_of(ahead);
    gap_ = hn::IfThenElse(is_better, gap, gap_);
    const DoublesMask not_better = hn::Not(is_better);
    side_.across_second = axis == 1 ? hn::Or(side_.across_second, is_better) : hn::And(side_.across_second, not_better);
    side_.at = hn::IfThenElse(is_better, at, side_.at);
    side_.up = one_of(is_better, normal * at, side_.up);
    is_of_first_ = is_of_first ? hn::Or(is_of_first_, is_better) : hn::And(is_of_first_, not_better);
  }

  // ---- Clipping to the reference side

  /// Sets the points, and clears the `clear` mask where they are uncertain. `is_against`: the side faces against the
  /// contact's normal.
  HWY_INLINE void over_sides(const Side& own_side, DoublesMask own_is_first, DoublesMask is_against,
                             FastContactLanes2d& look) const {
    const Cores cores = cores_by(own_is_first);
    Cut cut = cut_at_ends(cores, own_side);
    const Point2d up = one_of(is_against, -side_.up, side_.up);
    DoublesMask is_over = all(true);
    if constexpr (!are_boxes) is_over = is_lowest_clear(cut);
    const DoublesMask is_on_side = on_side(cores, own_side, up, cut, look);
    look.has_two = is_over;
    look.is_clear = hn::And(look.is_clear, hn::Or(is_on_side, hn::Not(is_over)));
    if constexpr (!are_boxes) {
      if (!hn::AllTrue(Tag<double>(), is_over)) between_corners(cores, hn::Not(is_over), is_against, look);
    }
  }

  /// The lowest point is an end that is clearly over the side; if both are equally low, any remaining point.
  HWY_INLINE DoublesMask is_lowest_clear(const Cut& cut) const {
    const Doubles rise = hn::Sub(cut.above[1], cut.above[0]);
    const Doubles lowest = hn::IfThenElse(hn::Lt(rise, both(0)), cut.along[1], cut.along[0]);
    const Doubles left = hn::Mul(hn::Sub(cut.share[1], cut.share[0]), hn::Abs(hn::Sub(cut.along[1], cut.along[0])));
    return hn::Or(hn::Lt(hn::Abs(lowest), hn::Sub(cut.half, margin_)),
                  hn::And(hn::Le(hn::Abs(rise), noise_), hn::Gt(left, margin_)));
  }

  HWY_INLINE Cut cut_at_ends(const Cores& cores, const Side& own_side) const {
    const Core2d<2>& own = cores.own.core;
    const Core2d<2>& other = cores.other.core;
    Cut cut;
    const auto looks = [&](std::size_t axis) HWY_ATTR { return hn::Abs(dot(other.normal[axis], own_side.up)); };
    cut.across_second =
        hn::Or(hn::Not(cores.other.is_box), hn::Gt(looks(1), hn::Add(looks(0), both(tolerance::aligned))));
    const DoublesMask across_first = hn::Not(cut.across_second);
    const DoublesMask own_along = hn::Not(own_side.across_second);
    cut.at = hn::Neg(side_of(dot(one_of_two(cut.across_second, other.normal), own_side.up)));
    cut.middle = other.center + one_of_two(cut.across_second, other.half_edge) * cut.at;
    cut.half_edge = one_of_two(across_first, other.half_edge);
    cut.half = one_of_two(own_along, own.half_length);
    cut.other_half = one_of_two(across_first, other.half_length);
    const Point2d off = cut.middle - (own.center + one_of_two(own_side.across_second, own.half_edge) * own_side.at);
    const Point2d along = one_of_two(own_along, own.along);
    const Doubles middle = dot(off, along);
    const Doubles half_way = dot(cut.half_edge, along);
    const Doubles height = dot(off, own_side.up);
    const Doubles half_rise = dot(cut.half_edge, own_side.up);
    cut.along[0] = hn::Sub(middle, half_way);
    cut.along[1] = hn::Add(middle, half_way);
    cut.above[0] = hn::Sub(height, half_rise);
    cut.above[1] = hn::Add(height, half_rise);
    const Doubles per_way = hn::Div(both(0.5), half_way);
    for (std::size_t i = 0; i < 2; ++i) {
      cut.is_cut[i] = hn::Gt(hn::Abs(cut.along[i]), hn::Add(cut.half, doubt_));
      const Doubles share = hn::Mul(hn::Sub(hn::CopySign(cut.half, cut.along[i]), cut.along[0]), per_way);
      cut.share[i] = hn::IfThenElse(cut.is_cut[i], share, both(static_cast<double>(i)));
    }
    return cut;
  }

  /// Returns where part of the side remains.
  HWY_INLINE DoublesMask on_side(const Cores& cores, const Side& own_side, const Point2d& up, Cut& cut,
                                 FastContactLanes2d& look) const {
    const DoublesMask is_beside = hn::Not(hn::Lt(cut.share[0], cut.share[1]));
    const Doubles rise = hn::Sub(cut.above[1], cut.above[0]);
    const Doubles at_height = hn::Div(hn::Sub(reach_, cut.above[0]), rise);
    Doubles above[2];
    DoublesMask is_high[2];
    for (std::size_t i = 0; i < 2; ++i) {
      above[i] = hn::Add(cut.above[0], hn::Mul(rise, cut.share[i]));
      is_high[i] = hn::Gt(above[i], hn::Add(reach_, doubt_));
    }
    const DoublesMask is_all_high = hn::And(is_high[0], is_high[1]);
    if constexpr (are_boxes) {
      const Doubles resting = hn::Mul(both(2 * tolerance::aligned), min_of(cut.half, cut.other_half));
      const DoublesMask is_resting = hn::Le(max_of(above[0], above[1]), resting);
      for (DoublesMask& high : is_high) high = hn::AndNot(is_resting, high);
    }
    for (std::size_t i = 0; i < 2; ++i) {
      cut.share[i] = hn::IfThenElse(is_high[i], at_height, cut.share[i]);
      put_point(cores, own_side, up, cut, i, is_high[i], look.points[i]);
    }
    return hn::Not(hn::Or(is_beside, is_all_high));
  }

  HWY_INLINE void put_point(const Cores& cores, const Side& own_side, const Point2d& up, const Cut& cut, std::size_t i,
                            DoublesMask is_high, PointLanes2d& point) const {
    const Point2d on_core = cut.middle + cut.half_edge * hn::Sub(hn::Mul(both(2), cut.share[i]), both(1));
    const Point2d on_other = on_core - up * cores.other.core.radius;
    const Doubles gap = hn::Add(cut.above[0], hn::Mul(hn::Sub(cut.above[1], cut.above[0]), cut.share[i]));
    const Doubles depth = max_of(both(0), hn::Sub(reach_, gap));
    const DoublesMask is_at_corner = hn::AndNot(is_high, cut.is_cut[i]);
    const Doubles of_own =
        hn::IfThenElse(is_at_corner, cores.own.corner_of_side(own_side.across_second, own_side.at, cut.along[i]),
                       cores.own.side_feature(own_side.across_second, own_side.at));
    const Doubles of_other =
        hn::IfThenElse(hn::Or(is_high, cut.is_cut[i]), cores.other.side_feature(cut.across_second, cut.at),
                       cores.other.corner_of_side(cut.across_second, cut.at, both(i == 1 ? 1 : -1)));
    put_pair(cores, on_other + up * depth, on_other, depth, of_own, of_other, point);
  }

  // ---- A side of the first core that also faces the normal carries the points, even if the contact is on another

  HWY_INLINE DoublesMask is_along_side(const Point2d& normal) const {
    constexpr double most = tolerance::aligned * tolerance::aligned;
    const auto is_aligned = [&normal](const Point2d& up) HWY_ATTR {
      const Point2d turn = normal - up;
      return hn::Le(dot(turn, turn), both(most));
    };
    return hn::Or(is_aligned(side_.up), is_aligned(-side_.up));
  }

  HWY_NOINLINE void put_on_first(DoublesMask is_on_first, DoublesMask across_second, FastContactLanes2d& look) const {
    const Point2d normal = one_of_two(across_second, first_.normal);
    const Doubles at = hn::Neg(side_of(dot(normal, side_.up)));
    const Side side_of_first{hn::Or(hn::And(is_on_first, across_second), hn::AndNot(is_on_first, side_.across_second)),
                             hn::IfThenElse(is_on_first, at, side_.at), one_of(is_on_first, normal * at, side_.up)};
    over_sides(side_of_first, hn::Or(is_on_first, is_of_first_), is_on_first, look);
  }

  // ---- Corners

  /// Separate cores that are nearest at a corner of each. Only for some lanes, and certain only there.
  HWY_NOINLINE void between_corners(const Cores& cores, DoublesMask lanes, DoublesMask is_against,
                                    FastContactLanes2d& look) const {
    const Core2d<2>& own = cores.own.core;
    const Core2d<2>& other = cores.other.core;
    Point2d own_sides = own.sides_of(other.center);
    own_sides = own.sides_of(other.corner(other.sides_of(own.corner(own_sides))));
    const Point2d corner = own.corner(own_sides);
    const Point2d other_sides = other.sides_of(corner);
    const Point2d way = other.corner(other_sides) - corner;
    const Doubles distance = hn::Sqrt(dot(way, way));
    const Doubles depth = hn::Sub(reach_, distance);
    const Point2d normal = way * hn::Div(both(1), distance);
    const DoublesMask is_apart = hn::And(hn::Gt(gap_, margin_), hn::Gt(distance, margin_));
    const DoublesMask are_beyond =
        hn::And(is_beyond(cores.own, own_sides, way, distance), is_beyond(cores.other, other_sides, -way, distance));
    const DoublesMask is_clear = hn::And(hn::And(is_apart, are_beyond), hn::Gt(depth, doubt_));
    look.is_clear = hn::And(look.is_clear, hn::Or(is_clear, hn::Not(lanes)));
    // Manifold points keep the existing normal.
    look.normal = one_of(hn::AndNot(is_against, lanes), one_of(cores.own_is_first, normal, -normal), look.normal);
    PointLanes2d single;
    put_pair(cores, corner + normal * own.radius, (corner + way) - normal * other.radius, depth,
             cores.own.corner_feature(own_sides), cores.other.corner_feature(other_sides), single);
    PointLanes2d& point = look.points[0];
    point.on_first = one_of(lanes, single.on_first, point.on_first);
    point.on_second = one_of(lanes, single.on_second, point.on_second);
    point.depth = hn::IfThenElse(lanes, single.depth, point.depth);
    point.of_first = hn::IfThenElse(lanes, single.of_first, point.of_first);
    point.of_second = hn::IfThenElse(lanes, single.of_second, point.of_second);
  }

  HWY_INLINE static DoublesMask is_beyond(const EitherCore& core, const Point2d& sides, const Point2d& way,
                                          Doubles distance) {
    constexpr double least_cosine = 16 * tolerance::aligned;
    const Doubles least = hn::Mul(both(least_cosine), distance);
    const auto of_axis = [&](std::size_t axis) HWY_ATTR {
      return hn::Gt(hn::Mul(dot(way, core.core.along[axis]), sides.at[axis]), least);
    };
    return hn::And(of_axis(0), hn::Or(of_axis(1), hn::Not(core.is_box)));
  }

  HWY_INLINE void put_pair(const Cores& cores, const Point2d& on_own, const Point2d& on_other, Doubles depth,
                           Doubles of_own, Doubles of_other, PointLanes2d& point) const {
    const DoublesMask own_is_first = cores.own_is_first;
    point.on_first = origin_ + one_of(own_is_first, on_own, on_other);
    point.on_second = origin_ + one_of(own_is_first, on_other, on_own);
    point.depth = depth;
    point.of_first = hn::IfThenElse(own_is_first, of_own, of_other);
    point.of_second = hn::IfThenElse(own_is_first, of_other, of_own);
  }

  Point2d origin_;
  const Core2d<first_axes>& first_;
  const Core2d<second_axes>& second_;
  Doubles size_;
  Doubles reach_;
  Doubles noise_;
  Doubles doubt_;
  Doubles margin_;
  Doubles gap_;
  Side side_;
  DoublesMask is_of_first_;
};

#endif
}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
