// SPDX-License-Identifier: MIT
// An index of your own is a SpatialIndex as soon as it has its members: here a list that looks at every box. BruteForce
// is one with all that spatial_index.hpp promises: it refuses bad boxes and keys, and lets a visitor end the visit.
#include <algorithm>
#include <cstdio>
#include <map>
#include <set>

#include <graze/graze.hpp>

class BoxList {
 public:
  using Box = graze::Aabb<3>;
  graze::Key insert(const Box& box) { return boxes_.emplace(graze::Key{next_++, 1, 0}, box).first->first; }
  void update(graze::Key key, const Box& box) { boxes_.at(key) = box; }
  void erase(graze::Key key) { boxes_.erase(key); }
  void clear() { boxes_.clear(); }
  bool contains(graze::Key key) const { return boxes_.contains(key); }
  Box box(graze::Key key) const { return boxes_.at(key); }
  std::size_t size() const { return boxes_.size(); }
  void query(const auto& region, auto&& visit) const {
    for (const auto& [key, box] : boxes_) {
      if (graze::intersects(region, box)) visit(key);
    }
  }
  void ray_cast(const graze::Ray<3>& ray, auto&& visit) const {
    std::set<std::pair<double, graze::Key>> hits;
    for (const auto& [key, box] : boxes_) {
      if (const auto hit = graze::ray_cast(box, ray)) hits.emplace(hit->t, key);
    }
    for (const auto& [t, key] : hits) visit(key, t);
  }
  std::vector<graze::Neighbour> nearest(const graze::Vec<3>& point, std::size_t k) const {
    std::vector<graze::Neighbour> all;
    for (const auto& [key, box] : boxes_) all.push_back({key, graze::distance_squared(point, box)});
    std::ranges::stable_sort(all, {}, &graze::Neighbour::distance_squared);  // equal ones stay in the order of keys
    all.resize(std::min(k, all.size()));
    return all;
  }
  void pairs(auto&& visit) const {
    for (const auto& [a, box] : boxes_) {
      for (const auto& [b, other] : boxes_) {
        if (a < b && graze::intersects(box, other)) visit(a, b);
      }
    }
  }

 private:
  std::map<graze::Key, Box> boxes_;
  std::uint32_t next_ = 0;
};

int main() {
  BoxList index;
  for (int i = 0; i < 100; ++i) index.insert(graze::Aabb<3>::from_center({static_cast<float>(i), 0, 0}, {1, 1, 1}));
  const graze::Sphere<3> ball{{40, 2, 0}, 5};
  const std::size_t found = graze::count(index, ball);  // takes every SpatialIndex
  std::printf("%zu boxes touch the ball\n", found);
  return found == 11 ? 0 : 1;
}
