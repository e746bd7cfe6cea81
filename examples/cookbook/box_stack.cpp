// SPDX-License-Identifier: MIT
// A stack of boxes at rest, frame by frame: where they touch, and how contacts correspond to those of the previous
// frame.
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include <graze/math/pose.hpp>
#include <graze/query/manifold.hpp>

#include "picture.hpp"

using Box = graze::OrientedRect<>;

/// A contact of two neighbours, and the number of frames it has lasted: a solver stores its impulse here.
struct Known {
  std::size_t upper;
  graze::ContactId id;
  int frames = 1;
};

/// The stack in a frame: the boxes move slightly, as after a solver step, and the top box slides to the right.
std::vector<Box> stack_in(int frame) {
  const auto wobble = static_cast<float>(frame % 2) * 0.02F;
  std::vector<Box> boxes{{{0, -0.5F}, {4, 0.5F}}};
  boxes.push_back({{wobble, 0.99F}, {1, 1}, graze::Mat<2>(graze::rotation_matrix(10 * wobble))});
  boxes.push_back({{0.5F * static_cast<float>(frame), 2.98F}, {1, 1}});
  return boxes;
}

int main(int argc, char** argv) {
  cookbook::Picture<2> picture("a stack of boxes, and where they touch");
  std::vector<Known> known;
  for (int frame = 0; frame < 6; ++frame) {
    const std::vector<Box> boxes = stack_in(frame);
    std::vector<Known> found;
    std::printf("frame %d:", frame);
    for (std::size_t upper = 1; upper < boxes.size(); ++upper) {
      const graze::Manifold<2> touching = graze::manifold(boxes[upper - 1], boxes[upper]);
      for (const auto& contact : touching.contacts()) {
        const auto is_same = [&](const Known& old) { return old.upper == upper && old.id == contact.id; };
        const auto before = std::find_if(known.begin(), known.end(), is_same);
        found.push_back({upper, contact.id, before == known.end() ? 1 : before->frames + 1});
        std::printf(" (%.2f, %.2f) for %d,", contact.point.x, contact.point.y, found.back().frames);
        if (frame == 3) picture.connect(contact.point, contact.point + touching.normal);
      }
    }
    std::printf(" %zu contacts\n", found.size());
    known = found;
    for (std::size_t i = 0; frame == 3 && i < boxes.size(); ++i) picture.draw(boxes[i], "box " + std::to_string(i));
  }
  return picture.save(argc, argv);
}
