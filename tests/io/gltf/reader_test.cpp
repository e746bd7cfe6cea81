// SPDX-License-Identifier: MIT
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <graze/io/gltf/reader.hpp>
#include <graze/io/gltf/root.hpp>
#include <graze/io/mesh/bytes.hpp>

#include "io/mesh_text.hpp"
#include "io/scene_text.hpp"
#include "io/tiled_folder.hpp"

namespace graze::io::gltf_reader_test {
namespace {

/// Four corners of a square as floats, then six indices of two bytes, then the corners as normalized int16 with a
/// padding of two bytes each: 48, 12 and 32 bytes.
std::string square_bytes() {
  std::string bytes;
  for (const float number : {0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 1.F, 1.F, 0.F, 0.F, 1.F, 0.F}) append_number(bytes, number);
  for (const int index : {0, 1, 2, 0, 2, 3}) append_number(bytes, static_cast<std::uint16_t>(index));
  for (const int number : {0, 0, 0, 9, 32767, 0, 0, 9, 32767, 32767, 0, 9, 0, 32767, 0, 9}) {
    append_number(bytes, static_cast<std::uint16_t>(number));
  }
  return bytes;
}

const std::string asset = R"("asset": {"version": "2.0"})";
const std::string arrays =
    R"("buffers": [{"byteLength": 92}], "bufferViews": [)"
    R"({"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 12}, )"
    R"({"buffer": 0, "byteOffset": 60, "byteLength": 32, "byteStride": 8}], "accessors": [)"
    R"({"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"}, )"
    R"({"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"}, )"
    R"({"bufferView": 2, "componentType": 5122, "normalized": true, "count": 4, "type": "VEC3"}])";
const std::string square =
    R"("meshes": [{"name": "square", "primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}])";

std::string gltf(const std::string& fields) { return "{" + asset + ", " + arrays + ", " + fields + "}"; }

MeshFile read(const std::string& text) {
  const std::string bytes = square_bytes();
  return read_gltf(JsonDocument(text, "a.gltf"), bytes, ".");
}

std::string refusal(const std::string& text) {
  return error_of([&text] { read(text); });
}

