// SPDX-License-Identifier: MIT
// Questions about two shapes.
#include <graze/query/closest_points.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/distance.hpp>
#include <graze/query/intersects.hpp>
#include <graze/query/manifold.hpp>
#include <graze/query/relation.hpp>
#include <graze/query/separation.hpp>
#include <graze/query/shape_cast.hpp>
#include <graze/query/time_of_impact.hpp>

#include "results.hpp"
#include "shape_in.hpp"
#include "vectors.hpp"

using namespace graze;
using namespace graze::c;

graze_status graze_relation_of(const graze_shape* a, const graze_shape* b, graze_relation* out) {
  return guarded(__func__, [&] {
    graze_relation& result = required("out", out);
    result = on_pair(
        a, b, [](const auto& in_a, const auto& in_b) { return static_cast<graze_relation>(relation(in_a, in_b)); });
  });
}

graze_status graze_intersects(const graze_shape* a, const graze_shape* b, bool* out) {
  return guarded(__func__, [&] {
    bool& result = required("out", out);
    result = on_pair(a, b, [](const auto& in_a, const auto& in_b) { return intersects(in_a, in_b); });
  });
}

graze_status graze_distance(const graze_shape* a, const graze_shape* b, double* out) {
  return guarded(__func__, [&] {
    double& result = required("out", out);
    result = on_pair(a, b, [](const auto& in_a, const auto& in_b) -> double { return distance(in_a, in_b); });
  });
}

graze_status graze_closest_points(const graze_shape* a, const graze_shape* b, graze_proximity* out) {
  return guarded(__func__, [&] {
    graze_proximity& result = required("out", out);
    result = on_pair(a, b, [](const auto& in_a, const auto& in_b) { return c_result(closest_points(in_a, in_b)); });
  });
}

graze_status graze_separation(const graze_shape* a, const graze_shape* b, graze_proximity* out) {
  return guarded(__func__, [&] {
    graze_proximity& result = required("out", out);
    result = on_pair(a, b, [](const auto& in_a, const auto& in_b) { return c_result(separation(in_a, in_b)); });
  });
}

graze_status graze_contact_of(const graze_shape* a, const graze_shape* b, double margin, graze_contact* out) {
  return guarded(__func__, [&] {
    graze_contact& result = required("out", out);
    const ContactOptions options{.margin = required_length("margin", margin)};
    return on_pair(
        a, b, [&](const auto& in_a, const auto& in_b) { return write_answer(result, contact(in_a, in_b, options)); });
  });
}

graze_status graze_manifold_of(const graze_shape* a, const graze_shape* b, double margin, graze_manifold* out) {
  return guarded(__func__, [&] {
    graze_manifold& result = required("out", out);
    const ContactOptions options{.margin = required_length("margin", margin)};
    result = on_pair(a, b, [&](const auto& in_a, const auto& in_b) { return c_result(manifold(in_a, in_b, options)); });
    return result.count > 0 ? GRAZE_OK : GRAZE_NONE;
  });
}

graze_status graze_shape_cast(const graze_shape* a, graze_vec motion, const graze_shape* b,
                              const graze_cast_options* options, graze_impact* out) {
  return guarded(__func__, [&] {
    graze_impact& result = required("out", out);
    CastOptions used;
    if (options != nullptr) {
      used.ignore_initial_touch = options->ignore_initial_touch;
      used.target_distance = required_length("options->target_distance", options->target_distance);
    }
    return on_pair(a, b, [&]<Dim N, class T>(const AnyShape<N, T>& in_a, const AnyShape<N, T>& in_b) {
      return write_answer(result, shape_cast(in_a, finite_in<N, T>("motion", motion), in_b, used));
    });
  });
}

graze_status graze_time_of_impact(const graze_shape* a, const graze_motion* motion_a, const graze_shape* b,
                                  const graze_motion* motion_b, graze_impact* out) {
  return guarded(__func__, [&] {
    graze_impact& result = required("out", out);
    return on_pair(a, b, [&]<Dim N, class T>(const AnyShape<N, T>& in_a, const AnyShape<N, T>& in_b) {
      const auto way_a = motion_in<N, T>("motion_a", motion_a);
      const auto way_b = motion_in<N, T>("motion_b", motion_b);
      return write_answer(result, time_of_impact(in_a, way_a, in_b, way_b));
    });
  });
}
