// SPDX-License-Identifier: MIT
/// @file
/// Reads and writes files of triangle meshes: STL, OBJ, PLY, OFF and glTF 2.0. docs/mesh_formats.md says what of each
/// format is read.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <graze/io/omission.hpp>
#include <graze/math/platform/export.hpp>
#include <graze/shape/mesh.hpp>

namespace graze::io {

/// Which axis points up in the coordinates of a 3D file.
enum class UpAxis { unknown, y, z };

/// One mesh of a file, at its place in the file's coordinates.
struct MeshPart {
  std::string name;      ///< As in the file; not unique, and empty if the file does not give one.
  Mesh<3, double> mesh;  ///< A surface. Parts that are instances of one mesh share its triangles.
};

/// The meshes of a file, in its order and in its own coordinates, which are neither scaled nor turned.
struct MeshFile {
  std::vector<MeshPart> parts;                           ///< May be empty, and so may be a part's mesh.
  std::string source;                                    ///< The file's name as the user gave it, for messages.
  std::string format;                                    ///< "stl", "obj", "ply", "off", "gltf"
  UpAxis up = UpAxis::unknown;                           ///< y for glTF; the other formats do not say.
  std::optional<double> metres_per_unit = std::nullopt;  ///< 1 for glTF; the other formats do not say.
  std::vector<Omission> omissions = {};                  ///< What was not read, in the order of first occurrence.
  std::vector<std::string> warnings = {};                ///< Doubtful facts about the file, as sentences.
};

/// Reads a mesh file of any format, distinguished by content, not by name. The vertices of STL, which has no indices,
/// are welded where they are equal; those of other formats stay as they are, and `welded` welds them. Polygons become
/// triangles. A glTF file may refer to others in its own folder and below. Throws InputError.
GRAZE_EXPORT MeshFile read_meshes(const std::filesystem::path& path);

/// Reads meshes from the bytes of a file. `source` names it in messages; a glTF file finds others in `folder`. Throws
/// InputError.
GRAZE_EXPORT MeshFile parse_meshes(std::string_view bytes, const std::string& source,
                                   const std::filesystem::path& folder);

/// Makes a solid of each part that is closed and encloses a volume: whose faces, once equal vertices are welded, use
/// each edge as often in one direction as in the other. The other parts stay surfaces, and `file.warnings` names them.
GRAZE_EXPORT void make_closed_parts_solid(MeshFile& file);

/// Multiplies all coordinates: by 0.001 from millimetres to metres. Throws std::invalid_argument unless the factor is
/// finite and above 0, or if a coordinate overflows.
GRAZE_EXPORT void scale_parts(MeshFile& file, double factor);

/// A quarter turn about x.
enum class MeshTurn {
  y_up_to_z_up,  ///< (x, y, z) becomes (x, -z, y).
  z_up_to_y_up,  ///< (x, y, z) becomes (x, z, -y).
};

/// Turns all parts, exactly, and sets `file.up`.
GRAZE_EXPORT void turn_parts(MeshFile& file, MeshTurn turn);

/// The formats that are written: STL and PLY binary, glTF as .glb.
enum class MeshOutput { stl, obj, ply, off, glb };

/// Writes meshes. STL, PLY and OFF have no parts: all become one mesh. STL and glTF hold floats, so coordinates are
/// rounded; in the others, numbers survive bit for bit. In glTF, parts that share triangles are instances of one mesh.
/// Kinds of meshes are not written. Throws OutputError for what the format cannot hold: a coordinate beyond the range
/// of floats, more bytes than glTF can count. The caller checks the state of `out`.
GRAZE_EXPORT void write_meshes(std::ostream& out, MeshOutput format, std::span<const MeshPart> parts);

}  // namespace graze::io
