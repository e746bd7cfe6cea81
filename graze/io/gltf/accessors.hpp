// SPDX-License-Identifier: MIT
// The numbers of glTF: accessors describe arrays in buffers, which are chunks, data URIs or files.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <graze/io/gltf/root.hpp>
#include <graze/math/vec.hpp>

namespace graze::io {

class GltfAccessors {
 public:
  /// `binary` is the chunk of a .glb; buffers that are files lie in `folder` or below. Refers to `root`.
  GltfAccessors(const GltfRoot& root, std::optional<std::string_view> binary, std::filesystem::path folder)
      : root_(root), binary_(binary), folder_(std::move(folder)) {}

  /// Points: vectors of three floats, or of small integers (KHR_mesh_quantization). Each accessor is read once. Throws
  /// InputError.
  const std::vector<Vec<3, double>>& points(std::size_t accessor);
  /// Points that are the corners of faces in turn, without indices. Throws InputError, also if a file uses points so
  /// often that its faces would be out of proportion to its size.
  const std::vector<Vec<3, double>>& corners(std::size_t accessor);
  /// Indices: unsigned integers of one, two or four bytes. Throws InputError.
  std::vector<std::uint32_t> indices(std::size_t accessor);

 private:
  struct Layout;

  Layout layout_of(const JsonFields& accessor, std::size_t components) const;
  /// The numbers of an accessor, `components` for each element.
  std::vector<double> values(std::size_t accessor, std::size_t components);
  void read(const JsonFields& place, const Layout& layout, std::vector<double>& values);
  void read_sparse(const JsonFields& accessor, const Layout& layout, std::vector<double>& values);
  std::string_view bytes_of_view(std::size_t view);
  std::string_view bytes_of_buffer(std::size_t buffer);
  std::string load(const GltfItem& buffer) const;
  std::string load_file(const JsonFields& buffer, std::string_view uri) const;
  void spend(const JsonFields& accessor, std::size_t values);

  const GltfRoot& root_;
  std::optional<std::string_view> binary_;
  std::filesystem::path folder_;
  std::map<std::size_t, std::string> loaded_;  ///< By buffer; a map, because its elements keep their addresses.
  std::map<std::size_t, std::vector<Vec<3, double>>> points_;
  std::size_t total_bytes_ = 0;
  std::size_t values_read_ = 0;
};

}  // namespace graze::io
