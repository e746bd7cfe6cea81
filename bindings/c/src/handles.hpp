// SPDX-License-Identifier: MIT
// Handles: numbers that name values, and that are never valid again once their value has ended.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <shared_mutex>
#include <string>
#include <utility>
#include <vector>

#include "errors.hpp"

namespace graze::c {

/// The values of one type by their handles. A handle has the index of a place in its lower 32 bits, above them the
/// generation of the place in 24, which is odd while it is taken, and in the upper 8 a mark of the type, so that the
/// handle of another type is refused, too. Places are used again until their generations are used up. Safe from many
/// threads; who looks up a value shares it, so another thread may end its handle meanwhile.
template <class Value>
class HandleTable {
 public:
  /// `noun` names a value in messages.
  HandleTable(std::uint8_t mark, const char* noun) : mark_(mark), noun_(noun) {}

  std::uint64_t add(std::shared_ptr<Value> value) {
    const std::unique_lock lock(mutex_);
    if (first_vacant_ == no_place) {
      if (places_.size() == no_place)
        throw Error(GRAZE_TOO_MANY, std::string("there is no handle left for a ") + noun_);
      places_.emplace_back();
      first_vacant_ = static_cast<std::uint32_t>(places_.size() - 1);
    }
    const std::uint32_t index = first_vacant_;
    Place& place = places_[index];
    first_vacant_ = place.next_vacant;
    ++place.generation;
    place.value = std::move(value);
    return handle_of(index, place.generation);
  }

  /// Throws Error for a handle that names no value.
  std::shared_ptr<Value> find(std::uint64_t handle) const {
    const std::shared_lock lock(mutex_);
    return places_[index_of(handle)].value;
  }

  /// Ends a handle. Throws like `find`.
  void end(std::uint64_t handle) {
    std::shared_ptr<Value> value;  // destroyed without the lock
    const std::unique_lock lock(mutex_);
    const std::uint32_t index = index_of(handle);
    Place& place = places_[index];
    value.swap(place.value);
    ++place.generation;
    if (place.generation == last_generation) return;
    place.next_vacant = first_vacant_;
    first_vacant_ = index;
  }

 private:
  static constexpr std::uint32_t no_place = 0xFFFFFFFF;
  static constexpr std::uint32_t last_generation = 0xFFFFFE;  // even: it stays vacant

  struct Place {
    std::uint32_t generation = 0;
    std::uint32_t next_vacant = no_place;
    std::shared_ptr<Value> value;
  };

  std::uint64_t handle_of(std::uint32_t index, std::uint32_t generation) const {
    return std::uint64_t{mark_} << 56U | std::uint64_t{generation} << 32U | index;
  }

  std::uint32_t index_of(std::uint64_t handle) const {
    const auto index = static_cast<std::uint32_t>(handle);
    const bool is_known = index < places_.size() && places_[index].value != nullptr &&
                          handle_of(index, places_[index].generation) == handle;
    if (is_known) return index;
    const bool is_ours = handle >> 56U == mark_;
    throw Error(GRAZE_OUT_OF_RANGE, std::string("the handle ") + std::to_string(handle) + " names no " + noun_ +
                                        (is_ours ? "; it was destroyed, or never created" : ""));
  }

  std::uint8_t mark_;
  const char* noun_;
  mutable std::shared_mutex mutex_;
  std::vector<Place> places_;
  std::uint32_t first_vacant_ = no_place;
};

}  // namespace graze::c