TEST(GltfReader, NodesThatShowAMeshAreParts) {
  const MeshFile file =
      read(gltf(square + R"(, "nodes": [{"name": "root", "children": [2, 1], "translation": [1, 0, 0]},
      {"mesh": 0, "translation": [0, 0, 5]}, {"name": "first", "mesh": 0}, {"name": "in no scene", "mesh": 0}],
      "scenes": [{}, {"nodes": [0]}], "scene": 1)"));
  EXPECT_EQ(file.format, "gltf");
  EXPECT_EQ(file.up, UpAxis::y);
  EXPECT_EQ(file.metres_per_unit, 1.0);
  ASSERT_EQ(file.parts.size(), 2U);
  EXPECT_EQ(file.parts[0].name, "first");
  EXPECT_EQ(points_of(file.parts[0].mesh), (MeshPoints{{1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}}));
  EXPECT_EQ(faces_of(file.parts[0].mesh), (MeshFaces{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(file.parts[1].name, "square");
  EXPECT_EQ(file.parts[1].mesh.vertices()[0], (Vec<3, double>(1, 0, 5)));
  EXPECT_EQ(detail::placed(file.parts[0].mesh).data(), detail::placed(file.parts[1].mesh).data());
}

TEST(GltfReader, WithoutScenesAllRootsAreRead) {
  EXPECT_EQ(read(gltf(square + R"(, "nodes": [{"mesh": 0, "children": [1]}, {"mesh": 0}, {"mesh": 0}])")).parts.size(),
            3U);
  EXPECT_EQ(read(gltf(square + R"(, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}, {"mesh": 0}])")).parts.size(),
            1U);
  EXPECT_TRUE(read("{" + asset + "}").parts.empty());
}

MeshFaces faces_of_primitive(const std::string& primitive) {
  const MeshFile file = read(gltf(R"("meshes": [{"primitives": [)" + primitive + R"(]}], "nodes": [{"mesh": 0}])"));
  return faces_of(file.parts.at(0).mesh);
}

TEST(GltfReader, StripsFansAndLooseTrianglesAreCut) {
  EXPECT_EQ(faces_of_primitive(R"({"attributes": {"POSITION": 0}, "mode": 5})"), (MeshFaces{{0, 1, 2}, {1, 3, 2}}));
  EXPECT_EQ(faces_of_primitive(R"({"attributes": {"POSITION": 0}, "mode": 6})"), (MeshFaces{{1, 2, 0}, {2, 3, 0}}));
  EXPECT_EQ(faces_of_primitive(R"({"attributes": {"POSITION": 0}})"), (MeshFaces{{0, 1, 2}}));
  EXPECT_EQ(faces_of_primitive(R"({"attributes": {"POSITION": 0}}, {"attributes": {"POSITION": 0}, "indices": 1})"),
            (MeshFaces{{0, 1, 2}, {0, 1, 2}, {0, 2, 3}}));  // on common vertices
  EXPECT_EQ(faces_of_primitive(R"({"attributes": {"POSITION": 0}}, {"attributes": {"POSITION": 2}})"),
            (MeshFaces{{0, 1, 2}, {3, 4, 5}}));
}

TEST(GltfReader, NormalizedIntegersAndStridesAreRead) {
  const MeshFile file = read(gltf(R"("extensionsRequired": ["KHR_mesh_quantization"], "nodes": [{"mesh": 0}], )"
                                  R"("meshes": [{"primitives": [{"attributes": {"POSITION": 2}, "indices": 1}]}])"));
  EXPECT_EQ(points_of(file.parts.at(0).mesh), (MeshPoints{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
}

TEST(GltfReader, SparseAccessorsReplaceElements) {
  const std::string sparse = R"({"componentType": 5126, "count": 3, "type": "VEC3", "sparse": {"count": 2,
      "indices": {"bufferView": 1, "byteOffset": 2, "componentType": 5123},
      "values": {"bufferView": 0, "byteOffset": 12}}})";
  std::string text = gltf(R"("nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 3}}]}])");
  text.insert(text.find("], \"nodes\""), ", " + sparse);
  EXPECT_EQ(points_of(read(text).parts.at(0).mesh), (MeshPoints{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}));
}

TEST(GltfReader, SparseAccessorsMayBeIndicesAndNormalized) {
  const std::string indices = R"({"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR",
      "sparse": {"count": 1, "indices": {"bufferView": 1, "byteOffset": 4, "componentType": 5123},
      "values": {"bufferView": 1, "byteOffset": 10}}})";
  const std::string points = R"({"bufferView": 2, "componentType": 5122, "normalized": true, "count": 4,
      "type": "VEC3", "sparse": {"count": 1, "indices": {"bufferView": 1, "byteOffset": 4, "componentType": 5123},
      "values": {"bufferView": 2, "byteOffset": 24}}})";
  std::string text =
      gltf(R"("nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 4}, "indices": 3}]}])");
  text.insert(text.find("], \"nodes\""), ", " + indices + ", " + points);
  const Mesh<3, double> mesh = read(text).parts.at(0).mesh;
  EXPECT_EQ(points_of(mesh), (MeshPoints{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 0}}));
  EXPECT_EQ(faces_of(mesh), (MeshFaces{{0, 1, 3}, {0, 2, 3}}));
}

TEST(GltfReader, WhatIsNotReadIsCounted) {
  const MeshFile file = read(gltf(R"("nodes": [{"mesh": 0, "skin": 0}, {"mesh": 1, "weights": [0, 0.5]}],
      "animations": [{}, {}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "mode": 1},
      {"attributes": {"POSITION": 0}, "mode": 1}, {"attributes": {}}]},
      {"primitives": [{"attributes": {"POSITION": 0}, "mode": 5}]}])"));
  ASSERT_EQ(file.omissions.size(), 5U);
  EXPECT_EQ(omission_text(file.omissions[0]), "2 x animation");
  EXPECT_EQ(file.omissions[1].what, "skin");
  EXPECT_EQ(file.omissions[1].loss, Loss::precision);
  EXPECT_EQ(omission_text(file.omissions[2]), "2 x primitive of lines (a.gltf, mesh 0)");
  EXPECT_EQ(file.omissions[3].what, "primitive without positions");
  EXPECT_EQ(file.omissions[4].what, "morph target");
}

