// SPDX-License-Identifier: MIT
#include <algorithm>
#include <atomic>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include <graze/broad/index/key_table.hpp>

namespace graze::detail {
namespace {

/// The only global state in graze: with a number of its own, an index recognises keys of other indexes. No answer
/// depends on it. Zero is reserved for default-constructed keys.
std::uint32_t new_owner() {
  static std::atomic<std::uint32_t> owners{0};
  const std::uint32_t owner = owners.fetch_add(1, std::memory_order_relaxed) + 1;
  return owner == 0 ? new_owner() : owner;
}

}  // namespace

KeyTable::KeyTable(std::uint32_t most) : most_(most), owner_(new_owner()) {}

Key KeyTable::prepare() {
  if (!free_.empty()) return {free_.back(), generations_[free_.back()] + 1, owner_};
  if (is_full()) throw_full();
  if (generations_.size() == generations_.capacity()) {
    const std::size_t room = std::max<std::size_t>(16, 2 * generations_.size());
    free_.reserve(room);
    generations_.reserve(room);
  }
  return {slots(), 1, owner_};
}

Key KeyTable::take() noexcept {
  std::uint32_t slot = slots();
  if (free_.empty()) {
    generations_.push_back(0);
  } else {
    slot = free_.back();
    free_.pop_back();
  }
  ++generations_[slot];
  ++size_;
  ++changes_;
  return key_of(slot);
}

void KeyTable::take_many(std::span<std::uint32_t> slots) {
  if (slots.size() > room()) throw_full();
  const std::size_t used_again = std::min(slots.size(), free_.size());
  const std::size_t known = generations_.size();
  generations_.reserve(known + slots.size() - used_again);
  free_.reserve(generations_.capacity());
  for (std::size_t k = 0; k < used_again; ++k) slots[k] = take().index;
  const std::span<std::uint32_t> fresh = slots.subspan(used_again);
  std::iota(fresh.begin(), fresh.end(), static_cast<std::uint32_t>(known));
  generations_.resize(known + fresh.size(), 1);
  size_ += fresh.size();
  changes_ += fresh.size();
}

std::vector<Key> KeyTable::keys_of(std::span<const std::uint32_t> slots) const {
  std::vector<Key> keys;
  reserve_in_large_pages(keys, slots.size());
  keys.resize(slots.size());
  for (std::size_t k = 0; k < slots.size(); ++k) keys[k] = key_of(slots[k]);
  return keys;
}

void KeyTable::throw_full() const {
  throw std::length_error("SpatialIndex: full; it holds at most " + std::to_string(most_) + " boxes");
}

void KeyTable::release(std::uint32_t slot) noexcept {
  --size_;
  ++changes_;
  if (++generations_[slot] != used_up) free_.push_back(slot);
}

void KeyTable::release_all() noexcept {
  for (std::uint32_t slot = 0; slot < slots(); ++slot) {
    if (is_taken(slot)) release(slot);
  }
}

void KeyTable::plan(std::span<const Key> next, std::span<const Key> free) {
  if (!generations_.empty()) throw std::logic_error("SpatialIndex: keys must be planned before anything is inserted");
  const std::size_t places = next.size() + free.size();
  if (places > most_) throw std::length_error("SpatialIndex: more keys are planned than it can hold");
  PageVector<std::uint32_t> generations(places);
  std::vector<bool> is_named(places, false);
  const auto enter = [&](const Key& key, unsigned last_bit, std::uint32_t generation) {
    const bool is_given = key.generation <= used_up && (key.generation & 1U) == last_bit;
    if (key.index >= places || is_named[key.index] || !is_given) {
      throw std::invalid_argument("SpatialIndex: the key (index " + std::to_string(key.index) + ", generation " +
                                  std::to_string(key.generation) + ") cannot be planned");
    }
    is_named[key.index] = true;
    generations[key.index] = generation;
  };
  for (const Key& key : free) enter(key, 0, key.generation);
  for (const Key& key : next) enter(key, 1, key.generation - 1);
  PageVector<std::uint32_t> stack;
  stack.reserve(generations.capacity());
  for (const Key& key : free) {
    if (key.generation != used_up) stack.push_back(key.index);
  }
  for (std::size_t i = next.size(); i-- > 0;) stack.push_back(next[i].index);
  generations_ = std::move(generations);
  free_ = std::move(stack);
}

std::vector<Key> KeyTable::free_keys() const {
  std::vector<Key> keys;
  for (std::uint32_t slot = 0; slot < slots(); ++slot) {
    if (generations_[slot] == used_up) keys.push_back(key_of(slot));
  }
  for (const std::uint32_t slot : free_) keys.push_back(key_of(slot));
  return keys;
}

std::uint32_t KeyTable::slot_of(const Key& key) const {
  if (contains(key)) return key.index;
  const std::string name = "SpatialIndex: the key (index " + std::to_string(key.index) + ", generation " +
                           std::to_string(key.generation) + ") ";
  if (key == Key{}) throw std::out_of_range(name + "is default-constructed; only insert returns keys");
  if (!has_issued(key)) throw std::out_of_range(name + "belongs to another index");
  throw std::out_of_range(name + "names no box any more; it was erased");
}

}  // namespace graze::detail
