// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <variant>
#include <vector>

#include <ccd/ccd.h>
#include <ccd/vec3.h>

#include <graze/math/vec.hpp>

#include "exam/rival.hpp"

namespace graze::exam {
namespace {

using Vec3 = Vec<3, double>;

/// A hull of points, inflated by a radius: the object passed to libccd's callbacks.
struct Body {
  std::vector<Vec3> corners;
  double radius = 0;
  mutable std::size_t asked = 0;  ///< The number of support calls.
};

/// Aborts ccdGJKPenetration, whose EPA has no iteration limit.
struct GivesUp {};
constexpr std::size_t most_asked = 20'000;

Body box_body(const Vec3& center, const Mat<3, double>& half_edges) {
  Body body;
  for (unsigned corner = 0; corner < 8; ++corner) {
    Vec3 place = center;
    for (Dim i = 0; i < 3; ++i)
      place += (corner >> static_cast<unsigned>(i) & 1U) != 0 ? half_edges[i] : -half_edges[i];
    body.corners.push_back(place);
  }
  return body;
}

struct BodyOf {
  using Found = std::optional<Body>;

  Found operator()(const Vec3& point) const { return Body{{point}}; }
  Found operator()(const Segment<3, double>& s) const { return Body{{s.start, s.end}}; }
  Found operator()(const Sphere<3, double>& sphere) const { return Body{{sphere.center}, sphere.radius}; }
  Found operator()(const Capsule<3, double>& capsule) const { return Body{{capsule.a, capsule.b}, capsule.radius}; }
  Found operator()(const Triangle<3, double>& t) const { return Body{{t.a, t.b, t.c}}; }
  Found operator()(const Polytope<3, double>& p) const { return Body{{p.vertices().begin(), p.vertices().end()}}; }
  Found operator()(const Obb<3, double>& box) const { return box_body(box.center, half_edges(box)); }
  Found operator()(const Aabb<3, double>& box) const {
    Mat<3, double> half(0.0);
    for (Dim i = 0; i < 3; ++i) half[i][i] = 0.5 * (box.max[i] - box.min[i]);
    return box_body(0.5 * (box.min + box.max), half);
  }
  template <class S>
  Found operator()(const S&) const {
    return std::nullopt;
  }
};

void support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* found) {
  const auto& body = *static_cast<const Body*>(object);
  if (++body.asked > most_asked) throw GivesUp();
  const Vec3 way(direction->v[0], direction->v[1], direction->v[2]);
  Vec3 best = body.corners.front();
  for (const Vec3& corner : body.corners) {
    if (dot(corner, way) > dot(best, way)) best = corner;
  }
  const double length = std::sqrt(dot(way, way));
  if (length > 0) best += way * (body.radius / length);
  ccdVec3Set(found, best.x, best.y, best.z);
}

ccd_t settings_of_both() {
  ccd_t settings;
  CCD_INIT(&settings);
  settings.support1 = support;
  settings.support2 = support;
  settings.max_iterations = 1000;  // the default is unlimited
  return settings;
}

}  // namespace

std::optional<bool> libccd_answer(const Solid3<double>& a, const Solid3<double>& b) {
  const std::optional<Body> body_a = std::visit(BodyOf(), a);
  const std::optional<Body> body_b = std::visit(BodyOf(), b);
  if (!body_a || !body_b) return std::nullopt;
  const ccd_t settings = settings_of_both();
  return ccdGJKIntersect(&*body_a, &*body_b, &settings) != 0;
}

std::optional<Proximity> libccd_parting(const Solid3<double>& a, const Solid3<double>& b) {
  const std::optional<Body> body_a = std::visit(BodyOf(), a);
  const std::optional<Body> body_b = std::visit(BodyOf(), b);
  if (!body_a || !body_b) return std::nullopt;
  const ccd_t settings = settings_of_both();
  ccd_real_t depth = 0;
  ccd_vec3_t way;
  ccd_vec3_t place;
  try {
    if (ccdGJKPenetration(&*body_a, &*body_b, &settings, &depth, &way, &place) != 0) return Proximity{};
  } catch (const GivesUp&) {
    return Proximity{};
  }
  return Proximity{true, depth, Vec3(way.v[0], way.v[1], way.v[2])};
}

}  // namespace graze::exam
