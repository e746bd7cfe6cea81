// SPDX-License-Identifier: MIT
// Numbers in the mesh formats that are bytes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>

#include <graze/math/platform/bit_cast.hpp>

namespace graze::io {

/// Which byte of a number comes first.
enum class ByteOrder { little, big };

/// The unsigned integer of a size.
template <std::size_t Size>
using BitsOfSize = std::conditional_t<
    Size == 1, std::uint8_t,
    std::conditional_t<Size == 2, std::uint16_t, std::conditional_t<Size == 4, std::uint32_t, std::uint64_t>>>;

/// The number stored in the first sizeof(Number) bytes; the caller makes sure that they are there.
template <class Number>
Number number_at(const char* bytes, ByteOrder order = ByteOrder::little) {
  using Bits = BitsOfSize<sizeof(Number)>;
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < sizeof(Number); ++i) {
    const std::size_t place = order == ByteOrder::little ? i : sizeof(Number) - 1 - i;
    bits |= std::uint64_t{static_cast<unsigned char>(bytes[i])} << (8 * place);
  }
  return bit_cast<Number>(static_cast<Bits>(bits));
}

/// Appends the bytes of a number, the least significant first.
template <class Number>
void append_number(std::string& out, Number number) {
  const std::uint64_t bits = bit_cast<BitsOfSize<sizeof(Number)>>(number);
  for (std::size_t i = 0; i < sizeof(Number); ++i)
    out += static_cast<char>(static_cast<unsigned char>(bits >> (8 * i)));
}

}  // namespace graze::io
