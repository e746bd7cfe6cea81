// SPDX-License-Identifier: MIT
// All overlapping pairs of many boxes: once from the input, or repeatedly from boxes in the module's memory. Also the
// exact test of many pairs of shapes.
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include <emscripten/bind.h>
#include <fmt/format.h>

#include <graze/broad/pairs.hpp>
#include <graze/broad/touching_pairs.hpp>
#include <graze/shape/any_shape.hpp>

#include "arguments.hpp"
#include "bridge.hpp"

namespace graze::wasm {
namespace {

// JavaScript accesses boxes as consecutive numbers, and pairs as 32-bit integers.
static_assert(sizeof(Aabb<2, float>) == 4 * sizeof(float) && sizeof(Aabb<3, double>) == 6 * sizeof(double));
static_assert(sizeof(Pair) == 2 * sizeof(std::uint32_t));

std::vector<Pair> found_at_once;

PairOptions options_of(bool sorted, double margin, const std::string& method) {
  const auto known = pair_method_named(method);
  if (!known) {
    std::string names;
    for (const PairMethod each : all_pair_methods()) {
      names += (names.empty() ? "\"" : ", \"") + std::string(name_of(each)) + '"';
    }
    throw std::invalid_argument("there is no method \"" + method + "\"; the methods are " + names);
  }
  return {nullptr, sorted ? PairOrder::sorted : PairOrder::any, margin, *known};
}

/// The options of a search.
struct Wanted {
  int dimension = 2;
  bool is_double = false;
  bool sorted = true;
  double margin = 0;
  std::string method = "automatic";
};

template <Dim N, class T>
std::span<const Aabb<N, T>> boxes_in_input(std::size_t first, std::size_t count) {
  const std::span<const T> numbers = input<T>((first + count) * 2 * static_cast<std::size_t>(N));
  return {reinterpret_cast<const Aabb<N, T>*>(numbers.data()) + first, count};
}

template <Dim N, class T>
std::vector<Pair> pairs_in_input(std::size_t count_a, double count_b, const PairOptions& options) {
  const auto boxes_a = boxes_in_input<N, T>(0, count_a);
  if (count_b < 0) return overlapping_pairs<N, T>(boxes_a, options);
  return overlapping_pairs<N, T>(boxes_a, boxes_in_input<N, T>(count_a, static_cast<std::size_t>(count_b)), options);
}

/// Finds the pairs of the boxes in the input, among `count_a` of them or, if `count_b` is not negative, between those
/// and the following `count_b`. Returns the number of pairs.
std::size_t overlapping_pairs_of(Wanted wanted, std::size_t count_a, double count_b) {
  found_at_once = {};
  const PairOptions options = options_of(wanted.sorted, wanted.margin, wanted.method);
  in_dimension(wanted.dimension, [&](auto n) {
    found_at_once = wanted.is_double ? pairs_in_input<n, double>(count_a, count_b, options)
                                     : pairs_in_input<n, float>(count_a, count_b, options);
  });
  return found_at_once.size();
}

/// The index of a shape given by JavaScript. Throws std::out_of_range like touching_pairs.
std::uint32_t place_of(double number, std::size_t shapes) {
  if (number >= 0 && number < static_cast<double>(shapes)) return static_cast<std::uint32_t>(number);
  throw std::out_of_range(fmt::format("candidates: there is no shape {}; there are {}", number, shapes));
}

/// Finds the touching pairs among the candidates, whose indexes are in the input; the argument is the list of shapes.
/// Returns the number of pairs.
std::size_t touching_pairs_of(int dimension, std::size_t place, std::size_t count) {
  found_at_once = {};
  in_dimension(dimension, [&](auto n) {
    const std::vector<AnyShape<n, double>> shapes = Arguments(place).shapes<n>();
    const std::span<const double> places = input<double>(2 * count);
    std::vector<Pair> candidates;
    candidates.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      candidates.push_back({place_of(places[2 * i], shapes.size()), place_of(places[2 * i + 1], shapes.size())});
    }
    found_at_once = touching_pairs<n, double>(shapes, candidates);
  });
  return found_at_once.size();
}

std::size_t pairs_address() { return reinterpret_cast<std::size_t>(found_at_once.data()); }
void release_pairs() { found_at_once = {}; }

template <Dim N, class T>
struct Finder {
  std::vector<Aabb<N, T>> boxes;
  PairFinder<N, T> finder;
  std::span<const Pair> pairs;
};

/// A PairFinder and its boxes.
class AnyPairFinder {
 public:
  AnyPairFinder(int dimension, bool is_double) {
    in_dimension(dimension, [&](auto n) {
      if (is_double) {
        finder_ = Finder<n, double>{};
      } else {
        finder_ = Finder<n, float>{};
      }
    });
  }

  void resize(std::size_t count) {
    std::visit(
        [count](auto& held) {
          using Box = typename std::decay_t<decltype(held.boxes)>::value_type;
          using Corner = decltype(Box::min);
          held.boxes.resize(count, Box{Corner(0), Corner(0)});
        },
        finder_);
  }

  std::size_t boxes_address() {
    return std::visit([](auto& held) { return reinterpret_cast<std::size_t>(held.boxes.data()); }, finder_);
  }

  std::size_t find(bool sorted, double margin, const std::string& method) {
    const PairOptions options = options_of(sorted, margin, method);
    return std::visit(
        [&options](auto& held) {
          held.pairs = held.finder.find(held.boxes, options);
          return held.pairs.size();
        },
        finder_);
  }

  std::size_t pairs_address() const {
    return std::visit([](const auto& held) { return reinterpret_cast<std::size_t>(held.pairs.data()); }, finder_);
  }

  std::string method() const {
    return std::string(name_of(std::visit([](const auto& held) { return held.finder.method(); }, finder_)));
  }

  std::size_t bytes() const {
    return std::visit([](const auto& held) { return held.finder.bytes(); }, finder_);
  }

 private:
  std::variant<Finder<2, float>, Finder<3, float>, Finder<2, double>, Finder<3, double>> finder_;
};

AnyPairFinder* make_finder(int dimension, bool is_double) {
  return std::make_unique<AnyPairFinder>(dimension, is_double).release();  // embind owns it
}
void resize(AnyPairFinder& finder, std::size_t count) { finder.resize(count); }
std::size_t find(AnyPairFinder& finder, bool sorted, double margin, std::string method) {
  return finder.find(sorted, margin, method);
}

}  // namespace

EMSCRIPTEN_BINDINGS(graze_pairs) {
  using namespace emscripten;  // NOLINT(google-build-using-namespace): as embind is written
  value_object<Wanted>("Wanted")
      .field("dimension", &Wanted::dimension)
      .field("isDouble", &Wanted::is_double)
      .field("sorted", &Wanted::sorted)
      .field("margin", &Wanted::margin)
      .field("method", &Wanted::method);
  function("overlappingPairs", &Guarded<&overlapping_pairs_of>::call);
  function("touchingPairs", &Guarded<&touching_pairs_of>::call);
  function("pairsAddress", &pairs_address);
  function("releasePairs", &release_pairs);
  class_<AnyPairFinder>("PairFinder")
      .class_function("make", &Guarded<&make_finder>::call, allow_raw_pointers())
      .function("resize", &Guarded<&resize>::call)
      .function("boxesAddress", &AnyPairFinder::boxes_address)
      .function("find", &Guarded<&find>::call)
      .function("pairsAddress", &AnyPairFinder::pairs_address)
      .function("method", &AnyPairFinder::method)
      .function("bytes", &AnyPairFinder::bytes);
}

}  // namespace graze::wasm
