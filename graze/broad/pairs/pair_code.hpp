// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include <graze/broad/pair.hpp>

namespace graze::detail {

/// A pair in a bucket of neighbouring first indices as one number: the row, which is the first index relative to the
/// bucket's lowest, in the bits above the second index. Numbers of one bucket sort like their pairs. The number type
/// Code is std::int32_t if 31 bits suffice, otherwise std::int64_t; signed, because vectors compare signed numbers
/// faster, but never negative.
struct PairCode {
  std::uint32_t row_bits = 0;
  std::uint32_t second_bits = 0;

  static constexpr std::uint32_t narrow_bits = 31;

  bool narrow() const { return row_bits + second_bits <= narrow_bits; }
  std::uint32_t rows() const { return 1U << row_bits; }
  std::size_t bucket_of(const Pair& pair) const { return pair.a >> row_bits; }

  template <class Code>
  Code of(const Pair& pair) const {
    if constexpr (sizeof(Code) == sizeof(std::uint32_t)) {
      return static_cast<Code>((pair.a & (rows() - 1)) << second_bits | pair.b);
    } else {
      return static_cast<Code>(std::uint64_t{pair.a & (rows() - 1)} << second_bits | pair.b);
    }
  }
  template <class Code>
  std::uint32_t row_of(Code code) const {
    return static_cast<std::uint32_t>(code >> second_bits);
  }
  template <class Code>
  std::uint32_t second_of(Code code) const {
    return static_cast<std::uint32_t>(code & ((Code{1} << second_bits) - 1));
  }

  friend bool operator==(const PairCode&, const PairCode&) = default;
};

}  // namespace graze::detail
