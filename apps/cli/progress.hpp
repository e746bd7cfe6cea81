// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

namespace graze::cli {

/// A line on the error stream that shows how far the work is; it appears after a second, on a terminal only, and is
/// gone without a trace when the progress ends. A thread of its own draws it, so that it moves also while the work
/// cannot say how far it is. One at a time; nothing else may be written to the terminal meanwhile.
class Progress {
 public:
  /// Begins with work of unknown length.
  explicit Progress(std::string_view work);
  ~Progress() { stop(); }

  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// The next piece of work: of `total` steps, or of unknown length for 0.
  void begin(std::string_view work, std::size_t total = 0);

  /// So many steps of it are done.
  void advance(std::size_t done) { done_.store(done, std::memory_order_relaxed); }

  /// Takes the line away. Harmless when it is gone already.
  void stop();

 private:
  void draw_until_stopped();
  std::string line() const;

  std::string work_;
  std::size_t total_ = 0;
  std::atomic<std::size_t> done_ = 0;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::mutex mutex_;  ///< Guards everything but `done_`.
  std::condition_variable woken_;
  bool stopped_ = false;
  std::thread drawer_;
};

}  // namespace graze::cli
