// SPDX-License-Identifier: MIT
// The options of the exam, and the file of cases that failed.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace graze::exam {

struct Settings {
  std::size_t cases = 1'000'000;   ///< Per pair of types and space.
  std::size_t points = 100'000;    ///< Cases per shape and space for point queries, all of them passed to the oracle.
  std::size_t contacts = 20'000;   ///< Contacts per pair of types and space, the same.
  std::size_t distances = 20'000;  ///< Distances, the same.
  std::size_t manifolds = 20'000;  ///< Manifolds, the same.
  std::size_t casts = 2'000;       ///< Casts of shapes, the same.
  std::size_t impacts = 500;       ///< Times of impact of shapes that turn, the same.
  std::size_t rays = 100'000;      ///< Rays per type and space, the same.
  std::size_t hulls = 2'000;       ///< Sets of points per kind and space for convex_hull.
  std::size_t masses = 2'000;      ///< Shapes per type and space for mass_properties.
  std::uint64_t seed = 1;
  double seconds = 0;  ///< Each pair stops after this time; 0 for never.
  std::string pairs;   ///< Only pairs whose name, such as "3D float obb, triangle", holds this.
  std::string output;  ///< The data file; standard output if empty.
  std::string regressions = "tests/exam/regressions.csv";
  bool keeps_hardest = false;  ///< Adds the hardest case of each pair and shape to the regressions, even if it passed.
  std::size_t jobs = 1;
};

/// The number of cases of a question: an option of the command line, and a number in the data file.
struct Limit {
  std::string_view name;
  std::size_t Settings::*number;
  std::string_view help;
};

inline constexpr std::array<Limit, 10> limits = {{
    {"cases", &Settings::cases, "cases per pair of types and space"},
    {"points", &Settings::points, "cases per shape and space for point queries"},
    {"contacts", &Settings::contacts, "cases per pair of types and space for contact"},
    {"distances", &Settings::distances, "cases per pair of types and space for closest_points"},
    {"manifolds", &Settings::manifolds, "cases per pair of types and space for manifold"},
    {"casts", &Settings::casts, "cases per pair of types and space for shape_cast"},
    {"impacts", &Settings::impacts, "cases per pair of types and space for time_of_impact"},
    {"rays", &Settings::rays, "cases per shape and space for ray_cast"},
    {"hulls", &Settings::hulls, "sets of points per kind and space for convex_hull"},
    {"masses", &Settings::masses, "cases per shape and space for mass_properties"},
}};

/// The options, or the exit status if help was requested or an error was reported.
std::variant<Settings, int> read_settings(int argc, const char* const* argv);

/// Rows appended to a file of regressions, without duplicates; the first row creates the file.
class RegressionLog {
 public:
  explicit RegressionLog(std::string path) : path_(std::move(path)) {
    std::ifstream file(path_);
    for (std::string line; std::getline(file, line);) rows_.insert(line);
  }

  /// Adds a case that failed.
  void add_failure(const std::string& row) {
    const std::lock_guard<std::mutex> lock(one_at_a_time_);
    ++failures_;
    write(row);
  }

  /// Adds a case that passed but is worth keeping.
  void add(const std::string& row) {
    const std::lock_guard<std::mutex> lock(one_at_a_time_);
    write(row);
  }

  std::size_t failures() const { return failures_; }

 private:
  void write(const std::string& row) {
    if (!rows_.insert(row).second) return;
    if (!file_.is_open()) file_.open(path_, std::ios::app);
    file_ << row << '\n';
    if (!file_.flush()) throw std::runtime_error("cannot write " + path_);
  }

  std::string path_;
  std::mutex one_at_a_time_;
  std::set<std::string> rows_;
  std::ofstream file_;
  std::size_t failures_ = 0;
};

}  // namespace graze::exam
