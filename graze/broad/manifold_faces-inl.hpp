// SPDX-License-Identifier: MIT
// The manifolds of many pairs of oriented boxes across a face of one of them, as manifold_of_met_obbs in
// query/manifold.hpp makes them. Included once for each instruction set, hence no ordinary guard.
#if defined(GRAZE_BROAD_MANIFOLD_FACES_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BROAD_MANIFOLD_FACES_INL_HPP
#undef GRAZE_BROAD_MANIFOLD_FACES_INL_HPP
#else
#define GRAZE_BROAD_MANIFOLD_FACES_INL_HPP
#endif

#include <cstddef>
#include <cstdint>
#include <limits>

#include <hwy/highway.h>

#include <graze/broad/manifold_choice-inl.hpp>
#include <graze/broad/manifold_clip-inl.hpp>
#include <graze/broad/manifold_lanes-inl.hpp>
#include <graze/broad/manifold_points-inl.hpp>
#include <graze/query/obb_touch.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {

/// Pairs whose axis is the normal of a face of the box `own`, which carries their points.
template <class T>
struct FacePairs {
  const T* own[pairs_at_once];
  const T* other[pairs_at_once];
  Row<double> axis;    ///< Of `own`.
  Row<double> of_b;    ///< 1 where `own` is the second in the order of the contact, else 0.
  Row<double> turned;  ///< 1 where the user's second box is the first in that order.
};

/// Pairs in the order of their contact whose axis is another than the normal of the face that carries their points,
/// which looks along it up to 1e-5.
template <class T>
struct CarriedPairs {
  const T* first[pairs_at_once];
  const T* second[pairs_at_once];
  Row<double> is_on_edges;  ///< 1 where the axis is across edges along these axes, else 0.
  Row<double> axis_a;
  Row<double> axis_b;  ///< Or it is the normal across this one of the second box.
  Row<double> of_b;    ///< 1 where the second box carries the points.
  Row<double> turned;
};

HWY_INLINE DoublesMask is_set(const Row<double>& row) { return hn::Ne(hn::Load(Tag<double>(), row.of), both(0)); }

HWY_INLINE DoublesMask may_be_aligned(const BoxLanes& box, const Point& direction) {
  const auto cosine = [&](Dim i) { return hn::Abs(dot(box.axes[i], direction)); };
  return hn::Gt(hn::Max(hn::Max(cosine(0), cosine(1)), cosine(2)), both(1 - doubt_of_cosines));
}

/// The face of a box that looks most along a direction, as looking_face of query/obb_touch.hpp.
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

/// Its normal, of length 1.
HWY_INLINE Point outward_normal(const BoxLanes& box_from_face, const Point& direction) {
  const Point adjoint = cross(box_from_face.axes[1], box_from_face.axes[2]);
  const Point side = adjoint / hn::Sqrt(dot(adjoint, adjoint));
  return one_of(hn::Lt(dot(side, direction), both(0)), side * both(-1), side);
}

/// Whether a face looks straight along a direction, as aligned_face of query/obb_touch.hpp says.
HWY_INLINE DoublesMask is_face_along(const BoxLanes& box, const Point& direction) {
  const DoublesMask may_be = may_be_aligned(box, direction);
  if (hn::AllFalse(Tag<double>(), may_be)) return may_be;
  const LookingFace face(box, direction);
  const Point turn = outward_normal(turned_to(box, face.axis), direction) - direction;
  return hn::And(may_be, hn::Le(dot(turn, turn), both(tolerance::aligned * tolerance::aligned)));
}

/// The face across the first axis.
HWY_INLINE FaceLanes face_of(const BoxLanes& box, DoublesMask is_far) {
  const Doubles side = hn::IfThenElse(is_far, both(1), both(-1));
  return {box.center + box.half_edges[0] * side, box.half_edges[1], box.half_edges[2]};
}

HWY_INLINE Doubles face_number(Doubles axis, DoublesMask is_far) {
  return hn::Add(hn::Add(axis, axis), hn::IfThenElseZero(is_far, both(1)));
}

/// What is known of pairs before their faces are laid on each other.
struct CarriedLanes {
  BoxLanes own;  ///< With the axis of the carrying face as the first.
  BoxLanes other;
  AxisLanes found;
  UpwardLanes upward;
  Doubles own_axis;
  DoublesMask is_far;
  Doubles size;
};

