// SPDX-License-Identifier: MIT
// Which part of a compound, or which face of a mesh, decides a contact. Include contact.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include <graze/math/lanes/sixteen.hpp>
#include <graze/math/rounding.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/closest_point.hpp>
#include <graze/query/contact/convex.hpp>
#include <graze/query/contains.hpp>
#include <graze/query/convex/wide_support.hpp>
#include <graze/query/cores/penetration.hpp>
#include <graze/query/parts/inside.hpp>
#include <graze/query/parts/visit.hpp>
#include <graze/query/scaling/range.hpp>
#include <graze/query/signed_distance.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/half_space.hpp>
#include <graze/shape/mesh.hpp>
#include <graze/shape/parts/box_block.hpp>
#include <graze/shape/parts/may_matter.hpp>
#include <graze/shape/triangle.hpp>

namespace graze::detail {

/// The deepest contact of the parts added so far, of several the first part's.
template <Dim N>
struct DecidingContact {
  void add(const std::optional<Penetration<N>>& candidate, std::size_t index) {
    if (candidate && first.is_replaced_by(-candidate->depth, index)) found = candidate;
  }

  std::optional<Penetration<N>> found;
  FirstPart first;
};

/// For `visit_parts`: faces whose boxes, grown as by touching_bounds, overlap one so deeply that they may decide the
/// contact of a convex shape in it. Pushing the box out along an axis separates the shapes, too; so they are no deeper
/// than that.
template <Dim N, class T>
class MayDecideContact {
 public:
  MayDecideContact(const Aabb<N, T>& box, const DecidingContact<N>& deepest)
      : box_(box),
        deepest_(deepest),
        slack_(errors * static_cast<double>(std::max(max_abs(box.min), max_abs(box.max)))) {}

  double key(const Aabb<N, T>& grown) const {
    double most = std::numeric_limits<double>::infinity();
    for (Dim i = 0; i < N; ++i) {
      most = std::min(most, static_cast<double>(grown.max[i]) - static_cast<double>(box_.min[i]));
      most = std::min(most, static_cast<double>(box_.max[i]) - static_cast<double>(grown.min[i]));
    }
    return most < 0 ? std::numeric_limits<double>::quiet_NaN() : -most;
  }
  bool admits(double key) const { return -key >= least(); }
  bool operator()(const Aabb<N, T>& grown) const { return admits(key(grown)); }
#ifdef GRAZE_HAS_LANES
  LaneMask lanes(const BoxBlock<N, T>& grown, Row<T>& keys) const {
    return overlapping_lanes(grown, box_, round_down<T>(least()), keys);
  }
#endif

 private:
  static constexpr double errors = 1e-6;  // more than those of depths, and of sums of T

  double least() const {
    if (!deepest_.found) return 0;
    return std::max(0.0, deepest_.found->depth - slack_);
  }

  const Aabb<N, T>& box_;
  const DecidingContact<N>& deepest_;
  double slack_;
};

/// The numbers with which a half-space ends at a point: a normal of T, and dot(normal, point) before rounding to T. The
/// normal is shortened if that would overflow.
template <class T>
struct EndAt {
  EndAt(const Vec<3, double>& direction, const Vec<3, double>& point)
      : normal(Vec<3, T>(direction / max_abs(direction)) * (is_huge(point) ? T(0.25) : T(1))),
        offset(dot(wide<3, T>(normal), point)) {}

  static bool is_huge(const Vec<3, double>& point) {
    return max_abs(point) > static_cast<double>(std::numeric_limits<T>::max()) / 4;
  }

  Vec<3, T> normal;
  double offset;
};

/// The half-space of which a face is part of the boundary, with the faces' outside outside; none for a flat face.
template <class T>
std::optional<HalfSpace<3, T>> half_space_behind(const Triangle<3, T>& face) {
  const Vec<3, double> a = wide<3, T>(face.a);
  const Vec<3, double> to_b = wide<3, T>(face.b) - a;
  const Vec<3, double> to_c = wide<3, T>(face.c) - a;
  const double scale = scale_to_moderate(std::max(max_abs(to_b), max_abs(to_c)));
  const Vec<3, double> normal = accurate_cross(to_b * scale, to_c * scale);
  const double size = max_abs(normal);
  if (!(size > 0) || !std::isfinite(size)) return std::nullopt;
  const EndAt<T> end(normal, a);
  return HalfSpace<3, T>{end.normal, static_cast<T>(end.offset)};
}

/// The half-space that ends at the nearest point of a face, as seen from a point, which it contains.
template <class T>
HalfSpace<3, T> half_space_up_to(const Triangle<3, T>& face, const Vec<3, T>& point) {
  const Vec<3, double> nearest = wide<3, T>(closest_point(face, point));
  const Vec<3, double> from = wide<3, T>(point);
  const Vec<3, double> way = nearest - from;
  const EndAt<T> end(max_abs(way) > 0 ? way : unit_axis<3>(0), nearest);
  return {end.normal, round_up<T>(std::max(end.offset, dot(wide<3, T>(end.normal), from)))};
}

/// The contact of a solid mesh. If the center of the shape's box is outside, the faces push as those of a surface do.
/// Otherwise that would push what is mostly inside through to the other side of a face. Then the shape is pushed out to
/// the plane of a face, whichever is least deep: of the faces that it touches, and of the one nearest to the center. A
/// shape that touches no face, but is inside, is pushed to the plane of the nearest one. If it is in front of that
/// plane, as near a face that is turned around, or if the face is flat and has none, it is pushed straight to the face.
template <class T, class S>
class ContactOfSolid {
 public:
  ContactOfSolid(const Mesh<3, T>& mesh, const S& shape)
      : mesh_(mesh),
        shape_(shape),
        center_(bounds(shape).center()),
        is_deep_(is_finite(center_) && is_held(mesh, center_)) {}

