// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>

namespace graze::exam {

class Stopwatch {
 public:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

  /// Whether there is time left; a limit of 0 means none.
  bool is_within(double limit) const { return limit <= 0 || seconds() < limit; }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace graze::exam
