// SPDX-License-Identifier: MIT
// The results of fast contacts: find_fast_contact(a, b, turns), in spheres_and_capsules.hpp, sphere_box.hpp,
// capsule_box.hpp, sphere_2d.hpp, boxes_2d.hpp, half_space.hpp and sphere_triangle.hpp.
#pragma once

#include <cstddef>

#include <graze/math/vec.hpp>
#include <graze/query/cores/penetration.hpp>
#include <graze/query/patch/clipped.hpp>
#include <graze/query/patch/manifold_points.hpp>

namespace graze::detail {

/// The contact of two shapes, in cases that are easy to decide. The calculation takes the desired order as an argument:
/// swapping afterwards would copy the result, which takes longer than the calculation.
template <Dim N>
struct FastContact {
  bool is_known = false;   ///< If not, nothing else is valid.
  bool meets = false;      ///< If not, only the error is valid besides.
  bool is_single = false;  ///< Whether the manifold is only this point, on the features below.
  Penetration<N> found;
  Feature feature_a{FeatureKind::vertex, 0};
  Feature feature_b{FeatureKind::vertex, 0};

  /// Sets what was calculated from the first to the second shape given, or from the second to the first.
  [[gnu::always_inline]] void set(const Vec<N, double>& normal, double depth, const Vec<N, double>& on_first,
                                  const Vec<N, double>& on_second, bool turns) {
    found.normal = normal * (turns ? -1.0 : 1.0);
    found.depth = depth;
    found.point_a = turns ? on_second : on_first;
    found.point_b = turns ? on_first : on_second;
  }

  [[gnu::always_inline]] void set_features(const Feature& first, const Feature& second, bool turns) {
    feature_a = turns ? second : first;
    feature_b = turns ? first : second;
  }

  /// The points of the manifold, if they are known. Returns their number.
  [[gnu::always_inline]] std::size_t put_points(SurfacePair<N>* points) const {
    if (!is_single) return 0;
    points[0] = {found.point_a, found.point_b, found.depth, feature_a, feature_b};
    return 1;
  }
};

}  // namespace graze::detail
