// SPDX-License-Identifier: MIT
// Reads a mesh file, or a bracket in millimetres if none is named: what is in it, in metres and with z up, then as
// .glb.
#include <cstdio>
#include <sstream>
#include <string>

#include <graze/graze.hpp>
#include <graze/io/input_error.hpp>
#include <graze/io/mesh_file.hpp>
#include <graze/shape/mesh_report.hpp>
#include <graze/shape/welded.hpp>

/// A tetrahedron and a plate, y up.
constexpr const char* bracket = R"(o foot
v 0 0 0
v 100 0 0
v 0 50 0
v 0 0 100
f 1 3 2
f 1 2 4
f 1 4 3
f 2 3 4
o plate
v 0 60 0
v 100 60 0
v 100 60 100
v 0 60 100
f 8 7 6 5
)";

int main(int argc, char** argv) {
  try {
    namespace io = graze::io;
    io::MeshFile file = argc > 1 ? io::read_meshes(argv[1]) : io::parse_meshes(bracket, "bracket.obj", ".");
    io::make_closed_parts_solid(file);
    io::scale_parts(file, 0.001);
    io::turn_parts(file, io::MeshTurn::y_up_to_z_up);
    for (const io::MeshPart& part : file.parts) {
      const graze::MeshReport found = graze::report(graze::welded(part.mesh));
      const bool is_solid = part.mesh.kind() == graze::MeshKind::solid;
      std::printf("%s: %zu faces, %zu open edges, a %s, up to z = %g\n", part.name.c_str(), part.mesh.faces().size(),
                  found.open_edges, is_solid ? "solid" : "surface", graze::bounds(part.mesh).max.z);
    }
    for (const std::string& warning : file.warnings) std::printf("%s\n", warning.c_str());
    for (const io::Omission& omission : file.omissions) std::printf("not read: %s\n", omission.what.c_str());

    std::stringstream out;  // or a std::ofstream in binary mode
    io::write_meshes(out, io::MeshOutput::glb, file.parts);
    const io::MeshFile again = io::parse_meshes(out.str(), "bracket.glb", ".");
    std::printf("%zu bytes of %s, %zu parts\n", out.str().size(), again.format.c_str(), again.parts.size());
    return again.parts.size() == file.parts.size() ? 0 : 1;
  } catch (const graze::io::InputError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
