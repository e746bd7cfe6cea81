// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/BroadphaseCollision/btOverlappingPairCache.h>

#include "../bench/scene/frames.hpp"

namespace bench {

/// Bullet keeps the pairs of boxes enlarged by a margin. A flag in each kept pair tells whether the boxes themselves
/// touch, so begin and end events need no search. 2D boxes are flat.
template <Dim N>
class OfBullet {
 public:
  static constexpr const char* name = "Bullet btDbvtBroadphase";

  explicit OfBullet(const Frames<N>& frames)
      : frames_(frames), boxes_(frames.start()), kept_(outcome_), broadphase_(&kept_) {
    gDbvtMargin = 0.2F;
    for (const Box<N>& box : boxes_) {
      proxies_.push_back(broadphase_.createProxy(corner(box.min), corner(box.max), 0, nullptr, 1, 1, nullptr));
    }
    find();
  }

  void step(std::size_t frame) {
    outcome_.clear();
    frames_.each_move(frame, [this](std::size_t k, const Box<N>& box) {
      boxes_[k] = box;
      broadphase_.setAabb(proxies_[k], corner(box.min), corner(box.max), nullptr);
    });
    find();
  }

  const Outcome& outcome() const { return outcome_; }

 private:
  static btVector3 corner(const graze::Vec<N, float>& v) {
    if constexpr (N == 3) {
      return {v.x, v.y, v.z};
    } else {
      return {v.x, v.y, 0};
    }
  }
  static std::size_t index_of(const btBroadphaseProxy* proxy) {
    return static_cast<std::size_t>(proxy->m_uniqueId - 1);
  }
  static Pair indices_of(const btBroadphasePair& pair) {
    return ascending(index_of(pair.m_pProxy0), index_of(pair.m_pProxy1));
  }

  /// Reports pairs that Bullet no longer keeps.
  class KeptPairs final : public btHashedOverlappingPairCache {
   public:
    explicit KeptPairs(Outcome& outcome) : outcome_(outcome) {}

    void cleanOverlappingPair(btBroadphasePair& pair, btDispatcher* /*dispatcher*/) override {
      if (pair.m_internalTmpValue == touching) outcome_.ended.push_back(indices_of(pair));
    }

   private:
    Outcome& outcome_;
  };

  void find() {
    broadphase_.calculateOverlappingPairs(nullptr);
    btBroadphasePairArray& kept = kept_.getOverlappingPairArray();
    for (int i = 0; i < kept.size(); ++i) {
      const Pair pair = indices_of(kept[i]);
      const int now = boxes_overlap(boxes_[pair.a], boxes_[pair.b]) ? touching : 0;
      if (now == touching) outcome_.touching.push_back(pair);
      if (now == kept[i].m_internalTmpValue) continue;
      (now == touching ? outcome_.began : outcome_.ended).push_back(pair);
      kept[i].m_internalTmpValue = now;
    }
  }

  static constexpr int touching = 1;

  const Frames<N>& frames_;
  std::vector<Box<N>> boxes_;
  Outcome outcome_;
  KeptPairs kept_;
  btDbvtBroadphase broadphase_;
  std::vector<btBroadphaseProxy*> proxies_;
};

}  // namespace bench
