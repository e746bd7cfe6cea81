// SPDX-License-Identifier: MIT
// Which part of a compound, or which face of a mesh, decides a contact. Include contact.hpp.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>

#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
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

/// The half-space of which a face is part of the boundary, with the faces' outside outside; none for a flat face.
template <class T>
std::optional<HalfSpace<3, T>> half_space_behind(const Triangle<3, T>& face) {
  const Vec<3, double> a = wide<3, T>(face.a);
  Vec<3, double> normal = accurate_cross(wide<3, T>(face.b) - a, wide<3, T>(face.c) - a);
  const double size = max_abs(normal);
  if (!(size > 0) || !std::isfinite(size)) return std::nullopt;
  const Vec<3, T> rounded(normal / size);
  return HalfSpace<3, T>{rounded, static_cast<T>(dot(wide<3, T>(rounded), a))};
}

/// The contact of a solid mesh. If the center of the shape's box is outside, the faces push as those of a surface do.
/// Otherwise that would push what is mostly inside through to the other side of a face. Then the shape is pushed out to
/// the plane of a face, whichever is least deep: of the faces that it touches, and of the one nearest to the center. A
/// shape that touches no face is pushed to the plane of the nearest one.
template <class T, class S>
class ContactOfSolid {
 public:
  ContactOfSolid(const Mesh<3, T>& mesh, const S& shape)
      : mesh_(mesh),
        shape_(shape),
        center_(bounds(shape).center()),
        is_deep_(is_finite(center_) && is_held(mesh, center_)) {}

  void add(const std::optional<Penetration<3>>& candidate, std::size_t face) {
    if (candidate && !(is_deep_ && add_plane(face))) before_.add(candidate, face);
  }

  void finish() {
    std::optional<Vec<3, T>> inside;
    if (is_deep_) {
      inside = center_;
    } else if (!before_.found) {
      inside = point_inside(mesh_, shape_);
    }
    if (inside) add_plane(deciding_part(mesh_, *inside).index);
  }

  const std::optional<Penetration<3>>& found() const { return is_behind() ? behind_ : before_.found; }
  std::size_t index() const { return is_behind() ? first_behind_.index() : before_.first.index(); }
  bool is_behind() const { return behind_.has_value(); }

 private:
  /// False for a flat face, which has no plane.
  bool add_plane(std::size_t face) {
    const auto plane = half_space_behind(mesh_.triangle(face));
    if (!plane) return false;
    const std::optional<Penetration<3>> candidate = penetration(*plane, shape_);
    if (candidate && first_behind_.is_replaced_by(candidate->depth, face)) behind_ = candidate;
    return true;
  }

  const Mesh<3, T>& mesh_;
  const S& shape_;
  Vec<3, T> center_;
  bool is_deep_;
  DecidingContact<3> before_;
  std::optional<Penetration<3>> behind_;
  FirstPart first_behind_;
};

/// Calls use(found, index, is_behind) with the contact that decides; is_behind: it is that of the plane of a solid's
/// face. `find(part)` returns the contact of one part with the shape, which is in the box.
template <HasParts Whole, class S, class Find, class Use>
auto with_deciding_contact(const Whole& whole, const S& shape, const Aabb<dimension_of<S>, scalar_of<S>>& box,
                           const Find& find, const Use& use) {
  constexpr Dim N = dimension_of<S>;
  using T = scalar_of<S>;
  const MayTouch<N, T> may_touch{box};
  if constexpr (N == 3 && is_mesh<Whole>) {
    if (whole.kind() == MeshKind::solid) {
      ContactOfSolid<T, S> contact(whole, shape);
      visit_parts(whole, may_touch, [&](const auto& part, std::size_t index) {
        contact.add(find(part.shape), index);
        return true;
      });
      contact.finish();
      return use(contact.found(), contact.index(), contact.is_behind());
    }
  }
  DecidingContact<N> deepest;
  visit_parts(whole, may_touch, [&](const auto& part, std::size_t index) {
    deepest.add(find(part.shape), index);
    return true;
  });
  return use(deepest.found, deepest.first.index(), false);
}

}  // namespace graze::detail
