// SPDX-License-Identifier: MIT
#include <graze/shape/hull/vertices-inl.hpp>

namespace graze::detail {

template std::vector<std::uint32_t> hull_vertices(std::span<const Vec<3, float>>);
template std::vector<std::uint32_t> hull_vertices(std::span<const Vec<3, double>>);

}  // namespace graze::detail
