// SPDX-License-Identifier: MIT
#include <graze/shape/hull/faces-inl.hpp>

namespace graze::detail {

template std::vector<HullTriangle> hull_faces(std::span<const Vec<3, float>>);
template std::vector<HullTriangle> hull_faces(std::span<const Vec<3, double>>);

}  // namespace graze::detail
