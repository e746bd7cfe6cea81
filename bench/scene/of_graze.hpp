// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include <graze/broad/executor.hpp>
#include <graze/scene/scene.hpp>

#include "../bench/scene/frames.hpp"

namespace bench {

template <Dim N>
class OfGraze {
 public:
  static constexpr const char* name = "graze Scene";

  explicit OfGraze(const Frames<N>& frames) : frames_(frames) {
    for (const Box<N>& box : frames.start()) ids_.push_back(scene_.add(box));
    scene_.update(graze::serial_executor());
  }

  void step(std::size_t frame) {
    if (frames_.all_move()) {
      scene_.move(ids_, frames_.places(frame));
    } else {
      move_some(frame);
    }
    scene_.update(graze::serial_executor());
  }

  Outcome outcome() const {
    return {plain(scene_.pairs()), plain(scene_.events().began), plain(scene_.events().ended)};
  }

 private:
  void move_some(std::size_t frame) {
    moved_.clear();
    places_.clear();
    frames_.each_move(frame, [this](std::size_t k, const Box<N>& box) {
      moved_.push_back(ids_[k]);
      places_.push_back(box);
    });
    scene_.move(moved_, places_);
  }

  static std::vector<Pair> plain(const std::vector<graze::ObjectPair>& pairs) {
    std::vector<Pair> result;
    for (const graze::ObjectPair& pair : pairs) result.push_back({pair.a.index, pair.b.index});
    return result;
  }

  const Frames<N>& frames_;

 protected:
  graze::Scene<N> scene_;

 private:
  std::vector<graze::ObjectId> ids_;
  std::vector<graze::ObjectId> moved_;
  std::vector<Box<N>> places_;
};

/// The same while a reader holds the snapshot of the previous frame.
template <Dim N>
class OfGrazeRead : public OfGraze<N> {
 public:
  static constexpr const char* name = "graze Scene, a snapshot each frame";

  using OfGraze<N>::OfGraze;

  void step(std::size_t frame) {
    OfGraze<N>::step(frame);
    snapshot_ = this->scene_.snapshot();
  }

 private:
  std::shared_ptr<const graze::SceneView<N>> snapshot_;
};

}  // namespace bench
