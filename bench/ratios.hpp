// SPDX-License-Identifier: MIT
// Prints a summary table after a comparison benchmark: for every case, graze's time, the fastest other library's time,
// and their ratio. Sorted by name, because runs in random order begin anywhere.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

namespace graze::bench {

/// Sets the counter that RatioReporter reads: nanoseconds for each of `count` items.
inline void count_things(benchmark::State& state, std::size_t count) {
  state.counters["ns"] = benchmark::Counter(
      1e-9 * static_cast<double>(count), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// For benchmarks named "case/contestant", where graze's contestants begin with "graze". Others are compared with
/// graze's first one. Of several repetitions, the median counts.
class RatioReporter : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) {
      const auto counter = run.counters.find("ns");
      if (run.run_type != Run::RT_Iteration || run.error_occurred || counter == run.counters.end()) continue;
      times_of(run.run_name.function_name).push_back(counter->second.value);
    }
  }

  void Finalize() override {
    std::sort(races_.begin(), races_.end(), [](const Race& a, const Race& b) { return a.name < b.name; });
    std::printf(
        "\n| case | graze, ns | fastest other | ns | times as long | the others |\n|---|--:|---|--:|--:|---|\n");
    for (const Race& race : races_) print(race);
  }

 private:
  struct Racer {
    std::string name;
    std::vector<double> times;

    double median() const {
      std::vector<double> sorted = times;
      std::sort(sorted.begin(), sorted.end());
      return sorted[sorted.size() / 2];
    }
  };

  struct Race {
    std::string name;
    std::vector<Racer> racers;
  };

  template <class Named>
  static Named& find_or_add(std::vector<Named>& all, const std::string& name) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const Named& one) { return one.name == name; });
    return found != all.end() ? *found : all.emplace_back(Named{name, {}});
  }

  std::vector<double>& times_of(const std::string& run) {
    const std::size_t slash = run.rfind('/');
    return find_or_add(find_or_add(races_, run.substr(0, slash)).racers, run.substr(slash + 1)).times;
  }

  static void print(const Race& race) {
    std::vector<const Racer*> others;
    const Racer* ours = nullptr;
    for (const Racer& racer : race.racers) {
      if (racer.name.rfind("graze", 0) != 0)
        others.push_back(&racer);
      else if (ours == nullptr)
        ours = &racer;
    }
    if (ours == nullptr || others.empty()) return;
    std::sort(others.begin(), others.end(), [](const Racer* a, const Racer* b) { return a->median() < b->median(); });
    const double base = ours->median();
    std::printf("| %s | %.3g | %s | %.3g | %.2f |", race.name.c_str(), base, others[0]->name.c_str(),
                others[0]->median(), others[0]->median() / base);
    for (std::size_t i = 1; i < others.size(); ++i) {
      std::printf("%s %s %.2f", i > 1 ? "," : "", others[i]->name.c_str(), others[i]->median() / base);
    }
    std::printf(" |\n");
  }

  std::vector<Race> races_;
};

/// Runs the benchmarks that the program's arguments select, prints the table, and returns the exit status.
inline int run_races(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  RatioReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  benchmark::Shutdown();
  return 0;
}

}  // namespace graze::bench
