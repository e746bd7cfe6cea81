// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <graze/broad/executor.hpp>
#include <graze/scene/scene.hpp>

#include "scene/frames.hpp"

namespace bench {

template <Dim N>
class OfGraze {
 public:
  static constexpr const char* name = "graze Scene";

  explicit OfGraze(const Frames<N>& frames) : frames_(frames) {
    for (const Box<N>& box : frames.start()) moves_.push_back({scene_.add(box), box});
    scene_.update(graze::serial_executor());
  }

  void step(std::size_t frame) {
    chosen_.clear();
    frames_.each_move(frame, [this](std::size_t k, const Box<N>& box) { chosen_.push_back({moves_[k].id, box}); });
    scene_.move(chosen_);
    scene_.update(graze::serial_executor());
  }

  Outcome outcome() const {
    return {plain(scene_.pairs()), plain(scene_.events().began), plain(scene_.events().ended)};
  }

 private:
  static std::vector<Pair> plain(const std::vector<graze::ObjectPair>& pairs) {
    std::vector<Pair> result;
    for (const graze::ObjectPair& pair : pairs) result.push_back({pair.a.index, pair.b.index});
    return result;
  }

  const Frames<N>& frames_;
  graze::Scene<N> scene_;
  std::vector<graze::ObjectMove<N>> moves_;
  std::vector<graze::ObjectMove<N>> chosen_;
};

}  // namespace bench
