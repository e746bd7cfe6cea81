// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

#include <graze/shape/aabb.hpp>

namespace bench {

/// The quadtree of most textbooks: nodes and objects behind pointers, an object in every leaf that it touches, results
/// in vectors, and merging by counting the objects below. Only its usual errors are fixed: a split moves each object to
/// all children that it touches, removal uses the box at insertion, a query reports each object once, by a flag, and
/// objects that touch no leaf are in a list beside the root.
class TextbookQuadTree {
 public:
  using Box = graze::Aabb<2, float>;

  struct Object {
    Box box;
    std::size_t id;
    bool flag = false;
  };

  TextbookQuadTree(const Box& world, std::size_t capacity, int max_depth)
      : root_(std::make_unique<Node>(world, 0)), capacity_(capacity), max_depth_(max_depth) {}

  void insert(Object* object) {
    if (!root_->insert(object, *this)) outside_.push_back(object);
  }

  void update(Object* object, const Box& box) {
    root_->remove(object, *this);
    outside_.erase(std::remove(outside_.begin(), outside_.end(), object), outside_.end());
    object->box = box;
    insert(object);
  }

  std::vector<Object*> query(const Box& area) const {
    std::vector<Object*> found = root_->query(area);
    for (Object* object : outside_) {
      if (boxes_overlap(object->box, area)) found.push_back(object);
    }
    for (Object* object : found) object->flag = false;
    return found;
  }

 private:
  struct Node {
    Node(const Box& node_box, int node_depth) : box(node_box), depth(node_depth) {}

    bool insert(Object* object, const TextbookQuadTree& tree) {
      if (!boxes_overlap(box, object->box)) return false;
      if (children.empty() && objects.size() >= tree.capacity_ && depth < tree.max_depth_) split(tree);
      if (children.empty()) {
        objects.push_back(object);
      } else {
        for (const auto& child : children) child->insert(object, tree);
      }
      return true;
    }

    void remove(Object* object, const TextbookQuadTree& tree) {
      if (!boxes_overlap(box, object->box)) return;
      if (children.empty()) {
        objects.erase(std::remove(objects.begin(), objects.end(), object), objects.end());
        return;
      }
      for (const auto& child : children) child->remove(object, tree);
      shake(tree);
    }

    std::vector<Object*> query(const Box& area) const {
      std::vector<Object*> found;
      if (!boxes_overlap(box, area)) return found;
      for (Object* object : objects) {
        if (object->flag || !boxes_overlap(object->box, area)) continue;
        object->flag = true;
        found.push_back(object);
      }
      for (const auto& child : children) {
        const std::vector<Object*> below = child->query(area);
        found.insert(found.end(), below.begin(), below.end());
      }
      return found;
    }

    void split(const TextbookQuadTree& tree) {
      const auto center = box.center();
      const Box quarters[] = {{box.min, center},
                              {{center.x, box.min.y}, {box.max.x, center.y}},
                              {{box.min.x, center.y}, {center.x, box.max.y}},
                              {center, box.max}};
      for (const Box& quarter : quarters) children.push_back(std::make_unique<Node>(quarter, depth + 1));
      for (Object* object : objects) {
        for (const auto& child : children) child->insert(object, tree);
      }
      objects.clear();
    }

    void shake(const TextbookQuadTree& tree) {
      for (const auto& child : children) {
        if (!child->children.empty()) return;
      }
      std::vector<Object*> below;
      for (const auto& child : children) {
        for (Object* object : child->objects) {
          if (object->flag) continue;
          object->flag = true;
          below.push_back(object);
        }
        if (below.size() >= tree.capacity_) break;
      }
      for (Object* object : below) object->flag = false;
      if (below.size() >= tree.capacity_) return;
      children.clear();
      objects = std::move(below);
    }

    Box box;
    int depth;
    std::vector<std::unique_ptr<Node>> children;
    std::vector<Object*> objects;
  };

  std::unique_ptr<Node> root_;
  std::vector<Object*> outside_;
  std::size_t capacity_;
  int max_depth_;
};

}  // namespace bench
