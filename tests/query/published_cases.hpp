// SPDX-License-Identifier: MIT
// Cases published by other projects: bugs in their trackers, and values of their test suites. The numbers are theirs;
// the answers were recalculated with fifty digits from the decimals as given here.
#pragma once

#include <span>
#include <string>

namespace graze::test {

/// One case, in text, which costs nothing to compile.
///
///   asked            a                       b                answer
///   3D relation      a shape                 a shape          apart, touching, overlapping, or meet: one of these two
///   3D distance      a shape                 a shape          the distance [the nearest point of a, and of b]
///   3D depth         a shape                 a shape          the depth [the normal]
///   3D ray           a shape                 a ray, segment   none, or where it is entered [the normal]
///   3D cast          a shape by its motion   a shape          none, or the time of impact [the normal]
///   2D impact        a shape by its motion   the same         none, or the time of impact
///   3D point         a shape                 a point          the signed distance [the closest point]
///   3D hull          a polytope's points     -                the number of corners, the volume
///   3D sphere          a polytope's points     -                the radius of the smallest sphere, its center
///   3D mass          a shape                 -                volume, centroid
///
/// Each is evaluated in float and in double, or as "3D double relation" in one of them if the answer depends on the
/// last digits. A motion in 2D is the translation, the rotation and its center. Shapes are written as in
/// query/regressions.hpp.
struct PublishedCase {
  const char* source;  ///< Its source, and the topic or the error there.
  const char* asked;
  const char* a;
  const char* b;
  const char* answer;
  double slack = 1;  ///< Multiplies the permitted error: for answers that magnify the error of the input.
};

/// Evaluates graze, in both orders for two shapes, and checks that all its answers about the case agree.
void expect_published(std::span<const PublishedCase> cases);

}  // namespace graze::test
