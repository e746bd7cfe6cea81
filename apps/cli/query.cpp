// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <limits>
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
#include <graze/io/json/shape_reader.hpp>
#include <graze/io/log/query_log.hpp>
#include <graze/io/log/scene_after.hpp>
#include <graze/io/report/found.hpp>
#include <graze/io/scene_file.hpp>
#include <graze/io/text/decimal.hpp>
#include <graze/scene/scene.hpp>
#include <graze/scene/scene_query.hpp>

#include "command.hpp"
#include "coordinates.hpp"
#include "input.hpp"
#include "output.hpp"
#include "progress.hpp"
#include "terminal.hpp"
#include "usage.hpp"

namespace graze::cli {
namespace {

using io::FoundDetail;
using io::ReportFormat;

/// The parsed command line.
struct QueryArguments {
  std::optional<std::string> scene;
  std::optional<std::string> log;
  std::string format = "table";
  std::string output = "-";
  std::optional<std::string> point;
  std::optional<std::string> box;
  std::optional<std::string> sphere;
  std::optional<std::string> ray;
  std::optional<std::string> cast;
  std::optional<std::string> motion;
  std::optional<std::string> contacts_with;
  std::optional<std::string> nearest_to;
  std::optional<std::int64_t> nearest;  // signed, so that negative numbers are detected
  std::optional<double> t_max;
  std::optional<std::string> layer;
  bool only_first = false;
  io::SceneReading reading;
  bool strict = false;
};

constexpr std::array<std::pair<std::string_view, ReportFormat>, 4> query_formats{{{"table", ReportFormat::table},
                                                                                  {"json", ReportFormat::json},
                                                                                  {"ndjson", ReportFormat::ndjson},
                                                                                  {"csv", ReportFormat::csv}}};

/// Refuses a missing or ambiguous source, and an output that would overwrite the log.
void require_one_scene(const QueryArguments& arguments) {
  if (!arguments.scene && !arguments.log) {
    throw UsageError("query needs a SCENE, or --log FILE for the scene at the end of a log");
  }
  if (arguments.scene && arguments.log) {
    throw UsageError("the scene " + io::in_quotes(*arguments.scene) + " and the log " + io::in_quotes(*arguments.log) +
                     " cannot both be queried; give only one of SCENE and --log");
  }
  if (arguments.log && !is_standard_stream(arguments.output) && name_same_file(*arguments.log, arguments.output)) {
    throw UsageError("the log " + io::in_quotes(arguments.output) +
                     " would be overwritten; name another file to write to");
  }
}

/// Refuses a missing or ambiguous question, and options that belong to another one.
void require_one_question(const QueryArguments& arguments) {
  int questions = 0;
  for (const auto* const question : {&arguments.point, &arguments.box, &arguments.sphere, &arguments.ray,
                                     &arguments.cast, &arguments.contacts_with, &arguments.nearest_to}) {
    questions += question->has_value() ? 1 : 0;
  }
  constexpr std::string_view known = "of --point, --box, --sphere, --ray, --cast, --contacts-with and --nearest-to";
  if (questions == 0) throw UsageError(fmt::format("no query is given; use one {}", known));
  if (questions > 1) throw UsageError(fmt::format("several queries are given; use only one {}", known));
  if (arguments.nearest && !arguments.point && !arguments.nearest_to) {
    throw UsageError("--nearest needs --point or --nearest-to");
  }
  if (arguments.nearest && *arguments.nearest < 1) {
    throw UsageError(fmt::format("--nearest is {}; it must be 1 or more", *arguments.nearest));
  }
  if (arguments.t_max && !arguments.ray) throw UsageError("--t-max needs --ray");
  if (arguments.cast && !arguments.motion) throw UsageError("--cast needs --motion");
  if (arguments.motion && !arguments.cast) throw UsageError("--motion needs --cast");
  if (arguments.only_first && !arguments.ray && !arguments.cast) throw UsageError("--first needs --ray or --cast");
}

/// Parses "1,2.5,-3" as the given number of numbers.
std::vector<double> numbers_in(const std::string& option, const std::string& text, std::size_t count,
                               const std::string& meaning) {
  std::vector<double> numbers;
  for (std::size_t first = 0; first <= text.size();) {
    const std::size_t comma = std::min(text.find(',', first), text.size());
    const io::Decimal number = io::decimal_of(std::string_view(text).substr(first, comma - first));
    if (!number.fault.empty()) {
      throw UsageError(fmt::format("{} {} is not a comma-separated list of numbers: one {}", option,
                                   io::in_quotes(text), number.fault));
    }
    numbers.push_back(number.value);
    first = comma + 1;
  }
  if (numbers.size() != count) {
    throw UsageError(fmt::format("{} {} has {} number{}; it takes {}", option, io::in_quotes(text), numbers.size(),
                                 numbers.size() == 1 ? "" : "s", meaning));
  }
  return numbers;
}

/// One query to a scene of either dimension.
template <Dim N>
class Query {
 public:
  Query(const QueryArguments& arguments, const Scene<N, double>& scene) : arguments_(arguments), scene_(scene) {
    if (arguments.layer) query_.layers = mask_of(*arguments.layer);
  }

