// SPDX-License-Identifier: MIT
// The test that SceneView::cull applies to the box of every object. Compiled in scene_view.cpp, since a region that is
// an AnyShape instantiates every type of shape.
#pragma once

#include <graze/broad/index/region.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/frustum.hpp>
#include <graze/shape/shape.hpp>

namespace graze {

/// Whether a region may meet a box, allowing for rounding: SceneView::cull calls it with the touching_bounds of every
/// object.
template <class R>
bool meets_inflated(const R& region, const Aabb<dimension_of<R>, scalar_of<R>>& box) {
  return detail::RegionProbe<Inflated<R>>(Inflated<R>{region}).meets(box);
}

extern template bool meets_inflated(const AnyShape<2, float>&, const Aabb<2, float>&);
extern template bool meets_inflated(const AnyShape<3, float>&, const Aabb<3, float>&);
extern template bool meets_inflated(const AnyShape<2, double>&, const Aabb<2, double>&);
extern template bool meets_inflated(const AnyShape<3, double>&, const Aabb<3, double>&);
extern template bool meets_inflated(const Frustum<2, float>&, const Aabb<2, float>&);
extern template bool meets_inflated(const Frustum<3, float>&, const Aabb<3, float>&);
extern template bool meets_inflated(const Frustum<2, double>&, const Aabb<2, double>&);
extern template bool meets_inflated(const Frustum<3, double>&, const Aabb<3, double>&);

}  // namespace graze
