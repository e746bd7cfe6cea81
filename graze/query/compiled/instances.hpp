// SPDX-License-Identifier: MIT
// Queries on AnyShape instantiate every type of shape and take long to compile, so graze::graze holds them compiled,
// with the searches that they share. This file lists them: one macro per header, for one dimension N and scalar T. With
// GRAZE_COMPILED_QUERIES, which the CMake target graze::graze defines, each header declares its list `extern`; the
// sources of this folder instantiate the same lists. Users of graze::geometry compile what they call.
#pragma once

#include <graze/math/platform/export.hpp>

#ifdef GRAZE_COMPILED_QUERIES
#define GRAZE_DECLARE_INSTANCES(LIST) \
  LIST(extern, 2, float)              \
  LIST(extern, 3, float)              \
  LIST(extern, 2, double)             \
  LIST(extern, 3, double)
#define GRAZE_DECLARE_INSTANCES_OF_DIMENSIONS(LIST) LIST(extern, 2) LIST(extern, 3)
#else
#define GRAZE_DECLARE_INSTANCES(LIST)
#define GRAZE_DECLARE_INSTANCES_OF_DIMENSIONS(LIST)
#endif

// ---- Searches on any convex shapes, in double

#define GRAZE_GJK_INSTANCES(LINKAGE, N)                                                                           \
  LINKAGE template GRAZE_EXPORT void detail::prove_distance(detail::AnyDifference<N>&, const detail::Simplex<N>&, \
                                                            GjkResult<N>&);

#define GRAZE_EPA_INSTANCES(LINKAGE, N)                                                                           \
  LINKAGE template GRAZE_EXPORT EpaResult<N> detail::epa_on(detail::AnyDifference<N>&, const detail::Simplex<N>&, \
                                                            const EpaOptions&);

// ---- Two shapes

#define GRAZE_RELATION_INSTANCES(LINKAGE, N, T)                                                        \
  LINKAGE template GRAZE_EXPORT Relation detail::decide(const AnyShape<N, T>&, const AnyShape<N, T>&); \
  LINKAGE template GRAZE_EXPORT Relation relation(const AnyShape<N, T>&, const AnyShape<N, T>&);

#define GRAZE_CLOSEST_POINTS_INSTANCES(LINKAGE, N, T)                                                                \
  LINKAGE template GRAZE_EXPORT Proximity<N, double> detail::proximity(const AnyShape<N, T>&, const AnyShape<N, T>&, \
                                                                       SimplexCache<N>*);                            \
  LINKAGE template GRAZE_EXPORT Proximity<N, T> closest_points(const AnyShape<N, T>&, const AnyShape<N, T>&);        \
  LINKAGE template GRAZE_EXPORT Proximity<N, T> closest_points(const AnyShape<N, T>&, const AnyShape<N, T>&,         \
                                                               SimplexCache<N>&);

#define GRAZE_DISTANCE_INSTANCES(LINKAGE, N, T)                                           \
  LINKAGE template GRAZE_EXPORT T distance(const AnyShape<N, T>&, const AnyShape<N, T>&); \
  LINKAGE template GRAZE_EXPORT T distance(const AnyShape<N, T>&, const AnyShape<N, T>&, SimplexCache<N>&);

#define GRAZE_CONTACT_INSTANCES(LINKAGE, N, T)                                                                      \
  LINKAGE template GRAZE_EXPORT std::optional<detail::Penetration<N>> detail::penetration(const AnyShape<N, T>&,    \
                                                                                          const AnyShape<N, T>&);   \
  LINKAGE template GRAZE_EXPORT std::optional<Contact<N, T>> contact(const AnyShape<N, T>&, const AnyShape<N, T>&); \
  LINKAGE template GRAZE_EXPORT std::optional<Contact<N, T>> contact(const AnyShape<N, T>&, const AnyShape<N, T>&,  \
                                                                     ContactOptions);

#define GRAZE_MANIFOLD_INSTANCES(LINKAGE, N, T)                                                        \
  LINKAGE template GRAZE_EXPORT Manifold<N, T> manifold(const AnyShape<N, T>&, const AnyShape<N, T>&); \
  LINKAGE template GRAZE_EXPORT Manifold<N, T> manifold(const AnyShape<N, T>&, const AnyShape<N, T>&, ContactOptions);

#define GRAZE_SEPARATION_INSTANCES(LINKAGE, N, T) \
  LINKAGE template GRAZE_EXPORT Proximity<N, T> separation(const AnyShape<N, T>&, const AnyShape<N, T>&);

