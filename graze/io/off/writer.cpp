// SPDX-License-Identifier: MIT
#include <array>
#include <cstdint>
#include <ostream>
#include <span>

#include <fmt/format.h>

#include <graze/io/mesh/joined.hpp>
#include <graze/io/off/writer.hpp>

namespace graze::io {

void write_off(std::ostream& out, std::span<const MeshPart> parts) {
  const JoinedMesh mesh = joined(parts);
  out << fmt::format("OFF\n{} {} 0\n", mesh.vertices.size(), mesh.faces.size());
  for (const Vec<3, double>& vertex : mesh.vertices) {
    out << fmt::format("{} {} {}\n", vertex.x, vertex.y, vertex.z);
  }
  for (const std::array<std::uint32_t, 3>& face : mesh.faces) {
    out << fmt::format("3 {} {} {}\n", face[0], face[1], face[2]);
  }
}

}  // namespace graze::io
