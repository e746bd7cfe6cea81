// SPDX-License-Identifier: MIT
#include "files.hpp"

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <graze/io/json_scene.hpp>
#include <graze/io/log/query_log.hpp>
#include <graze/io/log/scene_after.hpp>
#include <graze/io/log/side_by_side.hpp>
#include <graze/io/replay.hpp>
#include <graze/io/scene_file.hpp>
#include <graze/io/scene_numbers.hpp>
#include <graze/io/shape_numbers.hpp>
#include <graze/io/svg.hpp>

#include "results.hpp"
#include "scenes.hpp"
#include "shape_fields.hpp"

namespace graze::python {
namespace {

io::SceneFile file_of(const HeldScene& held) {
  return std::visit(
      [&]<Dim N, class T>(const LoggedScene<N, T>& held_scene) {
        return without_gil([&] {
          const std::shared_lock lock(*held.lock);
          return io::SceneFile{io::scene_with_numbers<double>(held_scene.scene),
                               "",
                               std::string(io::json_scene_schema),
                               io::YAxis::up,
                               {}};
        });
      },
      held.any);
}

std::string drawn(const io::SceneFile& file) {
  return without_gil([&] {
    std::ostringstream out;
    std::visit([&](const auto& scene) { io::write_svg(out, file, scene.pairs()); }, file.scene);
    return out.str();
  });
}

py::object python_file(io::SceneFile file) {
  static ResultClass file_class("SceneFile");
  py::dict velocities;
  std::visit(
      [&]<Dim N>(const Scene<N, double>&) {
        for (const auto& [id, velocity] : file.velocities) {
          velocities[py::int_(packed(id))] = frozen_array<double>(&velocity[0], {static_cast<py::ssize_t>(N)});
        }
      },
      file.scene);
  const py::object scene =
      std::visit([]<Dim N>(Scene<N, double>& read) { return python_scene<N, double>(std::move(read)); }, file.scene);
  return file_class(scene, file.format, file.y_axis == io::YAxis::up ? "up" : "down", velocities,
                    py::cast(file.warnings), texts_of(file.omissions));
}

py::object read_file(const py::object& path, const py::object& meshes) {
  const std::filesystem::path place = path_of(path);
  const io::SceneReading reading{mesh_kind_of({"read_scene", "meshes"}, meshes)};
  return python_file(without_gil([&] { return io::read_scene(place, reading); }));
}

/// Of str or bytes.
py::object parse_text(const std::string& text, const std::string& source, const py::object& folder,
                      const py::object& meshes) {
  const std::filesystem::path place = path_of(folder);
  const io::SceneReading reading{mesh_kind_of({"parse_scene", "meshes"}, meshes)};
  return python_file(without_gil([&] { return io::parse_scene(text, source, place, reading); }));
}

std::string scene_text(const HeldScene& held) {
  const io::SceneFile file = file_of(held);
  std::ostringstream out;
  io::write_json_scene(out, file);
  return out.str();
}

template <Dim N>
io::ReplayReport replayed(const io::QueryLog<N>& log) {
  return io::replay<N>(log, io::library_targets<N>(log.numbers));
}

/// The text of a query log, and its name in messages: the path if it is a file.
struct LogText {
  std::string text;
  std::string source;
};

LogText log_text_of(std::string_view function, const py::object& log, const std::string& source) {
  if (py::isinstance<py::bytes>(log)) return {std::string(py::bytes(log)), source};
  if (py::isinstance<py::str>(log)) {
    const auto bytes = py::reinterpret_steal<py::object>(PyUnicode_AsUTF8String(log.ptr()));
    if (!bytes) throw py::error_already_set();
    return {std::string(py::bytes(bytes)), source};
  }
  if (!py::hasattr(log, "__fspath__")) {
    throw py::type_error(fmt::format("{}: log is a {}; a pathlib.Path or the text of a log is needed", function,
                                     Py_TYPE(log.ptr())->tp_name));
  }
  const std::filesystem::path place = path_of(log);
  return {std::string(py::bytes(py::module_::import("pathlib").attr("Path")(log).attr("read_bytes")())),
          place.string()};
}

py::object replay_log(const py::object& given, const std::string& source) {
  static ResultClass report_class("ReplayReport");
  const LogText text = log_text_of("replay", given, source);
  const io::ReplayReport report = without_gil([&] {
    const io::AnyQueryLog log = io::parse_query_log(text.text, text.source);
    return std::visit([](const auto& any) { return replayed(any); }, log);
  });
  return report_class(report.calls, report.differing);
}

py::object scene_after_log(const py::object& given, const std::string& source) {
  const LogText text = log_text_of("scene_after", given, source);
  auto scene = without_gil([&] {
    const io::AnyQueryLog log = io::parse_query_log(text.text, text.source);
    return std::visit([&](const auto& any) -> io::AnyScene { return io::scene_after(any, text.source); }, log);
  });
  return std::visit([]<Dim N>(Scene<N, double>& after) { return python_scene<N, double>(std::move(after)); }, scene);
}

}  // namespace

py::list texts_of(const std::vector<io::Omission>& omissions) {
  py::list texts;
  for (const io::Omission& omission : omissions) texts.append(io::omission_text(omission));
  return texts;
}

std::filesystem::path path_of(const py::object& path) {
  PyObject* bytes = nullptr;
  if (PyUnicode_FSConverter(path.ptr(), static_cast<void*>(&bytes)) == 0) throw py::error_already_set();
  return std::string(py::reinterpret_steal<py::bytes>(bytes));
}

std::string svg_of(const HeldScene& scene) { return drawn(file_of(scene)); }

std::string svg_of_shape(const HeldShape& shape) {
  return on_shape(shape, []<Dim N, class T>(const AnyShape<N, T>& any) {
    Scene<N, double> scene;
    scene.add(io::with_numbers<double, N, T>(any));
    return drawn({std::move(scene), "", "", io::YAxis::up, {}});
  });
}

void add_files(py::module_& module) {
  const py::arg_v meshes("meshes", "surface");
  module.def(
      "read_scene", &read_file, py::arg("path"), py::kw_only(), meshes,
      "Reads a scene file in any format that graze knows (JSON, CSV, Tiled, STL, OBJ, PLY, OFF, glTF), told apart by "
      "content: a SceneFile whose scene has float64. meshes: 'solid' makes solids of the closed meshes of a mesh "
      "file.");
  module.def("parse_scene", &parse_text, py::arg("text"), py::arg("source") = "text", py::arg("folder") = ".",
             py::kw_only(), meshes,
             "Reads a scene from str or bytes; `source` names it in messages, and files that it refers to are in "
             "`folder`.");
  module.def("scene_json", &scene_text, py::arg("scene"), "A scene as a text in graze's format, docs/scene_format.md.");
  module.def(
      "replay", &replay_log, py::arg("log"), py::arg("source") = "log",
      "Performs the calls of a query log (docs/query_log.md) again and compares the answers: a ReplayReport. The "
      "log is a pathlib.Path, or its text as str or bytes; then `source` names it in messages.");
  module.def("scene_after", &scene_after_log, py::arg("log"), py::arg("source") = "log",
             "The scene after the calls of a query log, as in `replay`, with float64.");
}

}  // namespace graze::python
