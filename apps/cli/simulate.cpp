// SPDX-License-Identifier: MIT
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include <graze/io/input_error.hpp>
#include <graze/io/recorded_scene.hpp>
#include <graze/io/report/frames.hpp>
#include <graze/query/transformed.hpp>
#include <graze/scene/scene.hpp>

#include "command.hpp"
#include "input.hpp"
#include "output.hpp"
#include "progress.hpp"
#include "terminal.hpp"
#include "usage.hpp"

namespace graze::cli {
namespace {

using Clock = std::chrono::steady_clock;

/// The parsed command line.
struct SimulateArguments {
  std::string scene;
  std::string output = "-";
  std::optional<std::string> log;
  std::optional<std::int64_t> frames;  // signed, so that negative numbers are detected
  double seconds_per_frame = 1.0 / 60;
  bool strict = false;
};

void require_sensible(const SimulateArguments& arguments) {
  if (!arguments.frames) throw UsageError("--frames is missing; give the number of times to move the objects");
  if (*arguments.frames < 1) {
    throw UsageError(fmt::format("--frames is {}; it must be 1 or more", *arguments.frames));
  }
  if (!(arguments.seconds_per_frame > 0 && std::isfinite(arguments.seconds_per_frame))) {
    throw UsageError(fmt::format("--seconds-per-frame is {}; it must be above 0", arguments.seconds_per_frame));
  }
  if (!arguments.log) return;
  require_not_overwritten(arguments.scene, *arguments.log);
  if (name_same_file(*arguments.log, arguments.output)) {
    throw UsageError("--log " + io::in_quotes(*arguments.log) + " is also the output of the frames; name another file");
  }
}

/// The final summary.
struct Totals {
  std::size_t began = 0;
  std::size_t ended = 0;
  double seconds = 0;  ///< Time for moving and finding pairs, without reading and writing.
};

/// A scene whose objects move at constant velocity: a Scene, or a RecordedScene.
template <class World, Dim N>
class Simulation {
 public:
  /// The scene must outlive this.
  Simulation(World& scene, const io::SceneFile& file, double seconds_per_frame)
      : scene_(scene), source_(file.source), seconds_per_frame_(seconds_per_frame) {
    for (const io::ObjectVelocity& each : file.velocities) {
      movers_.push_back({each.id, scene.object(each.id).shape, each.velocity});
    }
  }

  /// Every frame is calculated from frame 0, so that rounding errors do not accumulate.
  io::FrameReport frame(std::size_t number) {
    const Clock::time_point start = Clock::now();
    const double seconds = static_cast<double>(number) * seconds_per_frame_;
    if (number > 0) move_by(seconds, number);
    const SceneEvents& events = scene_.update();
    totals_.began += events.began.size();
    totals_.ended += events.ended.size();
    totals_.seconds += std::chrono::duration<double>(Clock::now() - start).count();
    return {number, seconds, events.began.size() + events.stayed.size(), names(events.began), names(events.ended)};
  }

  const Totals& totals() const { return totals_; }

 private:
  struct Mover {
    ObjectId id;
    AnyShape<N, double> shape;  // in frame 0
    Vec<3, double> velocity;
  };

  void move_by(double seconds, std::size_t number) {
    std::vector<ObjectMove<N, double>> moves;
    moves.reserve(movers_.size());
    try {
      for (const Mover& mover : movers_) {
        Vec<N, double> offset;
        for (Dim i = 0; i < N; ++i) offset[i] = mover.velocity[i] * seconds;
        moves.push_back({mover.id, translated<N, double>(mover.shape, offset)});
      }
      scene_.move(moves);
    } catch (const std::invalid_argument& refusal) {  // out of range
      throw io::InputError(fmt::format("{}: in frame {}: {}", source_, number, refusal.what()));
    }
  }

  std::vector<io::NamePair> names(const std::vector<ObjectPair>& pairs) const {
    std::vector<io::NamePair> result;
    result.reserve(pairs.size());
    for (const ObjectPair& pair : pairs) result.emplace_back(scene_.object(pair.a).name, scene_.object(pair.b).name);
    return result;
  }

