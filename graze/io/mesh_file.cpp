// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <ostream>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <unordered_set>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <graze/io/file/utf8_path.hpp>
#include <graze/io/file/whole_file.hpp>
#include <graze/io/gltf/reader.hpp>
#include <graze/io/gltf/root.hpp>
#include <graze/io/gltf/writer.hpp>
#include <graze/io/input_error.hpp>
#include <graze/io/json/document.hpp>
#include <graze/io/mesh/format.hpp>
#include <graze/io/mesh/shared_triangles.hpp>
#include <graze/io/mesh_file.hpp>
#include <graze/io/obj/reader.hpp>
#include <graze/io/obj/writer.hpp>
#include <graze/io/off/reader.hpp>
#include <graze/io/off/writer.hpp>
#include <graze/io/ply/reader.hpp>
#include <graze/io/ply/writer.hpp>
#include <graze/io/stl/reader.hpp>
#include <graze/io/stl/writer.hpp>
#include <graze/io/text/foreign_format.hpp>
#include <graze/io/text/in_quotes.hpp>
#include <graze/io/text/utf8.hpp>
#include <graze/shape/mesh_report.hpp>
#include <graze/shape/welded.hpp>

namespace graze::io {
namespace {

namespace fs = std::filesystem;

MeshFile parse_json_meshes(std::string_view text, const std::string& source, const fs::path& folder) {
  const JsonDocument document(text, source);
  if (is_gltf(document.root())) return read_gltf(document, std::nullopt, folder);
  throw InputError(
      fmt::format("{}: this is JSON, but not glTF; graze reads meshes from {}", source, mesh_formats_in_words));
}

/// Six times the volume that a closed mesh encloses: positive if its faces run counter-clockwise as seen from outside.
double volume_of(const Mesh<3, double>& mesh) {
  if (mesh.faces().empty()) return 0;
  const Vec<3, double> origin = mesh.triangle(0).a;
  double volume = 0;
  for (std::size_t face = 0; face < mesh.faces().size(); ++face) {
    const Triangle<3, double> triangle = mesh.triangle(face);
    volume += dot(triangle.a - origin, cross(triangle.b - origin, triangle.c - origin));
  }
  return volume;
}

/// Why a mesh cannot be made a solid; empty if it can.
std::string_view obstacle(const Mesh<3, double>& mesh) {
  if (mesh.faces().empty()) return "has no faces";
  if (!report(mesh).is_closed) return "is not closed";
  return volume_of(mesh) > 0 ? "" : "encloses no volume, or is inside out";
}

}  // namespace

MeshFile read_meshes(const fs::path& path) {
  const std::string bytes = read_whole_file(path, "the mesh file");
  return parse_meshes(bytes, utf8_from_path(path), path.parent_path());
}

MeshFile parse_meshes(std::string_view bytes, const std::string& source, const fs::path& folder) {
  const std::optional<MeshFormat> format = mesh_format_of(bytes);
  if (format == MeshFormat::stl_text) return read_stl_text(bytes, source);
  if (format == MeshFormat::stl_binary) return read_stl_binary(bytes, source);
  if (format == MeshFormat::obj) return read_obj(bytes, source);
  if (format == MeshFormat::ply) return read_ply(bytes, source);
  if (format == MeshFormat::off) return read_off(bytes, source);
  if (format == MeshFormat::glb) return read_glb_file(bytes, source, folder);
  const std::string_view text = without_byte_order_mark(bytes);
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  if (begin == std::string_view::npos) throw InputError(source + ": this is empty; a mesh needs at least its header");
  if (text[begin] == '{') return parse_json_meshes(bytes, source, folder);
  if (const std::string foreign = foreign_format(text); !foreign.empty()) throw InputError(source + ": " + foreign);
  throw InputError(fmt::format("{}: this is no mesh; graze reads meshes from {}", source, mesh_formats_in_words));
}

void make_closed_parts_solid(MeshFile& file) {
  struct Solid {
    Mesh<3, double> mesh;
    std::string_view obstacle;
  };
  auto solids = once_per_triangles<Solid>([](const Mesh<3, double>& mesh) {
    const Mesh<3, double> joined = welded(mesh);
    return Solid{mesh_of<3, double>(joined.vertices(), joined.faces(), MeshKind::solid), obstacle(joined)};
  });
  std::unordered_set<std::string> said;  // instances often have the same name
  for (std::size_t i = 0; i < file.parts.size(); ++i) {
    MeshPart& part = file.parts[i];
    const Solid& solid = solids.of(part.mesh);
    if (solid.obstacle.empty()) {
      part.mesh = placed_like(solid.mesh, part.mesh);
    } else {
      const std::string name = part.name.empty() ? fmt::format("number {}", i) : in_quotes(part.name);
      std::string warning = fmt::format("{}: the mesh {} {}, so it stays a surface", file.source, name, solid.obstacle);
      if (said.insert(warning).second) file.warnings.push_back(std::move(warning));
    }
  }
}

void scale_parts(MeshFile& file, double factor) {
  if (!(factor > 0 && std::isfinite(factor))) {
    throw std::invalid_argument(fmt::format("scale_parts: the factor is {}; it must be above 0 and finite", factor));
  }
  auto scaled = once_per_triangles<Mesh<3, double>>([factor](const Mesh<3, double>& mesh) {
    std::vector<Vec<3, double>> vertices;
    for (const Vec<3, double>& vertex : mesh.vertices()) vertices.push_back(vertex * factor);
    return mesh_of<3, double>(vertices, mesh.faces(), mesh.kind());
  });
  for (MeshPart& part : file.parts) {
    const auto& placed = detail::placed(part.mesh);
    const Mesh<3, double>& mesh = scaled.of(part.mesh);
    part.mesh = placed.is_moved() ? transformed(mesh, {placed.pose().rotation, placed.pose().position * factor}) : mesh;
  }
  if (file.metres_per_unit) *file.metres_per_unit /= factor;
}

void turn_parts(MeshFile& file, MeshTurn turn) {
  const double sign = turn == MeshTurn::y_up_to_z_up ? 1 : -1;
  const Pose<3, double> pose{{{1, 0, 0}, {0, 0, sign}, {0, -sign, 0}}, Vec<3, double>(0)};
  for (MeshPart& part : file.parts) part.mesh = transformed(part.mesh, pose);
  file.up = turn == MeshTurn::y_up_to_z_up ? UpAxis::z : UpAxis::y;
}

void write_meshes(std::ostream& out, MeshOutput format, std::span<const MeshPart> parts) {
  if (format == MeshOutput::stl) write_stl(out, parts);
  if (format == MeshOutput::obj) write_obj(out, parts);
  if (format == MeshOutput::ply) write_ply(out, parts);
  if (format == MeshOutput::off) write_off(out, parts);
  if (format == MeshOutput::glb) write_glb(out, parts);
}

}  // namespace graze::io
