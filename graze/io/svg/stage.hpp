// SPDX-License-Identifier: MIT
// Where a scene is drawn: from which side it is seen, how large, and where unbounded shapes end.
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

/// Shapes that reach farther out than this (unbounded ones: that start or pass farther out) are not drawn: their
/// squares, and those of their differences, must stay far from the largest double.
inline constexpr double farthest_drawn = 1e100;

template <Dim N>
struct Stage {
  View<N> view;
  Aabb<N, double> box;  ///< What unbounded shapes are cut off at: in 2D what the card shows, in 3D a box of space.
  Frame frame;
  std::vector<std::size_t> drawn;  ///< The positions of the objects that can be drawn, ascending.
  std::size_t too_far = 0;         ///< How many cannot, see `farthest_drawn`.
};

/// The stage on which every object is seen whole, an unbounded one in part.
template <Dim N>
Stage<N> stage_for(const Subject<N>& subject, YAxis y_axis);

/// Calls `visit` with a shape that is no compound, as its own type, or with all such parts of a compound.
template <Dim N, class Visit>
void for_each_part(const AnyShape<N, double>& shape, const Visit& visit) {
  detail::visit(
      [&visit]<class S>(const S& held) {
        if constexpr (std::is_same_v<S, Compound<N, double>>) {
          for (const Part<N, double>& part : held.parts) for_each_part<N>(part.shape, visit);
        } else {
          visit(held);
        }
      },
      shape);
}

/// The outline of a part on the stage, cut off where it is unbounded; empty when the stage shows nothing of it. Of a
/// half-space in 3D only the boundary is drawn, for its inside would hide everything.
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

/// The box in the picture around all that is seen of a shape; `Aabb::nothing()` when nothing is.
template <Dim N>
Aabb<2, double> picture_box(const Stage<N>& stage, const AnyShape<N, double>& shape);

}  // namespace graze::io::svg
