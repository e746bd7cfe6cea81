// SPDX-License-Identifier: MIT
#include <array>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <span>

#include <fmt/format.h>

#include <graze/io/obj/writer.hpp>
#include <graze/io/text/printable.hpp>

namespace graze::io {

void write_obj(std::ostream& out, std::span<const MeshPart> parts) {
  if (parts.empty()) out << "g\n";  // so that the file is recognised
  std::size_t first = 1;            // indices count from 1 through the whole file
  for (const MeshPart& part : parts) {
    out << fmt::format("o {}\n", printable(part.name));
    for (const Vec<3, double>& vertex : part.mesh.vertices()) {
      out << fmt::format("v {} {} {}\n", vertex.x, vertex.y, vertex.z);
    }
    for (const std::array<std::uint32_t, 3>& face : part.mesh.faces()) {
      out << fmt::format("f {} {} {}\n", first + face[0], first + face[1], first + face[2]);
    }
    first += part.mesh.vertices().size();
  }
}

}  // namespace graze::io
