// SPDX-License-Identifier: MIT
#include "progress.hpp"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

#include <fmt/format.h>

#include "terminal.hpp"

namespace graze::cli {
namespace {

constexpr std::chrono::milliseconds quiet_time{1000};
constexpr std::chrono::milliseconds frame_time{100};

void write_at_once(const std::string& text) {
  std::fputs(text.c_str(), stderr);
  std::fflush(stderr);
}

}  // namespace

Progress::Progress(std::string_view work) : work_(work) {
  if (has_cursor(Stream::error)) drawer_ = std::thread(&Progress::draw_until_stopped, this);
}

void Progress::begin(std::string_view work, std::size_t total) {
  const std::lock_guard lock(mutex_);
  work_ = work;
  total_ = total;
  done_ = 0;
}

void Progress::stop() {
  if (!drawer_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    stopped_ = true;
  }
  woken_.notify_one();
  drawer_.join();
}

void Progress::draw_until_stopped() {
  std::unique_lock lock(mutex_);
  const auto is_stopped = [this] { return stopped_; };
  if (woken_.wait_for(lock, quiet_time, is_stopped)) return;
  do {
    // The last column stays empty: some terminals wrap after writing to it.
    write_at_once(fmt::format("\r{:.{}}\x1b[K", line(), terminal_columns() - 1));
  } while (!woken_.wait_for(lock, frame_time, is_stopped));
  write_at_once("\r\x1b[K");
}

std::string Progress::line() const {
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
  if (total_ == 0) return fmt::format("{} ... {:.0f} s", work_, elapsed.count());
  constexpr std::size_t width = 24;
  const std::size_t done = std::min(done_.load(std::memory_order_relaxed), total_);
  const double share = static_cast<double>(done) / static_cast<double>(total_);
  const auto filled = static_cast<std::size_t>(share * static_cast<double>(width));
  return fmt::format("{} [{:<{}}] {:3.0f} % {:.0f} s", work_, std::string(filled, '='), width, share * 100,
                     elapsed.count());
}

}  // namespace graze::cli
