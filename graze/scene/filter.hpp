// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace graze {

/// The index of a layer, 0 to 63.
using Layer = std::uint8_t;

/// The number of layers.
inline constexpr Layer max_layers = 64;

/// A set of layers: bit i stands for layer i.
using LayerMask = std::uint64_t;

/// The mask of all layers.
inline constexpr LayerMask all_layers = ~LayerMask{0};

/// The mask of one layer, which must be below `max_layers`.
constexpr LayerMask only_layer(Layer layer) { return LayerMask{1} << layer; }

/// True if each object's mask contains the other's layer. Other pairs are never tested.
constexpr bool filters_admit(Layer layer_a, LayerMask mask_a, Layer layer_b, LayerMask mask_b) {
  return (mask_a & only_layer(layer_b)) != 0 && (mask_b & only_layer(layer_a)) != 0;
}

}  // namespace graze