  World& scene_;
  std::string source_;
  double seconds_per_frame_;
  std::vector<Mover> movers_;
  Totals totals_;
};

/// Moves the objects of a scene and writes all frames.
template <Dim N, class World>
Totals move_and_write(const SimulateArguments& arguments, World& scene, const io::SceneFile& file, Progress& progress) {
  const auto frames = static_cast<std::size_t>(*arguments.frames);
  Simulation<World, N> simulation(scene, file, arguments.seconds_per_frame);
  write_output(arguments.output, [&](std::ostream& out) {
    // Printing the frames shows the progress.
    if (is_standard_stream(arguments.output) && is_terminal(Stream::output)) progress.stop();
    progress.begin("simulating", frames);
    for (const io::Omission& omission : io::missing_shapes(file.omissions)) out << io::omission_ndjson(omission);
    for (std::size_t number = 0; number <= frames && out; ++number) {
      io::write_frame(out, simulation.frame(number));
      out.flush();
      progress.advance(number);
    }
  });
  return simulation.totals();
}

/// The same, recorded if requested.
template <Dim N>
Totals simulate(const SimulateArguments& arguments, Scene<N, double>& scene, const io::SceneFile& file,
                Progress& progress) {
  if (!arguments.log) return move_and_write<N>(arguments, scene, file, progress);
  Totals totals;
  write_output(*arguments.log, [&](std::ostream& log) {
    io::RecordedScene<N, double> recorded(log, scene);
    totals = move_and_write<N>(arguments, recorded, file, progress);
  });
  return totals;
}

ExitCode run_simulate(const SimulateArguments& arguments) {
  require_sensible(arguments);
  Progress reading("reading the scene");
  io::SceneFile file = read_input(arguments.scene);
  reading.stop();
  tell_omissions(file, arguments.strict);

  Progress progress("simulating");
  std::size_t objects = 0;
  const Totals totals = std::visit(
      [&]<Dim N>(Scene<N, double>& scene) {
        objects = scene.size();
        return simulate<N>(arguments, scene, file, progress);
      },
      file.scene);
  progress.stop();
  say(fmt::format("{} frames; {} objects, {} moving, {} contacts began, {} ended, {:.3f} seconds", *arguments.frames,
                  objects, file.velocities.size(), totals.began, totals.ended, totals.seconds));
  return done;
}

constexpr const char* simulate_footer =
    R"(Objects with a "velocity" in the scene file move at that velocity; nothing stops them. Frame 0
is the scene as read. Each frame is a line of JSON: the pairs that began and that ended to touch.

Examples:
  graze simulate --frames 600 yard.json > events.ndjson
  graze simulate --frames 10 --seconds-per-frame 0.5 yard.json
  graze simulate --frames 60 --log yard.log yard.json

Exit codes: 0 done; 2 wrong usage; 3 bad input, or an output that cannot be written)";

}  // namespace

Command add_simulate(CLI::App& program) {
  CLI::App* app = program.add_subcommand("simulate", "Move the objects of a scene and report which begin to touch");
  const auto arguments = std::make_shared<SimulateArguments>();
  const auto add = [app](const char* name, auto& value, const char* help, const char* type) {
    app->add_option(name, value, help)->type_name(type)->take_last();
  };
  app->add_option("SCENE", arguments->scene, "Scene file, or - for the standard input")->required()->type_name("");
  add("--frames", arguments->frames, "Number of times to move the objects", "N");
  add("--seconds-per-frame", arguments->seconds_per_frame, "Time between frames, 1/60 by default", "SECONDS");
  add("--output", arguments->output, "Write the frames to a file instead of the standard output", "FILE");
  add("--log", arguments->log, "Record all calls on the scene, for graze replay", "FILE");
  add_strict(*app, arguments->strict);
  app->footer(simulate_footer);
  return {app, [arguments] { return run_simulate(*arguments); }};
}

}  // namespace graze::cli
