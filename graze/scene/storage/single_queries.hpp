// SPDX-License-Identifier: MIT
// Queries on single objects. Each instantiates code for every type of shape in every dimension and number type, so it
// is compiled only once, in scene_ray.cpp and scene_view.cpp.
#pragma once

#include <optional>

#include <graze/broad/index/region.hpp>
#include <graze/query/ray_cast.hpp>
#include <graze/query/signed_distance.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/frustum.hpp>

namespace graze {

extern template std::optional<RayHit<2, float>> ray_cast(const AnyShape<2, float>&, const Ray<2, float>&, float,
                                                         RayOptions);
extern template std::optional<RayHit<3, float>> ray_cast(const AnyShape<3, float>&, const Ray<3, float>&, float,
                                                         RayOptions);
extern template std::optional<RayHit<2, double>> ray_cast(const AnyShape<2, double>&, const Ray<2, double>&, double,
                                                          RayOptions);
extern template std::optional<RayHit<3, double>> ray_cast(const AnyShape<3, double>&, const Ray<3, double>&, double,
                                                          RayOptions);

extern template float signed_distance(const AnyShape<2, float>&, const Vec<2, float>&);
extern template float signed_distance(const AnyShape<3, float>&, const Vec<3, float>&);
extern template double signed_distance(const AnyShape<2, double>&, const Vec<2, double>&);
extern template double signed_distance(const AnyShape<3, double>&, const Vec<3, double>&);

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