/// The axis of each pair, in boxes seen from the first one's center.
template <class T>
HWY_INLINE AxisLanes axis_of_carried(const BoxPair& boxes, const CarriedPairs<T>& pairs) {
  const BoxLanes a = turned_to(boxes.box[0], hn::Load(Tag<double>(), pairs.axis_a.of));
  const BoxLanes b = turned_to(boxes.box[1], hn::Load(Tag<double>(), pairs.axis_b.of));
  const DoublesMask on_edges = is_set(pairs.is_on_edges);
  const AxisLanes across_edges = EdgesLanes(a, 0, b, 0).axis();
  const AxisLanes across_face = axis_of_face(b, 0, boxes.box[0], b.center);
  return {one_of(on_edges, across_edges.normal, across_face.normal),
          hn::IfThenElse(on_edges, across_edges.gap, across_face.gap)};
}

/// Which box has a face along the axis of a pair and so carries the points: the first, or else, where the axis is
/// across edges, the second.
class CarryingBoxes {
 public:
  template <class T>
  HWY_INLINE explicit CarryingBoxes(const CarriedPairs<T>& pairs) {
    BoxPair boxes{{load_boxes(pairs.first), load_boxes(pairs.second)}};
    see_from_first(boxes);
    const Point normal = axis_of_carried(boxes, pairs).normal;
    by_first_ = is_face_along(boxes.box[0], normal);
    by_second_ =
        hn::AndNot(by_first_, hn::And(is_set(pairs.is_on_edges), is_face_along(boxes.box[1], normal * both(-1))));
  }

  /// One bit for each pair.
  std::uint32_t by_first() const { return bits_of<double>(by_first_); }
  std::uint32_t by_second() const { return bits_of<double>(by_second_); }

 private:
  DoublesMask by_first_;
  DoublesMask by_second_;
};

template <class T>
class FaceContacts {
 public:
  HWY_INLINE explicit FaceContacts(const FacePairs<T>& pairs)
      : turned_(is_set(pairs.turned)), of_b_(is_set(pairs.of_b)), is_open_(no_lane()) {
    BoxPair boxes{{load_boxes(pairs.own), load_boxes(pairs.other)}};
    const Point way = place_boxes(boxes);
    CarriedLanes carried;
    carried.own_axis = hn::Load(Tag<double>(), pairs.axis.of);
    carried.own = turned_to(boxes.box[0], carried.own_axis);
    carried.other = boxes.box[1];
    carried.size = hn::Add(size_of(boxes.box[0]), size_of(boxes.box[1]));
    carried.found = axis_of_face(carried.own, 0, carried.other, way);
    const Point up = upward_of(carried.found.normal);
    carried.upward = {up, up};
    carried.is_far = hn::Gt(dot(carried.own.axes[0], up), both(0));
    lay(carried);
  }

  HWY_INLINE explicit FaceContacts(const CarriedPairs<T>& pairs)
      : turned_(is_set(pairs.turned)), of_b_(is_set(pairs.of_b)), is_open_(no_lane()) {
    BoxPair boxes{{load_boxes(pairs.first), load_boxes(pairs.second)}};
    origin_ = see_from_first(boxes);
    CarriedLanes carried;
    carried.size = hn::Add(size_of(boxes.box[0]), size_of(boxes.box[1]));
    carried.found = axis_of_carried(boxes, pairs);
    const Point up = upward_of(carried.found.normal);
    const BoxLanes own = one_of(of_b_, boxes.box[1], boxes.box[0]);
    const LookingFace face(own, up);
    is_open_ = face.is_open;
    carried.own_axis = face.axis;
    carried.is_far = face.is_far;
    carried.own = turned_to(own, face.axis);
    carried.other = one_of(of_b_, boxes.box[0], boxes.box[1]);
    carried.upward = {up, outward_normal(carried.own, up)};
    lay(carried);
  }

  /// One bit for each pair of which not all is clear.
  std::uint32_t open() const { return bits_of<double>(is_open_); }

  /// `turns` where the user's second box has the face.
  void write(std::size_t lane, bool turns, Manifold<3, T>& to) const {
    const auto size = static_cast<std::size_t>(count_.of[lane]);
    const auto& of_reference = features_of_faces[static_cast<std::size_t>(reference_face_.of[lane])];
    const auto& of_incident = features_of_faces[static_cast<std::size_t>(incident_face_.of[lane])];
    for (std::size_t k = 0; k < size; ++k) {
      ManifoldPoint<3, T>& point = to.points[k];
      points_[k].write(lane, point);
      const PlacesOnFaces& places = places_by_line_pair[static_cast<std::size_t>(lines_[k].of[lane])];
      const Feature features[2] = {of_reference[places.on_reference], of_incident[places.on_incident]};
      point.id = {features[turns ? 1 : 0], features[turns ? 0 : 1], 0, 0};
    }
    for (std::size_t k = size; k < to.points.size(); ++k) clear_point(to.points[k]);
    rows_.write(lane, size, to);
  }