  /// A contact of a face, or, with a margin, of one that is only near.
  void add(const std::optional<Penetration<3>>& candidate, std::size_t face) {
    if (!candidate) return;
    const bool touches = candidate->depth >= 0;
    touches_ = touches_ || touches;
    if (!(touches && is_deep_ && add_plane(face))) before_.add(candidate, face);
  }

  void finish() {
    std::optional<Vec<3, T>> inside = touches_ ? std::nullopt : point_inside(mesh_, shape_);
    if (!touches_ && !inside) return;
    if (is_deep_) {
      add_plane(nearest_face(center_));
    } else if (inside) {
      add_plane(nearest_face(*inside));
    }
    if (!inside || is_behind()) return;
    const std::size_t face = nearest_face(*inside);
    add_half_space(half_space_up_to(mesh_.triangle(face), *inside), face);
  }

  const std::optional<Penetration<3>>& found() const { return is_behind() ? behind_ : before_.found; }
  std::size_t index() const { return is_behind() ? first_behind_.index() : before_.first.index(); }

  /// The half-space that the shape is pushed out of; null if it is pushed by a face.
  const HalfSpace<3, T>* half_space() const { return is_behind() ? &half_space_ : nullptr; }

 private:
  bool is_behind() const { return behind_.has_value(); }

  std::size_t nearest_face(const Vec<3, T>& point) const { return deciding_part(mesh_, point).index; }

  /// Whether the face has a plane and the shape reaches behind it.
  bool add_plane(std::size_t face) {
    const auto plane = half_space_behind(mesh_.triangle(face));
    return plane && add_half_space(*plane, face);
  }

  bool add_half_space(const HalfSpace<3, T>& half_space, std::size_t face) {
    const std::optional<Penetration<3>> candidate = penetration(half_space, shape_);
    if (candidate && first_behind_.is_replaced_by(candidate->depth, face)) {
      behind_ = candidate;
      half_space_ = half_space;
    }
    return candidate.has_value();
  }

  const Mesh<3, T>& mesh_;
  const S& shape_;
  Vec<3, T> center_;
  bool is_deep_;
  bool touches_ = false;
  DecidingContact<3> before_;
  std::optional<Penetration<3>> behind_;
  FirstPart first_behind_;
  HalfSpace<3, T> half_space_;
};

/// Calls use(found, index, half_space) with the contact that decides: it is that of a part, or, if half_space is not
/// null, of a half-space up to a solid's face. `find(part)` returns the contact of one part with the shape, which is in
/// the box.
template <HasParts Whole, class S, class Find, class Use>
auto with_deciding_contact(const Whole& whole, const S& shape, const Aabb<dimension_of<S>, scalar_of<S>>& box,
                           const Find& find, const Use& use) {
  constexpr Dim N = dimension_of<S>;
  using T = scalar_of<S>;
  const MayTouch<N, T> may_touch{box};
  if constexpr (N == 3 && is_mesh<Whole>) {
    if (whole.kind() == MeshKind::solid) {
      ContactOfSolid<T, S> contact(whole, shape);
      const auto add = [&](const auto& part, std::size_t index) {
        contact.add(find(part.shape), index);
        return true;
      };
      visit_parts(whole, may_touch, PartVisitor<Whole>(add));
      contact.finish();
      return use(contact.found(), contact.index(), contact.half_space());
    }
  }
  DecidingContact<N> deepest;
  const auto add = [&](const auto& part, std::size_t index) {
    deepest.add(find(part.shape), index);
    return true;
  };
  if constexpr (is_mesh<Whole> && !HasParts<S>) {
    visit_parts(whole, MayDecideContact<N, T>(box, deepest), ByKey(), add);
  } else {
    visit_parts(whole, may_touch, PartVisitor<Whole>(add));
  }
  return use(deepest.found, deepest.first.index(), static_cast<const HalfSpace<N, T>*>(nullptr));
}

}  // namespace graze::detail
