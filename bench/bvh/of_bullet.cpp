// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>
#include <memory>

#include <BulletCollision/BroadphaseCollision/btDbvt.h>

#include <graze/broad/spatial_index.hpp>

#include "contestant.hpp"

namespace bench {
namespace {

btVector3 vector(const Point<3>& p) { return {p.x, p.y, p.z}; }

btDbvtVolume volume(const Box<3>& box) { return btDbvtVolume::FromMM(vector(box.min), vector(box.max)); }

/// The tree of Bullet's broad phase. Moving boxes have the margin that Bullet's authors use for larger worlds; it is
/// slower without. Boxes in the tree may be enlarged, so hits are tested.
class DynamicTree {
 public:
  void build(std::span<const Box<3>> boxes) {
    boxes_.assign(boxes.begin(), boxes.end());
    tree_ = std::make_unique<btDbvt>();
    leaves_.clear();
    for (Box<3>& box : boxes_) leaves_.push_back(tree_->insert(volume(box), &box));
  }
  void move(std::span<const Box<3>> boxes, const Share& share) {
    for (std::size_t k = share.first; k < boxes.size(); k += share.step) {
      boxes_[k] = boxes[k];
      btDbvtVolume fresh = volume(boxes[k]);
      tree_->update(leaves_[k], fresh, 0.2F);
    }
  }
  template <class Visit>
  void query(const Box<3>& region, const Visit& visit) {
    struct Policy : btDbvt::ICollide {
      void Process(const btDbvtNode* leaf) {  // NOLINT(readability-identifier-naming): Bullet's name for it
        const auto* box = static_cast<const Box<3>*>(leaf->data);
        if (boxes_overlap(*region, *box)) (*visit)(static_cast<std::size_t>(box - first));
      }
      const Box<3>* first = nullptr;
      const Box<3>* region = nullptr;
      const Visit* visit = nullptr;
    } policy;
    policy.first = boxes_.data();
    policy.region = &region;
    policy.visit = &visit;
    tree_->collideTVNoStackAlloc(tree_->m_root, volume(region), stack_, policy);
  }
  /// Bullet's own ray traversal does not stop at the first box. The traversal with a callback before each descent can
  /// be made to, and is much faster.
  double first_hit(const Ray<3>& ray) const {
    struct Policy : btDbvt::ICollide {
      bool Descent(const btDbvtNode* node) {  // NOLINT(readability-identifier-naming)
        return btRayAabb2(origin, inverse, signs, corners(node), t_min, 0, last);
      }
      void Process(const btDbvtNode* leaf) {  // NOLINT(readability-identifier-naming)
        const auto t = graze::detail::entry_of(*ray, *static_cast<const Box<3>*>(leaf->data));
        if (!t || !(*t < first)) return;
        first = *t;
        last = static_cast<float>(first + 1e-3);  // margin for Bullet's rounding
      }
      const btVector3* corners(const btDbvtNode* node) {
        both[0] = node->volume.Mins();
        both[1] = node->volume.Maxs();
        return both;
      }
      const Ray<3>* ray = nullptr;
      btVector3 origin;
      btVector3 inverse;
      btVector3 both[2];
      unsigned signs[3] = {};
      float t_min = 0;
      float last = 1e4F;
      double first = std::numeric_limits<double>::infinity();
    } policy;
    policy.ray = &ray;
    policy.origin = vector(ray.origin);
    for (int i = 0; i < 3; ++i) {
      policy.inverse[i] = ray.direction[i] == 0 ? BT_LARGE_FLOAT : 1 / ray.direction[i];
      policy.signs[i] = static_cast<unsigned>(policy.inverse[i] < 0);
    }
    btDbvt::collideTU(tree_->m_root, policy);
    return policy.first;
  }

 private:
  std::vector<Box<3>> boxes_;
  std::unique_ptr<btDbvt> tree_;
  std::vector<btDbvtNode*> leaves_;
  btNodeStack stack_;
};

}  // namespace

template <Dim N>
void enter_bullet(Entrants<N>& field) {
  if constexpr (N == 3) field.push_back(entrant<3, DynamicTree>("Bullet btDbvt"));
}

template void enter_bullet(Entrants<2>&);
template void enter_bullet(Entrants<3>&);

}  // namespace bench