  void ask(io::FoundReport& report) {
    if (arguments_.ray) return ask_ray(report);
    if (arguments_.cast) return ask_cast(report);
    if (arguments_.contacts_with) return ask_contacts(report);
    if (arguments_.nearest || arguments_.nearest_to) return ask_nearest(report);
    for (const ObjectId id : scene_.overlapping(region(), query_)) report.objects.push_back(found(id, 0));
  }

 private:
  static constexpr bool is_flat = N == 2;
  static constexpr std::size_t two_vectors = 2 * static_cast<std::size_t>(N);

  LayerMask mask_of(const std::string& name) const {
    const std::vector<std::string>& known = scene_.layer_names();
    for (std::size_t i = 0; i < known.size(); ++i) {
      if (known[i] == name) return only_layer(static_cast<Layer>(i));
    }
    const std::vector<std::string_view> words(known.begin(), known.end());
    throw UsageError("--layer " + io::in_quotes(name) + " is not in the scene" + io::did_you_mean(name, words));
  }

  io::FoundObject found(const ObjectId& id, double number) const {
    const Object<N, double>& object = scene_.object(id);
    // All objects of a file have names, but not all of a log; those without one are shown by their ids.
    const bool has_name = !arguments_.log || !object.name.empty();
    return {has_name ? object.name : fmt::format("[{}, {}]", id.index, id.generation),
            type_name<N, double>(object.shape), number};
  }

  Vec<N, double> point() const {
    const auto numbers = numbers_in("--point", *arguments_.point, N, is_flat ? "x,y" : "x,y,z");
    return vector_at<N>(numbers, 0);
  }

  AnyShape<N, double> region() const {
    if (arguments_.point) return point();
    if (arguments_.box) {
      const auto numbers = numbers_in("--box", *arguments_.box, two_vectors, is_flat ? "x,y,x,y" : "x,y,z,x,y,z");
      return Aabb<N, double>::from_corners(vector_at<N>(numbers, 0), vector_at<N>(numbers, N));
    }
    const auto numbers = numbers_in("--sphere", *arguments_.sphere, N + 1, is_flat ? "x,y,radius" : "x,y,z,radius");
    return Sphere<N, double>{vector_at<N>(numbers, 0), numbers[N]};
  }

  /// A shape in JSON, or that of an object by its name, which then is not found itself.
  AnyShape<N, double> shape(const std::string& option, const std::string& text) {
    if (!text.empty() && text.front() == '{') {
      try {
        return io::parse_json_shape<N>(text, option);
      } catch (const io::InputError& error) {
        throw UsageError(error.what());
      }
    }
    const std::optional<ObjectId> id = scene_.find(text);
    if (!id) {
      std::vector<std::string_view> names;
      for (const ObjectId& other : scene_.ids()) names.push_back(scene_.object(other).name);
      throw UsageError(option + " " + io::in_quotes(text) + " is no object of the scene, and no shape such as " +
                       R"({"type": "sphere", ...})" + io::did_you_mean(text, names));
    }
    excepted_ = *id;
    query_.except = {&excepted_, 1};
    return scene_.object(*id).shape;
  }

