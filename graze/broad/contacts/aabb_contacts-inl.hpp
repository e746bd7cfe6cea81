// SPDX-License-Identifier: MIT
// The manifolds of many pairs of AABBs, one pair per lane: bit-identical to penetration_of_simple and
// query/patch/aabb_manifold.hpp. Included once per instruction set, so it has no ordinary include guard.
#if defined(GRAZE_BROAD_CONTACTS_AABB_CONTACTS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BROAD_CONTACTS_AABB_CONTACTS_INL_HPP
#undef GRAZE_BROAD_CONTACTS_AABB_CONTACTS_INL_HPP
#else
#define GRAZE_BROAD_CONTACTS_AABB_CONTACTS_INL_HPP
#endif

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include <hwy/highway.h>

#include <graze/broad/contacts/fast_contact-inl.hpp>
#include <graze/broad/contacts/manifold_lanes-inl.hpp>
#include <graze/broad/contacts/manifold_points-inl.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/query/manifold.hpp>
#include <graze/query/patch/aabb_manifold.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {
#if HWY_TARGET != HWY_SCALAR  // which has no vectors of two groups of pairs

/// A corner of the common part of two faces, as bits: whose face it is (the axis by 32, plus 16 if it is the far one),
/// the corner by 4, plus 2 and 1 if it is at the face's own end along the next axis and along the last.
inline constexpr std::size_t shared_corners = 96;
inline const std::array<Feature, shared_corners>& features_of_shared() {
  static const auto features = [] {
    std::array<Feature, shared_corners> all{};
    for (std::uint32_t place = 0; place < shared_corners; ++place) {
      const BoxFaceNumbers face{static_cast<Dim>(place / 32), (place & 16U) != 0};
      all[place] = feature_of_shared(face, place / 4 % 4, (place & 2U) != 0, (place & 1U) != 0);
    }
    return all;
  }();
  return features;
}

/// A box's ends along each axis.
struct AabbLanes {
  Point min;
  Point max;

  template <class T>
  HWY_INLINE explicit AabbLanes(const T* const* rows) {
    Doubles numbers[6];
    load_wide(rows, numbers);
    min = {{numbers[0], numbers[1], numbers[2]}};
    max = {{numbers[3], numbers[4], numbers[5]}};
  }

  HWY_INLINE DoublesMask has_faces() const {
    return hn::And(hn::And(hn::Lt(min.at[0], max.at[0]), hn::Lt(min.at[1], max.at[1])), hn::Lt(min.at[2], max.at[2]));
  }
  HWY_INLINE Doubles size() const {
    const Point way = max - min;
    return sum(hn::Abs(way.at[0]), hn::Abs(way.at[1]), hn::Abs(way.at[2]));
  }
};

/// The axis of least depth of two boxes.
struct LeastDepth {
  Doubles depth;
  Doubles axis;
  DoublesMask is_far;  ///< The first box's far face, and the second one's near one.

  HWY_INLINE LeastDepth(const AabbLanes& a, const AabbLanes& b) : is_far(no_lane()) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Doubles ahead = hn::Sub(a.max.at[i], b.min.at[i]);
      const Doubles behind = hn::Sub(b.max.at[i], a.min.at[i]);
      const Doubles least = min_of(ahead, behind);
      const DoublesMask is_less = i == 0 ? hn::Le(least, least) : hn::Lt(least, depth);
      depth = i == 0 ? least : hn::IfThenElse(is_less, least, depth);
      axis = i == 0 ? both(0) : hn::IfThenElse(is_less, both(static_cast<double>(i)), axis);
      is_far = hn::Or(hn::And(is_less, hn::Le(ahead, behind)), hn::AndNot(is_less, is_far));
    }
  }

  /// One of three numbers, `turns` after the one along this axis.
  HWY_INLINE Doubles along(const Point& v, std::size_t turns) const {
    return hn::IfThenElse(hn::Eq(axis, both(0)), v.at[turns],
                          hn::IfThenElse(hn::Eq(axis, both(1)), v.at[(1 + turns) % 3], v.at[(2 + turns) % 3]));
  }

  /// The inverse: a point from the numbers along the axis, the next and the last one.
  HWY_INLINE Point placed(Doubles on_axis, Doubles on_next, Doubles on_last) const {
    const Point of{{on_axis, on_next, on_last}};
    const auto at = [&](std::size_t i) HWY_ATTR {
      return hn::IfThenElse(hn::Eq(axis, both(0)), of.at[i],
                            hn::IfThenElse(hn::Eq(axis, both(1)), of.at[(i + 2) % 3], of.at[(i + 1) % 3]));
    };
    return {{at(0), at(1), at(2)}};
  }
};

