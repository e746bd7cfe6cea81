// SPDX-License-Identifier: MIT
#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <graze/io/json/shape_fields.hpp>
#include <graze/io/json/shape_writer.hpp>
#include <graze/io/output_error.hpp>
#include <graze/query/bounds.hpp>

namespace graze::io::json_shape_writer_test {
namespace {

template <Dim N>
std::string written(const AnyShape<N, double>& shape) {
  std::string text;
  append_json_shape<N>(text, shape);
  return text;
}

TEST(JsonShapeWriter, EveryTypeIsWrittenWithItsFieldsInOrder) {
  using V = Vec<2, double>;
  EXPECT_EQ(written<2>(V(1, 2)), R"("type": "point", "position": [1, 2])");
  EXPECT_EQ(written<2>(Segment<2, double>{{1, 2}, {3, 4}}), R"("type": "segment", "start": [1, 2], "end": [3, 4])");
  EXPECT_EQ(written<2>(Ray<2, double>{{1, 2}, {0, 1}}), R"("type": "ray", "origin": [1, 2], "direction": [0, 1])");
  EXPECT_EQ(written<3>(Sphere<3, double>{{1, 2, 3}, 0.1}), R"("type": "sphere", "center": [1, 2, 3], "radius": 0.1)");
  EXPECT_EQ(written<2>(Aabb<2, double>{{1, 2}, {3, 4}}), R"("type": "aabb", "min": [1, 2], "max": [3, 4])");
  EXPECT_EQ(written<2>(Obb<2, double>{{1, 2}, {3, 4}, Mat<2, double>(V(0, 1), V(-1, 0))}),
            R"("type": "obb", "center": [1, 2], "half_extents": [3, 4], "axes": [[0, 1], [-1, 0]])");
  EXPECT_EQ(written<2>(Plane<2, double>{{0, 1}, 5}), R"("type": "plane", "normal": [0, 1], "offset": 5)");
  EXPECT_EQ(written<2>(HalfSpace<2, double>{{0, 1}, 5}), R"("type": "half_space", "normal": [0, 1], "offset": 5)");
  EXPECT_EQ(written<2>(Triangle<2, double>{{0, 0}, {1, 0}, {0, 1}}),
            R"("type": "triangle", "a": [0, 0], "b": [1, 0], "c": [0, 1])");
  EXPECT_EQ(written<2>(Capsule<2, double>{{0, 0}, {1, 0}, 2}),
            R"("type": "capsule", "a": [0, 0], "b": [1, 0], "radius": 2)");
  const std::vector<V> points = {{0, 0}, {1, 0}, {0, 1}};
  EXPECT_EQ(written<2>(convex_hull<2, double>(points)), R"("type": "polytope", "points": [[0, 0], [1, 0], [0, 1]])");
  EXPECT_EQ(
      written<2>(compound_of<2, double>({V(1, 2), V(3, 4)})),
      R"("type": "compound", "parts": [{"type": "point", "position": [1, 2]}, {"type": "point", "position": [3, 4]}])");
  EXPECT_EQ(written<2>(Compound<2, double>{}), R"("type": "compound", "parts": [])");
  const std::array<Vec<2, double>, 3> corners = {{{0, 0}, {1.5, 0}, {0, 1}}};
  const std::array<std::array<std::uint32_t, 3>, 1> faces = {{{0, 1, 2}}};
  EXPECT_EQ((written<2>(mesh_of<2, double>(corners, faces, MeshKind::solid))),
            R"("type": "mesh", "vertices": [[0, 0], [1.5, 0], [0, 1]], "faces": [[0, 1, 2]], "kind": "solid")");
}

TEST(JsonShapeWriter, NumbersAreTheShortestThatReadBackTheSame) {
  using V = Vec<2, double>;
  EXPECT_EQ(written<2>(V(0.1 + 0.2, -0.0)), R"("type": "point", "position": [0.30000000000000004, -0.0])");
  EXPECT_EQ(written<2>(V(std::numeric_limits<double>::max(), std::numeric_limits<double>::denorm_min())),
            R"("type": "point", "position": [1.7976931348623157e+308, 5e-324])");
  EXPECT_EQ(written<2>(V(1e22, 123456789)), R"("type": "point", "position": [1e+22, 123456789])");
}

TEST(JsonShapeWriter, CompoundsDeeperThanTheFormatAllowsAreRefused) {
  AnyShape<2, double> shape = Vec<2, double>(0, 0);
  for (std::size_t i = 0; i < max_compound_depth; ++i) shape = compound_of<2, double>({shape});
  EXPECT_NO_THROW(written<2>(shape));
  shape = compound_of<2, double>({shape});
  EXPECT_THROW(written<2>(shape), OutputError);
}

}  // namespace
}  // namespace graze::io::json_shape_writer_test
