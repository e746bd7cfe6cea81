// SPDX-License-Identifier: MIT
#include "results.hpp"

namespace graze::race {

const Timing* timing_of(const Heat& heat, const std::string& name) {
  for (const Timing& timing : heat.timings) {
    if (timing.name == name && timing.frames > 0) return &timing;
  }
  return nullptr;
}

double time_of(const Timing& timing, Finish finish) { return finish == Finish::sorted ? timing.sorted : timing.median; }

const Timing* fastest(const Heat& heat, Side side, std::size_t threads, Field field, Finish finish) {
  const Timing* best = nullptr;
  for (const Timing& timing : heat.timings) {
    const bool belongs = timing.side == side && (field == Field::all || !timing.keeps);
    const bool counts = belongs && timing.threads <= threads && timing.frames > 0;
    if (counts && (best == nullptr || time_of(timing, finish) < time_of(*best, finish))) best = &timing;
  }
  return best;
}

// The plain function is the first of graze's contestants.
const Timing* judged(const Heat& heat, std::size_t threads) {
  for (const Timing& timing : heat.timings) {
    if (timing.side == Side::graze && timing.threads == threads) return timing.frames > 0 ? &timing : nullptr;
  }
  return nullptr;
}

}  // namespace graze::race
