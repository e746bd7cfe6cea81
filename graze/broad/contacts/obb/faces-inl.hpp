// SPDX-License-Identifier: MIT
// The manifolds of many pairs of oriented boxes across a face of one of them, as manifold_of_met_obbs in
// query/manifold.hpp. Included once per instruction set, so it has no ordinary include guard.
#if defined(GRAZE_BROAD_CONTACTS_OBB_FACES_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BROAD_CONTACTS_OBB_FACES_INL_HPP
#undef GRAZE_BROAD_CONTACTS_OBB_FACES_INL_HPP
#else
#define GRAZE_BROAD_CONTACTS_OBB_FACES_INL_HPP
#endif

#include <bit>
#include <cstddef>
#include <cstdint>

#include <hwy/highway.h>

#include <graze/broad/contacts/manifold_lanes-inl.hpp>
#include <graze/broad/contacts/manifold_points-inl.hpp>
#include <graze/broad/contacts/obb/choice-inl.hpp>
#include <graze/broad/contacts/obb/clip-inl.hpp>
#include <graze/broad/contacts/obb/lines-inl.hpp>
#include <graze/broad/contacts/obb/obb_kernels.hpp>
#include <graze/query/fast_contact/obb/contact.hpp>
#include <graze/query/manifold.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {
#if HWY_TARGET != HWY_SCALAR  // which has no vectors of two groups of pairs

/// In addition to the bits of an ObbAxisTest: the reference face is on the second box, and the axis is not its normal.
inline constexpr std::uint64_t reference_on_second = std::uint64_t{1} << 32U;

/// A group of pairs, with their axis tests and that bit.
template <class T>
struct PairGroup {
  const T* const* first;
  const T* const* second;
  const std::uint64_t* looks;
};

/// The axis tests of a group.
class AxisTestLanes {
 public:
  HWY_INLINE explicit AxisTestLanes(const std::uint64_t* looks)
      : looks_(hn::LoadU(BitsTag(), looks)),
        axis_(hn::ConvertTo(Tag<double>(), hn::BitCast(hn::RebindToSigned<Tag<double>>(),
                                                       hn::And(looks_, hn::Set(BitsTag(), ObbAxisTest::axis_bits))))) {}

  /// Its index, as in BoxesAxes.
  Doubles axis() const { return axis_; }
  /// Three indices make one row: the faces of the first box, those of the second, and the edges of the first.
  HWY_INLINE Doubles row() const { return hn::Floor(hn::Mul(hn::Add(axis_, both(0.5)), both(1.0 / 3))); }
  HWY_INLINE DoublesMask turned() const { return has_bits(ObbAxisTest::turned); }
  HWY_INLINE DoublesMask by_second() const { return has_bits(reference_on_second); }

 private:
  HWY_INLINE DoublesMask has_bits(std::uint64_t bits) const {
    return hn::RebindMask(Tag<double>(), hn::TestBit(looks_, hn::Set(BitsTag(), bits)));
  }

  Bits looks_;
  Doubles axis_;
};

/// Pairs whose axis is the normal of the reference face, on the box `own`.
template <class T>
struct FacePairs {
  const T* const* own;
  const T* const* other;
  Doubles axis;        ///< Of `own`.
  DoublesMask of_b;    ///< `own` is the second in the contact order.
  DoublesMask turned;  ///< The user's second box is the first in that order.

  /// From a group whose first boxes have the reference face.
  HWY_INLINE explicit FacePairs(const PairGroup<T>& group) : own(group.first), other(group.second) {
    const AxisTestLanes looks(group.looks);
    of_b = hn::Gt(looks.axis(), both(2));
    axis = hn::Sub(looks.axis(), hn::IfThenElseZero(of_b, both(3)));
    turned = looks.turned();
  }
};

/// Pairs in their contact order whose axis is not the normal of the reference face, but parallel to it up to 1e-5.
template <class T>
struct OffAxisPairs {
  const T* const* first;
  const T* const* second;
  DoublesMask is_on_edges;  ///< The axis is across edges along these axes.
  Doubles axis_a;
  Doubles axis_b;    ///< Or it is the normal across this one of the second box.
  DoublesMask of_b;  ///< The second box has the reference face.
  DoublesMask turned;

  HWY_INLINE explicit OffAxisPairs(const PairGroup<T>& group) : first(group.first), second(group.second) {
    const AxisTestLanes looks(group.looks);
    const Doubles row = looks.row();
    is_on_edges = hn::Gt(row, both(1));
    axis_a = hn::IfThenElseZero(is_on_edges, hn::Sub(row, both(2)));
    axis_b = hn::Sub(looks.axis(), hn::Mul(row, both(3)));
    of_b = looks.by_second();
    turned = looks.turned();
  }
};

