// SPDX-License-Identifier: MIT
// Quad trees, octrees and bounding volume hierarchies, in either dimension, as one class.
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include <emscripten/bind.h>

#include <graze/broad/bvh.hpp>
#include <graze/broad/orthtree.hpp>

#include "arguments.hpp"
#include "bridge.hpp"

namespace graze::wasm {
namespace {

using AnyIndex = std::variant<QuadTree<double>, Octree<double>, Bvh<2, double>, Bvh<3, double>>;

/// An index, and the owner of its keys, which JavaScript does not see.
struct Index {
  AnyIndex index;
  std::uint32_t owner = 0;

  Key key_of(double id) const {
    const UnpackedId unpacked = unpacked_id(id);
    return {unpacked.index, unpacked.generation, owner};
  }
};

template <class I>
constexpr Dim dimension_in = dimension_of<typename std::decay_t<I>::Box>;

void put_key(const Key& key) { answer().push_back(packed_id(key.index, key.generation)); }

Index* make_orthtree(int dimension, std::size_t capacity, int max_depth) {
  OrthtreeOptions options;
  if (capacity != 0) options.capacity = capacity;
  if (max_depth >= 0) options.max_depth = max_depth;
  return in_dimension(dimension, [&](auto n) {
    return std::make_unique<Index>(Index{Orthtree<n, double>(options)}).release();  // embind owns it
  });
}

Index* make_bvh(int dimension, double margin) {
  return in_dimension(dimension, [&](auto n) {
    return std::make_unique<Index>(Index{Bvh<n, double>(BvhOptions{margin})}).release();  // embind owns it
  });
}

/// Inserts the boxes of the input; the output contains their keys.
void insert(Index& self, std::size_t count) {
  std::visit(
      [&](auto& index) {
        constexpr Dim n = dimension_in<decltype(index)>;
        const auto numbers = input<double>(count * 2 * static_cast<std::size_t>(n));
        std::vector<Key> keys;
        try {
          for (std::size_t i = 0; i < count; ++i) keys.push_back(index.insert(box_at<n>(numbers, i)));
        } catch (...) {
          for (const Key& key : keys) index.erase(key);
          throw;
        }
        for (const Key& key : keys) put_key(key);
        if (!keys.empty()) self.owner = keys.front().owner;
      },
      self.index);
}

/// The input contains keys, then as many boxes.
void update(Index& self, std::size_t count) {
  std::visit(
      [&](auto& index) {
        constexpr Dim n = dimension_in<decltype(index)>;
        const auto numbers = input<double>(count * (1 + 2 * static_cast<std::size_t>(n)));
        const auto boxes = numbers.subspan(count);
        for (std::size_t i = 0; i < count; ++i) {  // so that nothing changes if one is refused
          index.box(self.key_of(numbers[i]));
          detail::require_box(box_at<n>(boxes, i));
        }
        for (std::size_t i = 0; i < count; ++i) index.update(self.key_of(numbers[i]), box_at<n>(boxes, i));
      },
      self.index);
}

void erase(Index& self, double key) {
  std::visit([&](auto& index) { index.erase(self.key_of(key)); }, self.index);
}

void clear(Index& self) {
  std::visit([](auto& index) { index.clear(); }, self.index);
}

std::size_t size(Index& self) {
  return std::visit([](const auto& index) { return index.size(); }, self.index);
}

bool contains_key(Index& self, double key) {
  return std::visit([&](const auto& index) { return index.contains(self.key_of(key)); }, self.index);
}

void box_of(Index& self, double key) {
  std::visit([&](const auto& index) { put<dimension_in<decltype(index)>>(index.box(self.key_of(key))); }, self.index);
}

void query(Index& self, std::size_t place) {
  std::visit(
      [&](const auto& index) {
        const auto visit_region = [&](const auto& shape) { index.query(shape, [](const Key& key) { put_key(key); }); };
        std::visit(visit_region, Arguments(place).shape<dimension_in<decltype(index)>>());
      },
      self.index);
}

void ray_cast_index(Index& self, std::size_t place) {
  std::visit(
      [&](const auto& index) {
        index.ray_cast(Arguments(place).ray<dimension_in<decltype(index)>>(), [](const Key& key, double t) {
          put_key(key);
          answer().push_back(t);
        });
      },
      self.index);
}

void nearest(Index& self, std::size_t place, std::size_t count) {
  std::visit(
      [&](const auto& index) {
        constexpr Dim n = dimension_in<decltype(index)>;
        const auto from = Arguments(place).vector<n>();
        for (const Neighbour& neighbour : index.nearest(from, count)) {
          put_key(neighbour.key);
          answer().push_back(neighbour.distance_squared);
        }
      },
      self.index);
}

void pairs(Index& self) {
  std::visit(
      [](const auto& index) {
        index.pairs([](const Key& a, const Key& b) {
          put_key(a);
          put_key(b);
        });
      },
      self.index);
}

/// For each cell its box, depth, count, and 1 for a leaf.
void cells(Index& self) {
  std::visit(
      [](const auto& index) {
        constexpr Dim n = dimension_in<decltype(index)>;
        index.visit_cells([](const auto& cell) {
          put<n>(cell.box);
          answer().push_back(cell.depth);
          answer().push_back(static_cast<double>(cell.count));
          answer().push_back(cell.is_leaf ? 1 : 0);
        });
      },
      self.index);
}

}  // namespace

EMSCRIPTEN_BINDINGS(graze_indexes) {
  using namespace emscripten;  // NOLINT(google-build-using-namespace): as embind is written
  class_<Index>("Index")
      .class_function("makeOrthtree", &Guarded<&make_orthtree>::call, allow_raw_pointers())
      .class_function("makeBvh", &Guarded<&make_bvh>::call, allow_raw_pointers())
      .function("insert", &Guarded<&insert>::call)
      .function("update", &Guarded<&update>::call)
      .function("erase", &Guarded<&erase>::call)
      .function("clear", &Guarded<&clear>::call)
      .function("size", &Guarded<&size>::call)
      .function("contains", &Guarded<&contains_key>::call)
      .function("box", &Guarded<&box_of>::call)
      .function("query", &Guarded<&query>::call)
      .function("rayCast", &Guarded<&ray_cast_index>::call)
      .function("nearest", &Guarded<&nearest>::call)
      .function("pairs", &Guarded<&pairs>::call)
      .function("cells", &Guarded<&cells>::call);
}

}  // namespace graze::wasm
