// SPDX-License-Identifier: MIT
// Keys of indexes and ids of scenes as Python's integers: the index in the lower 32 bits, the generation in the upper.
// The owner, by which C++ tells the keys of different containers apart, is left out, because it does not fit.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "arrays.hpp"

namespace graze::python {

/// For Key and ObjectId.
template <class Name>
std::uint64_t packed(const Name& name) {
  return std::uint64_t{name.generation} << 32U | name.index;
}

template <class Name>
Name unpacked(std::uint64_t number, std::uint32_t owner) {
  return {static_cast<std::uint32_t>(number), static_cast<std::uint32_t>(number >> 32U), owner};
}

/// Throws TypeError for what is not an integer, IndexError for one that cannot be a key.
std::uint64_t packed_of(Argument argument, py::handle value);

/// The same of an array or another sequence of integers.
std::vector<std::uint64_t> all_packed_of(Argument argument, py::handle value);

template <class Name>
py::array array_of_names(std::span<const Name> names) {
  std::vector<std::uint64_t> numbers;
  numbers.reserve(names.size());
  for (const Name& name : names) numbers.push_back(packed(name));
  return array_of<std::uint64_t>(std::move(numbers), 0);
}

/// Of pairs with the members a and b: two columns.
template <class NamePair>
py::array array_of_name_pairs(std::span<const NamePair> pairs) {
  std::vector<std::array<std::uint64_t, 2>> numbers;
  numbers.reserve(pairs.size());
  for (const NamePair& pair : pairs) numbers.push_back({packed(pair.a), packed(pair.b)});
  return array_of<std::uint64_t>(std::move(numbers), 2);
}

}  // namespace graze::python