HWY_INLINE DoublesMask may_be_aligned(const BoxLanes& box, const Point& direction) {
  const auto cosine = [&](Dim i) { return hn::Abs(dot(box.axes[i], direction)); };
  return hn::Gt(hn::Max(hn::Max(cosine(0), cosine(1)), cosine(2)), both(1 - doubt_of_cosines));
}

/// The face of a box that faces a direction most, as facing_face of query/fast_contact/obb/contact.hpp.
struct LookingFace {
  Doubles axis;
  DoublesMask is_far;
  DoublesMask is_open;

  HWY_INLINE LookingFace(const BoxLanes& box, const Point& direction) {
    const Doubles x = dot(box.axes[0], direction);
    const Doubles y = dot(box.axes[1], direction);
    const Doubles z = dot(box.axes[2], direction);
    const Doubles larger = hn::Max(hn::Abs(x), hn::Abs(y));
    const Doubles second = hn::Max(hn::Min(hn::Abs(x), hn::Abs(y)), hn::Min(larger, hn::Abs(z)));
    const Doubles lead = hn::Sub(hn::Max(larger, hn::Abs(z)), second);
    is_open = hn::Not(hn::Gt(lead, both(doubt_of_cosines)));
    const DoublesMask is_second = hn::Gt(hn::Abs(y), hn::Abs(x));
    const DoublesMask is_third = hn::Gt(hn::Abs(z), larger);
    axis = hn::IfThenElse(is_third, both(2), hn::IfThenElseZero(is_second, both(1)));
    is_far = hn::Gt(hn::IfThenElse(is_third, z, hn::IfThenElse(is_second, y, x)), both(0));
  }
};

/// Its unit normal.
HWY_INLINE Point outward_normal(const BoxLanes& box_from_face, const Point& direction) {
  const Point adjoint = cross(box_from_face.axes[1], box_from_face.axes[2]);
  const Point side = adjoint * hn::Div(both(1), hn::Sqrt(dot(adjoint, adjoint)));
  return one_of(hn::Lt(dot(side, direction), both(0)), side * both(-1), side);
}

/// Whether a face's normal is parallel to a direction, as in aligned_face of query/fast_contact/obb/contact.hpp.
HWY_INLINE DoublesMask is_face_along(const BoxLanes& box, const Point& direction) {
  const DoublesMask may_be = may_be_aligned(box, direction);
  if (hn::AllFalse(Tag<double>(), may_be)) return may_be;
  const LookingFace face(box, direction);
  const Point turn = outward_normal(turned_to(box, face.axis), direction) - direction;
  return hn::And(may_be, hn::Le(dot(turn, turn), both(tolerance::aligned * tolerance::aligned)));
}

/// The face perpendicular to the first axis.
HWY_INLINE FaceLanes face_of(const BoxLanes& box, DoublesMask is_far) {
  const Doubles side = hn::IfThenElse(is_far, both(1), both(-1));
  return {box.center + box.half_edges[0] * side, box.half_edges[1], box.half_edges[2], box.half[1], box.half[2]};
}

/// As BoxFaceNumbers::face().
HWY_INLINE Bits face_number(Doubles axis, DoublesMask is_far) {
  return whole(hn::Add(hn::Add(axis, axis), hn::IfThenElseZero(is_far, both(1))));
}

/// The data of pairs before their faces are clipped.
struct ClipInput {
  BoxLanes own;  ///< With the axis of the reference face as the first.
  BoxLanes other;
  AxisLanes found;
  UpwardLanes upward;
  Doubles own_axis;
  DoublesMask is_far;
  Doubles size;
  DoublesMask turned;  ///< The user's second box is the first in the contact order.
  DoublesMask of_b;    ///< The second box in that order has the reference face.
  DoublesMask is_open;
  Point origin;  ///< The center of the first box in that order.
};

HWY_INLINE Point upward_of(const Point& normal, DoublesMask of_b) {
  return normal * hn::IfThenElse(of_b, both(-1), both(1));
}

/// The axis of each pair, for boxes relative to the first one's center.
template <class T>
HWY_INLINE AxisLanes axis_of_pairs(const BoxPair& boxes, const OffAxisPairs<T>& pairs) {
  const BoxLanes a = turned_to(boxes.box[0], pairs.axis_a);
  const BoxLanes b = turned_to(boxes.box[1], pairs.axis_b);
  const DoublesMask on_edges = pairs.is_on_edges;
  const AxisLanes across_edges = EdgesLanes(a, 0, b, 0).axis();
  const AxisLanes across_face = axis_of_face(b, 0, boxes.box[0], b.center);
  return {one_of(on_edges, across_edges.normal, across_face.normal),
          hn::IfThenElse(on_edges, across_edges.gap, across_face.gap)};
}

