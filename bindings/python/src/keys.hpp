// SPDX-License-Identifier: MIT
// Keys of indexes and ids of scenes as Python's integers: the index in the lower 32 bits, above it the generation. Of
// the owner, by which C++ tells the keys of different containers apart, there is room for 15 bits: they change the
// upper half of the generation, which few programs reach. A foreign key therefore looks like one of a generation that
// never was.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "arrays.hpp"

namespace graze::python {

/// A generation as a key has it, and back. The sign bit of the key stays free, because NumPy makes floats of a list in
/// which only some integers need it.
constexpr std::uint32_t marked(std::uint32_t generation, std::uint32_t owner) {
  return generation ^ ((owner & 0x7fffU) << 16U);
}

/// For Key and ObjectId.
template <class Name>
std::uint64_t packed(const Name& name) {
  return std::uint64_t{marked(name.generation, name.owner)} << 32U | name.index;
}

template <class Name>
Name unpacked(std::uint64_t number, std::uint32_t owner) {
  return {static_cast<std::uint32_t>(number), marked(static_cast<std::uint32_t>(number >> 32U), owner), owner};
}

/// Throws TypeError for what is not an integer, IndexError for one that cannot be a key.
std::uint64_t packed_of(Argument argument, py::handle value);

/// The same, but none for an integer that cannot be a key.
std::optional<std::uint64_t> packed_if_possible(Argument argument, py::handle value);

/// The same of an array of uint64, which it keeps, or of another sequence of integers.
class PackedNumbers {
 public:
  PackedNumbers(Argument argument, py::handle value);
  PackedNumbers(const PackedNumbers&) = delete;
  PackedNumbers& operator=(const PackedNumbers&) = delete;

  std::size_t size() const { return numbers_.size(); }
  std::uint64_t operator[](std::size_t i) const { return numbers_[i]; }

  /// The names, of a container.
  template <class Name>
  std::vector<Name> names(std::uint32_t owner) const {
    std::vector<Name> result;
    result.reserve(size());
    for (const std::uint64_t number : numbers_) result.push_back(unpacked<Name>(number, owner));
    return result;
  }

 private:
  py::object array_;
  std::vector<std::uint64_t> copied_;
  std::span<const std::uint64_t> numbers_;
};

template <class Name>
py::array array_of_names(std::span<const Name> names) {
  std::vector<std::uint64_t> numbers;
  numbers.reserve(names.size());
  for (const Name& name : names) numbers.push_back(packed(name));
  return array_of<std::uint64_t>(std::move(numbers), 0);
}

using PackedPair = std::array<std::uint64_t, 2>;

/// Of pairs with the members a and b.
template <class NamePair>
NewRows<PackedPair> packed_pairs(std::span<const NamePair> pairs) {
  NewRows<PackedPair> numbers(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) numbers[i] = {packed(pairs[i].a), packed(pairs[i].b)};
  return numbers;
}

/// Two columns.
template <class NamePair>
py::array array_of_name_pairs(std::span<const NamePair> pairs) {
  return array_of<std::uint64_t>(packed_pairs(pairs), 2);
}

}  // namespace graze::python
