// SPDX-License-Identifier: MIT
// Every method on the boxes of two real chips, whose pairs were counted independently: cells of few sizes in rows, many
// of which abut. The folder is in GRAZE_SHARED_DATA, or ../shared/data beside the project. If GRAZE_TEST_SCALE is below
// 1, a fifth of the boxes, whose pairs brute force alone tells: with sanitizers it would take a minute for all.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/pairs.hpp>

#include "number_of_cases.hpp"
#include "simd_targets.hpp"
#include "thread_executor.hpp"

namespace graze::pairs_of_chips_test {
namespace {

std::filesystem::path chip_file(const char* name) {
  const char* const folder = std::getenv("GRAZE_SHARED_DATA");
  if (folder != nullptr) return std::filesystem::path(folder) / name;
  const char* const root = std::getenv("GRAZE_ROOT");
  return std::filesystem::path(root == nullptr ? "." : root) / ".." / "shared" / "data" / name;
}

/// The boxes of a file of lines id,min_x,min_y,max_x,max_y: integers that float holds exactly.
template <class T>
std::vector<Aabb<2, T>> boxes_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  std::vector<Aabb<2, T>> boxes;
  while (std::getline(file, line)) {
    int min_x = 0;
    int min_y = 0;
    int max_x = 0;
    int max_y = 0;
    const char* const numbers = line.c_str() + std::min(line.find(','), line.size());
    if (std::sscanf(numbers, ",%d,%d,%d,%d", &min_x, &min_y, &max_x, &max_y) != 4) {
      ADD_FAILURE() << path << ": " << line;
      return {};
    }
    boxes.push_back({{static_cast<T>(min_x), static_cast<T>(min_y)}, {static_cast<T>(max_x), static_cast<T>(max_y)}});
  }
  return boxes;
}

bool is_whole_chip_tried() { return test::number_from_environment("GRAZE_TEST_SCALE", 1) >= 1; }

template <class T>
class Chip {
 public:
  explicit Chip(std::vector<Aabb<2, T>> boxes)
      : boxes_(std::move(boxes)), expected_(pairs({.method = PairMethod::brute_force})) {}

  std::size_t pair_count() const { return expected_.size(); }

  void expect_pairs_by(PairMethod method, const Executor& executor, const std::string& where) const {
    EXPECT_EQ(pairs({.executor = &executor, .method = method}), expected_) << name_of(method) << where;
    std::vector<Pair> as_found = pairs({.executor = &executor, .order = PairOrder::any, .method = method});
    std::sort(as_found.begin(), as_found.end());
    EXPECT_EQ(as_found, expected_) << name_of(method) << where << " in any order";
  }

  /// Between the first third of the boxes and the rest: the pairs with a box in each.
  void expect_pairs_of_two_sets() const {
    const std::span<const Aabb<2, T>> all = boxes_;
    const std::size_t cut = all.size() / 3;
    std::vector<Pair> across;
    for (const Pair& pair : expected_) {
      if (pair.a < cut && pair.b >= cut) across.push_back({pair.a, pair.b - static_cast<std::uint32_t>(cut)});
    }
    for (const PairMethod method : {PairMethod::automatic, PairMethod::dense, PairMethod::tree}) {
      EXPECT_EQ(overlapping_pairs(all.first(cut), all.subspan(cut), {.method = method}), across) << name_of(method);
    }
  }

 private:
  std::vector<Pair> pairs(const PairOptions& options) const { return overlapping_pairs(boxes_, options); }

  std::vector<Aabb<2, T>> boxes_;
  std::vector<Pair> expected_;
};

template <class T>
void expect_known_answers(const char* name, std::size_t pair_count) {
  const std::filesystem::path path = chip_file(name);
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "there is no " << path;
  std::vector<Aabb<2, T>> boxes = boxes_of<T>(path);
  if (!is_whole_chip_tried()) boxes.resize(boxes.size() / 5);
  const Chip<T> chip(std::move(boxes));
  if (is_whole_chip_tried()) {
    ASSERT_EQ(chip.pair_count(), pair_count);
  } else {
    ASSERT_GT(chip.pair_count(), 1'000);
  }
  for (const std::size_t threads : {1U, 2U, 7U}) {
    const test::ThreadExecutor executor(threads);
    for (const PairMethod method : {PairMethod::automatic, PairMethod::dense, PairMethod::tree}) {
      chip.expect_pairs_by(method, executor, " by " + std::to_string(threads) + " threads");
    }
  }
  for (const std::int64_t target : test::simd_targets()) {
    const test::ForcedTarget forced(target);
    for (const PairMethod method : {PairMethod::dense, PairMethod::tree}) {
      chip.expect_pairs_by(method, serial_executor(), std::string(" on ") + hwy::TargetName(target));
    }
  }
  chip.expect_pairs_of_two_sets();
}

TEST(PairsOfChips, PlacedCellsInDouble) { expect_known_answers<double>("chip_aes.csv", 26'815); }
TEST(PairsOfChips, PlacedCellsInFloat) { expect_known_answers<float>("chip_aes.csv", 26'815); }
TEST(PairsOfChips, CellsThatAbutInDouble) { expect_known_answers<double>("chip_aes_legal.csv", 42'887); }
TEST(PairsOfChips, CellsThatAbutInFloat) { expect_known_answers<float>("chip_aes_legal.csv", 42'887); }

}  // namespace
}  // namespace graze::pairs_of_chips_test
