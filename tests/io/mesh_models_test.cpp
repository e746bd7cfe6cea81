// SPDX-License-Identifier: MIT
// Every file of Debian's package assimp-testmodels in a format that graze reads: good ones have the faces that were
// counted by another program, malformed ones are refused with a message.
#include <algorithm>
#include <cctype>
#include <cstddef>
#include <filesystem>
#include <set>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include <graze/io/mesh_file.hpp>

#include "io/scene_text.hpp"

namespace graze::io::mesh_models_test {
namespace {

namespace fs = std::filesystem;

/// Where the package installs them; `./dev test` installs the package.
const fs::path models = "/usr/share/assimp/models";

struct GoodModel {
  std::string_view file;
  std::size_t parts;
  std::size_t faces;  ///< Triangles, of all parts.
};

constexpr GoodModel good_models[] = {
    {"OBJ/WusonOBJ.obj", 1, 3732},
    {"OBJ/box.obj", 1, 12},
    {"OBJ/box_longline.obj", 1, 944},
    {"OBJ/box_mat_with_spaces.obj", 1, 12},
    {"OBJ/box_without_lineending.obj", 1, 12},
    {"OBJ/concave_polygon.obj", 1, 64},
    {"OBJ/cube_mtllib_after_g.obj", 1, 12},
    {"OBJ/cube_usemtl.obj", 1, 12},
    {"OBJ/cube_with_vertexcolors.obj", 1, 12},
    {"OBJ/cube_with_vertexcolors_uni.obj", 1, 12},
    {"OBJ/empty_mat.obj", 1, 256},
    {"OBJ/multiple_spaces.obj", 1, 1},
    {"OBJ/point_cloud.obj", 0, 0},
    {"OBJ/regr01.obj", 55, 2710},
    {"OBJ/regr_3429812.obj", 3, 4},
    {"OBJ/space_in_material_name.obj", 1, 64},
    {"OBJ/spider.obj", 19, 1368},
    {"OBJ/testline.obj", 0, 0},
    {"OBJ/testmixed.obj", 1, 12},
    {"OBJ/testpoints.obj", 0, 0},
    {"OFF/Cube.off", 1, 12},
    {"OFF/Wuson.off", 1, 3732},
    {"OFF/formatDetection", 1, 12},
    {"PLY/Wuson.ply", 1, 3732},
    {"PLY/cube.ply", 1, 12},
    {"PLY/cube_binary.ply", 1, 12},
    {"PLY/cube_uv.ply", 1, 12},
    {"PLY/float-color.ply", 1, 1},
    {"PLY/points.ply", 1, 0},
    {"STL/3DSMaxExport.STL", 1, 2000},
    {"STL/Spider_ascii.stl", 1, 1368},
    {"STL/Spider_binary.stl", 1, 1368},
    {"STL/Wuson.stl", 1, 3732},
    {"STL/formatDetection", 1, 1},
    {"STL/sphereWithHole.stl", 1, 285},
    {"STL/triangle.stl", 1, 1},
    {"STL/triangle_with_empty_solid.stl", 2, 1},
    {"STL/triangle_with_two_solids.stl", 2, 2},
    {"glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb", 67, 121496},
    {"glTF2/BoxBadNormals-glTF-Binary/BoxBadNormals.glb", 1, 12},
    {"glTF2/BoxTexcoords-glTF/boxTexcoords.gltf", 1, 12},
    {"glTF2/BoxTextured-glTF-Binary/BoxTextured.glb", 1, 12},
    {"glTF2/BoxTextured-glTF-Embedded/BoxTextured.gltf", 1, 12},
    {"glTF2/BoxTextured-glTF-pbrSpecularGlossiness/BoxTextured.gltf", 1, 12},
    {"glTF2/BoxTextured-glTF-techniqueWebGL/BoxTextured.gltf", 1, 12},
    {"glTF2/BoxTextured-glTF/BoxTextured.gltf", 1, 12},
    {"glTF2/ClearCoat-glTF/ClearCoatTest.gltf", 27, 37116},
    {"glTF2/IncorrectVertexArrays/Cube.gltf", 8, 46},
    {"glTF2/TestNoRootNode/SceneWithoutNodes.gltf", 0, 0},
    {"glTF2/cameras/Cameras.gltf", 1, 2},
    {"glTF2/glTF-Asset-Generator/Mesh_PrimitiveMode/Mesh_PrimitiveMode_00.gltf", 1, 0},
    {"glTF2/glTF-Asset-Generator/Mesh_PrimitiveMode/Mesh_PrimitiveMode_01.gltf", 1, 0},
    {"glTF2/glTF-Asset-Generator/Mesh_PrimitiveMode/Mesh_PrimitiveMode_02.gltf", 1, 0},
    {"glTF2/glTF-Asset-Generator/Mesh_PrimitiveMode/Mesh_PrimitiveMode_03.gltf", 1, 0},
    {"glTF2/glTF-Asset-Generator/Mesh_PrimitiveMode/Mesh_PrimitiveMode_04.gltf", 1, 2},
    {"glTF2/glTF-Asset-Generator/Mesh_PrimitiveMode/Mesh_PrimitiveMode_05.gltf", 1, 2},
    {"glTF2/glTF-Asset-Generator/Mesh_PrimitiveMode/Mesh_PrimitiveMode_06.gltf", 1, 2},
    {"glTF2/glTF-Asset-Generator/Mesh_PrimitiveMode/Mesh_PrimitiveMode_07.gltf", 1, 0},
    {"glTF2/glTF-Asset-Generator/Mesh_PrimitiveMode/Mesh_PrimitiveMode_08.gltf", 1, 0},
    {"glTF2/glTF-Asset-Generator/Mesh_PrimitiveMode/Mesh_PrimitiveMode_09.gltf", 1, 0},
    {"glTF2/glTF-Asset-Generator/Mesh_PrimitiveMode/Mesh_PrimitiveMode_10.gltf", 1, 0},
    {"glTF2/glTF-Asset-Generator/Mesh_PrimitiveMode/Mesh_PrimitiveMode_11.gltf", 1, 2},
    {"glTF2/glTF-Asset-Generator/Mesh_PrimitiveMode/Mesh_PrimitiveMode_12.gltf", 1, 2},
    {"glTF2/glTF-Asset-Generator/Mesh_PrimitiveMode/Mesh_PrimitiveMode_13.gltf", 1, 2},
    {"glTF2/glTF-Asset-Generator/Mesh_PrimitiveMode/Mesh_PrimitiveMode_14.gltf", 1, 2},
    {"glTF2/glTF-Asset-Generator/Mesh_PrimitiveMode/Mesh_PrimitiveMode_15.gltf", 1, 2},
    {"glTF2/glTF-Sample-Models/AnimatedMorphCube-glTF/AnimatedMorphCube.gltf", 1, 12},
    {"glTF2/issue_3269/texcoord_crash.gltf", 5, 10},
    {"glTF2/simple_skin/simple_skin.gltf", 1, 8},
    {"glTF2/textureTransform/TextureTransformTest.gltf", 12, 24},
    {"glTF2/wrongTypes/badExtension.gltf", 1, 12},
    {"glTF2/wrongTypes/badNumber.gltf", 1, 12},
    {"glTF2/wrongTypes/badObject.gltf", 1, 12},
    {"glTF2/wrongTypes/badString.gltf", 1, 12},
    {"glTF2/wrongTypes/badUint.gltf", 1, 12},
};

struct BadModel {
  std::string_view file;
  std::string_view fault;  ///< The message after the file's name.
};

constexpr BadModel bad_models[] = {
    {"OBJ/box_UTF16BE.obj", "this is UTF-16; save it as UTF-8"},
    {"OBJ/number_formats.obj", "line 11, column 14: z is \"3.1+e2\", which is not a number"},
    {"OFF/invalid.off", "line 7, column 3: face 1 has vertex 20, but there are 3 vertices, numbered from 0"},
    {"PLY/issue623.ply", "line 14, column 1: the length of a list is \"7.941797\", which is not a whole number"},
    {"PLY/pond.0.ply",
     "byte 36: the header promises 70051 elements \"vertex\", which take at least 31 bytes each, but only 2171512 "
     "bytes follow; is the file cut off?"},
    {"glTF/BoxTextured-glTF-Binary/BoxTextured.glb",
     "byte 4: this is glTF 1; graze reads glTF 2.0, so export it as that"},
    {"glTF/BoxTextured-glTF-Embedded/BoxTextured.gltf",
     "line 65, column 14: this is glTF 1.0; graze reads glTF 2.0, so export it as that"},
    {"glTF/BoxTextured-glTF-MaterialsCommon/BoxTextured.gltf",
     "line 65, column 14: this is glTF 1.0; graze reads glTF 2.0, so export it as that"},
    {"glTF/BoxTextured-glTF/BoxTextured.gltf",
     "line 65, column 14: this is glTF 1.0; graze reads glTF 2.0, so export it as that"},
    {"glTF/CesiumMilkTruck/CesiumMilkTruck.gltf",
     "line 200, column 14: this is glTF 1.0; graze reads glTF 2.0, so export it as that"},
    {"glTF/IncorrectVertexArrays/Cube_v1.gltf",
     "line 112, column 14: this is glTF 1.0; graze reads glTF 2.0, so export it as that"},
    {"glTF/TwoBoxes/TwoBoxes.gltf", "line 49, column 14: this is glTF 1.0; graze reads glTF 2.0, so export it as that"},
    {"glTF2/BoxWithInfinites-glTF-Binary/BoxWithInfinites.glb",
     "line 1, column 314: accessor 2: element 0 has -inf; coordinates must be finite numbers"},
    {"glTF2/IndexOutOfRange/AllIndicesOutOfRange.gltf",
     "line 59, column 9: accessor 0: index 0 is 65535, but accessor 2, which mesh 0 uses with it, has 24 vertices"},
    {"glTF2/IndexOutOfRange/IndexOutOfRange.gltf",
     "line 59, column 9: accessor 0: index 0 is 255, but accessor 2, which mesh 0 uses with it, has 24 vertices"},
    {"glTF2/MissingBin/BoxTextured.gltf",
     "line 178, column 20: buffer 0: \"uri\" is \"BoxTextured0.bin\", which cannot be read: there is no such file"},
    {"glTF2/RecursiveNodes/RecursiveNodes.gltf",
     "line 14, column 9: node 0: is a child of two nodes, or of itself; the nodes must be a tree"},
    {"glTF2/SchemaFailures/sceneWrongType.gltf", "line 6, column 14: \"scene\" must be a whole number, not a string"},
    {"glTF2/TestNoRootNode/NoScene.gltf",
     "line 5, column 14: \"scene\" is 0, but \"scenes\" has 0 elements, numbered from 0"},
    {"glTF2/draco/2CylinderEngine.gltf",
     "line 4753, column 5: the file needs the extension \"KHR_draco_mesh_compression\", which graze does not read; "
     "export it without"},
    {"glTF2/wrongTypes/badArray.gltf", "line 44, column 27: mesh 0: \"primitives\" must be an array, not an object"},
    {"invalid/OutOfMemory.off",
     "line 2, column 1: the number of vertices is 353535235358, but only 293 bytes follow; is the file cut off?"},
    {"invalid/empty.obj", "this is empty; a mesh needs at least its header"},
    {"invalid/empty.off", "this is empty; a mesh needs at least its header"},
    {"invalid/empty.ply", "this is empty; a mesh needs at least its header"},
    {"invalid/malformed.obj", "line 28, column 3: a face has vertex 0; vertices are numbered from 1"},
    {"invalid/malformed2.obj", "line 23, column 1: a face has 0 corners; it must have 3 to 10000"},
};

#define GRAZE_NEEDS_MODELS \
  if (!fs::exists(models)) GTEST_SKIP() << "there is no " << models << "; install assimp-testmodels"

TEST(MeshModels, GoodOnesAreRead) {
  GRAZE_NEEDS_MODELS;
  for (const GoodModel& model : good_models) {
    const MeshFile file = read_meshes(models / model.file);
    std::size_t faces = 0;
    for (const MeshPart& part : file.parts) faces += part.mesh.faces().size();
    EXPECT_EQ(file.parts.size(), model.parts) << model.file;
    EXPECT_EQ(faces, model.faces) << model.file;
  }
}

TEST(MeshModels, MalformedOnesAreRefused) {
  GRAZE_NEEDS_MODELS;
  for (const BadModel& model : bad_models) {
    const std::string path = (models / model.file).string();
    EXPECT_EQ(error_of([&path] { read_meshes(path); }), path + ": " + std::string(model.fault));
  }
}

TEST(MeshModels, NoneIsLeftOut) {
  GRAZE_NEEDS_MODELS;
  std::set<std::string> known;
  for (const GoodModel& model : good_models) known.emplace(model.file);
  for (const BadModel& model : bad_models) known.emplace(model.file);
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(models)) {
    std::string ending = entry.path().extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    const std::set<std::string> endings = {".stl", ".obj", ".ply", ".off", ".gltf", ".glb"};
    if (!entry.is_regular_file() || !endings.contains(ending)) continue;
    EXPECT_TRUE(known.contains(fs::relative(entry.path(), models).generic_string())) << entry.path();
  }
}

TEST(MeshModels, TheInstancesOfTheEngineShareTriangles) {
  GRAZE_NEEDS_MODELS;
  const MeshFile file = read_meshes(models / "glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb");
  std::set<const void*> shared;
  std::size_t faces = 0;
  for (const MeshPart& part : file.parts) {
    const auto& data = detail::placed(part.mesh).data();
    if (shared.insert(data.get()).second) faces += data->faces().size();
  }
  EXPECT_EQ(shared.size(), 29U);
  EXPECT_EQ(faces, 75'730U);
}

}  // namespace
}  // namespace graze::io::mesh_models_test
