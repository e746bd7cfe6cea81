// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include <graze/io/report/summary.hpp>
#include <graze/scene/scene.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/hull/lexicographic.hpp>
#include <graze/shape/welded.hpp>

namespace graze::io {
namespace {

template <Dim N>
std::vector<Count> types_of(const Scene<N, double>& scene) {
  std::array<std::size_t, shape_type_names.size()> counts{};
  for (const ObjectId id : scene.ids()) ++counts[scene.object(id).shape.index()];
  std::vector<Count> types;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] != 0) types.push_back({std::string(shape_type_names[i]), counts[i]});
  }
  return types;
}

template <Dim N>
std::vector<Count> layers_of(const Scene<N, double>& scene) {
  std::array<std::size_t, max_layers> counts{};
  for (const ObjectId id : scene.ids()) ++counts[scene.object(id).layer];
  const std::vector<std::string>& names = scene.layer_names();
  std::vector<Count> layers;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const bool is_named = i < names.size() && !names[i].empty();
    if (is_named || counts[i] != 0) layers.push_back({is_named ? names[i] : fmt::format("layer {}", i), counts[i]});
  }
  return layers;
}

template <Dim N>
double size_of(const Aabb<N, double>& box) {
  double largest = 0;
  for (Dim i = 0; i < N; ++i) largest = std::max(largest, box.max[i] - box.min[i]);
  return std::min(largest, std::numeric_limits<double>::max());
}

template <Dim N>
Extent extent_of(const Aabb<N, double>& box) {
  Extent extent;
  for (Dim i = 0; i < N; ++i) {
    extent.min.push_back(box.min[i]);
    extent.max.push_back(box.max[i]);
  }
  return extent;
}

/// Bins whose edges are powers of two; each bin spans as many octaves as needed so that at most eleven bins hold the
/// sizes above zero. `sizes` are ascending.
std::vector<SizeBin> bins_of(const std::vector<double>& sizes) {
  std::vector<SizeBin> bins;
  const auto positive = std::find_if(sizes.begin(), sizes.end(), [](double size) { return size > 0; });
  if (positive != sizes.begin()) bins.push_back({0, 0, static_cast<std::size_t>(positive - sizes.begin())});
  if (positive == sizes.end()) return bins;
  const int lowest = std::ilogb(*positive);
  const int octaves = std::ilogb(sizes.back()) - lowest + 1;
  constexpr int most_bins = 11;
  const int octaves_per_bin = (octaves + most_bins - 1) / most_bins;
  auto from = positive;
  for (int octave = lowest; from != sizes.end(); octave += octaves_per_bin) {
    // An edge beyond the largest double is clamped to it, so the bin must include that size.
    const double edge = std::ldexp(1.0, octave + octaves_per_bin);
    const auto to = std::isinf(edge) ? sizes.end() : std::lower_bound(from, sizes.end(), edge);
    bins.push_back({std::ldexp(1.0, octave), std::min(edge, std::numeric_limits<double>::max()),
                    static_cast<std::size_t>(to - from)});
    from = to;
  }
  return bins;
}

/// None without sizes. The rank is rounded up, so that the result is one of the sizes.
std::optional<SizeSpread> spread_of(std::vector<double> sizes) {
  if (sizes.empty()) return std::nullopt;
  std::sort(sizes.begin(), sizes.end());
  const auto at_least = [&](std::size_t percent) { return sizes[(sizes.size() * percent + 99) / 100 - 1]; };
  return SizeSpread{sizes.front(), at_least(50), at_least(90), sizes.back(), bins_of(sizes)};
}

template <Dim N>
void measure(const Scene<N, double>& scene, SceneSummary& summary) {
  Aabb<N, double> around = Aabb<N, double>::nothing();
  std::vector<double> sizes;
  for (const ObjectId id : scene.ids()) {
    const Aabb<N, double>& box = scene.object(id).box;
    if (is_nothing(box)) {
      ++summary.empty;
    } else if (!is_finite(box.min) || !is_finite(box.max)) {
      ++summary.unbounded;
    } else {
      around.grow(box);
      sizes.push_back(size_of(box));
    }
  }
  if (!sizes.empty()) summary.bounds = extent_of(around);
  summary.sizes = spread_of(std::move(sizes));
}

/// The numbers of vertices whose coordinates occur before.
template <Dim N>
std::size_t duplicates_in(std::span<const Vec<N, double>> vertices) {
  std::vector<Vec<N, double>> sorted(vertices.begin(), vertices.end());
  std::sort(sorted.begin(), sorted.end(), detail::lexicographically_less<N, double>);
  return static_cast<std::size_t>(sorted.end() - std::unique(sorted.begin(), sorted.end()));
}

/// Meshes that share triangles are examined once.
template <Dim N>
std::vector<MeshCount> meshes_of(const Scene<N, double>& scene) {
  std::map<const void*, MeshCount> known;
  std::vector<MeshCount> meshes;
  for (const ObjectId id : scene.ids()) {
    const auto* const mesh = std::get_if<Mesh<N, double>>(&scene.object(id).shape);
    if (mesh == nullptr) continue;
    const auto& data = *detail::placed(*mesh).data();
    const auto [count, is_new] = known.try_emplace(&data);
    if (is_new) {
      const auto own = mesh_of<N, double>(data.vertices(), data.faces(), data.kind());
      count->second = {"",
                       data.kind(),
                       data.vertices().size(),
                       data.faces().size(),
                       duplicates_in<N>(data.vertices()),
                       report(welded(own))};
      count->second.report.unused_vertices = report(own).unused_vertices;
    }
    meshes.push_back(count->second);
    meshes.back().name = scene.object(id).name;
  }
  return meshes;
}

}  // namespace

SceneSummary summarise(const SceneFile& file) {
  SceneSummary summary;
  summary.source = file.source;
  summary.format = file.format;
  summary.omissions = file.omissions;
  std::visit(
      [&]<Dim N>(const Scene<N, double>& scene) {
        summary.dimension = N;
        summary.objects = scene.size();
        summary.types = types_of(scene);
        summary.layers = layers_of(scene);
        measure(scene, summary);
        summary.meshes = meshes_of(scene);
      },
      file.scene);
  return summary;
}

}  // namespace graze::io
