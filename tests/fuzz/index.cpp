// SPDX-License-Identifier: MIT
// A spatial index with any operations, compared with BruteForce.
#include <array>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <graze/broad/bvh.hpp>
#include <graze/broad/grid.hpp>
#include <graze/broad/orthtree.hpp>
#include <graze/math/vec.hpp>

#include "broad/index_operations.hpp"
#include "broad/spatial_index_laws.hpp"
#include "fuzz/input.hpp"
#include "fuzz/require.hpp"

using namespace graze;
constexpr Dim N = GRAZE_FUZZ_DIMENSION;
using T = GRAZE_FUZZ_SCALAR;

namespace {

constexpr std::size_t most_steps = 100;

template <class I>
void run(int settings, double unit, const std::vector<test::Step>& steps) {
  try {
    test::Trial<I>(test::index_number<I>(settings), unit).run(steps);
  } catch (const rc::detail::CaseResult& result) {
    test::fuzz::require(false, [&](std::ostream& out) { out << result.description; });
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  test::fuzz::Input input(data, size);
  const std::size_t kind = input.below(36);
  const auto settings = static_cast<int>(kind / 9);
  const double unit = std::array{1.0, 0.1, 1e5}[kind / 3 % 3];
  std::vector<test::Step> steps;
  while (!input.is_empty() && steps.size() < most_steps) {
    test::Step step(8);
    for (int& number : step) number = input.whole();
    steps.push_back(std::move(step));
  }
  switch (kind % 3) {
    case 0:
      run<Orthtree<N, T>>(settings, unit, steps);
      break;
    case 1:
      run<Bvh<N, T>>(settings, unit, steps);
      break;
    default:
      run<Grid<N, T>>(settings, unit, steps);
  }
  return 0;
}
