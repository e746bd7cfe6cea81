// SPDX-License-Identifier: MIT
// A user-defined index in ten lines: implement which boxes may meet a region, and CustomIndex turns it into a
// SpatialIndex with keys, exact answers and error checks. This one supports queries for what lies ahead: it stores
// boxes by their right sides.
#include <cstdint>
#include <cstdio>
#include <set>
#include <utility>

#include <graze/graze.hpp>

struct Ahead {
  using Box = graze::Aabb<2>;
  void add(std::uint32_t number, const Box& box) { by_right_side.insert({box.max.x, number}); }
  void remove(std::uint32_t number, const Box& box) { by_right_side.erase({box.max.x, number}); }
  void candidates(const Box& region, auto&& visit) const {
    auto at = by_right_side.lower_bound({region.min.x, 0});
    while (at != by_right_side.end() && visit(at->second)) ++at;
  }
  std::set<std::pair<float, std::uint32_t>> by_right_side;
};

int main() {
  graze::CustomIndex<Ahead> index;
  for (int i = 0; i < 100; ++i) index.insert(graze::Aabb<2>::from_center({static_cast<float>(i), 0}, {1, 1}));
  const graze::Sphere<2> ball{{40, 2}, 5};
  const std::size_t touched = graze::count(index, ball);  // accepts every SpatialIndex
  std::printf("%zu boxes touch the ball\n", touched);
  index.ray_cast(graze::Ray<2>{{90.25F, 0.5F}, {1, 0}}, [](graze::Key key, double t) {
    std::printf("the ray enters box %u at t = %g\n", key.index, t);
    return t < 2;
  });
  index.cast(graze::Aabb<2>{{-9, 0}, {-8, 1}}, {7.75F, 0},
             [](graze::Key key, double t) { std::printf("the moving box touches box %u at t = %g\n", key.index, t); });
  const graze::Key last = index.nearest({120, 0}, 1).front().key;
  index.update(last, graze::Aabb<2>::from_center({200, 0}, {1, 1}));
  std::size_t ahead = 0;
  index.query(graze::Aabb<2>{{90, -1}, {300, 1}}, [&ahead](graze::Key) { ++ahead; });
  std::size_t pairs = 0;
  index.pairs([&pairs](graze::Key, graze::Key) { ++pairs; });
  std::printf("box %u goes to x = %g: %zu boxes ahead, %zu pairs\n", last.index,
              static_cast<double>(index.box(last).center().x), ahead, pairs);
  std::printf("the set holds %zu right sides\n", index.finder().by_right_side.size());
  index.clear();
  return touched == 11 && ahead == 11 && !index.contains(last) && index.finder().by_right_side.empty() ? 0 : 1;
}