  void ask_cast(io::FoundReport& report) {
    const auto numbers = numbers_in("--motion", *arguments_.motion, N, is_flat ? "x,y" : "x,y,z");
    const Vec<N, double> motion = vector_at<N>(numbers, 0);
    const AnyShape<N, double> moving = shape("--cast", *arguments_.cast);
    std::vector<ObjectImpact<N, double>> impacts;
    if (arguments_.only_first) {
      if (const auto first = scene_.shape_cast(moving, motion, query_)) impacts.push_back(*first);
    } else {
      impacts = scene_.shape_cast_all(moving, motion, query_);
    }
    report.detail = FoundDetail::impact;
    for (const auto& [id, impact] : impacts) {
      report.objects.push_back(found_at(id, impact.t, impact.point, impact.normal));
    }
  }

  void ask_contacts(io::FoundReport& report) {
    report.detail = FoundDetail::contact;
    for (const auto& [id, manifold] :
         scene_.contacts_with(shape("--contacts-with", *arguments_.contacts_with), query_)) {
      for (const auto& contact : manifold.contacts()) {
        report.objects.push_back(found_at(id, contact.depth, contact.point, manifold.normal));
      }
    }
  }

  void ask_nearest(io::FoundReport& report) {
    report.detail = FoundDetail::distance;
    const auto count = static_cast<std::size_t>(arguments_.nearest.value_or(1));
    const AnyShape<N, double> from =
        arguments_.nearest_to ? shape("--nearest-to", *arguments_.nearest_to) : AnyShape<N, double>(point());
    for (const auto& [id, distance] : scene_.nearest(from, count, query_))
      report.objects.push_back(found(id, distance));
  }

  io::FoundObject found_at(const ObjectId& id, double number, const Vec<N, double>& point,
                           const Vec<N, double>& normal) const {
    io::FoundObject object = found(id, number);
    object.point = coordinates(point);
    object.normal = coordinates(normal);
    return object;
  }

  void ask_ray(io::FoundReport& report) const {
    const auto numbers = numbers_in(
        "--ray", *arguments_.ray, two_vectors,
        is_flat ? "x,y of its origin and x,y of its direction" : "x,y,z of its origin and x,y,z of its direction");
    const Ray<N, double> ray{vector_at<N>(numbers, 0), vector_at<N>(numbers, N)};
    const double t_max = arguments_.t_max.value_or(std::numeric_limits<double>::infinity());
    report.detail = FoundDetail::hit;
    std::vector<ObjectHit<N, double>> hits;
    if (arguments_.only_first) {
      if (const auto first = scene_.ray_cast(ray, t_max, query_)) hits.push_back(*first);
    } else {
      hits = scene_.ray_cast_all(ray, t_max, query_);
    }
    for (const auto& [id, hit] : hits) report.objects.push_back(found_at(id, hit.t, hit.point, hit.normal));
  }