TEST(GltfReader, BuffersAreDataOrFilesBeside) {
  const TiledFolder folder;
  folder.write("a b.bin", square_bytes());
  std::string text = gltf(square + R"(, "nodes": [{"mesh": 0}])");
  text.replace(text.find("{\"byteLength\": 92}"), 18, R"({"byteLength": 92, "uri": "a%20b.bin"})");
  EXPECT_EQ(read_gltf(JsonDocument(text, "a"), std::nullopt, folder.path()).parts.at(0).mesh.faces().size(), 2U);
  EXPECT_EQ(error_of([&] { read_gltf(JsonDocument(text, "a"), std::nullopt, folder.path() / "none"); }),
            "a: line 1, column 69: buffer 0: \"uri\" is \"a b.bin\", which cannot be read: there is no such file");
  text.replace(text.find("a%20b.bin"), 9, "../a%20b.bin");
  EXPECT_NE(error_of([&] {
              read_gltf(JsonDocument(text, "a"), std::nullopt, folder.path());
            }).find("graze opens only files in the same folder and below"),
            std::string::npos);
}

TEST(GltfReader, FaultsAreRefusedWithTheirPlace) {
  const std::string node = R"("nodes": [{"mesh": 0}], )";
  const auto mesh = [&](const std::string& primitive) {
    return gltf(node + R"("meshes": [{"primitives": [)" + primitive + "]}]");
  };
  const std::vector<std::pair<std::string, std::string>> table = {
      {R"({"asset": {"version": "1.0"}, "meshes": {}})",
       "this is glTF 1.0; graze reads glTF 2.0, so export it as that"},
      {R"({"asset": {}, "meshes": {}})", "this is glTF 1.0; graze reads glTF 2.0"},
      {"{" + asset + R"(, "extensionsRequired": ["KHR_draco_mesh_compression"]})",
       "the file needs the extension \"KHR_draco_mesh_compression\", which graze does not read; export it without"},
      {"{" + asset + R"(, "nodes": {}})", "\"nodes\" must be an array, not an object"},
      {"{" + asset + R"(, "nodes": [7]})", "node 0: must be an object, not a number"},
      {"{" + asset + R"(, "scene": 3})", "\"scene\" is 3, but \"scenes\" has 0 elements, numbered from 0"},
      {"{" + asset + R"(, "nodes": [{"mesh": -1}]})", "node 0: \"mesh\" is -1; it must be a whole number"},
      {"{" + asset + R"(, "scenes": [{"nodes": [0]}], "nodes": [{"children": [1]}, {"children": [0]}]})",
       "node 0: is a child of two nodes, or of itself; the nodes must be a tree"},
      {mesh(R"({"attributes": {"POSITION": 1}})"), "accessor 1: \"type\" is \"SCALAR\"; here it must be \"VEC3\""},
      {mesh(R"({"attributes": {"POSITION": 0}, "indices": 0})"),
       "accessor 0: has componentType 5126; indices have 5121, 5123 or 5125"},
      {mesh(R"({"attributes": {"POSITION": 0}, "mode": 7})"), "mesh 0, primitive 0: \"mode\" is 7; it must be 0 to 6"},
      {mesh("[]"), "mesh 0, primitive 0: must be an object, not an array"}};
  for (const auto& [text, expected] : table)
    EXPECT_NE(refusal(text).find(expected), std::string::npos) << refusal(text);
}

/// The refusal of the square after a change of its text.
std::string refusal_with(const std::string& before, const std::string& after) {
  std::string text = gltf(square + R"(, "nodes": [{"mesh": 0}])");
  const std::size_t at = text.find(before);
  if (at == std::string::npos) return "there is no " + before;
  return refusal(text.replace(at, before.size(), after));
}

