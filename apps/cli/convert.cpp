// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include <graze/io/input_error.hpp>
#include <graze/io/json_scene.hpp>
#include <graze/io/mesh/scene.hpp>
#include <graze/io/mesh_file.hpp>
#include <graze/io/text/in_quotes.hpp>

#include "command.hpp"
#include "file_ending.hpp"
#include "input.hpp"
#include "output.hpp"
#include "progress.hpp"
#include "usage.hpp"

namespace graze::cli {
namespace {

struct ConvertArguments {
  std::string input;
  std::string output;
  std::optional<double> scale;
  std::optional<std::string> turn;
  io::SceneReading reading;
  bool strict = false;
};

constexpr std::array<std::pair<std::string_view, io::MeshTurn>, 2> turns{
    {{"y-to-z", io::MeshTurn::y_up_to_z_up}, {"z-to-y", io::MeshTurn::z_up_to_y_up}}};

constexpr std::array<std::pair<std::string_view, io::MeshOutput>, 5> mesh_endings{{{".stl", io::MeshOutput::stl},
                                                                                   {".obj", io::MeshOutput::obj},
                                                                                   {".ply", io::MeshOutput::ply},
                                                                                   {".off", io::MeshOutput::off},
                                                                                   {".glb", io::MeshOutput::glb}}};

/// The mesh format that the name of the output asks for; none for graze's JSON.
std::optional<io::MeshOutput> mesh_format_of(const std::string& output) {
  if (is_standard_stream(output)) return std::nullopt;
  const std::string ending = file_ending(output);
  if (ending == ".json") return std::nullopt;
  const auto* const found =
      std::find_if(mesh_endings.begin(), mesh_endings.end(), [&](const auto& one) { return one.first == ending; });
  if (found != mesh_endings.end()) return found->second;
  throw UsageError("graze cannot write " + io::in_quotes(output) +
                   "; it writes graze's JSON, so give a name that ends in .json, or - for the standard output, and "
                   "meshes as .glb, .stl, .obj, .ply or .off");
}

/// The meshes of a scene. A mesh format holds no other shapes.
std::vector<io::MeshPart> parts_of(const io::SceneFile& file) {
  const auto* const scene = std::get_if<Scene<3, double>>(&file.scene);
  if (scene == nullptr) {
    throw io::InputError(fmt::format("{}: is a 2D scene, and mesh files are 3D; write it as .json", name_of(file)));
  }
  std::vector<io::MeshPart> parts;
  for (const ObjectId id : scene->ids()) {
    const Object<3, double>& object = scene->object(id);
    const auto* const mesh = std::get_if<Mesh<3, double>>(&object.shape);
    if (mesh == nullptr) {
      throw io::InputError(fmt::format("{}: the object {} is a {}, and mesh files hold only meshes; write it as .json",
                                       name_of(file), io::in_quotes(object.name), type_name<3, double>(object.shape)));
    }
    parts.push_back({object.name, *mesh});
  }
  return parts;
}

/// Reads the input, scaled and turned if that is wanted, which only mesh files allow.
io::SceneFile read_scene(const ConvertArguments& arguments) {
  if (!arguments.scale && !arguments.turn) return read_input(arguments.input, arguments.reading);
  io::MeshFile meshes = read_mesh_input(arguments.input);
  if (arguments.reading.meshes == MeshKind::solid) io::make_closed_parts_solid(meshes);
  try {
    if (arguments.scale) io::scale_parts(meshes, *arguments.scale);
  } catch (const std::invalid_argument&) {
    throw io::InputError(fmt::format("{}: --scale {} makes a coordinate larger than about 1.8e308, the largest number",
                                     meshes.source, *arguments.scale));
  }
  if (arguments.turn) io::turn_parts(meshes, chosen("--turn", *arguments.turn, turns));
  return io::scene_of_meshes(std::move(meshes));
}

ExitCode run_convert(const ConvertArguments& arguments) {
  const std::optional<io::MeshOutput> format = mesh_format_of(arguments.output);
  if (arguments.turn) static_cast<void>(chosen("--turn", *arguments.turn, turns));
  if (arguments.scale && !(*arguments.scale > 0 && std::isfinite(*arguments.scale))) {
    throw UsageError(fmt::format("--scale {} is not a factor; it must be above 0", *arguments.scale));
  }
  Progress reading("reading the scene");
  const io::SceneFile file = read_scene(arguments);
  reading.stop();
  tell_omissions(file, arguments.strict);
  const std::vector<io::MeshPart> parts = format ? parts_of(file) : std::vector<io::MeshPart>();
  Progress writing("writing the scene");
  if (is_standard_stream(arguments.output)) writing.stop();  // the data may go to the same terminal
  write_output(arguments.output, [&](std::ostream& out) {
    format ? io::write_meshes(out, *format, parts) : io::write_json_scene(out, file);
  });
  return done;
}

constexpr const char* convert_footer =
    R"(OUT ends in .json, .glb, .stl, .obj, .ply or .off; it may be the same file as IN. Numbers survive
bit for bit, except in .stl and .glb, which hold floats. STL, PLY and OFF join all meshes to one.

Examples:
  graze convert level.tmx level.json
  graze convert chip.csv - | gzip > chip.json.gz
  graze convert engine.glb engine.obj
  graze convert --scale 0.001 --turn z-to-y part.stl part.glb

Exit codes: 0 done; 2 wrong usage; 3 bad input, or an output that cannot be written)";

}  // namespace

Command add_convert(CLI::App& program) {
  CLI::App* app = program.add_subcommand("convert", "Write a scene in graze's own JSON, or its meshes as a mesh file");
  const auto arguments = std::make_shared<ConvertArguments>();
  app->add_option("IN", arguments->input, "Scene file, or - for the standard input")->required()->type_name("");
  app->add_option("OUT", arguments->output, "File to write, or - for JSON on the standard output")
      ->required()
      ->type_name("");
  app->add_option("--scale", arguments->scale, "Multiply the coordinates of a mesh file, as by 0.001 from mm to m")
      ->type_name("FACTOR")
      ->take_last();
  app->add_option("--turn", arguments->turn, "Turn a mesh file from y up to z up, or back: y-to-z or z-to-y")
      ->type_name("AXES")
      ->take_last();
  add_solid(*app, arguments->reading);
  add_strict(*app, arguments->strict);
  app->footer(convert_footer);
  return {app, [arguments] { return run_convert(*arguments); }};
}

}  // namespace graze::cli
