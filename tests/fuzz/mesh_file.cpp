// SPDX-License-Identifier: MIT
// Any bytes as a mesh file: they are rejected with a message, or read; what was read can be written in every format and
// read again with the same faces.
#include <array>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

#include <graze/io/mesh_file.hpp>
#include <graze/io/output_error.hpp>

#include "fuzz/input.hpp"
#include "fuzz/texts.hpp"

using namespace graze;

namespace {

using Corners = std::vector<Vec<3, double>>;

Corners corners_of(const io::MeshFile& file) {
  Corners corners;
  for (const io::MeshPart& part : file.parts) {
    for (std::size_t face = 0; face < part.mesh.faces().size(); ++face) {
      for (const Vec<3, double>& corner : part.mesh.triangle(face).vertices()) corners.push_back(corner);
    }
  }
  return corners;
}

/// Formats that hold floats round, or refuse what is beyond their range.
void require_return(const io::MeshFile& file, io::MeshOutput format, bool holds_doubles) {
  std::ostringstream out;
  try {
    io::write_meshes(out, format, file.parts);
  } catch (const io::OutputError&) {
    test::fuzz::require(!holds_doubles, [](std::ostream& say) { say << "this format must hold all doubles"; });
    return;
  }
  const io::MeshFile again =
      test::fuzz::read_again(out.str(), [](const std::string& bytes) { return io::parse_meshes(bytes, "again", "."); });
  const Corners before = corners_of(file);
  const Corners after = corners_of(again);
  test::fuzz::require(before.size() == after.size() && (!holds_doubles || before == after), [&](std::ostream& say) {
    say << "the faces must be unchanged after writing and reading, but are " << before.size() / 3 << " and "
        << after.size() / 3 << " in\n"
        << out.str();
  });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes = test::fuzz::Input(data, size).rest();
  auto file = test::fuzz::read_or_refuse([&] { return io::parse_meshes(bytes, "mesh", "no folder"); });
  if (!file) return 0;
  require_return(*file, io::MeshOutput::obj, true);
  require_return(*file, io::MeshOutput::ply, true);
  require_return(*file, io::MeshOutput::off, true);
  require_return(*file, io::MeshOutput::stl, false);
  require_return(*file, io::MeshOutput::glb, false);
  io::make_closed_parts_solid(*file);
  return 0;
}
