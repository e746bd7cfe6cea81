// SPDX-License-Identifier: MIT
// The answers that bench/contact.cpp compares, and its shapes.
#pragma once

#include <cstddef>

#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/capsule.hpp>
#include <graze/shape/obb.hpp>
#include <graze/shape/sphere.hpp>

namespace graze::contact_bench {

using Point = Vec<3, double>;
using Sphere = graze::Sphere<3, double>;
using Aabb = graze::Aabb<3, double>;
using Obb = graze::Obb<3, double>;
using Capsule = graze::Capsule<3, double>;

/// The number of contacts, and the depth of the deepest.
struct Answer {
  std::size_t count = 0;
  double depth = 0;
};

}  // namespace graze::contact_bench
