// SPDX-License-Identifier: MIT
// Cheap variations of a difficult case, each a case of its own: numbers changed by a few ulp or by many, one shape
// moved by as little, both mirrored. A case that just touches has many that just do not.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <utility>
#include <variant>
#include <vector>

#include <graze/math/vec.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/shape.hpp>

#include "catalogue.hpp"
#include "query/numbers_of.hpp"
#include "query/placement.hpp"

namespace graze::test {

template <Dim N, class T>
class CaseVariations {
 public:
  using Any = AnyShape<N, T>;
  using Pair = AnyPair<N, T>;

  explicit CaseVariations(std::uint64_t seed) : random_(seed) {}

  /// One or two changes; the case itself if they would make a shape invalid.
  Pair vary(const Pair& base) {
    Pair varied = base;
    const std::size_t changes = 1 + below(2);
    for (std::size_t i = 0; i < changes; ++i) change(varied);
    return is_valid(varied.first) && is_valid(varied.second) ? varied : base;
  }

 private:
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(random_() % count); }

  /// Of eight changes, five nudge a number, two move a shape, one mirrors both.
  void change(Pair& pair) {
    const std::size_t choice = below(8);
    Any& either = below(2) == 0 ? pair.first : pair.second;
    if (choice < 5) {
      nudge(either);
    } else if (choice < 7) {
      Vec<N, T> offset;
      const double size = std::max(size_of<N, T>(pair), 1e-30);
      for (Dim i = 0; i < N; ++i) offset[i] = below(2) == 0 ? T(0) : few_ulp(static_cast<T>(size));
      either = moved<N, T>(either, offset);
    } else {
      mirror(pair);
    }
  }

  /// One to thirty-two ulp up or down; in one case of three up to almost the number itself.
  T few_ulp(T x) {
    constexpr int digits = std::numeric_limits<T>::digits;
    const auto exponent = static_cast<int>(below(3) == 0 ? below(digits - 3) : below(6));
    int of_x = 1;  // zero is off by ulp of one
    if (x != T(0)) std::frexp(x, &of_x);
    const T step = std::ldexp(T(1), of_x - digits + exponent);
    return below(2) == 0 ? step : -step;
  }

  void nudge(Any& shape) {
    if (std::holds_alternative<Polytope<N, T>>(shape) || std::holds_alternative<Mesh<N, T>>(shape)) {
      nudge_chosen(shape, [](Any& any, const auto& visit) {
        for_each_vector<N, T>(any, [&visit](Vec<N, T>& v) {
          for (Dim i = 0; i < N; ++i) visit(v[i]);
        });
      });
    } else if (const auto* compound = std::get_if<Compound<N, T>>(&shape)) {
      std::vector<Any> parts;
      for (const Part<N, T>& part : compound->parts) parts.push_back(part.shape);
      if (parts.empty()) return;
      nudge(parts[below(parts.size())]);
      shape = compound_of<N, T>(std::move(parts));
    } else {
      nudge_chosen(shape, [](Any& any, const auto& visit) { for_each_number<N, T>(any, visit); });
    }
  }

  template <class ForEach>
  void nudge_chosen(Any& shape, const ForEach& for_each) {
    std::size_t count = 0;
    for_each(shape, [&count](T&) { ++count; });
    std::size_t left = below(count);
    for_each(shape, [&](T& x) {
      if (left-- == 0) x += few_ulp(x);
    });
  }

  void mirror(Pair& pair) {
    const auto axis = static_cast<Dim>(below(static_cast<std::size_t>(N)));
    for (Any* shape : {&pair.first, &pair.second}) {
      for_each_vector<N, T>(*shape, [axis](Vec<N, T>& v) { v[axis] = T(0) - v[axis]; });
    }
  }

  std::mt19937_64 random_;
};

}  // namespace graze::test