#define GRAZE_SHAPE_CAST_INSTANCES(LINKAGE, N, T)                                                               \
  LINKAGE template GRAZE_EXPORT std::optional<detail::CastHit<N>> detail::cast_hit(                             \
      const AnyShape<N, T>&, const Vec<N, double>&, const AnyShape<N, T>&, const detail::NoCastOptions&);       \
  LINKAGE template GRAZE_EXPORT std::optional<detail::CastHit<N>> detail::cast_hit(                             \
      const AnyShape<N, T>&, const Vec<N, double>&, const AnyShape<N, T>&, const CastOptions&);                 \
  LINKAGE template GRAZE_EXPORT std::optional<Impact<N, T>> detail::impact_of(                                  \
      const AnyShape<N, T>&, const Vec<N, T>&, const AnyShape<N, T>&, const detail::NoCastOptions&);            \
  LINKAGE template GRAZE_EXPORT std::optional<Impact<N, T>> detail::impact_of(                                  \
      const AnyShape<N, T>&, const Vec<N, T>&, const AnyShape<N, T>&, const CastOptions&);                      \
  LINKAGE template GRAZE_EXPORT std::optional<Impact<N, T>> shape_cast(const AnyShape<N, T>&, const Vec<N, T>&, \
                                                                       const AnyShape<N, T>&);                  \
  LINKAGE template GRAZE_EXPORT std::optional<Impact<N, T>> shape_cast(const AnyShape<N, T>&, const Vec<N, T>&, \
                                                                       const AnyShape<N, T>&, CastOptions);

#define GRAZE_TIME_OF_IMPACT_INSTANCES(LINKAGE, N, T)                                                    \
  LINKAGE template GRAZE_EXPORT std::optional<detail::CastHit<N>> detail::cast_hit_in_motion(            \
      const AnyShape<N, T>&, const Motion<N, double>&, const AnyShape<N, T>&, const Motion<N, double>&); \
  LINKAGE template GRAZE_EXPORT std::optional<Impact<N, T>> time_of_impact(                              \
      const AnyShape<N, T>&, const Motion<N, T>&, const AnyShape<N, T>&, const Motion<N, T>&);

// ---- One shape

#define GRAZE_RAY_CAST_INSTANCES(LINKAGE, N, T)                                                                   \
  LINKAGE template GRAZE_EXPORT std::optional<RayHit<N, T>> ray_cast(const AnyShape<N, T>&, const Ray<N, T>&, T,  \
                                                                     RayOptions);                                 \
  LINKAGE template GRAZE_EXPORT std::optional<RayHit<N, T>> ray_cast(const AnyShape<N, T>&, const Segment<N, T>&, \
                                                                     RayOptions);

#define GRAZE_CONTAINS_INSTANCES(LINKAGE, N, T)                                                \
  LINKAGE template GRAZE_EXPORT bool detail::is_held(const AnyShape<N, T>&, const Vec<N, T>&); \
  LINKAGE template GRAZE_EXPORT bool contains(const AnyShape<N, T>&, const Vec<N, T>&);

#define GRAZE_SIGNED_DISTANCE_INSTANCES(LINKAGE, N, T)                                                      \
  LINKAGE template GRAZE_EXPORT double detail::signed_distance_of(const AnyShape<N, T>&, const Vec<N, T>&); \
  LINKAGE template GRAZE_EXPORT T signed_distance(const AnyShape<N, T>&, const Vec<N, T>&);

#define GRAZE_CLOSEST_POINT_INSTANCES(LINKAGE, N, T)                                                         \
  LINKAGE template GRAZE_EXPORT Vec<N, T> detail::closest_point_of(const AnyShape<N, T>&, const Vec<N, T>&); \
  LINKAGE template GRAZE_EXPORT Vec<N, T> closest_point(const AnyShape<N, T>&, const Vec<N, T>&);

#define GRAZE_CLOSEST_BOUNDARY_POINT_INSTANCES(LINKAGE, N, T) \
  LINKAGE template GRAZE_EXPORT Vec<N, T> closest_boundary_point(const AnyShape<N, T>&, const Vec<N, T>&);

#define GRAZE_MASS_PROPERTIES_INSTANCES(LINKAGE, N, T) \
  LINKAGE template GRAZE_EXPORT MassProperties<N> mass_properties(const AnyShape<N, T>&);
