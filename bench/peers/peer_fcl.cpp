// SPDX-License-Identifier: MIT
// Tried: the manager with pointers instead of arrays (1.4 times as slow), reporting each moved object (three times),
// and rebuilding the tree from the top (twice) or by Morton codes (twice).
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fcl/config.h>
#include <fcl/narrowphase/collision_object.h>

#include "../bench/fcl_box.hpp"
#include "contestant.hpp"
#include "fcl_tree.hpp"

namespace graze::race {
namespace {

template <class T>
struct Fcl {
  using Object = fcl::CollisionObject<T>;
  using Box = bench::FclBox<T>;
  using Tree = bench::FclTree<T>;

  static void collide(const Tree& tree, std::vector<Pair>& pairs) { tree.collide(&pairs, take); }

 private:
  /// Returning false continues the search.
  static bool take(Object* one, Object* other, void* pairs) {
    static_cast<std::vector<Pair>*>(pairs)->push_back(ascending(Box::number_of(one), Box::number_of(other)));
    return false;
  }
};

}  // namespace

template <Dim N, class T>
void enter_fcl(Entrants<N, T>& field) {
  if constexpr (N == 3) {
    Entrant<N, T> entrant;
    entrant.name = "FCL DynamicAABBTree_Array";
    entrant.keeps = true;
    entrant.settings =
        "FCL " FCL_VERSION
        ", the tree kept and refitted; not rebalanced from the root, because its answers are wrong afterwards";
    entrant.prepare = [](std::span<const Aabb<N, T>> boxes) { return std::make_unique<FclTree<Fcl<T>, T>>(boxes); };
    field.push_back(std::move(entrant));
  }
}

template void enter_fcl(Entrants<2, float>& field);
template void enter_fcl(Entrants<2, double>& field);
template void enter_fcl(Entrants<3, float>& field);
template void enter_fcl(Entrants<3, double>& field);

}  // namespace graze::race