/// Which box has a face parallel to the axis of a pair, which becomes the reference face: the first, or else, if the
/// axis is across edges, the second.
class ReferenceBoxes {
 public:
  template <class T>
  HWY_INLINE explicit ReferenceBoxes(const OffAxisPairs<T>& pairs) {
    BoxPair boxes{{load_boxes(pairs.first), load_boxes(pairs.second)}};
    see_from_first(boxes);
    const Point normal = axis_of_pairs(boxes, pairs).normal;
    by_first_ = is_face_along(boxes.box[0], normal);
    by_second_ = hn::AndNot(by_first_, hn::And(pairs.is_on_edges, is_face_along(boxes.box[1], normal * both(-1))));
  }

  /// One bit for each pair.
  std::uint32_t by_first() const { return bits_of<double>(by_first_); }
  std::uint32_t by_second() const { return bits_of<double>(by_second_); }

 private:
  DoublesMask by_first_;
  DoublesMask by_second_;
};

template <class T>
HWY_INLINE ClipInput clip_input(const FacePairs<T>& pairs) {
  ClipInput input;
  BoxLanes own;
  load_boxes(pairs.own, own);
  load_boxes(pairs.other, input.other);
  input.turned = pairs.turned;
  input.of_b = pairs.of_b;
  input.is_open = no_lane();
  const Point zero{{both(0), both(0), both(0)}};
  const Point of_own = own.center;
  const Point of_other = input.other.center;
  const Point way = one_of(input.of_b, of_own - of_other, of_other - of_own);
  input.origin = one_of(input.of_b, of_other, of_own);
  own.center = one_of(input.of_b, way, zero);
  input.other.center = one_of(input.of_b, zero, way);
  input.own_axis = pairs.axis;
  input.size = hn::Add(size_of(own), size_of(input.other));
  turn_to(own, input.own_axis, input.own);
  input.found = axis_of_face(input.own, 0, input.other, way);
  const Point up = upward_of(input.found.normal, input.of_b);
  input.upward = {up, up};
  input.is_far = hn::Gt(dot(input.own.axes[0], up), both(0));
  return input;
}

template <class T>
HWY_INLINE ClipInput clip_input(const OffAxisPairs<T>& pairs) {
  BoxPair boxes{{load_boxes(pairs.first), load_boxes(pairs.second)}};
  ClipInput input;
  input.turned = pairs.turned;
  input.of_b = pairs.of_b;
  input.origin = see_from_first(boxes);
  input.size = hn::Add(size_of(boxes.box[0]), size_of(boxes.box[1]));
  input.found = axis_of_pairs(boxes, pairs);
  const Point up = upward_of(input.found.normal, input.of_b);
  const BoxLanes own = one_of(input.of_b, boxes.box[1], boxes.box[0]);
  const LookingFace face(own, up);
  input.is_open = face.is_open;
  input.own_axis = face.axis;
  input.is_far = face.is_far;
  input.own = turned_to(own, face.axis);
  input.other = one_of(input.of_b, boxes.box[0], boxes.box[1]);
  input.upward = {up, outward_normal(input.own, up)};
  return input;
}

/// Whether the reference box has a face parallel to the axis, as in is_face_along.
HWY_INLINE DoublesMask are_on_face(const ClipInput& input) {
  const Point turn = input.upward.normal - input.upward.up;
  return hn::And(may_be_aligned(input.own, input.upward.up),
                 hn::Le(dot(turn, turn), both(tolerance::aligned * tolerance::aligned)));
}

/// A group of pairs, whose incident faces are clipped to the reference faces.
template <class T>
class FaceContacts {
 public:
  /// Must be called first.
  HWY_INLINE void fill(const ClipInput& input) {
    up_ = input.upward.up;
    normal_ = input.found.normal;
    of_b_ = input.of_b;
    turns_ = hn::Xor(input.of_b, input.turned);
    origin_ = input.origin;
    const LookingFace looking(input.other, up_ * both(-1));
    incident_ = face_of(turned_to(input.other, looking.axis), looking.is_far);
    const FaceClip clip(incident_, face_of(input.own, input.is_far), input.upward,
                        hn::Mul(both(tolerance::coarse), input.size));
    clip.give(clip_);
    is_open_ = hn::Or(input.is_open, hn::Or(looking.is_open, clip_.is_open()));
    rows_.set(input.found, input.size, input.turned);
    store(face_number(input.own_axis, input.is_far), faces_[PlacesOnFaces::reference]);
    store(face_number(looking.axis, looking.is_far), faces_[PlacesOnFaces::incident]);
    store(clip_.turns(), places_);
  }

