// SPDX-License-Identifier: MIT
// Files of triangle meshes: STL, OBJ, PLY, OFF and glTF.
#include <algorithm>
#include <array>
#include <filesystem>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <graze/io/mesh_file.hpp>
#include <graze/io/shape_numbers.hpp>

#include "files.hpp"
#include "module.hpp"
#include "results.hpp"
#include "shape_fields.hpp"

namespace graze::python {
namespace {

/// read() of a file, whose closed parts become solids if that is the kind.
template <class Read>
py::object python_meshes(MeshKind kind, const Read& read) {
  static ResultClass file_class("MeshFile");
  static ResultClass part_class("MeshPart");
  const io::MeshFile file = without_gil([&] {
    io::MeshFile found = read();
    if (kind == MeshKind::solid) io::make_closed_parts_solid(found);
    return found;
  });
  py::tuple parts(file.parts.size());
  for (std::size_t i = 0; i < file.parts.size(); ++i) {
    const io::MeshPart& part = file.parts[i];
    parts[i] = part_class(part.name, python_shape<3, double>(part.mesh, "read_meshes: a part"));
  }
  const py::object up =
      file.up == io::UpAxis::unknown ? py::object(py::none()) : py::str(file.up == io::UpAxis::y ? "y" : "z");
  return file_class(parts, file.format, up, file.metres_per_unit, py::cast(file.warnings), texts_of(file.omissions));
}

py::object read_mesh_file(const py::object& path, const py::object& kind) {
  const std::filesystem::path place = path_of(path);
  return python_meshes(mesh_kind_of({"read_meshes", "kind"}, kind), [&] { return io::read_meshes(place); });
}

py::object parse_mesh_bytes(const std::string& data, const std::string& source, const py::object& folder,
                            const py::object& kind) {
  const std::filesystem::path place = path_of(folder);
  return python_meshes(mesh_kind_of({"parse_meshes", "kind"}, kind),
                       [&] { return io::parse_meshes(data, source, place); });
}

constexpr std::array<std::pair<std::string_view, io::MeshOutput>, 5> formats{{{"stl", io::MeshOutput::stl},
                                                                              {"obj", io::MeshOutput::obj},
                                                                              {"ply", io::MeshOutput::ply},
                                                                              {"off", io::MeshOutput::off},
                                                                              {"glb", io::MeshOutput::glb}}};

io::MeshOutput format_named(const std::string& name) {
  const auto* const found =
      std::find_if(formats.begin(), formats.end(), [&](const auto& one) { return one.first == name; });
  if (found != formats.end()) return found->second;
  throw py::value_error(fmt::format("mesh_bytes: format is '{}'; it is one of stl, obj, ply, off, glb", name));
}

/// A Mesh in 3D, or a MeshPart with one.
io::MeshPart part_of(std::size_t index, const py::object& value) {
  io::MeshPart part;
  py::object mesh = value;
  if (!is_boxed<HeldShape>(value) && py::hasattr(value, "mesh") && py::hasattr(value, "name")) {
    part.name = py::str(value.attr("name"));
    mesh = value.attr("mesh");
  }
  if (is_boxed<HeldShape>(mesh)) {
    const auto& shape = unboxed<HeldShape>(mesh);
    if (const auto* const any = std::get_if<AnyShape<3, double>>(&shape.any)) {
      if (const auto* const held = std::get_if<Mesh<3, double>>(any)) return {part.name, *held};
    }
    if (const auto* const any = std::get_if<AnyShape<3, float>>(&shape.any)) {
      if (std::holds_alternative<Mesh<3, float>>(*any)) {
        return {part.name, std::get<Mesh<3, double>>(io::with_numbers<double, 3, float>(*any))};
      }
    }
    throw py::type_error(fmt::format("mesh_bytes: mesh {} is {}; a Mesh in 3D is needed", index, described(shape)));
  }
  throw py::type_error(
      fmt::format("mesh_bytes: mesh {} is a {}; a Mesh in 3D is needed", index, Py_TYPE(mesh.ptr())->tp_name));
}

py::bytes bytes_of_meshes(const py::object& meshes, const std::string& format) {
  const io::MeshOutput output = format_named(format);
  std::vector<io::MeshPart> parts;
  if (is_boxed<HeldShape>(meshes)) {
    parts.push_back(part_of(0, meshes));
  } else {
    for (const py::handle each : py::iter(meshes)) {
      parts.push_back(part_of(parts.size(), py::reinterpret_borrow<py::object>(each)));
    }
  }
  return py::bytes(without_gil([&] {
    std::ostringstream out;
    io::write_meshes(out, output, parts);
    return std::move(out).str();
  }));
}

}  // namespace

void add_mesh_files(py::module_& module) {
  const py::arg_v kind("kind", "surface");
  module.def("read_meshes", &read_mesh_file, py::arg("path"), py::kw_only(), kind,
             "Reads a mesh file (STL, OBJ, PLY, OFF, glTF), told apart by content: a MeshFile, whose meshes have "
             "float64. kind: "
             "'solid' makes solids of those that are closed.");
  module.def("parse_meshes", &parse_mesh_bytes, py::arg("data"), py::arg("source") = "data", py::arg("folder") = ".",
             py::kw_only(), kind,
             "Reads meshes from bytes or str; `source` names them in messages, and files that glTF refers to are in "
             "`folder`.");
  module.def(
      "mesh_bytes", &bytes_of_meshes, py::arg("meshes"), py::arg("format"),
      "A Mesh in 3D, or a sequence of them or of MeshParts, as the bytes of a file: format is 'stl', 'obj', 'ply', "
      "'off' or 'glb'. STL and glTF hold float32, and STL, PLY and OFF join all to one mesh.");
}

}  // namespace graze::python
