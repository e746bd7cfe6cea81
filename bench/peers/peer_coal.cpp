// SPDX-License-Identifier: MIT
// Only compiled if CMake finds Coal.
#include <cstddef>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <coal/broadphase/broadphase_dynamic_AABB_tree_array.h>
#include <coal/collision_object.h>
#include <coal/config.hh>
#include <coal/shape/geometric_shapes.h>

#include "contestant.hpp"
#include "fcl_tree.hpp"

namespace graze::race {
namespace {

/// Coal has no other type than double.
struct Coal {
  using Object = coal::CollisionObject;

  class Box final : public Object {
   public:
    explicit Box(std::size_t number) : Object(any_geometry()), number_(number) {}

    std::size_t number() const { return number_; }
    template <class T>
    void place(const Aabb<3, T>& box) {
      getAABB().min_ = {box.min[0], box.min[1], box.min[2]};
      getAABB().max_ = {box.max[0], box.max[1], box.max[2]};
    }

   private:
    static const std::shared_ptr<coal::CollisionGeometry>& any_geometry() {
      static const std::shared_ptr<coal::CollisionGeometry> geometry = std::make_shared<coal::Box>(1, 1, 1);
      return geometry;
    }

    std::size_t number_;
  };

  /// Not rebalanced from the root, as FCL's, whose code it is.
  struct Tree : coal::DynamicAABBTreeArrayCollisionManager {
    Tree() { max_tree_nonbalanced_level = std::numeric_limits<int>::max(); }
  };

  class PairList final : public coal::CollisionCallBackBase {
   public:
    explicit PairList(std::vector<Pair>& pairs) : pairs_(pairs) {}

    /// Returning false continues the search.
    bool collide(Object* one, Object* other) override {
      pairs_.push_back(ascending(static_cast<const Box*>(one)->number(), static_cast<const Box*>(other)->number()));
      return false;
    }

   private:
    std::vector<Pair>& pairs_;
  };

  static void collide(const Tree& tree, std::vector<Pair>& pairs) {
    PairList list(pairs);
    tree.collide(&list);
  }
};

}  // namespace

template <Dim N, class T>
void enter_coal(Entrants<N, T>& field) {
  if constexpr (N == 3) {
    Entrant<N, T> entrant;
    entrant.name = "Coal DynamicAABBTree_Array";
    entrant.keeps = true;
    entrant.settings = "Coal " COAL_VERSION ", in double, the tree kept and refitted, as FCL's";
    entrant.prepare = [](std::span<const Aabb<N, T>> boxes) { return std::make_unique<FclTree<Coal, T>>(boxes); };
    field.push_back(std::move(entrant));
  }
}

template void enter_coal(Entrants<2, float>& field);
template void enter_coal(Entrants<2, double>& field);
template void enter_coal(Entrants<3, float>& field);
template void enter_coal(Entrants<3, double>& field);

}  // namespace graze::race
