// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <type_traits>
#include <variant>

#include <graze/math/platform/throw.hpp>

namespace graze::detail {

/// std::visit for one variant of at most sixteen types: calls `visitor` with the held value and returns its result,
/// which must have the same type for all alternatives. The standard library builds a table of function pointers through
/// four layers of templates for each type. A query on any two shapes has 144 combinations, and these templates took a
/// quarter of its compile time. A switch can also be inlined.
/// @throws std::bad_variant_access if the variant is valueless after an exception
template <class Visitor, class Variant>
// NOLINTNEXTLINE(readability-function-size): a case for each type
constexpr decltype(auto) visit(Visitor&& visitor, Variant& held) {
  constexpr std::size_t types = std::variant_size_v<std::remove_const_t<Variant>>;
  static_assert(types <= 16, "visit in graze/shape/fields/visit.hpp has a case for each of sixteen types: add some");
  switch (held.index()) {
    case 0:
      if constexpr (0 < types) return visitor(*std::get_if<0>(&held));
      break;
    case 1:
      if constexpr (1 < types) return visitor(*std::get_if<1>(&held));
      break;
    case 2:
      if constexpr (2 < types) return visitor(*std::get_if<2>(&held));
      break;
    case 3:
      if constexpr (3 < types) return visitor(*std::get_if<3>(&held));
      break;
    case 4:
      if constexpr (4 < types) return visitor(*std::get_if<4>(&held));
      break;
    case 5:
      if constexpr (5 < types) return visitor(*std::get_if<5>(&held));
      break;
    case 6:
      if constexpr (6 < types) return visitor(*std::get_if<6>(&held));
      break;
    case 7:
      if constexpr (7 < types) return visitor(*std::get_if<7>(&held));
      break;
    case 8:
      if constexpr (8 < types) return visitor(*std::get_if<8>(&held));
      break;
    case 9:
      if constexpr (9 < types) return visitor(*std::get_if<9>(&held));
      break;
    case 10:
      if constexpr (10 < types) return visitor(*std::get_if<10>(&held));
      break;
    case 11:
      if constexpr (11 < types) return visitor(*std::get_if<11>(&held));
      break;
    case 12:
      if constexpr (12 < types) return visitor(*std::get_if<12>(&held));
      break;
    case 13:
      if constexpr (13 < types) return visitor(*std::get_if<13>(&held));
      break;
    case 14:
      if constexpr (14 < types) return visitor(*std::get_if<14>(&held));
      break;
    case 15:
      if constexpr (15 < types) return visitor(*std::get_if<15>(&held));
      break;
    default:
      break;
  }
  GRAZE_THROW(std::bad_variant_access());
}

/// The same for two variants: calls visitor(value of a, value of b).
template <class Visitor, class VariantA, class VariantB>
constexpr decltype(auto) visit(Visitor&& visitor, VariantA& a, VariantB& b) {
  return visit(
      [&](auto& in_a) -> decltype(auto) {
        return visit([&](auto& in_b) -> decltype(auto) { return visitor(in_a, in_b); }, b);
      },
      a);
}

}  // namespace graze::detail
