// SPDX-License-Identifier: MIT
// What the exam is asked to do, where it reports wrong answers, and who it tells how far it is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace graze::exam {

struct Settings {
  std::size_t cases = 1'000'000;  ///< Per pair of types and space, and per shape for point queries.
  std::uint64_t seed = 1;
  double seconds = 0;  ///< Each pair stops after this; 0 for never.
  std::string pairs;   ///< Only pairs whose name, such as "3D float obb, triangle", holds this.
  std::string output;  ///< The page that the tables go to; standard output if empty.
  std::string failures = "tests/exam/failures.txt";
  std::size_t jobs = 1;
};

/// What the command line asks for; or, where help was asked for and given or an error was reported, the exit status.
std::variant<Settings, int> read_settings(int argc, const char* const* argv);

/// Wrong answers, as lines of C++ source at the end of a file, which is made by the first one.
class FailureLog {
 public:
  explicit FailureLog(std::string path) : path_(std::move(path)) {}

  void add(std::string_view line) {
    const std::lock_guard<std::mutex> lock(one_at_a_time_);
    if (!file_.is_open()) file_.open(path_, std::ios::app);
    file_ << line << '\n' << std::flush;
    ++count_;
  }

  std::size_t count() const { return count_; }

 private:
  std::string path_;
  std::mutex one_at_a_time_;
  std::ofstream file_;
  std::size_t count_ = 0;
};

}  // namespace graze::exam
