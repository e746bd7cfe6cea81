// SPDX-License-Identifier: MIT
// The results of the exam: counts, shares and largest errors by name, which data_file.hpp writes.
#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <type_traits>

#include <graze/math/vec.hpp>

namespace graze::exam {

/// One of the four spaces.
struct SpaceName {
  int dimension;
  std::string_view scalar;  ///< "float" or "double".
};

template <Dim N, class T>
constexpr SpaceName space_name() {
  return {static_cast<int>(N), std::is_same_v<T, float> ? "float" : "double"};
}

/// "3D float".
inline std::string label(const SpaceName& space) {
  return std::to_string(space.dimension) + "D " + std::string(space.scalar);
}

/// How a largest error is reported: one for all spaces, one each for float and double, or one for each space.
enum class By { all, scalar, space };

/// Figures of the same cases. Each is added in every case, even if it is zero, so that all subjects have the same ones.
struct Figures {
  struct Share {
    std::size_t part = 0;
    std::size_t whole = 0;

    void add(const Share& other) {
      part += other.part;
      whole += other.whole;
    }
  };
  struct Largest {
    double value = 0;
    By by = By::all;
  };

  std::size_t cases = 0;
  std::map<std::string_view, std::size_t> counts;
  std::map<std::string_view, Share> shares;         ///< Reported as part / whole.
  std::map<std::string_view, Share> wrong_of_kind;  ///< By kind of case; reported for all subjects together.
  std::map<std::string_view, Largest> largest;

  void count(std::string_view name, std::size_t number) { counts[name] += number; }

  void share(std::string_view name, std::size_t part, std::size_t whole = 1) { shares[name].add({part, whole}); }

  void keep(std::string_view name, double error, By by = By::all) {
    Largest& kept = largest[name];
    kept = {std::max(kept.value, error), by};
  }

  Figures& operator+=(const Figures& other) {
    cases += other.cases;
    for (const auto& [name, number] : other.counts) count(name, number);
    for (const auto& [name, share] : other.shares) shares[name].add(share);
    for (const auto& [kind, share] : other.wrong_of_kind) wrong_of_kind[kind].add(share);
    for (const auto& [name, kept] : other.largest) keep(name, kept.value, kept.by);
    return *this;
  }
};

/// The answers to one question about one subject, such as a pair of types, in one space.
struct Tally {
  std::string_view question;
  SpaceName space{};
  std::string subject;
  Figures own;  ///< graze's answers to all cases.
  std::map<std::string_view, Figures>
      programs;  ///< All answers to the cases passed to rivals, by name, graze's among them.
};

}  // namespace graze::exam
