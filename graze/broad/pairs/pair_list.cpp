// SPDX-License-Identifier: MIT
#include <algorithm>
#include <utility>

#include <graze/broad/memory/prefault.hpp>
#include <graze/broad/pairs/pair_list.hpp>

namespace graze::detail {
namespace {

constexpr std::size_t at_once = std::size_t{1} << 16U;  // pairs prefaulted at a time, half a megabyte
constexpr std::size_t prefaulted_from = 8 * at_once;    // pairs from which that pays

// Whether an address sanitizer reports writes to a vector's spare capacity: libc++ annotates it.
#if defined(_LIBCPP_VERSION) && defined(__has_feature)
constexpr bool watches_room_to_spare = __has_feature(address_sanitizer);
#else
constexpr bool watches_room_to_spare = false;
#endif

}  // namespace

/// Prefaults the memory of at least this many pairs, within the capacity.
void PairList::prefault_to(std::size_t count) {
  if (count <= prefaulted_ || pairs_.capacity() < prefaulted_from) return;
  const std::size_t end = std::min(std::max(count, prefaulted_ + at_once), pairs_.capacity());
  prefault(pairs_.data() + prefaulted_, (end - prefaulted_) * sizeof(Pair));
  prefaulted_ = end;
}

Pair* PairList::all(std::size_t count) {
  all_in_turns(count);
  reach_by_all(count);
  return pairs_.data();
}

Pair* PairList::all_in_turns(std::size_t count) {
  reserve_in_large_pages(pairs_, count);
  return pairs_.data();
}

void PairList::reach(std::size_t end) {
  while (pairs_.size() < end) {
    const std::size_t next = std::min(end, pairs_.size() + at_once);
    prefault_to(next);
    pairs_.resize(next);
  }
}

void PairList::reach_by_all(std::size_t end) {
  if (executor_.concurrency() < 2) return reach(end);
  if (pairs_.size() >= end) return;
  prefault(pairs_.data() + pairs_.size(), (end - pairs_.size()) * sizeof(Pair), executor_);
  pairs_.resize(end);
}

std::span<Pair> PairList::ahead(std::size_t expected) {
  if (watches_room_to_spare) return {};
  reserve_in_large_pages(pairs_, expected + expected / 16);
  return {pairs_.data(), pairs_.capacity()};
}

const Pair* PairList::append(std::span<const Pair> pairs, std::size_t expected) {
  const std::size_t count = pairs_.size() + pairs.size();
  if (count > pairs_.capacity()) {
    // The estimate after few pairs may be far too high; later ones allow for half as many more, whose pages are never
    // touched.
    std::vector<Pair> longer;
    reserve_in_large_pages(longer, std::clamp(expected + expected / 2, count + count / 2, 16 * count));
    longer.assign(pairs_.begin(), pairs_.end());
    pairs_ = std::move(longer);
    prefaulted_ = pairs_.size();
  }
  prefault_to(count);
  pairs_.insert(pairs_.end(), pairs.begin(), pairs.end());
  return pairs_.data();
}

std::vector<Pair> PairList::take() {
  if (pairs_.capacity() / 2 > pairs_.size()) pairs_.shrink_to_fit();
  return std::exchange(pairs_, {});
}

}  // namespace graze::detail
