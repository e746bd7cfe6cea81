// SPDX-License-Identifier: MIT
#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include <graze/io/file/referenced_file.hpp>
#include <graze/io/file/utf8_path.hpp>
#include <graze/io/input_error.hpp>
#include <graze/io/json/mesh_files.hpp>
#include <graze/io/json/shape_reader.hpp>
#include <graze/io/mesh/joined.hpp>
#include <graze/io/output_error.hpp>
#include <graze/io/text/in_quotes.hpp>
#include <graze/io/text/printable.hpp>
#include <graze/io/text/suggestion.hpp>
#include <graze/shape/welded.hpp>

namespace graze::io {
namespace {

/// The parts of that name; all of them for an empty name.
std::vector<MeshPart> parts_called(const std::string& name, const MeshFile& file, const JsonFields& fields) {
  std::vector<MeshPart> parts;
  std::vector<std::string_view> known;
  for (const MeshPart& part : file.parts) {
    if (name.empty() || part.name == name) parts.push_back(part);
    known.push_back(part.name);
  }
  if (!parts.empty() || name.empty()) return parts;
  throw fields.error("part", fmt::format("is {}, but the file has no part of that name{}", in_quotes(name),
                                         did_you_mean(name, known)));
}

}  // namespace

bool is_mesh_by_file(JsonValue object) {
  if (object.kind() != JsonKind::object) return false;
  const std::optional<JsonValue> type = object.find("type");
  return type && type->kind() == JsonKind::text && type->text() == "mesh" && object.find("file");
}

std::filesystem::path JsonMeshFiles::path_of(const JsonFields& fields) const {
  const std::string_view name = read_text(fields.require("file"), {"file"}, fields.place());
  if (folder_) return (*folder_ / path_from_utf8(name)).lexically_normal();
  throw fields.error("file", "names a mesh file, but this scene was not read from a file that it could be relative to");
}

const MeshFile& JsonMeshFiles::file(const JsonFields& fields, const std::filesystem::path& path) {
  const auto known = files_.find(path);
  if (known != files_.end()) return known->second;
  const ReferencedFile bytes = read_referenced_file(path);
  if (!bytes.fault.empty()) {
    throw fields.error("file", fmt::format("is {}, which cannot be read: {}; it is relative to the scene",
                                           in_quotes(fields.require("file").text()), bytes.fault));
  }
  try {
    const MeshFile& file =
        files_.emplace(path, parse_meshes(bytes.bytes, printable(utf8_from_path(path)), path.parent_path()))
            .first->second;
    omissions_.insert(omissions_.end(), file.omissions.begin(), file.omissions.end());
    warnings_.insert(warnings_.end(), file.warnings.begin(), file.warnings.end());
    return file;
  } catch (const InputError& error) {
    throw fields.error("file", fmt::format("cannot be used: {}", error.what()));
  }
}

Mesh<3, double> JsonMeshFiles::read(JsonValue object, const JsonPlace& place,
                                    std::span<const std::string_view> other_fields) {
  const JsonFields fields(object, place, "a mesh");
  std::vector<std::string_view> allowed = {"type", "file", "part", "kind"};
  allowed.insert(allowed.end(), other_fields.begin(), other_fields.end());
  fields.allow_only(allowed);
  Key key{path_of(fields), "", read_json_mesh_kind(fields)};
  auto& [path, part, kind] = key;
  if (const auto value = fields.find("part")) part = read_text(*value, {"part"}, place);
  if (const auto known = meshes_.find(key); known != meshes_.end()) return known->second;
  const std::vector<MeshPart> parts = parts_called(part, file(fields, path), fields);
  try {
    const JoinedMesh all = joined(parts);
    Mesh<3, double> mesh = mesh_of<3, double>(all.vertices, all.faces, kind);
    if (kind == MeshKind::solid) mesh = welded(mesh);
    return meshes_.emplace(key, mesh).first->second;
  } catch (const OutputError& error) {
    throw fields.error("file", fmt::format("cannot be used: {}", error.what()));
  }
}

}  // namespace graze::io
