// SPDX-License-Identifier: MIT
// A 3D hit in float, written four numbers at a time. Include ray_cast.hpp.
#pragma once

#include <cstddef>
#include <cstring>
#include <optional>
#include <type_traits>

#include <graze/math/lanes/lanes.hpp>
#include <graze/query/ray_hit.hpp>

#ifdef GRAZE_HAS_LANES

namespace graze::detail {

/// From t, x, y, z, and from the normal and a zero. No number is minus zero.
[[gnu::always_inline]] inline std::optional<RayHit<3, float>> hit_of(Lanes t_and_point, Lanes normal, double error) {
  using Hit = RayHit<3, float>;
  static_assert(std::is_trivially_copyable_v<Hit> && std::is_standard_layout_v<Hit>);
  static_assert(offsetof(Hit, t) == 0 && offsetof(Hit, point) == 4 && offsetof(Hit, normal) == 16);
  static_assert(offsetof(Hit, status) == 28 && sizeof(Status) == 4 && static_cast<int>(Status::converged) == 0);
  std::optional<Hit> result(std::in_place);
  const Lanes numbers[2] = {t_and_point + 0.0F, normal + 0.0F};
  std::memcpy(reinterpret_cast<char*>(&*result), numbers, sizeof(numbers));
  result->error = error;
  return result;
}

}  // namespace graze::detail

#endif
