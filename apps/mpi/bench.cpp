// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <mpi.h>

#include <graze/broad/scene_generators.hpp>
#include <graze/distributed/distributed_pair_finder.hpp>
#include <graze/distributed/partition.hpp>
#include <graze/distributed/together.hpp>

#include "bench_report.hpp"
#include "command.hpp"
#include "standard_output.hpp"
#include "usage.hpp"
#include "world_options.hpp"

namespace graze::mpi {
namespace {

using Clock = std::chrono::steady_clock;

enum class Format { table, json };
constexpr std::array<std::pair<std::string_view, Format>, 2> formats{
    {{"table", Format::table}, {"json", Format::json}}};

struct BenchArguments {
  WorldOptions world;
  std::string frames = "10";
  std::string skin = "0.5";
  std::string format = "table";
};

/// A world that moves in the same way on every rank, and the part of it that this rank passes.
template <Dim N>
class SharedWorld {
 public:
  SharedWorld(const cli::WorldArgument& world, std::uint64_t seed) : all_(world.world, world.count, seed) {
    const auto [begin, end] = part_of(world.count, rank_of_this(), number_of_ranks());
    ids_.resize(end - begin);
    std::iota(ids_.begin(), ids_.end(), std::uint64_t{begin});
    gather();
  }

  void step() {
    all_.step();
    gather();
  }

  /// From now on passes the boxes that this rank owns, as after an `exchange`.
  void take_own(const Partition<N>& partition) {
    ids_.clear();
    for (std::size_t i = 0; i < all_.boxes().size(); ++i) {
      if (owner(partition, all_.boxes()[i]) == rank_of_this()) ids_.push_back(i);
    }
    gather();
  }

  std::span<const Aabb<N, float>> all() const { return all_.boxes(); }
  std::span<const Aabb<N, float>> boxes() const { return boxes_; }
  std::span<const std::uint64_t> ids() const { return ids_; }

 private:
  void gather() {
    boxes_.clear();
    for (const std::uint64_t id : ids_) boxes_.push_back(all_.boxes()[id]);
  }

  MovingBoxes<N, float> all_;
  std::vector<std::uint64_t> ids_;
  std::vector<Aabb<N, float>> boxes_;
};

/// The expected number of ghosts if the anchors are spread uniformly over their bounds: a box of mean size e meets a
/// cell of size w if its anchor is in the cell or within e / 2 + skin beyond a side. Beyond the bounds there is
/// nothing.
template <Dim N>
double expected_ghosts(const Partition<N>& partition, std::span<const Aabb<N, float>> boxes, double skin) {
  Aabb<N, double> bounds = Aabb<N, double>::nothing();
  Vec<N, double> sizes(0.0);
  for (const Aabb<N, float>& box : boxes) {
    bounds.grow(anchor(box));
    sizes += wide<N, float>(box.max) - wide<N, float>(box.min);
  }
  double meetings = 0;
  for (int rank = 0; rank < partition.ranks(); ++rank) {
    const Aabb<N, double>& cell = partition.cell(rank);
    if (is_nothing(cell)) continue;
    double share = static_cast<double>(boxes.size());
    for (Dim k = 0; k < N; ++k) {
      const double beyond = sizes[k] / static_cast<double>(boxes.size()) / 2 + skin;
      const double low = std::max(cell.min[k] - beyond, bounds.min[k]);
      const double high = std::min(cell.max[k] + beyond, bounds.max[k]);
      const double extent = bounds.max[k] - bounds.min[k];
      if (extent > 0) share *= std::max(0.0, high - low) / extent;
    }
    meetings += share;
  }
  return meetings - static_cast<double>(boxes.size());
}

/// A sum over the pairs that does not depend on their order.
std::uint64_t checksum(std::span<const IdPair> pairs) {
  std::uint64_t sum = 0;
  for (const auto& [a, b] : pairs) {
    std::uint64_t mixed = (a * 0x9E3779B97F4A7C15U) ^ (b * 0xC2B2AE3D27D4EB4FU + 1);
    mixed = (mixed ^ (mixed >> 29U)) * 0xBF58476D1CE4E5B9U;
    sum += mixed ^ (mixed >> 32U);
  }
  return sum;
}

/// What all ranks did, on rank 0.
std::vector<RankFrame> gathered(const RankFrame& mine) {
  std::vector<RankFrame> all;
  together(MPI_COMM_WORLD, [&] { all.resize(static_cast<std::size_t>(number_of_ranks())); });
  MPI_Gather(&mine, sizeof mine, MPI_BYTE, all.data(), sizeof mine, MPI_BYTE, 0, MPI_COMM_WORLD);
  return all;
}

template <Dim N>
void measure(MpiBenchReport& report, const cli::WorldArgument& argument, std::uint64_t frames) {
  std::optional<SharedWorld<N>> world;
  std::unique_ptr<Executor> executor;
  together(MPI_COMM_WORLD, [&] {
    executor = limited_executor(report.threads);
    world.emplace(argument, report.seed);
  });
  DistributedPairFinder<N, float> finder(MPI_COMM_WORLD, {.executor = executor.get(), .skin = report.skin});
  const auto find = [&] { return finder.find(world->boxes(), world->ids()); };
  const auto settle = [&] { together(MPI_COMM_WORLD, [&] { world->take_own(finder.partition()); }); };
  // Not counted: the first call cuts space, the second has the boxes where they belong, and both allocate memory.
  find();
  settle();
  find();
  for (std::uint64_t frame = 0; frame < frames; ++frame) {
    together(MPI_COMM_WORLD, [&] { world->step(); });
    MPI_Barrier(MPI_COMM_WORLD);
    const Clock::time_point start = Clock::now();
    const std::span<const IdPair> pairs = find();
    const std::chrono::duration<double, std::milli> time = Clock::now() - start;
    FrameResult result;
    result.ranks = gathered({time.count(), finder.frame(), checksum(pairs)});
    together(MPI_COMM_WORLD, [&] {
      if (rank_of_this() == 0) {
        result.ghosts_model = expected_ghosts<N>(finder.partition(), world->all(), report.skin);
        report.frames.push_back(std::move(result));
      }
    });
    if (finder.frame().is_cut) settle();
  }
}

double read_skin(const std::string& text) {
  double skin = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), skin);
  if (status == std::errc() && end == text.data() + text.size() && std::isfinite(skin) && skin >= 0) return skin;
  throw cli::UsageError("--skin is " + io::in_quotes(text) + "; it must be a number, zero or more");
}

