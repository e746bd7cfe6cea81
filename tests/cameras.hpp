// SPDX-License-Identifier: MIT
// Frustums of cameras, for tests.
#pragma once

#include <ostream>
#include <string>

#include <rapidcheck.h>

#include <graze/math/vec.hpp>
#include <graze/shape/frustum.hpp>

#include "catalogue.hpp"

namespace graze::test {

/// A frustum with parallel near and far faces, of a camera with or without perspective, corners rounded to T. It may be
/// flat, or a pyramid.
template <Dim N, class T>
Frustum<N, T> any_frustum(const Source<N, T>& from) {
  const Mat<N, double> axes = wide_matrix<N, T>(*any_rotation<N, T>());
  const Vec<N, double> eye = wide<N, T>(*from.point);
  const double depth = static_cast<double>(*from.size);
  const double near_part = *rc::gen::element(0.0, 0.01, 0.5, 1.0);
  const bool has_perspective = *rc::gen::arbitrary<bool>();
  Vec<N, double> slope(1.0);  // of the sides, per unit of depth
  for (Dim i = 0; i + 1 < N; ++i) slope[i] = *rc::gen::element(0.0, 0.3, 1.0, 2.5);
  Frustum<N, T> frustum;
  for (std::size_t k = 0; k < frustum.corners.size(); ++k) {
    const bool is_far = k >= frustum.corners.size() / 2;
    Vec<N, double> local = slope * (depth * (is_far || !has_perspective ? 1.0 : near_part));
    local[N - 1] = depth * (is_far ? 1.0 : near_part);
    for (Dim i = 0; i + 1 < N; ++i) local[i] *= ((k >> static_cast<unsigned>(i)) & 1U) != 0 ? 1 : -1;
    frustum.corners[k] = Vec<N, T>(eye + axes * local);
  }
  return frustum;
}

/// The hull of any eight points, in 2D of four: the frustum of no camera.
template <Dim N, class T>
Frustum<N, T> any_odd_frustum(const Source<N, T>& from) {
  Frustum<N, T> frustum;
  for (Vec<N, T>& corner : frustum.corners) corner = *from.point;
  return frustum;
}

template <Dim N, class T>
std::string to_source(const Frustum<N, T>& frustum) {
  std::string corners;
  for (const Vec<N, T>& corner : frustum.corners) corners += (corners.empty() ? "" : ", ") + initializer(corner);
  return type_source<N, T>("Frustum") + "{{{" + corners + "}}}";
}

}  // namespace graze::test
