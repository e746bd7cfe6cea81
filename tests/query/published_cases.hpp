// SPDX-License-Identifier: MIT
// Cases that others published: bugs in their trackers, and figures of their test suites. The numbers are theirs, the
// answers were calculated anew, with fifty digits, from the decimals as they stand here.
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
///   3D cast          a shape by its way      a shape          none, or the time of impact [the normal]
///   2D impact        a shape by its motion   the same         none, or the time of impact
///   3D point         a shape                 a point          the signed distance [the closest point]
///   3D hull          a polytope's points     -                the number of corners, the volume
///   3D sphere          a polytope's points     -                the radius of the smallest sphere, its center
///   3D mass          a shape                 -                volume, centroid
///
/// Each is asked in float and in double, or as "3D double relation" in one of them: where the answer hangs on the last
/// digits. A motion in the plane is the way, the turn and the center. Shapes are written as in query/regressions.hpp.
struct PublishedCase {
  const char* source;  ///< Where it is from, and what it is about or went wrong there.
  const char* asked;
  const char* a;
  const char* b;
  const char* answer;
  double slack = 1;  ///< How many times the usual error is allowed: for answers that magnify that of the input.
};

/// Asks graze, in both orders where there are two shapes, and whether all that it says of the case agrees.
void expect_published(std::span<const PublishedCase> cases);

}  // namespace graze::test