TEST(GltfReader, SizesAreCheckedAgainstTheBytesThatAreThere) {
  const std::vector<std::array<std::string, 3>> table = {
      {R"("byteLength": 92)", R"("byteLength": 93)", "buffer 0: promises 93 bytes, but has only 92; is it cut off?"},
      {R"("byteLength": 48)", R"("byteLength": 93)",
       "bufferView 0: has 93 bytes from byte 0 on, but buffer 0 has only 92"},
      {R"("count": 4)", R"("count": 4000000000)",
       "accessor 0: needs 4000000000 elements, 12 bytes each, from byte 0 of bufferView 0, which has only 48 bytes"},
      {R"("count": 4)", R"("count": 5)", "accessor 0: needs 5 elements"},
      {R"("count": 4)", R"("count": 99999999999999999)",
       "accessor 0: \"count\" is 99999999999999999, which is more than any file holds"},
      {R"("count": 4)", R"("byteOffset": 1, "count": 4)", "accessor 0: needs 4 elements, 12 bytes each, from byte 1"},
      {R"("count": 4)", R"("byteOffset": 50, "count": 4)", "accessor 0: needs 4 elements, 12 bytes each, from byte 50"},
      {R"("bufferView": 0, "componentType": 5126, "count": 4)", R"("componentType": 5126, "count": 100001)",
       "accessor 0: has no \"bufferView\" for its 100001 elements; at most 100000 may be zero without one"},
      {R"("componentType": 5126)", R"("componentType": 5124)", "\"componentType\" is 5124"},
      {R"("byteLength": 48})", R"("byteLength": 48, "byteStride": 4})",
       "bufferView 0: \"byteStride\" is 4, but an element has 12 bytes"},
      {R"("byteOffset": 48, )", R"("byteOffset": 60, )",
       "accessor 1: index 3 is 9, but accessor 0, which mesh 0 uses with it, has 4 vertices"},
      {R"("buffer": 0, "byteLength": 48)", R"("buffer": 1, "byteLength": 48)",
       "bufferView 0: \"buffer\" is 1, but \"buffers\" has 1 elements, numbered from 0"}};
  for (const auto& [before, after, expected] : table) {
    const std::string message = refusal_with(before, after);
    EXPECT_NE(message.find(expected), std::string::npos) << message;
  }
}

TEST(GltfReader, OverlappingAccessorsCannotTakeMoreMemoryThanTheFile) {
  std::string primitives;
  std::string accessors;
  for (int i = 0; i < 30'000; ++i) {
    accessors += R"(, {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"})";
    primitives += std::string(i > 0 ? ", " : "") + R"({"attributes": {"POSITION": )" + std::to_string(3 + i) + "}}";
  }
  std::string text = gltf(R"("nodes": [{"mesh": 0}], "meshes": [{"primitives": [)" + primitives + "]}]");
  text.insert(text.find("], \"nodes\""), accessors);
  EXPECT_NE(refusal(text).find("have more numbers than the buffers have bytes; do they overlap?"), std::string::npos);
}

TEST(GltfReader, PointsWithoutIndicesCannotMakeMoreFacesThanTheFileHasBytes) {
  std::string primitives;
  for (int i = 0; i < 30'000; ++i) primitives += std::string(i > 0 ? ", " : "") + R"({"attributes": {"POSITION": 0}})";
  const std::string text = gltf(R"("nodes": [{"mesh": 0}], "meshes": [{"primitives": [)" + primitives + "]}]");
  EXPECT_NE(refusal(text).find("accessor 0: the accessors up to this one have more numbers than the buffers"),
            std::string::npos)
      << refusal(text);
}

TEST(GltfReader, OtherJsonIsNotTakenForGltf) {
  const auto is = [](const std::string& text) { return is_gltf(JsonDocument(text, "a").root()); };
  EXPECT_TRUE(is(R"({"asset": {"version": "2.0"}})"));
  EXPECT_TRUE(is(R"({"accessors": {}, "meshes": {}})"));
  EXPECT_FALSE(is(R"({"asset": {}, "schema": "graze.scene/1"})"));
  EXPECT_FALSE(is(R"({"asset": "a", "meshes": []})"));
  EXPECT_FALSE(is("[]"));
}

}  // namespace
}  // namespace graze::io::gltf_reader_test
