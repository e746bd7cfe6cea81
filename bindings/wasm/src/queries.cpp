// SPDX-License-Identifier: MIT
// Queries about one or two shapes. Booleans and enumerations are return values; everything else is in the output.
#include <cstddef>
#include <span>
#include <variant>
#include <vector>

#include <emscripten/bind.h>

#include <graze/query/bounding.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/closest_boundary_point.hpp>
#include <graze/query/closest_point.hpp>
#include <graze/query/closest_points.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/contains.hpp>
#include <graze/query/distance.hpp>
#include <graze/query/manifold.hpp>
#include <graze/query/ray_cast.hpp>
#include <graze/query/relation.hpp>
#include <graze/query/separation.hpp>
#include <graze/query/signed_distance.hpp>
#include <graze/shape/mesh.hpp>
#include <graze/shape/polytope.hpp>

#include "arguments.hpp"
#include "bridge.hpp"
#include "results.hpp"

namespace graze::wasm {
namespace {

/// Calls ask(a, b) with two shapes from the arguments.
template <class Ask>
auto about_pair(int dimension, std::size_t place, const Ask& ask) {
  return in_dimension(dimension, [&](auto n) {
    Arguments in(place);
    const AnyShape<n, double> a = in.shape<n>();
    const AnyShape<n, double> b = in.shape<n>();
    return ask(a, b);
  });
}

/// Calls ask(shape, point) with a point and a shape from the arguments.
template <class Ask>
auto about_point(int dimension, std::size_t place, const Ask& ask) {
  return in_dimension(dimension, [&](auto n) {
    Arguments in(place);
    const Vec<n, double> point = in.vector<n>();
    const AnyShape<n, double> shape = in.shape<n>();
    return ask(shape, point);
  });
}

/// Calls ask(shape) with a shape from the arguments.
template <class Ask>
auto about_shape(int dimension, std::size_t place, const Ask& ask) {
  return in_dimension(dimension, [&](auto n) { return ask(Arguments(place).shape<n>()); });
}

int relation_of(int dimension, std::size_t place) {
  return about_pair(dimension, place, [](const auto& a, const auto& b) { return static_cast<int>(relation(a, b)); });
}

double distance_of(int dimension, std::size_t place) {
  return about_pair(dimension, place, [](const auto& a, const auto& b) { return distance(a, b); });
}

/// distance, point_a, point_b, normal, relation, status, error
template <Dim N>
void put_proximity(const Proximity<N, double>& found) {
  answer().push_back(found.distance);
  put<N>(found.point_a);
  put<N>(found.point_b);
  put<N>(found.normal);
  answer().push_back(static_cast<double>(found.relation));
  put_end(found.status, found.error);
}

void closest_points_of(int dimension, std::size_t place) {
  about_pair(dimension, place, [](const auto& a, const auto& b) { put_proximity(closest_points(a, b)); });
}

void separation_of(int dimension, std::size_t place) {
  about_pair(dimension, place, [](const auto& a, const auto& b) { put_proximity(separation(a, b)); });
}

/// point, point_a, point_b, normal, depth, status, error; empty if the shapes are apart
void contact_of(int dimension, std::size_t place, double margin) {
  about_pair(dimension, place, [margin]<Dim N>(const AnyShape<N, double>& a, const AnyShape<N, double>& b) {
    const auto found = contact(a, b, {.margin = margin});
    if (!found) return;
    put<N>(found->point);
    put<N>(found->point_a);
    put<N>(found->point_b);
    put<N>(found->normal);
    answer().push_back(found->depth);
    put_end(found->status, found->error);
  });
}

/// As put_manifold describes.
void manifold_of(int dimension, std::size_t place, double margin) {
  about_pair(dimension, place, [margin]<Dim N>(const AnyShape<N, double>& a, const AnyShape<N, double>& b) {
    put_manifold<N>(manifold(a, b, {.margin = margin}));
  });
}

/// What put_hit puts, for a mesh what put_mesh_hit puts; empty if the ray, which precedes the shape, misses
void ray_cast_of(int dimension, std::size_t place, double t_max, bool at_exit) {
  in_dimension(dimension, [&](auto n) {
    Arguments in(place);
    const Ray<n, double> ray = in.ray<n>();
    const RayOptions options{at_exit ? RaySide::exit : RaySide::entry};
    const AnyShape<n, double> shape = in.shape<n>();
    if (const auto* const mesh = std::get_if<Mesh<n, double>>(&shape)) {
      if (const auto hit = ray_cast(*mesh, ray, t_max, options)) put_mesh_hit<n>(*hit);
    } else if (const auto hit = ray_cast(shape, ray, t_max, options)) {
      put_hit<n>(*hit);
    }
  });
}

bool contains_of(int dimension, std::size_t place) {
  return about_point(dimension, place, [](const auto& shape, const auto& point) { return contains(shape, point); });
}

void closest_point_of(int dimension, std::size_t place) {
  about_point(dimension, place, []<Dim N>(const AnyShape<N, double>& shape, const Vec<N, double>& point) {
    put<N>(closest_point(shape, point));
  });
}

void boundary_point_of(int dimension, std::size_t place) {
  about_point(dimension, place, []<Dim N>(const AnyShape<N, double>& shape, const Vec<N, double>& point) {
    put<N>(closest_boundary_point(shape, point));
  });
}

double signed_distance_to(int dimension, std::size_t place) {
  return about_point(dimension, place,
                     [](const auto& shape, const auto& point) { return signed_distance(shape, point); });
}

void bounds_of(int dimension, std::size_t place) {
  about_shape(dimension, place, []<Dim N>(const AnyShape<N, double>& shape) { put<N>(bounds(shape)); });
}

void normalised(int dimension, std::size_t place) {
  about_shape(dimension, place, []<Dim N>(const AnyShape<N, double>& shape) { put_shape<N>(shape); });
}

/// In the order of js/queries.js.
enum class Bounding { sphere, sphere_fast, box, obb, hull };

template <Dim N>
AnyShape<N, double> bounding(Bounding kind, const std::vector<Vec<N, double>>& points) {
  switch (kind) {
    case Bounding::sphere:
      return bounding_sphere(points);
    case Bounding::sphere_fast:
      return bounding_sphere_fast(points);
    case Bounding::box:
      return bounding_box(points);
    case Bounding::obb:
      return bounding_obb(points);
    case Bounding::hull:
      break;
  }
  return convex_hull<N, double>(points);
}

/// A shape that bounds the points of the input.
void bounding_of(int dimension, int kind, std::size_t count) {
  in_dimension(dimension, [&](auto n) {
    const std::span<const double> numbers = input<double>(count * static_cast<std::size_t>(n()));
    std::vector<Vec<n, double>> points;
    points.reserve(count);
    for (std::size_t i = 0; i < count; ++i) points.push_back(vector_at<n>(numbers, i));
    put_shape<n>(bounding<n>(static_cast<Bounding>(kind), points));
  });
}

}  // namespace

EMSCRIPTEN_BINDINGS(graze_queries) {
  using namespace emscripten;  // NOLINT(google-build-using-namespace): as embind is written
  function("relation", &Guarded<&relation_of>::call);
  function("distance", &Guarded<&distance_of>::call);
  function("closestPoints", &Guarded<&closest_points_of>::call);
  function("separation", &Guarded<&separation_of>::call);
  function("contact", &Guarded<&contact_of>::call);
  function("manifold", &Guarded<&manifold_of>::call);
  function("rayCast", &Guarded<&ray_cast_of>::call);
  function("contains", &Guarded<&contains_of>::call);
  function("closestPoint", &Guarded<&closest_point_of>::call);
  function("closestBoundaryPoint", &Guarded<&boundary_point_of>::call);
  function("signedDistance", &Guarded<&signed_distance_to>::call);
  function("bounds", &Guarded<&bounds_of>::call);
  function("normalised", &Guarded<&normalised>::call);
  function("bounding", &Guarded<&bounding_of>::call);
}

}  // namespace graze::wasm
