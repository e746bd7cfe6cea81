// SPDX-License-Identifier: MIT
// How a scene is drawn: the direction of view, the scale, and where unbounded shapes are cut off.
#pragma once

#include <cstddef>
#include <type_traits>
#include <vector>

#include <graze/io/scene_file.hpp>
#include <graze/io/svg/frame.hpp>
#include <graze/io/svg/subject.hpp>
#include <graze/query/outline.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/visit.hpp>

namespace graze::io::svg {

/// Shapes that extend beyond this (unbounded ones: that start or pass beyond it) are not drawn, because squares of
/// coordinates and of their differences must not overflow.
inline constexpr double farthest_drawn = 1e100;

template <Dim N>
struct Stage {
  View<N> view;
  Aabb<N, double> box;  ///< What unbounded shapes are cut off at: the card in 2D, a 3D box in 3D.
  Frame frame;
  std::vector<std::size_t> drawn;  ///< The positions of the objects that can be drawn, ascending.
  std::size_t too_far = 0;         ///< Number of objects that cannot be drawn, see `farthest_drawn`.
};

/// The stage that shows every bounded object completely and every unbounded one in part.
template <Dim N>
Stage<N> stage_for(const Subject<N>& subject, YAxis y_axis);

/// Calls `visit` with a shape in its own type; for a compound with each of its parts, at all nesting levels, for a mesh
/// with each of its faces.
template <Dim N, class Visit>
void for_each_part(const AnyShape<N, double>& shape, const Visit& visit) {
  detail::visit(
      [&visit]<class S>(const S& held) {
        if constexpr (std::is_same_v<S, Compound<N, double>>) {
          for (const Part<N, double>& part : held.parts) for_each_part<N>(part.shape, visit);
        } else if constexpr (std::is_same_v<S, Mesh<N, double>>) {
          for (std::size_t face = 0; face < held.faces().size(); ++face) visit(held.triangle(face));
        } else {
          visit(held);
        }
      },
      shape);
}

/// The outline of a part on the stage, cut off if it is unbounded; empty if no part of it is visible. Of a half-space
/// in 3D only the boundary is drawn, because its interior would hide everything.
template <Dim N, class S>
Outline outline_on(const Stage<N>& stage, const S& part) {
  if constexpr (std::is_same_v<S, HalfSpace<3, double>>) {
    return outline(boundary(part), stage.view, stage.box);
  } else if constexpr (requires { outline(part, stage.view, stage.box); }) {
    return outline(part, stage.view, stage.box);
  } else {
    return outline(part, stage.view);
  }
}

/// The box in the picture around the visible part of a shape; `Aabb::nothing()` if none is visible.
template <Dim N>
Aabb<2, double> picture_box(const Stage<N>& stage, const AnyShape<N, double>& shape);

}  // namespace graze::io::svg
