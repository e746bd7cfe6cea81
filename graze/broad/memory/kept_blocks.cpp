// SPDX-License-Identifier: MIT
#include <algorithm>

#include <graze/broad/memory/kept_blocks.hpp>

namespace graze::detail {

KeptBlocks::~KeptBlocks() {
  while (count_ > 0) release_oldest();
}

KeptBlocks::Block KeptBlocks::remove(std::size_t place) noexcept {
  const Block result = blocks_[place];
  std::copy(blocks_.begin() + place + 1, blocks_.begin() + count_, blocks_.begin() + place);
  --count_;
  bytes_ -= result.bytes;
  return result;
}

void KeptBlocks::release_oldest() noexcept {
  const Block oldest = remove(0);
  release_(oldest.memory, oldest.bytes);
}

void* KeptBlocks::take(std::size_t bytes) noexcept {
  const std::lock_guard lock(mutex_);
  ++clock_;
  while (count_ > 0 && clock_ - blocks_[0].kept_at > patience) release_oldest();
  for (std::size_t place = count_; place > 0; --place) {  // the latest may still be in a cache
    if (blocks_[place - 1].bytes != bytes) continue;
    used_ += bytes;
    return remove(place - 1).memory;
  }
  return nullptr;
}

void KeptBlocks::note_new(std::size_t bytes) noexcept {
  const std::lock_guard lock(mutex_);
  used_ += bytes;
}

void KeptBlocks::keep(void* block, std::size_t bytes) noexcept {
  const std::lock_guard lock(mutex_);
  used_ -= bytes;
  while (count_ > 0 && (count_ == blocks_.size() || bytes_ > most())) release_oldest();
  if (bytes > most()) {
    release_(block, bytes);
    return;
  }
  while (bytes_ + bytes > most()) release_oldest();
  blocks_[count_++] = {block, bytes, clock_};
  bytes_ += bytes;
}

std::size_t KeptBlocks::bytes() const noexcept {
  const std::lock_guard lock(mutex_);
  return bytes_;
}

}  // namespace graze::detail
