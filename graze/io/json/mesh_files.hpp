// SPDX-License-Identifier: MIT
// Meshes of a scene that are in files of their own.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include <graze/io/json/fields.hpp>
#include <graze/io/mesh_file.hpp>

namespace graze::io {

/// Whether an object of a scene is a mesh with the field "file".
bool is_mesh_by_file(JsonValue object);

/// Reads each file once. Objects with the same file, part and kind share triangles.
class JsonMeshFiles {
 public:
  /// `folder`: what file names are relative to. None if the scene was not read from a file; then there are no mesh
  /// files.
  explicit JsonMeshFiles(std::optional<std::filesystem::path> folder) : folder_(std::move(folder)) {}

  /// The mesh of an object with the fields "type", "file" and, optionally, "part" and "kind": all parts of the file as
  /// one mesh, or those of that name. Of a solid, equal vertices are joined. `other_fields` are the names of further
  /// allowed fields. Throws InputError.
  Mesh<3, double> read(JsonValue object, const JsonPlace& place, std::span<const std::string_view> other_fields);

  /// What was not read of the files, and doubtful facts about them, in the order of first use.
  const std::vector<Omission>& omissions() const { return omissions_; }
  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  using Key = std::tuple<std::filesystem::path, std::string, MeshKind>;  // file, part, kind

  std::filesystem::path path_of(const JsonFields& fields) const;
  const MeshFile& file(const JsonFields& fields, const std::filesystem::path& path);

  std::optional<std::filesystem::path> folder_;
  std::map<std::filesystem::path, MeshFile> files_;
  std::map<Key, Mesh<3, double>> meshes_;
  std::vector<Omission> omissions_;
  std::vector<std::string> warnings_;
};

}  // namespace graze::io
