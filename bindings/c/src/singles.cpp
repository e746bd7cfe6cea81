// SPDX-License-Identifier: MIT
// Questions about one shape.
#include <graze/query/bounds.hpp>
#include <graze/query/closest_boundary_point.hpp>
#include <graze/query/closest_point.hpp>
#include <graze/query/contains.hpp>
#include <graze/query/mass_properties.hpp>
#include <graze/query/signed_distance.hpp>

#include "rays.hpp"
#include "results.hpp"
#include "shape_in.hpp"
#include "vectors.hpp"

using namespace graze;
using namespace graze::c;

graze_status graze_contains(const graze_shape* shape, graze_vec point, bool* out) {
  return guarded(__func__, [&] {
    bool& result = required("out", out);
    result = on_shape("shape", shape, [&]<Dim N, class T>(const AnyShape<N, T>& in) {
      return contains(in, finite_in<N, T>("point", point));
    });
  });
}

graze_status graze_closest_point(const graze_shape* shape, graze_vec point, graze_vec* out) {
  return guarded(__func__, [&] {
    graze_vec& result = required("out", out);
    result = on_shape("shape", shape, [&]<Dim N, class T>(const AnyShape<N, T>& in) {
      return vec_out<N, T>(closest_point(in, finite_in<N, T>("point", point)));
    });
  });
}

graze_status graze_closest_boundary_point(const graze_shape* shape, graze_vec point, graze_vec* out) {
  return guarded(__func__, [&] {
    graze_vec& result = required("out", out);
    result = on_shape("shape", shape, [&]<Dim N, class T>(const AnyShape<N, T>& in) {
      return vec_out<N, T>(closest_boundary_point(in, finite_in<N, T>("point", point)));
    });
  });
}

graze_status graze_signed_distance(const graze_shape* shape, graze_vec point, double* out) {
  return guarded(__func__, [&] {
    double& result = required("out", out);
    result = on_shape("shape", shape, [&]<Dim N, class T>(const AnyShape<N, T>& in) -> double {
      return signed_distance(in, finite_in<N, T>("point", point));
    });
  });
}

graze_status graze_ray_cast(const graze_shape* shape, const graze_ray* ray, const graze_ray_options* options,
                            graze_ray_hit* out) {
  return guarded(__func__, [&] {
    const graze_ray& given = required("ray", ray);
    graze_ray_hit& result = required("out", out);
    const auto hit = on_shape("shape", shape, [&]<Dim N, class T>(const AnyShape<N, T>& in) {
      return hit_of(in, ray_in<N, T>("ray", given), limit_in<T>(options), ray_options_in(options));
    });
    result = hit.value_or(graze_ray_hit{});
    return hit ? GRAZE_OK : GRAZE_NONE;
  });
}

graze_status graze_bounds(const graze_shape* shape, graze_box* out) {
  return guarded(__func__, [&] {
    graze_box& result = required("out", out);
    result = on_shape("shape", shape, [](const auto& in) { return c_result(bounds(in)); });
  });
}

graze_status graze_mass_properties(const graze_shape* shape, graze_mass* out) {
  return guarded(__func__, [&] {
    graze_mass& result = required("out", out);
    result = on_shape("shape", shape, [](const auto& in) { return c_result(mass_properties(in)); });
  });
}