/// As SharedRange.
struct SharedLanes {
  Doubles end[2];
  Doubles is_reference[2];  ///< 1 or 0.

  HWY_INLINE SharedLanes(const AabbLanes& a, const AabbLanes& b, const LeastDepth& least, std::size_t turns,
                         Doubles slack) {
    const Doubles low = least.along(a.min, turns);
    const Doubles high = least.along(a.max, turns);
    const Doubles other_low = least.along(b.min, turns);
    const Doubles other_high = least.along(b.max, turns);
    set(0, hn::Lt(other_low, hn::Sub(low, slack)), low, other_low);
    set(1, hn::Gt(other_high, hn::Add(high, slack)), high, other_high);
  }

 private:
  HWY_INLINE void set(std::size_t side, DoublesMask mask, Doubles of_reference, Doubles of_incident) {
    end[side] = hn::IfThenElse(mask, of_reference, of_incident);
    is_reference[side] = hn::IfThenElseZero(mask, both(1));
  }
};

/// The manifolds of a group of pairs in their contact order, written one by one.
template <class T>
class AabbContacts {
 public:
  HWY_INLINE AabbContacts(const AabbLanes& a, const AabbLanes& b, std::uint32_t turned) : turned_(turned) {
    const LeastDepth least(a, b);
    const DoublesMask is_finite = hn::Lt(least.depth, both(std::numeric_limits<double>::infinity()));
    clear_ = bits_of<double>(hn::And(hn::And(a.has_faces(), b.has_faces()), is_finite));
    const DoublesMask turns = mask_of(Tag<double>(), turned);
    const Doubles slack = hn::Mul(both(tolerance::coarse), hn::Add(a.size(), b.size()));
    const SharedLanes x(a, b, least, 1, slack);
    const SharedLanes y(a, b, least, 2, slack);
    const Doubles of_a = hn::IfThenElse(least.is_far, least.along(a.max, 0), least.along(a.min, 0));
    const Doubles of_b = hn::IfThenElse(least.is_far, least.along(b.min, 0), least.along(b.max, 0));
    const Doubles face = hn::Mul(least.axis, both(32));
    const Doubles far_of_a = hn::IfThenElseZero(least.is_far, both(16));
    for (std::size_t corner = 0; corner < 4; ++corner) {
      const std::size_t right = (corner ^ corner >> 1U) & 1U;
      const std::size_t up = corner >> 1U;
      const Point on_a = least.placed(of_a, x.end[right], y.end[up]);
      const Point on_b = least.placed(of_b, x.end[right], y.end[up]);
      // halves first, as in manifolds of other shapes than obbs
      const Point middle = on_a * both(0.5) + on_b * both(0.5);
      points_[corner].set(on_a, on_b, middle, least.depth, turns);
      const Doubles by_reference = hn::Add(hn::Add(x.is_reference[right], x.is_reference[right]), y.is_reference[up]);
      const Doubles place = hn::Add(face, both(static_cast<double>(4 * corner)));
      store(hn::Add(hn::Add(place, far_of_a), by_reference), features_[0][corner]);
      store(hn::Add(hn::Sub(hn::Add(place, both(16)), far_of_a), hn::Sub(both(3), by_reference)), features_[1][corner]);
    }
    const Doubles side = hn::IfThenElse(least.is_far, both(1), both(-1));
    rows_.set(least.placed(side, both(0), both(0)), hn::Mul(both(tolerance::epsilon), least.depth), turns);
  }

  bool is_clear(std::size_t lane) const { return (clear_ >> lane & 1U) != 0; }

  void write(std::size_t lane, Manifold<3, T>& to) const {
    const std::size_t first = turned_ >> lane & 1U;
    for (std::size_t corner = 0; corner < 4; ++corner) {
      points_[corner].write(lane, to.points[corner]);
      write_feature(feature(first, corner, lane), to.points[corner].id.a);
      write_feature(feature(1 - first, corner, lane), to.points[corner].id.b);
    }
    rows_.write(lane, 4, to);
  }

 private:
  const Feature& feature(std::size_t of_second, std::size_t corner, std::size_t lane) const {
    return (*all_features_)[static_cast<std::size_t>(features_[of_second][corner].of[lane])];
  }

  const std::array<Feature, shared_corners>* all_features_ = &features_of_shared();
  std::uint32_t clear_;
  std::uint32_t turned_;
  ManifoldRows<T> rows_;
  PointRows<T> points_[4];
  Row<double> features_[2][4];
};

#endif
}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