void run_bench(const BenchArguments& arguments) {
  const Format format = cli::chosen("--format", arguments.format, formats);
  const cli::WorldArgument world = cli::read_world(arguments.world.world);
  const std::uint64_t frames = cli::read_number("--frames", arguments.frames, cli::frame_range);
  MpiBenchReport report;
  report.world = cli::text_of(world);
  report.seed = cli::read_number("--seed", arguments.world.seed, {});
  report.boxes = world.count;
  report.threads = threads_of(arguments.world);
  report.skin = read_skin(arguments.skin);
  if (world.dimension == 2) {
    measure<2>(report, world, frames);
  } else {
    measure<3>(report, world, frames);
  }
  together(MPI_COMM_WORLD, [&] {
    if (rank_of_this() == 0) write_out(format == Format::json ? json_of(report) : table_of(report));
  });
}

constexpr const char* bench_footer =
    R"(Every rank generates the whole world, moves it, and passes the boxes that it owns. Only finding the
pairs is measured: the time of a frame is that of the slowest rank. The checksum does not depend on
the number of ranks.

Examples:
  mpirun -n 2 graze-mpi bench --generate brownian:4M
  mpirun -n 64 --oversubscribe graze-mpi bench --generate 2d:heavy:1M --frames 3 --format json)";

}  // namespace

Command add_bench(CLI::App& program) {
  CLI::App* app = program.add_subcommand("bench", "Measure how fast all overlapping boxes are found, and what is sent");
  const auto arguments = std::make_shared<BenchArguments>();
  add_world_options(*app, arguments->world);
  app->add_option("--frames", arguments->frames, "Number of frames to measure, 10 by default")
      ->type_name("N")
      ->take_last();
  app->add_option("--skin", arguments->skin, "How far boxes move before ghosts are chosen anew, 0.5 by default")
      ->type_name("LENGTH")
      ->take_last();
  app->add_option("--format", arguments->format, "table (the default) or json")->type_name("FORMAT")->take_last();
  app->footer(bench_footer);
  return {app, [arguments] { run_bench(*arguments); }};
}

}  // namespace graze::mpi
