// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <unordered_set>
#include <vector>

#include <box2d/b2_broad_phase.h>

#include "../bench/scene/frames.hpp"

namespace bench {

/// Box2D enlarges boxes by b2_aabbExtension and reports pairs when one of the boxes leaves its enlarged box; the user
/// keeps them until they separate, as Box2D's contact manager does.
class OfBox2d {
 public:
  static constexpr const char* name = "Box2D b2BroadPhase";

  explicit OfBox2d(const Frames<2>& frames) : frames_(frames), boxes_(frames.start()) {
    for (std::size_t k = 0; k < boxes_.size(); ++k) {
      proxies_.push_back(broadphase_.CreateProxy(bounds_of(boxes_[k]), reinterpret_cast<void*>(k)));
    }
    find();
  }

  void step(std::size_t frame) {
    outcome_.clear();
    frames_.each_move(frame, [this](std::size_t k, const Box<2>& box) {
      boxes_[k] = box;
      broadphase_.MoveProxy(proxies_[k], bounds_of(box), b2Vec2(0, 0));
    });
    find();
  }

  const Outcome& outcome() const { return outcome_; }

  /// The name that Box2D requires.
  void AddPair(void* one, void* other) {  // NOLINT(readability-identifier-naming)
    const Pair pair = ascending(reinterpret_cast<std::size_t>(one), reinterpret_cast<std::size_t>(other));
    if (known_.insert(key_of(pair)).second) kept_.push_back({pair, false});
  }

 private:
  struct KeptPair {
    Pair pair;
    bool is_touching;
  };

  static b2AABB bounds_of(const Box<2>& box) {
    b2AABB result;
    result.lowerBound.Set(box.min.x, box.min.y);
    result.upperBound.Set(box.max.x, box.max.y);
    return result;
  }
  static std::uint64_t key_of(const Pair& pair) { return std::uint64_t{pair.a} << 32U | pair.b; }

  void find() {
    broadphase_.UpdatePairs(this);
    std::size_t left = 0;
    for (const KeptPair& kept : kept_) {
      const Pair& pair = kept.pair;
      const bool is_touching = boxes_overlap(boxes_[pair.a], boxes_[pair.b]);
      if (is_touching) outcome_.touching.push_back(pair);
      if (is_touching != kept.is_touching) (is_touching ? outcome_.began : outcome_.ended).push_back(pair);
      if (is_touching || broadphase_.TestOverlap(proxies_[pair.a], proxies_[pair.b])) {
        kept_[left++] = {pair, is_touching};
      } else {
        known_.erase(key_of(pair));
      }
    }
    kept_.resize(left);
  }

  const Frames<2>& frames_;
  std::vector<Box<2>> boxes_;
  b2BroadPhase broadphase_;
  std::vector<std::int32_t> proxies_;
  std::vector<KeptPair> kept_;
  std::unordered_set<std::uint64_t> known_;
  Outcome outcome_;
};

}  // namespace bench
