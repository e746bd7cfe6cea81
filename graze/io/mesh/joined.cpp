// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>

#include <fmt/format.h>

#include <graze/io/mesh/joined.hpp>
#include <graze/io/output_error.hpp>

namespace graze::io {

JoinedMesh joined(std::span<const MeshPart> parts) {
  JoinedMesh all;
  for (const MeshPart& part : parts) {
    const std::size_t first = all.vertices.size();
    if (part.mesh.vertices().size() > std::numeric_limits<std::uint32_t>::max() - first) {
      throw OutputError("the meshes have more than 2^32 - 1 vertices together, more than one mesh can have");
    }
    all.vertices.insert(all.vertices.end(), part.mesh.vertices().begin(), part.mesh.vertices().end());
    const auto shift = static_cast<std::uint32_t>(first);
    for (const std::array<std::uint32_t, 3>& face : part.mesh.faces()) {
      all.faces.push_back({shift + face[0], shift + face[1], shift + face[2]});
    }
  }
  return all;
}

float as_float(double coordinate, std::string_view format) {
  const auto rounded = static_cast<float>(coordinate);
  if (std::isfinite(rounded)) return rounded;
  throw OutputError(fmt::format("{} holds floats, up to 3.4e38, but a coordinate is {}", format, coordinate));
}

}  // namespace graze::io
