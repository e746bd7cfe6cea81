// SPDX-License-Identifier: MIT
// Interprets a fuzzer's bytes. Every sequence of bytes is a case, and small changes give similar cases.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <string>

#include <graze/math/vec.hpp>

#include "catalogue/nasty.hpp"

namespace graze::test::fuzz {

/// Reads bytes from the front; zeros after the end.
class Input {
 public:
  Input(const std::uint8_t* data, std::size_t size) : bytes_(data, size) {}

  bool is_empty() const { return bytes_.empty(); }

  std::uint8_t byte() {
    if (bytes_.empty()) return 0;
    const std::uint8_t first = bytes_.front();
    bytes_ = bytes_.subspan(1);
    return first;
  }

  /// 0 to 255 of them.
  std::size_t below(std::size_t count) { return byte() % count; }

  /// -128 to 127.
  int whole() { return static_cast<std::int8_t>(byte()); }

  /// Usually a multiple of an eighth from -10 to 10, so that things touch; such a number moved by some ulp; one of any
  /// magnitude; an invalid one; any bits.
  template <class T>
  T number() {
    const T drawn = any_number<T>();
    const double size = std::fabs(static_cast<double>(drawn));
    is_in_range_ = is_in_range_ && (size == 0 || (size >= 1e-140 && size <= 1e140));
    return drawn;
  }

  /// Whether all numbers were in the range for which the queries guarantee results (query/relation.hpp).
  bool is_in_range() const { return is_in_range_; }

  template <Dim N, class T>
  Vec<N, T> vec() {
    Vec<N, T> result;
    for (Dim i = 0; i < N; ++i) result[i] = number<T>();
    return result;
  }

  /// The rest, as text.
  std::string rest() {
    std::string text(bytes_.begin(), bytes_.end());
    bytes_ = {};
    return text;
  }

 private:
  template <class T>
  T any_number() {
    const std::uint8_t kind = byte();
    if (kind < 160) return static_cast<T>((kind - 80) / 8.0);
    if (kind < 200) return stepped(static_cast<T>(whole() / 8.0), kind - 180);
    if (kind < 236) return static_cast<T>(std::ldexp(whole() / 64.0, kind - 218));
    if (kind < 250) return nasty_values<T>[below(nasty_values<T>.size())];
    T any;
    std::uint8_t bytes[sizeof any];
    for (std::uint8_t& each : bytes) each = byte();
    std::memcpy(&any, bytes, sizeof any);
    return any;
  }

  template <class T>
  static T stepped(T number, int steps) {
    const T way = steps < 0 ? std::numeric_limits<T>::lowest() : std::numeric_limits<T>::max();
    for (int k = 0; k < std::abs(steps); ++k) number = std::nextafter(number, way);
    return number;
  }

  std::span<const std::uint8_t> bytes_;
  bool is_in_range_ = true;
};

}  // namespace graze::test::fuzz
