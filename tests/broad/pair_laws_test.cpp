// SPDX-License-Identifier: MIT
// Compares every method and option with plain brute force, on sets of boxes of every kind and on a coarse lattice where
// everything touches everything; failures shrink to the fewest boxes.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/broad/brute_force_pairs.hpp>
#include <graze/broad/pairs.hpp>

#include "box_worlds.hpp"
#include "simd_targets.hpp"
#include "thread_executor.hpp"

namespace graze::pair_laws_test {
namespace {

/// Boxes that are printed when a law fails.
template <Dim N, class T>
struct Boxes {
  std::string world;
  std::vector<Aabb<N, T>> all;
};

template <Dim N, class T>
std::ostream& operator<<(std::ostream& out, const Boxes<N, T>& boxes) {
  out << boxes.all.size() << " of " << boxes.world << ":";
  for (const Aabb<N, T>& box : boxes.all) {
    out << " [";
    for (Dim i = 0; i < N; ++i) out << (i == 0 ? "" : ", ") << box.min[i] << " ... " << box.max[i];
    out << "]";
  }
  return out;
}

/// One of the sets, with some number of boxes. If a law fails, boxes are removed as long as it does.
template <Dim N, class T>
rc::Gen<Boxes<N, T>> boxes_of_a_world() {
  const std::size_t worlds = test::box_worlds<N, T>(0, 0).size();
  const auto count = rc::gen::weightedOneOf<std::size_t>({{3, rc::gen::inRange<std::size_t>(0, 40)},
                                                          {6, rc::gen::inRange<std::size_t>(0, 500)},
                                                          {1, rc::gen::inRange<std::size_t>(500, 1500)}});
  const auto parts = rc::gen::tuple(rc::gen::inRange<std::size_t>(0, worlds), rc::gen::resize(100, count),
                                    rc::gen::arbitrary<std::uint64_t>());
  return [parts](const rc::Random& random, int size) {
    const auto [world, boxes, seed] = parts(random, size).value();
    test::BoxWorld<N, T> made = std::move(test::box_worlds<N, T>(boxes, seed)[world]);
    const auto with_fewer = [](const Boxes<N, T>& some) {
      return rc::seq::map(rc::shrink::removeChunks(some.all), [world = some.world](std::vector<Aabb<N, T>> fewer) {
        return Boxes<N, T>{world, std::move(fewer)};
      });
    };
    return rc::shrinkable::shrinkRecur(Boxes<N, T>{made.name, std::move(made.boxes)}, with_fewer);
  };
}

/// min_x, extent_x, min_y, ...: extents may be negative, which is an empty box.
template <Dim N, class T>
Boxes<N, T> boxes_of(const std::vector<std::vector<int>>& numbers) {
  Boxes<N, T> boxes{"a coarse lattice", {}};
  for (const auto& row : numbers) {
    Aabb<N, T> box;
    for (Dim i = 0; i < N; ++i) {
      box.min[i] = static_cast<T>(row[static_cast<std::size_t>(2 * i)]);
      box.max[i] = box.min[i] + static_cast<T>(row[static_cast<std::size_t>(2 * i + 1)]);
    }
    boxes.all.push_back(box);
  }
  return boxes;
}

template <Dim N, class T>
rc::Gen<Boxes<N, T>> boxes_on_a_lattice(int side) {
  const auto number = rc::gen::weightedOneOf<int>(
      {{8, rc::gen::inRange(0, side)}, {1, rc::gen::inRange(-1, 3)}, {1, rc::gen::inRange(0, 1000)}});
  return rc::gen::map(rc::gen::scale(12.0, rc::gen::container<std::vector<std::vector<int>>>(
                                               rc::gen::container<std::vector<int>>(2 * N, number))),
                      boxes_of<N, T>);
}

/// The options of a call.
struct Way {
  PairMethod method;
  PairOrder order;
  double margin;
  std::size_t threads;
  std::int64_t target;
  bool between_two_sets;
  bool visits;
  bool finder_was_used;
};

std::ostream& operator<<(std::ostream& out, const Way& way) {
  return out << "method " << name_of(way.method) << ", order " << (way.order == PairOrder::any ? "any" : "sorted")
             << ", margin " << way.margin << ", " << way.threads << " threads, " << hwy::TargetName(way.target)
             << (way.between_two_sets ? ", two sets" : "") << (way.visits ? ", visit" : "")
             << (way.finder_was_used ? ", finder used before" : "");
}

rc::Gen<Way> ways() {
  const std::span<const PairMethod> methods = all_pair_methods();
  return rc::gen::build<Way>(
      rc::gen::set(&Way::method, rc::gen::elementOf(std::vector<PairMethod>(methods.begin(), methods.end()))),
      rc::gen::set(&Way::order, rc::gen::element(PairOrder::sorted, PairOrder::any)),
      rc::gen::set(&Way::margin, rc::gen::element(0.0, 0.25, 3.0)),
      rc::gen::set(&Way::threads, rc::gen::element<std::size_t>(1, 2, 7)),
      rc::gen::set(&Way::target, rc::gen::elementOf(test::simd_targets())), rc::gen::set(&Way::between_two_sets),
      rc::gen::set(&Way::visits), rc::gen::set(&Way::finder_was_used));
}

template <Dim N, class T>
std::vector<Aabb<N, T>> grown(std::span<const Aabb<N, T>> boxes, double margin) {
  std::vector<Aabb<N, T>> larger(boxes.begin(), boxes.end());
  for (Aabb<N, T>& box : larger) {
    if (!is_nothing(box)) box = {box.min - static_cast<T>(margin), box.max + static_cast<T>(margin)};
  }
  return larger;
}

/// A finder's answer, in the order that it promises; sorted if it promises none.
template <Dim N, class T>
std::vector<Pair> found(std::span<const Aabb<N, T>> a, std::span<const Aabb<N, T>> b, const Way& way) {
  const test::ThreadExecutor executor(way.threads);
  const test::ForcedTarget forced(way.target);
  const PairOptions options{&executor, way.order, way.margin, way.method};
  PairFinder<N, T> finder;
  if (way.finder_was_used) finder.find(a, {.order = way.order, .method = way.method});
  std::vector<Pair> pairs;
  if (way.visits) {
    const PairVisitor add = [&pairs](std::span<const Pair> some) {
      pairs.insert(pairs.end(), some.begin(), some.end());
      return true;
    };
    way.between_two_sets ? finder.visit(a, b, add, options) : finder.visit(a, add, options);
  } else {
    const std::span<const Pair> all = way.between_two_sets ? finder.find(a, b, options) : finder.find(a, options);
    pairs.assign(all.begin(), all.end());
  }
  if (way.visits || way.order == PairOrder::any) std::sort(pairs.begin(), pairs.end());
  return pairs;
}

template <Dim N, class T>
void expect_lawful(const Boxes<N, T>& boxes) {
  const Way way = *ways();
  const std::span<const Aabb<N, T>> all = boxes.all;
  const std::size_t cut = way.between_two_sets ? all.size() / 3 : all.size();
  const std::vector<Aabb<N, T>> a = grown(all.first(cut), way.margin);
  const std::vector<Aabb<N, T>> b = grown(all.subspan(cut), way.margin);
  const std::vector<Pair> expected = way.between_two_sets ? brute_force_pairs<N, T>(std::span(a), std::span(b))
                                                          : brute_force_pairs<N, T>(std::span(a));
  RC_ASSERT((found<N, T>(all.first(cut), all.subspan(cut), way)) == expected);
}

RC_GTEST_PROP(PairLaws, InThePlaneInFloat, ()) { expect_lawful(*boxes_of_a_world<2, float>()); }
RC_GTEST_PROP(PairLaws, InThePlaneInDouble, ()) { expect_lawful(*boxes_of_a_world<2, double>()); }
RC_GTEST_PROP(PairLaws, InSpaceInFloat, ()) { expect_lawful(*boxes_of_a_world<3, float>()); }
RC_GTEST_PROP(PairLaws, InSpaceInDouble, ()) { expect_lawful(*boxes_of_a_world<3, double>()); }

template <Dim N, class T>
void expect_lawful_on_a_lattice(int most_places) {
  expect_lawful(*boxes_on_a_lattice<N, T>(*rc::gen::inRange(2, most_places)));
}

RC_GTEST_PROP(PairLaws, OnALatticeInThePlaneInFloat, ()) { expect_lawful_on_a_lattice<2, float>(60); }
RC_GTEST_PROP(PairLaws, OnALatticeInThePlaneInDouble, ()) { expect_lawful_on_a_lattice<2, double>(60); }
RC_GTEST_PROP(PairLaws, OnALatticeInSpaceInFloat, ()) { expect_lawful_on_a_lattice<3, float>(20); }
RC_GTEST_PROP(PairLaws, OnALatticeInSpaceInDouble, ()) { expect_lawful_on_a_lattice<3, double>(20); }

}  // namespace
}  // namespace graze::pair_laws_test
