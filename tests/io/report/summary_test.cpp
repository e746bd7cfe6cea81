// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <rapidcheck/gtest.h>

#include <graze/io/report/summary.hpp>

namespace graze::io::summary_test {
namespace {

SceneFile file_of(AnyScene scene) { return {std::move(scene), "yard.json", "graze.scene/1", YAxis::up, {}}; }

/// A scene of flat boxes along x, one for each size.
SceneFile boxes_of_sizes(const std::vector<double>& sizes) {
  Scene<2, double> scene;
  for (const double size : sizes) scene.add(Rect<double>{{0, 0}, {size, 0}});
  return file_of(std::move(scene));
}

SceneFile yard() {
  Scene<2, double> scene;
  const Layer walls = scene.layer("walls");
  scene.layer("nothing on it");
  scene.add(Circle<double>{{1, 2}, 3}, {"ball", 5});
  scene.add(Rect<double>{{-4, 0}, {-3, 10}}, {"wall", walls});
  scene.add(Ray<2, double>{{0, 0}, {1, 0}}, {"beam", walls});
  scene.add(Compound<2, double>{}, {"nothing", walls});
  SceneFile file = file_of(std::move(scene));
  file.omissions = {{"tile layer", 3}};
  return file;
}

TEST(Summary, counts_types_in_their_order_and_layers_by_number) {
  const SceneSummary summary = summarise(yard());
  EXPECT_EQ(summary.dimension, 2);
  EXPECT_EQ(summary.objects, 4U);
  ASSERT_EQ(summary.types.size(), 4U);
  EXPECT_EQ(summary.types[0].name, "ray");
  EXPECT_EQ(summary.types[1].name, "sphere");
  EXPECT_EQ(summary.types[2].name, "aabb");
  EXPECT_EQ(summary.types[3].name, "compound");
  ASSERT_EQ(summary.layers.size(), 3U);
  EXPECT_EQ(summary.layers[0].name, "walls");
  EXPECT_EQ(summary.layers[0].objects, 3U);
  EXPECT_EQ(summary.layers[1].objects, 0U);
  EXPECT_EQ(summary.layers[2].name, "layer 5");
  EXPECT_EQ(summary.layers[2].objects, 1U);
}

TEST(Summary, bounds_the_bounded_and_counts_the_rest) {
  const SceneSummary summary = summarise(yard());
  ASSERT_TRUE(summary.bounds);
  EXPECT_EQ(summary.bounds->min, (std::vector<double>{-4, -1}));
  EXPECT_EQ(summary.bounds->max, (std::vector<double>{4, 10}));
  EXPECT_EQ(summary.unbounded, 1U);
  EXPECT_EQ(summary.empty, 1U);
}

TEST(Summary, of_3d_has_three_coordinates) {
  Scene<3, double> scene;
  scene.add(Aabb<3, double>{{0, 0, 0}, {1, 2, 5}});
  const SceneSummary summary = summarise(file_of(std::move(scene)));
  EXPECT_EQ(summary.dimension, 3);
  EXPECT_EQ(summary.bounds->max, (std::vector<double>{1, 2, 5}));
  EXPECT_EQ(summary.sizes->max, 5);
}

TEST(Summary, of_an_empty_scene_has_no_bounds_and_no_sizes) {
  const SceneSummary summary = summarise(boxes_of_sizes({}));
  EXPECT_EQ(summary.objects, 0U);
  EXPECT_FALSE(summary.bounds);
  EXPECT_FALSE(summary.sizes);
}

TEST(Summary, gives_sizes_that_occur) {
  const SceneSummary summary = summarise(boxes_of_sizes({7, 1, 3, 2, 5, 4, 10, 6, 9, 8}));
  ASSERT_TRUE(summary.sizes);
  EXPECT_EQ(summary.sizes->min, 1);
  EXPECT_EQ(summary.sizes->median, 5);
  EXPECT_EQ(summary.sizes->p90, 9);
  EXPECT_EQ(summary.sizes->max, 10);
}

TEST(Summary, sorts_sizes_into_bins_between_powers_of_two) {
  const SceneSummary summary = summarise(boxes_of_sizes({0, 0, 1, 1.5, 2, 7.5}));
  const std::vector<SizeBin>& bins = summary.sizes->bins;
  ASSERT_EQ(bins.size(), 4U);
  const std::vector<double> edges{bins[0].from, bins[0].to, bins[1].from, bins[2].from, bins[3].from, bins[3].to};
  EXPECT_EQ(edges, (std::vector<double>{0, 0, 1, 2, 4, 8}));
  EXPECT_EQ(bins[0].objects, 2U);
  EXPECT_EQ(bins[1].objects, 2U);
  EXPECT_EQ(bins[2].objects, 1U);
  EXPECT_EQ(bins[3].objects, 1U);
}

TEST(Summary, takes_sizes_up_to_the_largest_double) {
  constexpr double largest = std::numeric_limits<double>::max();
  Scene<2, double> scene;
  scene.add(Rect<double>{{-largest, 0}, {largest, 0}});
  scene.add(Rect<double>{{0, 0}, {std::numeric_limits<double>::denorm_min(), 0}});
  const SceneSummary summary = summarise(file_of(std::move(scene)));
  EXPECT_EQ(summary.sizes->max, largest);
  EXPECT_LE(summary.sizes->bins.size(), 12U);
  EXPECT_EQ(summary.sizes->bins.front().objects, 1U);
  EXPECT_EQ(summary.sizes->bins.back().objects, 1U);
  EXPECT_EQ(summary.sizes->bins.back().to, largest);
}

TEST(Summary, examines_meshes_with_equal_vertices_joined) {
  const std::vector<Vec<3, double>> corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0},
                                               {1, 1, 0}, {0, 1, 0}, {9, 9, 9}};
  const std::vector<std::array<std::uint32_t, 3>> faces = {{0, 1, 2}, {3, 4, 5}};
  const Mesh<3, double> square = mesh_of<3, double>(corners, faces);
  Scene<3, double> scene;
  scene.add(square, {"here"});
  scene.add(transformed(square, {Mat<3, double>(1.0), {5, 0, 0}}), {"there"});
  scene.add(Sphere<3, double>{{0, 0, 0}, 1}, {"no mesh"});
  const SceneSummary summary = summarise(file_of(std::move(scene)));
  ASSERT_EQ(summary.meshes.size(), 2U);
  EXPECT_EQ(summary.meshes[1].name, "there");
  for (const MeshCount& mesh : summary.meshes) {
    EXPECT_EQ(mesh.vertices, 7U);
    EXPECT_EQ(mesh.faces, 2U);
    EXPECT_EQ(mesh.duplicate_vertices, 2U);
    EXPECT_EQ(mesh.report, (MeshReport{.open_edges = 4, .unused_vertices = 1, .components = 1, .is_closed = false}));
  }
}

RC_GTEST_PROP(Summary, has_every_size_in_the_bin_it_belongs_to, (const std::vector<double>& numbers)) {
  std::vector<double> sizes;
  for (const double number : numbers) sizes.push_back(std::isfinite(number) ? std::fabs(number) : 0);
  RC_PRE(!sizes.empty());
  const SceneSummary summary = summarise(boxes_of_sizes(sizes));
  std::size_t total = 0;
  RC_ASSERT(summary.sizes->bins.size() <= 12U);
  for (const SizeBin& bin : summary.sizes->bins) {
    std::size_t expected = 0;
    for (const double size : sizes) {
      const bool inside = bin.to == 0 ? size == 0 : bin.from <= size && size < bin.to;
      if (inside || (size == bin.to && bin.to == std::numeric_limits<double>::max())) ++expected;
    }
    RC_ASSERT(bin.objects == expected);
    total += bin.objects;
  }
  RC_ASSERT(total == sizes.size());
}

}  // namespace
}  // namespace graze::io::summary_test
