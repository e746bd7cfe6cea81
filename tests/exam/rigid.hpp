// SPDX-License-Identifier: MIT
// Which oriented boxes mean the same to graze and to its rivals.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include <graze/math/vec.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze::exam {

/// Whether a rival means the same set by it: an oriented box whose axes are orthonormal up to 4 epsilon. graze takes
/// the stored axes as exact.
template <class T>
bool is_rigid(const AnyShape<3, T>& shape) {
  const auto* box = std::get_if<Obb<3, T>>(&shape);
  if (box == nullptr) return true;
  const Mat<3, double> axes = wide_matrix<3, T>(box->axes);
  double orthonormality_error = 0;
  for (Dim i = 0; i < 3; ++i) {
    for (Dim j = 0; j < 3; ++j)
      orthonormality_error = std::max(orthonormality_error, std::fabs(dot(axes[i], axes[j]) - (i == j ? 1 : 0)));
  }
  return orthonormality_error <= 4 * static_cast<double>(std::numeric_limits<T>::epsilon());
}

}  // namespace graze::exam
