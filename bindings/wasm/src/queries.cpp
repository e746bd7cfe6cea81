// SPDX-License-Identifier: MIT
// Questions about one shape or two. Yes and no, and enumerations, are results; everything else is in the answer.
#include <cstddef>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include <emscripten/bind.h>

#include <graze/broad/relations.hpp>
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
#include <graze/query/signed_distance.hpp>
#include <graze/shape/polytope.hpp>

#include "bridge.hpp"
#include "shape_text.hpp"

namespace graze::wasm {
namespace {

void put_end(Status status, double error) {
  answer().push_back(status == Status::converged ? 0 : 1);
  answer().push_back(error);
}

int relation_of(int dimension, std::string a, std::string b) {
  return in_dimension(dimension,
                      [&](auto n) { return static_cast<int>(relation(shape_of<n>(a, "a"), shape_of<n>(b, "b"))); });
}

double distance_of(int dimension, std::string a, std::string b) {
  return in_dimension(dimension, [&](auto n) { return distance(shape_of<n>(a, "a"), shape_of<n>(b, "b")); });
}

/// distance, point_a, point_b, normal, relation, status, error
void closest_points_of(int dimension, std::string a, std::string b) {
  in_dimension(dimension, [&](auto n) {
    const Proximity<n, double> found = closest_points(shape_of<n>(a, "a"), shape_of<n>(b, "b"));
    answer().push_back(found.distance);
    put<n>(found.point_a);
    put<n>(found.point_b);
    put<n>(found.normal);
    answer().push_back(static_cast<double>(found.relation));
    put_end(found.status, found.error);
  });
}

/// point, point_a, point_b, normal, depth, status, error; nothing if the shapes are apart
void contact_of(int dimension, std::string a, std::string b) {
  in_dimension(dimension, [&](auto n) {
    const auto found = contact(shape_of<n>(a, "a"), shape_of<n>(b, "b"));
    if (!found) return;
    put<n>(found->point);
    put<n>(found->point_a);
    put<n>(found->point_b);
    put<n>(found->normal);
    answer().push_back(found->depth);
    put_end(found->status, found->error);
  });
}

void put_feature(const Feature& feature) {
  answer().push_back(static_cast<double>(feature.kind));
  answer().push_back(feature.index);
}

/// normal, status, error, then for each point: point, point_a, point_b, depth, and the id: kind and index of a's
/// feature and of b's, part of a and of b
void manifold_of(int dimension, std::string a, std::string b) {
  in_dimension(dimension, [&](auto n) {
    const Manifold<n, double> found = manifold(shape_of<n>(a, "a"), shape_of<n>(b, "b"));
    put<n>(found.normal);
    put_end(found.status, found.error);
    for (const ManifoldPoint<n, double>& point : found.contacts()) {
      put<n>(point.point);
      put<n>(point.point_a);
      put<n>(point.point_b);
      answer().push_back(point.depth);
      put_feature(point.id.a);
      put_feature(point.id.b);
      answer().push_back(point.id.part_a);
      answer().push_back(point.id.part_b);
    }
  });
}

/// t, point, normal, status, error; nothing if the ray misses
void ray_cast_of(int dimension, std::string shape, std::string ray, double t_max, bool at_exit) {
  in_dimension(dimension, [&](auto n) {
    const RayOptions options{at_exit ? RaySide::exit : RaySide::entry};
    const auto hit = ray_cast(shape_of<n>(shape, "shape"), ray_of<n>(ray), t_max, options);
    if (!hit) return;
    answer().push_back(hit->t);
    put<n>(hit->point);
    put<n>(hit->normal);
    put_end(hit->status, hit->error);
  });
}

template <Dim N>
Vec<N, double> point_of(const std::string& text) {
  return std::get<Vec<N, double>>(shape_of<N>(text, "point"));
}

bool contains_of(int dimension, std::string shape, std::string point) {
  return in_dimension(dimension, [&](auto n) { return contains(shape_of<n>(shape, "shape"), point_of<n>(point)); });
}

void closest_point_of(int dimension, std::string shape, std::string point) {
  in_dimension(dimension, [&](auto n) { put<n>(closest_point(shape_of<n>(shape, "shape"), point_of<n>(point))); });
}

void boundary_point_of(int dimension, std::string shape, std::string point) {
  in_dimension(dimension,
               [&](auto n) { put<n>(closest_boundary_point(shape_of<n>(shape, "shape"), point_of<n>(point))); });
}

double signed_distance_to(int dimension, std::string shape, std::string point) {
  return in_dimension(dimension,
                      [&](auto n) { return signed_distance(shape_of<n>(shape, "shape"), point_of<n>(point)); });
}

void bounds_of(int dimension, std::string shape) {
  in_dimension(dimension, [&](auto n) { put<n>(bounds(shape_of<n>(shape, "shape"))); });
}

std::string normalised(int dimension, std::string shape) {
  return in_dimension(dimension, [&](auto n) { return text_of<n>(shape_of<n>(shape, "shape")); });
}

/// The shape around the points of the input, as text.
std::string bounding_of(int dimension, std::string kind, std::size_t count) {
  return in_dimension(dimension, [&](auto n) {
    const std::span<const double> numbers = input<double>(count * static_cast<std::size_t>(n()));
    std::vector<Vec<n, double>> points;
    points.reserve(count);
    for (std::size_t i = 0; i < count; ++i) points.push_back(vector_at<n>(numbers, i));
    if (kind == "sphere") return text_of<n>(bounding_sphere(points));
    if (kind == "sphere_fast") return text_of<n>(bounding_sphere_fast(points));
    if (kind == "box") return text_of<n>(bounding_box(points));
    if (kind == "obb") return text_of<n>(bounding_obb(points));
    return text_of<n>(convex_hull<n, double>(points));
  });
}

}  // namespace

EMSCRIPTEN_BINDINGS(graze_queries) {
  using namespace emscripten;  // NOLINT(google-build-using-namespace): as embind is written
  function("relation", &Guarded<&relation_of>::call);
  function("distance", &Guarded<&distance_of>::call);
  function("closestPoints", &Guarded<&closest_points_of>::call);
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