  const QueryArguments& arguments_;
  const Scene<N, double>& scene_;
  SceneQuery query_;
  ObjectId excepted_;  // `query_` refers to it
};

template <Dim N>
io::FoundReport answer(const QueryArguments& arguments, const std::string& source, const Scene<N, double>& scene) {
  io::FoundReport report;
  report.head = {source, N, scene.size()};
  const auto start = std::chrono::steady_clock::now();
  try {
    Query<N>(arguments, scene).ask(report);
  } catch (
      const std::invalid_argument& error) {  // a negative radius, a ray of length zero, a number that is not finite
    throw UsageError(error.what());
  }
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

/// The query, and the file that it is about.
struct Subject {
  std::string source;
  io::AnyScene scene;
  std::vector<io::Omission> not_read = {};
};

Subject read_subject(const QueryArguments& arguments) {
  if (arguments.log) {
    const Progress progress("reading the log");
    const io::AnyQueryLog log = read_log(*arguments.log);
    return std::visit(
        [&arguments](const auto& held) {
          return Subject{*arguments.log, io::scene_after(held, *arguments.log)};
        },
        log);
  }
  Progress progress("reading the scene");
  io::SceneFile file = read_input(*arguments.scene, arguments.reading);
  progress.stop();
  tell_omissions(file, arguments.strict);
  return {std::move(file.source), std::move(file.scene), std::move(file.omissions)};
}

ExitCode run_query(const QueryArguments& arguments) {
  const ReportFormat format = chosen("--format", arguments.format, query_formats);
  require_one_scene(arguments);
  require_one_question(arguments);
  const Subject subject = read_subject(arguments);
  io::FoundReport report = std::visit(
      [&]<Dim N>(const Scene<N, double>& scene) { return answer<N>(arguments, subject.source, scene); }, subject.scene);
  report.head.not_read = subject.not_read;
  const bool is_shown = is_standard_stream(arguments.output);
  write_output(arguments.output, [&](std::ostream& out) {
    const bool on_terminal = is_shown && is_terminal(Stream::output);
    io::write_found(out, format, report, on_terminal ? colours_for(Stream::output) : io::Colours::off);
  });
  const bool has_summary = format == ReportFormat::table || format == ReportFormat::json;
  if (!has_summary || !is_shown) say(io::summary_line(report));
  return done;
}

constexpr const char* query_footer =
    R"(One query at a time. Objects are in the scene's order, the nearest objects by distance, hits of
rays by t, in multiples of the direction's length, and those of moving shapes by t from 0 to 1.
Shapes contain their surface. SHAPE is the name of an object, which then is not found itself,
or a shape as in a scene file: '{"type": "sphere", "center": [0, 1], "radius": 2}'.
Instead of SCENE, a query log can be given; then the scene at its end is queried.

Examples:
  graze query level.tmx --point 120,64
  graze query level.tmx --point 120,64 --nearest 3
  graze query workshop.json --box 0,0,0,2,2,2 --layer tools
  graze query workshop.json --ray 0,0,1,1,0,0 --first --format json
  graze query level.tmx --cast player --motion 40,0 --first
  graze query --log workshop.log --point 0,0,1

Exit codes: 0 done; 2 wrong usage; 3 bad input, or an output that cannot be written)";

}  // namespace

Command add_query(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "query", "Find objects at a point, in a region, on the way of a ray or a shape, or nearest to one");
  const auto arguments = std::make_shared<QueryArguments>();
  const auto add = [app](const char* name, auto& value, const char* help, const char* type) {
    app->add_option(name, value, help)->type_name(type)->take_last();
  };
  app->add_option("SCENE", arguments->scene, "Scene file, or - for the standard input")->type_name("");
  add("--log", arguments->log, "Instead of SCENE: a query log; queries the scene at its end", "FILE");
  add("--point", arguments->point, "Objects that contain this point", "X,Y[,Z]");
  add("--nearest", arguments->nearest, "With --point or --nearest-to: the K objects nearest to it", "K");
  add("--box", arguments->box, "Objects that touch the box between two corners", "CORNER,CORNER");
  add("--sphere", arguments->sphere, "Objects that touch this sphere, in 2D a circle", "CENTER,RADIUS");
  add("--ray", arguments->ray, "Objects that a ray hits, in order", "ORIGIN,DIRECTION");
  add("--t-max", arguments->t_max, "With --ray: no hit beyond this t; 1 for a segment", "T");
  add("--cast", arguments->cast, "Objects that a moving shape hits, in order", "SHAPE");
  add("--motion", arguments->motion, "With --cast: how far the shape moves", "X,Y[,Z]");
  add("--contacts-with", arguments->contacts_with, "Where objects touch this shape, and how deep", "SHAPE");
  add("--nearest-to", arguments->nearest_to, "The object nearest to this shape", "SHAPE");
  app->add_flag("--first", arguments->only_first, "With --ray or --cast: only the first hit");
  add("--layer", arguments->layer, "Only objects on this layer", "NAME");
  add("--format", arguments->format, "table (the default), json, ndjson or csv", "FORMAT");
  add("--output", arguments->output, "Write the result to a file instead of the standard output", "FILE");
  add_solid(*app, arguments->reading);
  add_strict(*app, arguments->strict);
  app->footer(query_footer);
  return {app, [arguments] { return run_query(*arguments); }};
}

}  // namespace graze::cli
