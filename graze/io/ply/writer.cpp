// SPDX-License-Identifier: MIT
#include <array>
#include <cstdint>
#include <ostream>
#include <span>
#include <string>

#include <fmt/format.h>

#include <graze/io/mesh/bytes.hpp>
#include <graze/io/mesh/joined.hpp>
#include <graze/io/ply/writer.hpp>

namespace graze::io {

void write_ply(std::ostream& out, std::span<const MeshPart> parts) {
  const JoinedMesh mesh = joined(parts);
  out << fmt::format(
      "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty double x\nproperty double y\n"
      "property double z\nelement face {}\nproperty list uchar uint vertex_indices\nend_header\n",
      mesh.vertices.size(), mesh.faces.size());
  std::string record;
  for (const Vec<3, double>& vertex : mesh.vertices) {
    record.clear();
    for (Dim i = 0; i < 3; ++i) append_number(record, vertex[i]);
    out << record;
  }
  for (const std::array<std::uint32_t, 3>& face : mesh.faces) {
    record.clear();
    append_number(record, std::uint8_t{3});
    for (const std::uint32_t vertex : face) append_number(record, vertex);
    out << record;
  }
}

}  // namespace graze::io
