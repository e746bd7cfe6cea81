// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <ostream>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include <graze/broad/executor.hpp>
#include <graze/broad/pairs.hpp>
#include <graze/broad/scene_generators.hpp>
#include <graze/io/file/utf8_path.hpp>
#include <graze/io/recording.hpp>

#include "bench_report.hpp"
#include "command.hpp"
#include "file_ending.hpp"
#include "input.hpp"
#include "memory_floor.hpp"
#include "output.hpp"
#include "progress.hpp"
#include "terminal.hpp"
#include "usage.hpp"
#include "world_argument.hpp"

namespace graze::cli {
namespace {

using Clock = std::chrono::steady_clock;

/// The parsed command line.
struct BenchArguments {
  std::optional<std::string> file;
  std::optional<std::string> world;
  std::optional<std::string> seed;
  std::optional<std::string> frames;
  std::vector<std::string> methods;
  std::string order = "sorted";
  std::optional<std::string> threads;
  std::string format = "table";
};

constexpr std::array<std::pair<std::string_view, BenchFormat>, 3> bench_formats{
    {{"table", BenchFormat::table}, {"json", BenchFormat::json}, {"csv", BenchFormat::csv}}};

constexpr std::array<std::pair<std::string_view, PairOrder>, 2> orders{
    {{"sorted", PairOrder::sorted}, {"any", PairOrder::any}}};

constexpr std::size_t usual_frames = 10;
constexpr NumberRange thread_range{1, 1024};

/// Above this many boxes, a method runs only if it is requested by name, because a frame would take seconds.
std::size_t usual_limit(PairMethod method) {
  switch (method) {
    case PairMethod::brute_force:
      return 10'000;
    case PairMethod::dense:
      return 50'000;
    case PairMethod::automatic:
    case PairMethod::tree:
      break;
  }
  return std::numeric_limits<std::size_t>::max();
}

/// What to measure, independent of the boxes.
struct Plan {
  std::vector<PairMethod> methods;
  std::vector<PairMethod> by_name;
  PairOptions options;
  std::unique_ptr<Executor> own_executor;
  std::optional<std::size_t> frames;
};

PairMethod read_method(const std::string& name) {
  if (const std::optional<PairMethod> method = pair_method_named(name)) return *method;
  std::vector<std::string_view> known{"all"};
  for (const PairMethod method : all_pair_methods()) known.push_back(name_of(method));
  throw UsageError("--method " + io::in_quotes(name) + " is not known" + io::did_you_mean(name, known));
}

Plan plan_of(const BenchArguments& arguments) {
  Plan plan;
  const auto add = [&plan](PairMethod method) {
    const bool is_new = std::find(plan.methods.begin(), plan.methods.end(), method) == plan.methods.end();
    if (is_new) plan.methods.push_back(method);
  };
  for (const std::string& name : arguments.methods) {
    if (name == "all") {
      for (const PairMethod method : all_pair_methods()) add(method);
    } else {
      const PairMethod method = read_method(name);
      add(method);
      plan.by_name.push_back(method);
    }
  }
  if (plan.methods.empty()) add(PairMethod::automatic);
  plan.options.order = chosen("--order", arguments.order, orders);
  if (arguments.frames) plan.frames = read_number("--frames", *arguments.frames, frame_range);
  plan.options.executor = &default_executor();
  if (arguments.threads) {
    plan.own_executor = limited_executor(read_number("--threads", *arguments.threads, thread_range));
    plan.options.executor = plan.own_executor.get();
  }
  return plan;
}

/// The pairs in ascending order, whatever order they came in.
std::vector<Pair> sorted(std::span<const Pair> pairs) {
  std::vector<Pair> result(pairs.begin(), pairs.end());
  std::sort(result.begin(), result.end());
  return result;
}

/// Describes the disagreement of two methods; nothing if they agree. Both lists are ascending.
std::optional<std::string> difference(std::string_view name_a, std::span<const Pair> a, std::string_view name_b,
                                      std::span<const Pair> b) {
  const auto [in_a, in_b] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  if (in_a == a.end() && in_b == b.end()) return std::nullopt;
  const bool only_in_a = in_b == b.end() || (in_a != a.end() && *in_a < *in_b);
  const Pair& pair = only_in_a ? *in_a : *in_b;
  return fmt::format("the boxes {} and {} are a pair according to {}, but not to {} ({} and {} pairs in total)", pair.a,
                     pair.b, only_in_a ? name_a : name_b, only_in_a ? name_b : name_a, only_in_a ? a.size() : b.size(),
                     only_in_a ? b.size() : a.size());
}

/// Runs all methods frame by frame and compares their results.
template <Dim N, class T>
class Measurement {
 public:
  Measurement(const Plan& plan, BenchReport& report) : plan_(plan), report_(report) {
    for (const PairMethod method : plan.methods) {
      const std::size_t limit = usual_limit(method);
      const bool is_by_name = std::find(plan.by_name.begin(), plan.by_name.end(), method) != plan.by_name.end();
      if (report.boxes > limit && !is_by_name) {
        report.skipped.push_back({name_of(method), fmt::format("{} boxes are more than {}", report.boxes, limit)});
        continue;
      }
      runs_.push_back({method, PairFinder<N, T>()});
      report.methods.push_back({name_of(method), {}, {}, 0});
    }
  }

