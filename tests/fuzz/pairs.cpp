// SPDX-License-Identifier: MIT
// All overlapping pairs by every method, with one thread and several, in both orders, of moving boxes and of two sets,
// compared with a double loop. All reject invalid boxes.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <graze/broad/pairs.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

#include "broad/thread_executor.hpp"
#include "fuzz/input.hpp"
#include "fuzz/require.hpp"

using namespace graze;
constexpr Dim N = GRAZE_FUZZ_DIMENSION;
using T = GRAZE_FUZZ_SCALAR;

namespace {

using Box = Aabb<N, T>;

/// The pairs, or the message of the rejection.
struct Answer {
  std::vector<Pair> pairs;
  std::string refusal;

  friend bool operator==(const Answer&, const Answer&) = default;
};

Answer answer_of(const auto& ask) {
  Answer answer;
  try {
    const auto pairs = ask();
    answer.pairs.assign(pairs.begin(), pairs.end());
  } catch (const std::invalid_argument& error) {
    answer.refusal = error.what();
  }
  return answer;
}

/// Many boxes from few bytes: each group is a box, a count, and a displacement from one to the next.
std::vector<Box> boxes_of(test::fuzz::Input& input) {
  std::vector<Box> boxes;
  for (std::size_t groups = input.below(12); groups > 0; --groups) {
    const Vec<N, T> corner = input.vec<N, T>();
    const Vec<N, T> other = input.vec<N, T>();
    const Vec<N, T> way = input.vec<N, T>();
    const bool is_sorted = input.below(8) != 0;
    for (std::size_t count = input.below(40); count > 0; --count) {
      const Vec<N, T> from = corner + way * static_cast<T>(count);
      boxes.push_back(is_sorted ? Box::from_corners(from, from + other) : Box{from, other});
    }
  }
  return boxes;
}

void check(const Answer& found, Answer expected, PairOrder order, PairMethod method) {
  Answer sorted = found;
  if (order == PairOrder::any) std::sort(sorted.pairs.begin(), sorted.pairs.end());
  test::fuzz::require(sorted == expected, [&](std::ostream& out) {
    out << name_of(method) << " finds " << found.pairs.size() << " of " << expected.pairs.size() << " pairs; it says \""
        << found.refusal << "\", and should \"" << expected.refusal << "\"";
  });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  test::fuzz::Input input(data, size);
  const test::ThreadExecutor three(3);
  PairOptions options;
  const std::size_t kind = input.below(12);
  options.order = kind % 2 == 0 ? PairOrder::sorted : PairOrder::any;
  options.executor = kind % 6 < 4 ? &serial_executor() : static_cast<const Executor*>(&three);
  options.method = all_pair_methods()[kind / 2 % all_pair_methods().size()];
  if (input.below(4) == 0) options.margin = input.number<double>();
  PairOptions plainly = options;
  plainly.order = PairOrder::sorted;
  plainly.executor = &serial_executor();
  plainly.method = PairMethod::brute_force;
  PairFinder<N, T> finder;
  for (int frame = 0; frame < 3; ++frame) {
    std::vector<Box> boxes = boxes_of(input);
    const std::span<const Box> all(boxes);
    const Answer expected = answer_of([&] { return overlapping_pairs(all, plainly); });
    check(answer_of([&] { return overlapping_pairs(all, options); }), expected, options.order, options.method);
    check(answer_of([&] { return finder.find(all, options); }), expected, options.order, options.method);
    const auto visited = answer_of([&] {
      std::vector<Pair> pairs;
      visit_overlapping_pairs(
          all,
          [&](std::span<const Pair> block) {
            pairs.insert(pairs.end(), block.begin(), block.end());
            return true;
          },
          options);
      return pairs;
    });
    check(visited, expected, PairOrder::any, options.method);
    const Vec<N, T> step = input.vec<N, T>();
    for (Box& box : boxes) box = {box.min + step, box.max + step};
    check(answer_of([&] { return finder.find(all, options); }),
          answer_of([&] { return overlapping_pairs(all, plainly); }), options.order, options.method);
    const std::span<const Box> first = all.first(all.size() / 3);
    const std::span<const Box> rest = all.subspan(all.size() / 3);
    check(answer_of([&] { return finder.find(first, rest, options); }),
          answer_of([&] { return overlapping_pairs(first, rest, plainly); }), options.order, options.method);
  }
  return 0;
}
