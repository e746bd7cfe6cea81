// SPDX-License-Identifier: MIT
// The manifolds of many pairs of oriented boxes across an edge of each: crossing_of_edges of
// query/fast_contact/obb/contact.hpp. Included once per instruction set, so it has no ordinary include guard.
#if defined(GRAZE_BROAD_CONTACTS_OBB_EDGES_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BROAD_CONTACTS_OBB_EDGES_INL_HPP
#undef GRAZE_BROAD_CONTACTS_OBB_EDGES_INL_HPP
#else
#define GRAZE_BROAD_CONTACTS_OBB_EDGES_INL_HPP
#endif

#include <cstddef>
#include <cstdint>

#include <hwy/highway.h>

#include <graze/broad/contacts/manifold_lanes-inl.hpp>
#include <graze/broad/contacts/manifold_points-inl.hpp>
#include <graze/broad/contacts/obb/faces-inl.hpp>
#include <graze/query/fast_contact/obb/contact.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {
#if HWY_TARGET != HWY_SCALAR  // which has no vectors of two groups of pairs

/// Pairs in their contact order, whose axis is across an edge of each and not parallel to a face normal.
template <class T>
struct EdgePairs {
  const T* const* first;
  const T* const* second;
  Doubles edge_a;  ///< The axes parallel to the edges.
  Doubles edge_b;
  DoublesMask turned;  ///< The first is the user's second.

  HWY_INLINE explicit EdgePairs(const PairGroup<T>& group) : first(group.first), second(group.second) {
    const AxisTestLanes looks(group.looks);
    const Doubles row = looks.row();
    edge_a = hn::Sub(row, both(2));
    edge_b = hn::Sub(looks.axis(), hn::Mul(row, both(3)));
    turned = looks.turned();
  }
};

template <class T>
class EdgeContacts {
 public:
  HWY_INLINE explicit EdgeContacts(const EdgePairs<T>& pairs) {
    BoxPair boxes{{load_boxes(pairs.first), load_boxes(pairs.second)}};
    const Point origin = see_from_first(boxes);
    const Doubles size = hn::Add(size_of(boxes.box[0]), size_of(boxes.box[1]));
    const Doubles axis_a = pairs.edge_a;
    const Doubles axis_b = pairs.edge_b;
    const DoublesMask turned = pairs.turned;
    turned_ = turned;
    const BoxLanes a = turned_to(boxes.box[0], axis_a);
    const BoxLanes b = turned_to(boxes.box[1], axis_b);
    const EdgesLanes edges(a, 0, b, 0);
    const AxisLanes found = edges.axis();
    const Doubles side = sign_of(edges.ahead);
    rows_.set(found, size, turned);
    const Farthest on_a(a, axis_a, edges.heights[0], side);
    const Farthest on_b(b, axis_b, edges.heights[1], hn::Neg(side));
    const Point between = on_b.middle - on_a.middle;
    const Doubles inverse = hn::Div(both(1), edges.squared);
    const Doubles along_a = hn::Mul(dot(cross(between, b.axes[0]), edges.across), inverse);
    const Doubles along_b = hn::Mul(dot(cross(between, a.axes[0]), edges.across), inverse);
    is_open_ = hn::Not(hn::And(hn::And(lies_on(along_a, a.half[0]), lies_on(along_b, b.half[0])),
                               hn::And(are_long(a, b, size), hn::Gt(edges.squared, both(least_squared_sine)))));
    store(on_a.number, numbers_[0]);
    store(on_b.number, numbers_[1]);
    point_.set((on_a.middle + a.axes[0] * along_a) + origin, (on_b.middle + b.axes[0] * along_b) + origin,
               max_of(both(0), hn::Neg(found.gap)), turned);
  }

  /// One bit for each uncertain pair.
  std::uint32_t open() const { return bits_of<double>(is_open_); }
  /// One bit for each pair whose first box is the user's second.
  std::uint32_t turns() const { return bits_of<double>(turned_); }

  void write(std::size_t lane, bool turned, Manifold<3, T>& to) const {
    point_.write(lane, to.points[0]);
    const auto edge = [&](std::size_t of_second) {
      return Feature{FeatureKind::edge, static_cast<std::uint32_t>(numbers_[of_second].of[lane])};
    };
    to.points[0].id.a = edge(turned ? 1 : 0);
    to.points[0].id.b = edge(turned ? 0 : 1);
    rows_.write(lane, 1, to);
  }

 private:
  /// The edge along the first axis that is farthest along the direction of the heights times `side`.
  struct Farthest {
    Doubles number;
    Point middle;

    HWY_INLINE Farthest(const BoxLanes& box, Doubles axis, const Doubles (&heights)[2], Doubles side) {
      const Doubles next = hn::Mul(heights[0], side);
      const Doubles last = hn::Mul(heights[1], side);
      number = hn::Add(hn::Mul(axis, both(4)), hn::Add(hn::IfThenElseZero(hn::Ge(next, both(0)), both(1)),
                                                       hn::IfThenElseZero(hn::Ge(last, both(0)), both(2))));
      middle = box.center + box.half_edges[1] * HWY_NAMESPACE::sign_of(next) +
               box.half_edges[2] * HWY_NAMESPACE::sign_of(last);
    }
  };

  HWY_INLINE static DoublesMask lies_on(Doubles along, Doubles half) {
    constexpr double farthest = 1 - 0x1p-20;
    return hn::Lt(hn::Abs(along), hn::Mul(both(farthest), half));
  }

  HWY_INLINE static DoublesMask are_long(const BoxLanes& a, const BoxLanes& b, Doubles size) {
    constexpr double least_share = 2e-6;
    const auto shortest = [](const BoxLanes& box) { return hn::Min(hn::Min(box.half[0], box.half[1]), box.half[2]); };
    return hn::Gt(hn::Min(shortest(a), shortest(b)), hn::Mul(both(least_share), size));
  }

  DoublesMask is_open_;
  DoublesMask turned_;
  ManifoldRows<T> rows_;
  PointRows<T> point_;
  Row<double> numbers_[2];
};

#endif
}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
