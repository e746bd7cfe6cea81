// SPDX-License-Identifier: MIT
#pragma once

#include <graze/math/vec.hpp>

namespace mesh_bench {

/// The point of a triangle that is closest to a point, in float: what Embree's users write, as its own tutorial does.
/// Ericson, "Real-Time Collision Detection" (2005), section 5.1.5.
inline graze::Vec<3, float> closest_in_float(const graze::Vec<3, float>& point, const graze::Vec<3, float>& a,
                                             const graze::Vec<3, float>& b, const graze::Vec<3, float>& c) {
  const graze::Vec<3, float> ab = b - a;
  const graze::Vec<3, float> ac = c - a;
  const graze::Vec<3, float> ap = point - a;
  const float d1 = dot(ab, ap);
  const float d2 = dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return a;
  const graze::Vec<3, float> bp = point - b;
  const float d3 = dot(ab, bp);
  const float d4 = dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return b;
  const graze::Vec<3, float> cp = point - c;
  const float d5 = dot(ab, cp);
  const float d6 = dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return c;
  const float vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + ab * (d1 / (d1 - d3));
  const float vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + ac * (d2 / (d2 - d6));
  const float va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) return b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
  const float denominator = 1 / (va + vb + vc);
  return a + ab * (vb * denominator) + ac * (vc * denominator);
}

}  // namespace mesh_bench
