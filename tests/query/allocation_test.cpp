// SPDX-License-Identifier: MIT
// No query of two shapes takes memory from the heap: not for any two types, nor where shapes touch or lie in each
// other. This program counts what is asked of operator new; answers are looked at elsewhere.
#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <map>
#include <new>
#include <string>
#include <type_traits>
#include <variant>

#include <gtest/gtest.h>

#include <graze/math/vec.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/compound.hpp>
#include <graze/shape/polytope.hpp>
#include <graze/shape/ray.hpp>

#include "catalogue.hpp"
#include "query/contacts.hpp"
#include "query/every_pair.hpp"
#include "query/manifolds.hpp"
#include "query/pairs.hpp"
#include "query/point_answers.hpp"
#include "query/proximities.hpp"
#include "query/ray_casts.hpp"
#include "query/shape_casts.hpp"

namespace graze::test::allocation_test {
namespace {

thread_local std::size_t asked_of_the_heap = 0;

void* take_if_there_is_some(std::size_t bytes) noexcept {
  ++asked_of_the_heap;
  return std::malloc(bytes == 0 ? 1 : bytes);
}

void* take(std::size_t bytes) {
  if (void* const memory = take_if_there_is_some(bytes)) return memory;
  throw std::bad_alloc();
}

}  // namespace
}  // namespace graze::test::allocation_test

void* operator new(std::size_t bytes) { return graze::test::allocation_test::take(bytes); }
void* operator new[](std::size_t bytes) { return graze::test::allocation_test::take(bytes); }
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept {
  return graze::test::allocation_test::take_if_there_is_some(bytes);
}
void* operator new[](std::size_t bytes, const std::nothrow_t&) noexcept {
  return graze::test::allocation_test::take_if_there_is_some(bytes);
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
void operator delete[](void* memory, const std::nothrow_t&) noexcept { std::free(memory); }

namespace graze::test::allocation_test {
namespace {

/// Which queries have asked, of which types, how often.
using Tally = std::map<std::string, std::size_t>;

template <Dim N, class T>
std::string types_of(const AnyShape<N, T>& a, const AnyShape<N, T>& b) {
  const auto name = [](const auto& held) { return std::string(Entry<std::decay_t<decltype(held)>>::name); };
  return std::visit(name, a) + ", " + std::visit(name, b);
}

template <Dim N, class T>
class Counting {
 public:
  /// Calls a query of two shapes, and notes if it takes memory.
  template <class Query>
  void call(const char* query, const AnyShape<N, T>& a, const AnyShape<N, T>& b, const Query& ask) {
    const std::size_t before = asked_of_the_heap;
    (void)ask();
    if (asked_of_the_heap != before) ++tally_[std::string(query) + " of " + types_of<N, T>(a, b)];
    ++calls_;
  }

  const Tally& tally() const { return tally_; }
  std::size_t calls() const { return calls_; }

 private:
  Tally tally_;
  std::size_t calls_ = 0;
};

template <Dim N, class T>
bool holds_polytope(const AnyShape<N, T>& shape) {
  if (const auto* compound = std::get_if<Compound<N, T>>(&shape)) {
    return std::any_of(compound->parts.begin(), compound->parts.end(),
                       [](const Part<N, T>& part) { return holds_polytope<N, T>(part.shape); });
  }
  return std::holds_alternative<Polytope<N, T>>(shape);
}

template <class Space>
class AllocationIn : public testing::Test {};

TYPED_TEST_SUITE(AllocationIn, Spaces);

TYPED_TEST(AllocationIn, IsNotNeededByAnyQueryOfTwoShapesButPolytopes) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  Counting<N, T> counting;
  const auto always = [] { return true; };
  const auto check = [&](const AnyPair<N, T>& pair) {
    const AnyShape<N, T>& a = pair.first;
    const AnyShape<N, T>& b = pair.second;
    if (holds_polytope<N, T>(a) || holds_polytope<N, T>(b)) return;
    const auto call = [&](const char* query, const auto& ask) { counting.call(query, a, b, ask); };
    call("relation", [&] { return relation_of<N, T>(a, b); });
    call("distance", [&] { return distance_of<N, T>(a, b); });
    call("closest_points", [&] { return closest_points_of<N, T>(a, b); });
    call("contact", [&] { return contact_of<N, T>(a, b); });
    call("manifold", [&] { return manifold_of<N, T>(a, b); });
    call("shape_cast", [&] { return impact_of<N, T>(a, Vec<N, T>(T(1)), b); });
    if (const auto* ray = std::get_if<Ray<N, T>>(&a)) {
      call("ray_cast", [&] { return hit_of<N, T>(b, *ray, T(8)); });
    }
    if (const auto* point = std::get_if<Vec<N, T>>(&a)) {
      call("point queries", [&] { return answers<N, T>(b, *point); });
    }
  };
  for (const CaseKind kind : {CaseKind::uniform, CaseKind::grid, CaseKind::shared_points}) {
    for_each_case<N, T>(kind, 10, check, always);
  }
  EXPECT_GT(counting.calls(), std::size_t{10'000});
  for (const auto& [what, times] : counting.tally()) ADD_FAILURE() << what << ", " << times << " times";
}

TEST(AllocationIn, IsSeenWhereThereIsSome) {
  const std::size_t before = asked_of_the_heap;
  const std::string text(1000, 'x');
  EXPECT_GT(asked_of_the_heap, before);
  EXPECT_EQ(text.size(), 1000U);
}

}  // namespace
}  // namespace graze::test::allocation_test
