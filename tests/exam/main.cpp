// SPDX-License-Identifier: MIT
// graze_exam: hard cases for every pair of types and every point query, for distances, contacts and rays, in four
// spaces, for graze, the exact oracle and other libraries. Results go to standard output or a data file, failed cases
// to a file of regressions; the exit status is 1 if there were any.
#include <atomic>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <mutex>
#include <string>
#include <thread>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>

#include "exam/data_file.hpp"
#include "exam/exams.hpp"
#include "exam/settings.hpp"
#include "exam/tally.hpp"

namespace graze::exam {
namespace {

/// One line that is overwritten, on a terminal only.
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

/// Each task stores its result separately, so that the data do not depend on the number of threads.
std::vector<Tally> run_all(const std::vector<Task>& tasks, std::size_t jobs) {
  std::vector<Tally> tallies(tasks.size());
  Progress progress(tasks.size());
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < tasks.size(); i = next++) {
      progress.begin(tasks[i].name);
      tallies[i] = tasks[i].run();
    }
  };
  std::vector<std::thread> threads;
  for (std::size_t i = 1; i < jobs; ++i) threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();
  return tallies;
}

int run(const Settings& settings) {
  RegressionLog regressions(settings.regressions);
  std::vector<Task> tasks;
  add_tasks_of_space<2, float>(settings, regressions, tasks);
  add_tasks_of_space<2, double>(settings, regressions, tasks);
  add_tasks_of_space<3, float>(settings, regressions, tasks);
  add_tasks_of_space<3, double>(settings, regressions, tasks);
  if (tasks.empty()) {
    fmt::print(stderr, "graze_exam: no pair is named \"{}\"; names are like \"3D float obb, triangle\"\n",
               settings.pairs);
    return 2;
  }
  const std::string data = data_text(run_all(tasks, settings.jobs), settings);
  if (settings.output.empty()) {
    fmt::print("{}", data);
  } else {
    write_file(settings.output, data);
  }
  if (regressions.failures() == 0) return 0;
  fmt::print(stderr, "graze_exam: {} cases failed, see {}\n", regressions.failures(), settings.regressions);
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
