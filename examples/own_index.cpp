// SPDX-License-Identifier: MIT
// An index of your own is a SpatialIndex as soon as it has its members, and what is written for indexes takes it: here
// one that counts what it is asked, around an Octree.
#include <cstdio>

#include <graze/graze.hpp>

/// Nothing of Octree is virtual, and nothing needs to be: the concept looks at names and types alone.
class CountingOctree : public graze::Octree<> {
 public:
  template <class Region, class Visit>
  void query(const Region& region, Visit&& visit) const {
    ++questions_;
    graze::Octree<>::query(region, visit);
  }

  int questions() const { return questions_; }

 private:
  mutable int questions_ = 0;
};

static_assert(graze::SpatialIndex<CountingOctree>);

/// Works with every index.
template <graze::SpatialIndex Index>
std::size_t crowd_around(const Index& index, const graze::Sphere<3>& place) {
  return graze::count(index, place);
}

int main() {
  CountingOctree index;
  graze::Bvh<3> judge;
  for (int i = 0; i < 1000; ++i) {
    const int row = i / 10 % 10;
    const int floor = i / 100;
    const graze::Vec<3> corner(static_cast<float>(i % 10), static_cast<float>(row), static_cast<float>(floor));
    index.insert({corner, corner + 0.5F});
    judge.insert({corner, corner + 0.5F});
  }
  const graze::Sphere<3> place{{4.5F, 4.5F, 4.5F}, 2};
  const std::size_t found = crowd_around(index, place);
  std::printf("%zu boxes, found by %d question\n", found, index.questions());
  return found == crowd_around(judge, place) && index.questions() == 1 ? 0 : 1;
}
