// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "contestant.hpp"

namespace graze::race {

/// The tree of FCL, and of Coal, which is derived from it. It is built at the start; in every frame it is refitted to
/// the objects' new boxes, and some leaves are moved to better places. A Library has the types Object, Box, a numbered
/// object with a given box, and Tree, and appends the pairs of a tree with `collide`.
template <class Library, class T>
class FclTree final : public Contestant<3, T> {
 public:
  explicit FclTree(std::span<const Aabb<3, T>> boxes) {
    objects_.reserve(boxes.size());
    std::vector<typename Library::Object*> pointers;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      objects_.push_back(std::make_unique<typename Library::Box>(i));
      objects_.back()->place(boxes[i]);
      pointers.push_back(objects_.back().get());
    }
    tree_.registerObjects(pointers);
    tree_.setup();
  }

  std::span<const Pair> find(std::span<const Aabb<3, T>> boxes) override {
    pairs_.clear();
    for (std::size_t i = 0; i < boxes.size(); ++i) objects_[i]->place(boxes[i]);
    tree_.update();
    Library::collide(tree_, pairs_);
    return pairs_;
  }

 private:
  std::vector<std::unique_ptr<typename Library::Box>> objects_;
  typename Library::Tree tree_;
  std::vector<Pair> pairs_;
};

}  // namespace graze::race
