// SPDX-License-Identifier: MIT
// Shapes compared bit by bit: 0.0 and -0.0 differ.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/description.hpp>
#include <graze/shape/fields/visit.hpp>

#include "catalogue.hpp"

namespace graze::io {

/// The bits of a shape's type and of all its numbers, in order: two shapes are identical if and only if these are
/// equal.
using Bits = std::vector<std::uint64_t>;

inline void append_bits(Bits& bits, double number) { bits.push_back(std::bit_cast<std::uint64_t>(number)); }

template <Dim N>
void append_bits(Bits& bits, const Vec<N, double>& vector) {
  for (Dim i = 0; i < N; ++i) append_bits(bits, vector[i]);
}

template <Dim N>
void append_bits(Bits& bits, const Mat<N, double>& matrix) {
  for (Dim i = 0; i < N; ++i) append_bits<N>(bits, matrix[i]);
}

template <template <Dim, class> class S, Dim N>
void append_bits(Bits& bits, const S<N, double>& shape) {
  detail::for_each_field(shape, [&bits](const auto&, const auto& value) { append_bits(bits, value); });
}

template <Dim N>
void append_bits(Bits& bits, const Polytope<N, double>& polytope) {
  for (const Vec<N, double>& vertex : polytope.vertices()) append_bits<N>(bits, vertex);
}

template <Dim N>
void append_bits(Bits& bits, const Mesh<N, double>& mesh) {
  for (const Vec<N, double>& vertex : mesh.vertices()) append_bits<N>(bits, vertex);
  for (const std::array<std::uint32_t, 3>& face : mesh.faces()) bits.insert(bits.end(), face.begin(), face.end());
  bits.push_back(static_cast<std::uint64_t>(mesh.kind()));
}

template <Dim N>
Bits bits_of(const AnyShape<N, double>& shape);

template <Dim N>
void append_bits(Bits& bits, const Compound<N, double>& compound) {
  bits.push_back(compound.parts.size());
  for (const Part<N, double>& part : compound.parts) {
    const Bits part_bits = bits_of<N>(part.shape);
    bits.insert(bits.end(), part_bits.begin(), part_bits.end());
    append_bits(bits, part.box);
  }
}

template <Dim N>
Bits bits_of(const AnyShape<N, double>& shape) {
  Bits bits = {shape.index()};
  detail::visit([&bits](const auto& held) { append_bits(bits, held); }, shape);
  return bits;
}

}  // namespace graze::io