  void measure(std::span<const Aabb<N, T>> boxes) {
    const std::size_t frame = report_.frames++;
    std::vector<Pair> reference;
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      const std::span<const Pair> pairs = find(i, boxes, frame == 0);
      if (i == 0) report_.pairs.push_back(pairs.size());
      if (runs_.size() == 1) break;
      std::vector<Pair> comparable = in_order(pairs);
      if (i == 0) {
        reference = std::move(comparable);
        continue;
      }
      const auto fault = difference(report_.methods[0].method, reference, report_.methods[i].method, comparable);
      if (fault) throw std::logic_error(fmt::format("in frame {}, {}", frame, *fault));
    }
    report_.floor.push_back(floor_.measure(std::as_bytes(boxes), report_.pairs.back()));
  }

 private:
  struct Run {
    PairMethod method;
    PairFinder<N, T> finder;
  };

  /// Measures one method on one frame. Its first call is not counted, because it allocates memory that later calls
  /// reuse.
  std::span<const Pair> find(std::size_t i, std::span<const Aabb<N, T>> boxes, bool is_first) {
    Run& run = runs_[i];
    PairOptions options = plan_.options;
    options.method = run.method;
    if (is_first) run.finder.find(boxes, options);
    const Clock::time_point start = Clock::now();
    const std::span<const Pair> pairs = run.finder.find(boxes, options);
    const std::chrono::duration<double, std::milli> time = Clock::now() - start;
    MethodResult& result = report_.methods[i];
    result.milliseconds.push_back(time.count());
    result.chosen = name_of(run.finder.method());
    result.bytes = run.finder.bytes();
    return pairs;
  }

  /// Where no order is promised, pairs are sorted before the comparison; where one is, they are compared as they are.
  std::vector<Pair> in_order(std::span<const Pair> pairs) const {
    return plan_.options.order == PairOrder::any ? sorted(pairs) : std::vector<Pair>(pairs.begin(), pairs.end());
  }