  /// Takes all corners of each pair of two groups, or selects four of more. The groups may be the same one. A selection
  /// has short code with long latencies: two take hardly longer than one.
  HWY_INLINE static void choose(FaceContacts& a, FaceContacts& b) {
    Lines lines = joined(a.clip_.left(), b.clip_.left());
    Lines beyond = lines;
    for (std::size_t k = 0; k < Manifold<3>::most_points; ++k) beyond = but_the_first(beyond);
    auto is_open = are_none(lines);
    const auto are_few = are_none(beyond);
    if (!hn::AllTrue(TwoTag(), are_few)) {
      const ChoiceLanes choice(lines, a.clip_, a.measures(), b.clip_, b.measures());
      lines = hn::IfThenElse(hn::RebindMask(LinesTag(), are_few), lines, choice.chosen());
      is_open = hn::Or(is_open, hn::Not(hn::Or(are_few, choice.is_clear())));
    }
    const Lines open = hn::IfThenElseZero(hn::RebindMask(LinesTag(), is_open), hn::Set(LinesTag(), 1));
    a.take(widened(lines, 0), widened(open, 0));
    if (&a != &b) b.take(widened(lines, 1), widened(open, 1));
  }

  /// Sets the selected corners.
  HWY_INLINE void set_points() {
    Bits rest = chosen_;
    for (std::size_t k = 0; k < Manifold<3>::most_points; ++k) {
      const Bits line = first_of(rest);
      set_point(k, line);
      rest = hn::Xor(rest, line);
    }
  }

  /// One bit for each uncertain pair.
  std::uint32_t open() const { return bits_of<double>(is_open_); }
  /// One bit for each pair whose face is on the user's second box.
  std::uint32_t turns() const { return bits_of<double>(turns_); }

  /// `turns` if the user's second box has the face.
  void write(std::size_t lane, bool turns, Manifold<3, T>& to) const {
    const auto size = static_cast<std::size_t>(std::popcount(corners_[lane]));
    const std::size_t on_a = turns ? PlacesOnFaces::incident : PlacesOnFaces::reference;
    const std::size_t on_b = turns ? PlacesOnFaces::reference : PlacesOnFaces::incident;
    const auto& of_a = features_of_faces[faces_[on_a].of[lane]];
    const auto& of_b = features_of_faces[faces_[on_b].of[lane]];
    const auto& places = places_by_lines[places_.of[lane]];
    for (std::size_t k = 0; k < size; ++k) {
      ManifoldPoint<3, T>& point = to.points[k];
      points_[k].write(lane, point);
      const PlacesOnFaces& of_lines = places[lines_[k].of[lane]];
      write_feature(of_a[of_lines.on[on_a]], point.id.a);
      write_feature(of_b[of_lines.on[on_b]], point.id.b);
    }
    rows_.write(lane, size, to);
  }

 private:
  HWY_INLINE MeasuresLanes measures() const { return MeasuresLanes(clip_, incident_, normal_, of_b_); }

  HWY_INLINE void take(Bits lines, Bits open) {
    chosen_ = lines;
    hn::Store(lines, BitsTag(), corners_);
    is_open_ = hn::Or(is_open_, has_bit(open, 0));
  }

  /// Sets the corner on a line, if there is one.
  HWY_INLINE void set_point(std::size_t k, Bits line) {
    const LineOfEach<Tag<double>> corner(line);
    const Doubles within[2] = {corner.of([this](std::size_t s) { return clip_.within(s, 0); }),
                               corner.of([this](std::size_t s) { return clip_.within(s, 1); })};
    store(corner.of([this](std::size_t s) { return clip_.lines(s); }), lines_[k]);
    const Doubles height = clip_.height_of(within[0], within[1]);
    const Point point = incident_.middle + incident_.right * within[0] + incident_.up * within[1];
    const Doubles depth = max_of(both(0), hn::Neg(height));
    const Point first = (point + up_ * depth) + origin_;
    points_[k].set(first, point + origin_, depth, turns_);
  }

  Point up_;
  Point normal_;
  DoublesMask of_b_;
  DoublesMask turns_;  ///< The user's second box has the face.
  Point origin_;
  FaceLanes incident_;
  ClipLanes clip_;
  DoublesMask is_open_;
  Bits chosen_;  ///< The lines with selected corners.
  ManifoldRows<T> rows_;
  PointRows<T> points_[Manifold<3>::most_points];
  alignas(64) std::uint64_t corners_[pairs_at_once];  ///< The same.
  Row<std::uint64_t> faces_[2];
  Row<std::uint64_t> places_;
  Row<std::uint64_t> lines_[Manifold<3>::most_points];
};

#endif
}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