 private:
  /// Seen from the center of the one that is first in the order of the contact. Returns the way from there to the
  /// other's.
  HWY_INLINE Point place_boxes(BoxPair& boxes) {
    const Point own = boxes.box[0].center;
    const Point other = boxes.box[1].center;
    const Point zero{{both(0), both(0), both(0)}};
    const Point way = one_of(of_b_, own - other, other - own);
    origin_ = one_of(of_b_, other, own);
    boxes.box[0].center = one_of(of_b_, way, zero);
    boxes.box[1].center = one_of(of_b_, zero, way);
    return way;
  }

  HWY_INLINE Point upward_of(const Point& normal) const { return normal * hn::IfThenElse(of_b_, both(-1), both(1)); }

  /// The other box' face on the carrying one.
  HWY_INLINE void lay(const CarriedLanes& carried) {
    turns_ = hn::Or(hn::AndNot(of_b_, turned_), hn::AndNot(turned_, of_b_));
    rows_.set(carried.found, carried.size, turned_);
    const Point& up = carried.upward.up;
    const LookingFace looking(carried.other, up * both(-1));
    store(face_number(carried.own_axis, carried.is_far), reference_face_);
    store(face_number(looking.axis, looking.is_far), incident_face_);
    const FaceLanes incident = face_of(turned_to(carried.other, looking.axis), looking.is_far);
    const ClipLanes clip(incident, face_of(carried.own, carried.is_far), carried.upward,
                         hn::Mul(both(tolerance::coarse), carried.size));
    is_open_ = hn::Or(is_open_, hn::Or(looking.is_open, clip.is_open()));
    choose(clip, incident, carried.found.normal);
    set_points(clip, incident, up);
  }

  /// The ranks of all corners, or of four of more; of others infinity.
  HWY_INLINE void choose(const ClipLanes& clip, const FaceLanes& incident, const Point& normal) {
    const Doubles none = both(std::numeric_limits<double>::infinity());
    for (std::size_t s = 0; s < clip_lines; ++s) ranks_[s] = hn::IfThenElse(clip.is_left(s), clip.rank(s), none);
    const auto count = [&] {
      return over_lines(Total(), [&](std::size_t s) { return hn::IfThenElseZero(hn::Lt(ranks_[s], none), both(1)); });
    };
    Doubles corners = count();
    const DoublesMask are_many = hn::Gt(corners, both(4));
    if (!hn::AllFalse(Tag<double>(), are_many)) {
      const ChoiceLanes choice(clip, incident, normal, of_b_);
      for (std::size_t s = 0; s < clip_lines; ++s) {
        ranks_[s] = hn::IfThenElse(hn::AndNot(choice.has(ranks_[s]), are_many), none, ranks_[s]);
      }
      corners = count();
      is_open_ = hn::Or(is_open_, hn::And(are_many, choice.is_open()));
    }
    store(corners, count_);
  }

  HWY_INLINE void set_points(const ClipLanes& clip, const FaceLanes& incident, const Point& up) {
    const Doubles none = both(std::numeric_limits<double>::infinity());
    Doubles rank = both(-1);
    for (std::size_t k = 0; k < 4; ++k) {
      rank =
          over_lines(Least(), [&](std::size_t s) { return hn::IfThenElse(hn::Gt(ranks_[s], rank), ranks_[s], none); });
      set_point(k, rank, clip, incident, up);
    }
  }

  /// That of the corner with the rank, if there is one.
  HWY_INLINE void set_point(std::size_t k, Doubles rank, const ClipLanes& clip, const FaceLanes& incident,
                            const Point& up) {
    const auto of_corner = [&](const auto& number) {
      return over_lines(Common(),
                        [&](std::size_t s) { return hn::IfThenElseZero(hn::Eq(ranks_[s], rank), number(s)); });
    };
    const Doubles within[2] = {of_corner([&](std::size_t s) { return clip.within(s, 0); }),
                               of_corner([&](std::size_t s) { return clip.within(s, 1); })};
    const Doubles lines = of_corner([&](std::size_t s) { return clip.lines(s); });
    store(lines, lines_[k]);
    const Doubles height = clip.height_of(within[0], within[1]);
    const Point point = incident.middle + incident.right * within[0] + incident.up * within[1];
    const Point first = (point - up * height) + origin_;
    points_[k].set(first, point + origin_, max_of(both(0), hn::Neg(height)), turns_);
  }

  DoublesMask turned_;
  DoublesMask of_b_;
  DoublesMask turns_;  ///< The user's second box has the face.
  DoublesMask is_open_;
  Doubles ranks_[clip_lines];
  Point origin_;
  ManifoldRows<T> rows_;
  PointRows<T> points_[4];
  Row<double> count_, reference_face_, incident_face_;
  Row<double> lines_[4];
};

}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
