// SPDX-License-Identifier: MIT
#include <limits>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include <graze/io/gltf/placement.hpp>

#include "io/mesh_text.hpp"
#include "io/scene_text.hpp"

namespace graze::io::gltf_placement_test {
namespace {

using V = Vec<3, double>;
using M = Mat<3, double>;

/// The transform of a node with these fields.
GltfTransform read(const std::string& fields) {
  const std::string text = "{" + fields + "}";  // must outlive the document
  const JsonDocument document(text, "a.gltf");
  return transform_of_node({document.root(), JsonPlace{document, nullptr, "node", 4}, "a node"});
}

std::string refusal(const std::string& fields) {
  return error_of([&fields] { read(fields); });
}

const void* triangles_of(const Mesh<3, double>& mesh) { return detail::placed(mesh).data().get(); }

double volume(const Mesh<3, double>& mesh) {
  double sum = 0;
  for (std::size_t i = 0; i < mesh.faces().size(); ++i) {
    const Triangle<3, double> triangle = mesh.triangle(i);
    sum += dot(triangle.a, cross(triangle.b, triangle.c)) / 6;
  }
  return sum;
}

TEST(GltfPlacement, TransformsOfNodesAreRead) {
  EXPECT_EQ(read("").linear, M(1.0));
  const GltfTransform moved = read(R"("translation": [1, 2, 3], "rotation": [0, 0, 1, 0], "scale": [2, 3, 4])");
  EXPECT_EQ(moved.offset, V(1, 2, 3));
  EXPECT_EQ(moved.linear, M(V(-2, 0, 0), V(0, -3, 0), V(0, 0, 4)));
  const GltfTransform matrix = read(R"("matrix": [1, 2, 3, 0, 4, 5, 6, 0, 7, 8, 9, 0, 10, 11, 12, 1])");
  EXPECT_EQ(matrix.linear, M(V(1, 2, 3), V(4, 5, 6), V(7, 8, 9)));
  EXPECT_EQ(matrix.offset, V(10, 11, 12));
  EXPECT_EQ(moved.after(matrix).offset, moved.linear * V(10, 11, 12) + V(1, 2, 3));
}

TEST(GltfPlacement, FaultyTransformsAreRefused) {
  EXPECT_EQ(refusal(R"("scale": [1, 2])"),
            "a.gltf: line 1, column 11: node 4: \"scale\" has 2 numbers; it must have 3");
  EXPECT_EQ(refusal(R"("rotation": [0, 0, 0, 0])"),
            "a.gltf: line 1, column 14: node 4: \"rotation\" is zero; a quaternion has any other length");
  EXPECT_EQ(refusal(R"("matrix": [1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1])"),
            "a.gltf: line 1, column 12: node 4: \"matrix\" is not affine: its last row must be 0, 0, 0, 1");
  EXPECT_NE(refusal(R"("translation": ["x", 0, 0])").find("must be a number, not a string"), std::string::npos);
}

TEST(GltfPlacement, RigidImagesShareTriangles) {
  const Mesh<3, double> cube = cube_mesh();
  GltfPlacement placement;
  EXPECT_EQ(triangles_of(placement.placed(cube, {})), triangles_of(cube));
  const GltfTransform turn{M(V(0, 1, 0), V(-1, 0, 0), V(0, 0, 1)), V(5, 0, 0)};
  const Mesh<3, double> image = placement.placed(cube, turn);
  EXPECT_EQ(triangles_of(image), triangles_of(cube));
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_EQ(image.vertices()[i], turn.linear * cube.vertices()[i] + turn.offset);
  }
}

TEST(GltfPlacement, ImagesOfTheSameScaleShareTriangles) {
  const Mesh<3, double> cube = cube_mesh();
  GltfPlacement placement;
  const Mesh<3, double> a = placement.placed(cube, {M(0.5), V(1, 2, 3)});
  const Mesh<3, double> b = placement.placed(cube, {M(V(0, 0.5, 0), V(-0.5, 0, 0), V(0, 0, 0.5)), V(0)});
  EXPECT_EQ(triangles_of(a), triangles_of(b));
  EXPECT_NE(triangles_of(a), triangles_of(cube));
  EXPECT_EQ(a.vertices()[6], V(1.5, 2.5, 3.5));
  EXPECT_NE(triangles_of(placement.placed(cube, {M(2.0), V(0)})), triangles_of(a));
}

TEST(GltfPlacement, SkewedAndMirroredImagesKeepTheirOutside) {
  const Mesh<3, double> cube = cube_mesh();
  GltfPlacement placement;
  const GltfTransform skew{M(V(1, 0, 0), V(3, 2, 0), V(0, 0, 1)), V(0)};
  EXPECT_EQ(placement.placed(cube, skew).vertices()[2], V(4, 2, 0));
  EXPECT_DOUBLE_EQ(volume(placement.placed(cube, skew)), 2);
  const GltfTransform mirror{M(V(-1, 0, 0), V(0, 1, 0), V(0, 0, 1)), V(7, 0, 0)};
  const Mesh<3, double> mirrored = placement.placed(cube, mirror);
  EXPECT_EQ(mirrored.vertices()[1], V(6, 0, 0));
  EXPECT_DOUBLE_EQ(volume(mirrored), 1);
  EXPECT_EQ(triangles_of(mirrored), triangles_of(placement.placed(cube, mirror)));
}

TEST(GltfPlacement, ScaledCopiesAreLimited) {
  const Mesh<3, double> cube = cube_mesh();  // 8 vertices and 12 faces
  GltfPlacement placement(59);
  for (const double scale : {2.0, 3.0, 2.0, 1.0}) EXPECT_NO_THROW(placement.placed(cube, {M(scale), V(0)}));
  EXPECT_THROW(placement.placed(cube, {M(4.0), V(0)}), std::length_error);
}

TEST(GltfPlacement, FlatImagesAreAllowedAndInfiniteOnesAreNot) {
  const Mesh<3, double> cube = cube_mesh();
  GltfPlacement placement;
  EXPECT_EQ(placement.placed(cube, {M(0.0), V(1, 1, 1)}).vertices()[6], V(1, 1, 1));
  EXPECT_THROW(placement.placed(cube, {M(1.0), V(std::numeric_limits<double>::infinity(), 0, 0)}),
               std::invalid_argument);
  EXPECT_THROW(placement.placed(cube, {M(std::numeric_limits<double>::quiet_NaN()), V(0)}), std::invalid_argument);
  EXPECT_THROW(placement.placed(cube, {M(1e308), V(1e308, 0, 0)}), std::invalid_argument);
}

}  // namespace
}  // namespace graze::io::gltf_placement_test
