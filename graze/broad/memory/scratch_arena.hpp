// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <span>
#include <vector>

namespace graze::detail {

/// Memory borrowed from owners that do not need it for a while, handed out in pieces; thread-safe.
class ScratchArena {
 public:
  static constexpr std::size_t piece = std::size_t{1} << 16U;  ///< Bytes.
  static constexpr std::size_t alignment = 2048;               ///< Of pieces.

  void clear() {
    free_.clear();
    given_.clear();
  }

  /// Adds the whole pieces inside some memory.
  void give(std::span<std::byte> memory) {
    const std::size_t beyond = reinterpret_cast<std::uintptr_t>(memory.data()) % alignment;
    const std::size_t skipped = beyond == 0 ? 0 : alignment - beyond;
    if (memory.size() < skipped + piece) return;
    const std::size_t pieces = (memory.size() - skipped) / piece;
    given_.push_back(memory.subspan(skipped, pieces * piece));
    free_.push_back(given_.back());
  }

  /// Null when nothing is left.
  std::byte* take() {
    const std::lock_guard lock(mutex_);
    if (free_.empty()) return nullptr;
    std::byte* const result = free_.back().data();
    free_.back() = free_.back().subspan(piece);
    if (free_.back().empty()) free_.pop_back();
    return result;
  }

  /// Whether a place is inside this memory.
  bool has(const std::byte* place) const {
    for (const std::span<std::byte> one : given_) {
      if (std::less_equal<>()(one.data(), place) && std::less<>()(place, one.data() + one.size())) return true;
    }
    return false;
  }

 private:
  std::mutex mutex_;
  std::vector<std::span<std::byte>> given_;
  std::vector<std::span<std::byte>> free_;
};

}  // namespace graze::detail
