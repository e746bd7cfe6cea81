// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <stdexcept>
#include <string>

#include <graze/math/platform/throw.hpp>
#include <graze/scene/filter.hpp>

namespace graze {

/// A symmetric table of which layers can touch each other; initially all can. An object obeys it through the mask of
/// its layer:
///
///     scene.add(shape, {.layer = enemy, .mask = matrix.mask_of(enemy)});
///
/// All functions throw std::out_of_range, naming the layer, for a layer that is not below `max_layers`.
class FilterMatrix {
 public:
  FilterMatrix() { rows_.fill(all_layers); }

  /// Lets the objects of two layers, or within one, touch each other.
  void join(Layer a, Layer b) {
    require(a, b);
    rows_[a] |= only_layer(b);
    rows_[b] |= only_layer(a);
  }

  /// Lets the objects of two layers, or within one, pass through each other.
  void part(Layer a, Layer b) {
    require(a, b);
    rows_[a] &= ~only_layer(b);
    rows_[b] &= ~only_layer(a);
  }

  /// True if objects of these layers can touch. Symmetric.
  bool can_touch(Layer a, Layer b) const {
    require(a, b);
    return (rows_[a] & only_layer(b)) != 0;
  }

  /// The mask of all layers that objects of this layer can touch.
  LayerMask mask_of(Layer layer) const {
    require(layer, layer);
    return rows_[layer];
  }

  friend bool operator==(const FilterMatrix&, const FilterMatrix&) = default;

 private:
  static void require(Layer a, Layer b) {
    const Layer larger = a < b ? b : a;
    if (larger < max_layers) return;
    GRAZE_THROW(std::out_of_range("FilterMatrix: there is no layer " + std::to_string(larger) +
                                  "; layers are numbered 0 to " + std::to_string(max_layers - 1)));
  }

  std::array<LayerMask, max_layers> rows_;
};

}  // namespace graze
