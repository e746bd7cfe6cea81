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

/// A progress line on the error stream, if that is a terminal; it appears after a second and is erased when the
/// progress ends. A separate thread draws it, so that it also moves during work without progress reports. Only one may
/// exist at a time, and nothing else may write to the terminal meanwhile.
class Progress {
 public:
  /// Begins with work of unknown length.
  explicit Progress(std::string_view work);
  ~Progress() { stop(); }

  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Begins the next step of the work, with `total` items, or 0 if their number is unknown.
  void begin(std::string_view work, std::size_t total = 0);

  /// Sets the number of completed items.
  void advance(std::size_t done) { done_.store(done, std::memory_order_relaxed); }

  /// Erases the line. May be called repeatedly.
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
