// SPDX-License-Identifier: MIT
// An arm that swings from one pose to another past a sliding crate: whether they meet, when and where. Start and end
// poses are free of contact, and so is the path of an arm that does not rotate.
#include <cstdio>

#include <graze/math/motion.hpp>
#include <graze/query/intersects.hpp>
#include <graze/query/shape_cast.hpp>
#include <graze/query/time_of_impact.hpp>
#include <graze/query/transformed.hpp>

#include "picture.hpp"

template <class S>
S moved(const S& shape, const graze::Motion<2>& motion, float t) {
  const graze::Pose<2, double> pose = pose_at(motion, static_cast<double>(t));
  return transformed(shape, graze::Pose<2>{graze::Mat<2>(pose.rotation), graze::Vec<2>(pose.position)});
}

int main(int argc, char** argv) {
  const graze::Pose<2> start{graze::Mat<2>(graze::rotation_matrix(-70.0)), {0, 0}};
  const graze::Pose<2> end{graze::Mat<2>(graze::rotation_matrix(70.0)), {0, 0}};
  const auto arm = transformed(graze::Capsule<2>{{0, 0}, {5, 0}, 0.4F}, start);  // about its joint
  const graze::Obb<2> crate{{7, -2.5F}, {0.8F, 0.5F}, graze::Mat<2>(graze::rotation_matrix(20.0))};
  const graze::Motion<2> swing = motion_between(start, end);
  const graze::Motion<2> slide{{-2.5F, 3}};

  std::printf("at the start: %s\n", intersects(arm, crate) ? "touching" : "apart");
  std::printf("at the end: %s\n", intersects(moved(arm, swing, 1), moved(crate, slide, 1)) ? "touching" : "apart");
  std::printf("without turning: %s\n", shape_cast(arm, swing.linear - slide.linear, crate) ? "an impact" : "none");

  cookbook::Picture<2> picture("an arm swings past a crate");
  picture.draw(arm, "start");
  picture.draw(moved(arm, swing, 1), "end");
  picture.draw(crate, "crate");
  if (const auto impact = time_of_impact(arm, swing, crate, slide)) {
    std::printf("t = %.4f at (%.3f, %.3f), normal (%.3f, %.3f)\n", static_cast<double>(impact->t),
                static_cast<double>(impact->point.x), static_cast<double>(impact->point.y),
                static_cast<double>(impact->normal.x), static_cast<double>(impact->normal.y));
    std::printf("never farther apart there than %.0e\n", impact->error);
    const graze::Obb<2> struck = moved(crate, slide, impact->t);
    picture.draw(moved(arm, swing, impact->t), "impact");
    picture.draw(struck);
    picture.connect(crate.center, struck.center);
    picture.connect(impact->point, impact->point + impact->normal);
  }
  return picture.save(argc, argv);
}
