// SPDX-License-Identifier: MIT
// Finds errors of mass_properties(shape), for shapes that are hulls of a few corners, by comparison with rational
// numbers.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include <graze/math/vec.hpp>
#include <graze/query/mass_properties.hpp>
#include <graze/shape/any_shape.hpp>

#include "exact/moments.hpp"
#include "exact/numbers.hpp"
#include "exact/parting.hpp"
#include "query/placement.hpp"

namespace graze::test {

/// The tolerance of mass_properties, relative to a box as large as the shape, or as far from the origin.
inline constexpr double most_off_of_mass = 1e-14;

inline double off_from(double answer, const Rational& truth) {
  if (!std::isfinite(answer)) return std::numeric_limits<double>::infinity();
  return std::fabs(to_double(exact(answer) - truth));
}

/// About the centroid: in 2D the trace of the second moments, in 3D the trace minus the moments themselves.
inline double inertia_error(const Inertia<2>& inertia, const ExactMass<2>& truth) {
  return off_from(inertia, truth.second[0][0] + truth.second[1][1]);
}

inline double inertia_error(const Inertia<3>& inertia, const ExactMass<3>& truth) {
  const Rational trace = truth.second[0][0] + truth.second[1][1] + truth.second[2][2];
  double worst = 0;
  for (Dim i = 0; i < 3; ++i) {
    for (Dim j = 0; j < 3; ++j) {
      const Rational product = truth.second[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
      worst = std::max(worst, off_from(inertia[i][j], i == j ? Rational(trace - product) : Rational(-product)));
    }
  }
  return worst;
}

/// The errors of one answer, relative to a box as large as the shape, or as far from the origin.
struct MassErrors {
  double true_volume = 0;
  double volume = 0;
  double centroid = 0;  ///< Times the volume.
  double inertia = 0;

  bool are_within_bounds() const {
    return volume <= most_off_of_mass && centroid <= most_off_of_mass && inertia <= most_off_of_mass;
  }
};

/// For a shape that is the hull of its corners.
template <Dim N, class T>
MassErrors mass_errors(const AnyShape<N, T>& shape) {
  const double size = 2 * size_of<N, T>({shape, shape});
  const ExactMass<N> truth = exact_mass<N>(bounded_solid<N, T>(shape)->corners);
  MassErrors errors;
  errors.true_volume = to_double(truth.volume);
  if (!(size > 0)) return errors;
  const MassProperties<N> answer = mass_properties(shape);
  const double box = std::pow(size, static_cast<double>(N));
  errors.volume = off_from(answer.volume, truth.volume) / box;
  if (truth.volume == 0) return errors;
  for (Dim i = 0; i < N; ++i) {
    const double error = off_from(answer.centroid[i], truth.centroid[static_cast<std::size_t>(i)]);
    errors.centroid = std::max(errors.centroid, error * errors.true_volume / (box * size));
  }
  errors.inertia = inertia_error(answer.inertia, truth) / (box * size * size);
  return errors;
}

}  // namespace graze::test