  const Plan& plan_;
  BenchReport& report_;
  std::vector<Run> runs_;
  MemoryFloor floor_;
};

/// Measures that many frames; `boxes_of` is called once for each, in order.
template <Dim N, class T>
void measure_frames(const Plan& plan, BenchReport& report, std::size_t frames,
                    const std::function<std::span<const Aabb<N, T>>(std::size_t)>& boxes_of) {
  report.dimension = N;
  report.scalar = sizeof(T) == sizeof(float) ? "float" : "double";
  Measurement<N, T> measurement(plan, report);
  Progress progress("measuring");
  progress.begin("measuring", frames);
  for (std::size_t frame = 0; frame < frames; ++frame) {
    measurement.measure(boxes_of(frame));
    progress.advance(frame + 1);
  }
}

/// Measures the same boxes repeatedly.
template <Dim N>
void measure_scene(const Plan& plan, BenchReport& report, const Scene<N, double>& scene) {
  std::vector<Aabb<N, double>> boxes;
  for (const ObjectId id : scene.ids()) boxes.push_back(scene.object(id).box);
  report.boxes = boxes.size();
  measure_frames<N, double>(plan, report, plan.frames.value_or(usual_frames),
                            [&](std::size_t) { return std::span<const Aabb<N, double>>(boxes); });
}

template <Dim N>
void measure_recording(const Plan& plan, BenchReport& report, io::RecordingReader& recording) {
  const std::size_t frames = plan.frames.value_or(recording.head().frames);
  if (frames > recording.head().frames) {
    throw UsageError(fmt::format("--frames is {}, but {} has only {}", frames, io::in_quotes(report.source),
                                 recording.head().frames));
  }
  report.boxes = recording.head().boxes;
  std::vector<Aabb<N, float>> boxes;
  measure_frames<N, float>(plan, report, frames, [&](std::size_t) {
    recording.next<N>(boxes);
    return std::span<const Aabb<N, float>>(boxes);
  });
}

template <Dim N>
void measure_world(const Plan& plan, BenchReport& report, const WorldArgument& world) {
  Progress progress("generating boxes");
  MovingBoxes<N, float> moving(world.world, world.count, *report.seed);
  progress.stop();
  report.boxes = world.count;
  measure_frames<N, float>(plan, report, plan.frames.value_or(usual_frames), [&](std::size_t frame) {
    if (frame > 0) moving.step();
    return moving.boxes();
  });
}

void measure_file(const Plan& plan, BenchReport& report, const std::string& name) {
  report.source = name;
  if (file_ending(name) == ".aabbs") {
    io::RecordingReader recording(io::path_from_utf8(name));
    if (recording.head().dimension() == 2) return measure_recording<2>(plan, report, recording);
    return measure_recording<3>(plan, report, recording);
  }
  Progress progress("reading the scene");
  const io::SceneFile file = read_input(name);
  progress.stop();
  tell_omissions(file, false);
  std::visit([&](const auto& scene) { measure_scene(plan, report, scene); }, file.scene);
}

BenchReport measured(const BenchArguments& arguments, const Plan& plan) {
  if (arguments.file.has_value() == arguments.world.has_value()) {
    throw UsageError(arguments.file
                         ? "FILE and --generate cannot be combined; leave one of them out"
                         : "graze bench needs boxes: a FILE, or --generate with something like brownian:100k");
  }
  if (arguments.file && arguments.seed)
    throw UsageError("--seed requires --generate; the boxes of a file are not random");
  BenchReport report;
  report.order = arguments.order;
  report.threads = plan.options.executor->concurrency();
  if (arguments.file) {
    measure_file(plan, report, *arguments.file);
    return report;
  }
  const WorldArgument world = read_world(*arguments.world);
  report.source = text_of(world);
  report.seed = read_number("--seed", arguments.seed.value_or("1"), {});
  if (world.dimension == 2) {
    measure_world<2>(plan, report, world);
  } else {
    measure_world<3>(plan, report, world);
  }
  return report;
}

ExitCode run_bench(const BenchArguments& arguments) {
  const BenchFormat format = chosen("--format", arguments.format, bench_formats);
  const Plan plan = plan_of(arguments);
  const BenchReport report = measured(arguments, plan);
  for (const SkippedMethod& one : report.skipped) {
    say(fmt::format("{} is skipped: {}; --method {} runs it anyway", one.method, one.reason, one.method));
  }
  write_output("-", [&](std::ostream& out) { write_bench_report(out, format, report, colours_for(Stream::output)); });
  return done;
}

constexpr const char* bench_footer =
    R"(FILE is a scene, whose objects' boxes are measured, or a recording that ends in .aabbs.
--generate takes WORLD:COUNT, or 2d:WORLD:COUNT for 2D. WORLD is brownian, heavy, cluster, line,
plane, lattice, giants or point; COUNT is the number of boxes.

Examples:
  graze bench --generate brownian:1M
  graze bench --generate 2d:heavy:100k --method all --threads 1
  graze bench --order any --format json recording.aabbs
  graze bench --method tree --method brute_force level.tmx

Exit codes: 0 done; 2 wrong usage; 3 bad input; 70 the methods disagree)";

}  // namespace

Command add_bench(CLI::App& program) {
  CLI::App* app = program.add_subcommand("bench", "Measure how fast all overlapping boxes are found");
  const auto arguments = std::make_shared<BenchArguments>();
  app->add_option("FILE", arguments->file, "Scene or recording, or - for a scene on the standard input")->type_name("");
  app->add_option("--generate", arguments->world, "Generate a world, such as brownian:1M")
      ->type_name("WORLD:COUNT")
      ->take_last();
  app->add_option("--seed", arguments->seed, "Seed of the random numbers, 1 by default")->type_name("N")->take_last();
  app->add_option("--frames", arguments->frames, "Number of frames to measure; by default 10, or all of a recording")
      ->type_name("N")
      ->take_last();
  app->add_option("--method", arguments->methods, "automatic (the default), the name of a method, or all; repeatable")
      ->type_name("NAME")
      ->delimiter(',')
      ->allow_extra_args(false);
  app->add_option("--order", arguments->order, "sorted (the default) or any")->type_name("ORDER")->take_last();
  app->add_option("--threads", arguments->threads, "Maximum number of threads; all cores by default")
      ->type_name("N")
      ->take_last();
  app->add_option("--format", arguments->format, "table (the default), json or csv")->type_name("FORMAT")->take_last();
  app->footer(bench_footer);
  return {app, [arguments] { return run_bench(*arguments); }};
}

}  // namespace graze::cli
