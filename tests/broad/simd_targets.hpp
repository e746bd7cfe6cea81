// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <hwy/targets.h>

#include <graze/broad/pairs/block_kernels.hpp>

namespace graze::test {

/// The instruction sets of this machine that the kernels were compiled for, the best first, the scalar one last.
inline std::vector<std::int64_t> all_simd_targets() {
  std::vector<std::int64_t> targets;
  const std::int64_t all = hwy::SupportedTargets() & detail::block_kernel_targets();
  for (std::int64_t rest = all; rest != 0; rest &= rest - 1) targets.push_back(rest & -rest);
  return targets;
}

/// Those that tests try: all, or with GRAZE_TEST_BRIEFLY the best two. AVX-512 masks memory accesses in hardware, AVX2
/// as all others do.
inline std::vector<std::int64_t> simd_targets() {
  std::vector<std::int64_t> targets = all_simd_targets();
#ifdef GRAZE_TEST_BRIEFLY
  if (targets.size() > 2) targets.resize(2);
#endif
  return targets;
}

/// During its lifetime, kernels of one instruction set are used.
class ForcedTarget {
 public:
  explicit ForcedTarget(std::int64_t target) { force(target); }
  ~ForcedTarget() { force(0); }
  ForcedTarget(const ForcedTarget&) = delete;
  ForcedTarget& operator=(const ForcedTarget&) = delete;

 private:
  static void force(std::int64_t targets) {
    hwy::SetSupportedTargetsForTest(targets);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  }
};

}  // namespace graze::test
