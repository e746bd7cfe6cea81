// SPDX-License-Identifier: MIT
// graze_exam: hard cases for every pair of types and every point query, for distances, contacts and rays, in four
// spaces, put to graze, to the exact oracle and to other libraries. The tables go to standard output or a page, cases
// that fail to a file of regressions; the status is 1 if there were any.
#include <atomic>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>

#include "exam/cast_exam.hpp"
#include "exam/contact_exam.hpp"
#include "exam/distance_exam.hpp"
#include "exam/hull_exam.hpp"
#include "exam/impact_exam.hpp"
#include "exam/manifold_exam.hpp"
#include "exam/mass_exam.hpp"
#include "exam/pair_exam.hpp"
#include "exam/ray_exam.hpp"
#include "exam/report.hpp"
#include "exam/settings.hpp"
#include "exam/tally.hpp"

namespace graze::exam {
namespace {

/// One question about one pair, one shape or one kind of points, in one space.
struct Task {
  std::string name;
  std::function<void()> run;
};

/// One line that is written over, on a terminal only.
class Progress {
 public:
  explicit Progress(std::size_t tasks) : tasks_(tasks) {}
  ~Progress() {
    if (is_shown_) std::fputs("\r\x1b[K", stderr);
  }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void begin(const std::string& name) {
    const std::lock_guard<std::mutex> lock(one_at_a_time_);
    ++begun_;
    if (is_shown_) fmt::print(stderr, "\r\x1b[K{} of {}: {}", begun_, tasks_, name);
  }

 private:
  std::size_t tasks_;
  std::size_t begun_ = 0;
  bool is_shown_ = isatty(STDERR_FILENO) == 1;
  std::mutex one_at_a_time_;
};

/// Each task has a place of its own for its result, so that the tables do not depend on the number of threads.
class Exam {
 public:
  explicit Exam(const Settings& settings) : settings_(settings), regressions_(settings.regressions) {
    constexpr std::size_t most = 4 * types * (types + 1) / 2;
    results_.pairs.reserve(most);  // tasks keep references
    results_.points.reserve(most);
    results_.distances.reserve(most);
    results_.contacts.reserve(most);
    results_.manifolds.reserve(most);
    results_.rays.reserve(most);
    results_.casts.reserve(most);
    results_.impacts.reserve(most);
    results_.hulls.reserve(most);
    results_.masses.reserve(most);
    add_space<2, float>();
    add_space<2, double>();
    add_space<3, float>();
    add_space<3, double>();
  }

  void run() {
    Progress progress(tasks_.size());
    std::atomic<std::size_t> next = 0;
    const auto work = [&] {
      for (std::size_t i = next++; i < tasks_.size(); i = next++) {
        progress.begin(tasks_[i].name);
        tasks_[i].run();
      }
    };
    std::vector<std::thread> threads;
    for (std::size_t i = 1; i < settings_.jobs; ++i) threads.emplace_back(work);
    work();
    for (std::thread& thread : threads) thread.join();
  }

  bool is_empty() const { return tasks_.empty(); }
  const Results& results() const { return results_; }
  const RegressionLog& regressions() const { return regressions_; }

 private:
  static constexpr std::size_t types = shape_type_names.size();

  template <Dim N, class T>
  void add_space() {
    add_pairs<N, T>();
    add_casts<N, T>();
    add_shapes<N, T>();
    for (std::size_t kind = 0; kind < hull_kind_count; ++kind) {
      add(label(space_name<N, T>()) + " hull " + std::string(hull_kind_names[kind]), results_.hulls,
          [this, kind] { return examine_hulls<N, T>(static_cast<HullKind>(kind), settings_, regressions_); });
    }
  }

  template <Dim N, class T>
  void add_pairs() {
    for (std::size_t a = 0; a < types; ++a) {
      for (std::size_t b = a; b < types; ++b) {
        const std::string name = label(space_name<N, T>()) + " " + pair_name(a, b);
        add(name, results_.pairs, [this, a, b] { return examine_pair<N, T>(a, b, settings_, regressions_); });
        add(name + " at a distance", results_.distances,
            [this, a, b] { return examine_distances<N, T>(a, b, settings_, regressions_); });
        add(name + " in contact", results_.contacts,
            [this, a, b] { return examine_contacts<N, T>(a, b, settings_, regressions_); });
        add(name + " by manifold", results_.manifolds,
            [this, a, b] { return examine_manifolds<N, T>(a, b, settings_, regressions_); });
        add(name + " that turn", results_.impacts,
            [this, a, b] { return examine_impacts<N, T>(a, b, settings_, regressions_); });
      }
    }
  }

  template <Dim N, class T>
  void add_casts() {
    for (std::size_t a = 0; a < types; ++a) {
      for (std::size_t b = 0; b < types; ++b) {
        if (!can_examine_casts(a, b)) continue;
        add(label(space_name<N, T>()) + " " + pair_name(a, b) + " in motion", results_.casts,
            [this, a, b] { return examine_casts<N, T>(a, b, settings_, regressions_); });
      }
    }
  }

  template <Dim N, class T>
  void add_shapes() {
    for (std::size_t type = 0; type < types; ++type) {
      const std::string name = label(space_name<N, T>()) + " " + std::string(shape_type_names[type]);
      if (type + 1 < types) {  // compounds, the last, are their parts
        add(name + " and points", results_.points,
            [this, type] { return examine_points<N, T>(type, settings_, regressions_); });
      }
      add(name + " and rays", results_.rays,
          [this, type] { return examine_rays<N, T>(type, settings_, regressions_); });
      if (can_examine_mass(N, type)) {
        add(name + " of mass", results_.masses,
            [this, type] { return examine_mass<N, T>(type, settings_, regressions_); });
      }
    }
  }

  template <class Tally, class Examine>
  void add(const std::string& name, std::vector<Tally>& tallies, Examine examine) {
    if (name.find(settings_.pairs) == std::string::npos) return;
    Tally& tally = tallies.emplace_back();
    tasks_.push_back({name, [&tally, examine] { tally = examine(); }});
  }

  Settings settings_;
  RegressionLog regressions_;
  Results results_;
  std::vector<Task> tasks_;
};

int run(const Settings& settings) {
  Exam exam(settings);
  if (exam.is_empty()) {
    fmt::print(stderr, "graze_exam: no pair is named \"{}\"; names are like \"3D float obb, triangle\"\n",
               settings.pairs);
    return 2;
  }
  exam.run();
  const std::string tables = markdown(exam.results(), settings);
  if (settings.output.empty()) {
    fmt::print("{}", tables);
  } else {
    write_page(settings.output, tables);
  }
  const std::size_t wrong = exam.regressions().failures();
  if (wrong == 0) return 0;
  fmt::print(stderr, "graze_exam: {} cases failed, see {}\n", wrong, settings.regressions);
  return 1;
}

}  // namespace
}  // namespace graze::exam

int main(int argc, char** argv) {
  try {
    const auto asked = graze::exam::read_settings(argc, argv);
    if (const int* status = std::get_if<int>(&asked)) return *status;
    return graze::exam::run(std::get<graze::exam::Settings>(asked));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "graze_exam: %s\n", error.what());
    return 2;
  }
}
