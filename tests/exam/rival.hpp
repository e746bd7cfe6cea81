// SPDX-License-Identifier: MIT
// Other programs: their answers to a question, and which programs support it. Each program is one file,
// rival_<name>.cpp. A function returns none if its program has no test for these types.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <type_traits>
#include <vector>

#include <graze/math/vec.hpp>
#include <graze/shape/any_shape.hpp>

#include "query/times_of_impact.hpp"

namespace graze::exam {

template <class T>
using Solid3 = AnyShape<3, T>;

/// A gap or depth that each must get right, relative to the largest coordinate of the shapes and of their differences:
/// 8 epsilon in float, 4500 in double.
template <class T>
inline constexpr double fair_gap = std::is_same_v<T, float> ? 1e-6 : 1e-12;

/// A program and its function for one kind of question.
template <class Function>
struct Rival {
  std::string_view name;
  Function* answer;
};

/// A query on two shapes.
template <class Answer, class T>
using OfPair = std::optional<Answer>(const Solid3<T>& a, const Solid3<T>& b);

// ---- Whether a and b share a point

/// Bullet's narrow phase for convex pairs: btGjkPairDetector with EPA, in float. Boxes, triangles and hulls without
/// margin, so that they have their exact size; for spheres and capsules the margin is the radius.
std::optional<bool> bullet_answer(const Solid3<float>& a, const Solid3<float>& b);

/// FCL's fcl::collide with its own GJK; for triangles the tests that it uses for meshes.
std::optional<bool> fcl_answer(const Solid3<float>& a, const Solid3<float>& b);
std::optional<bool> fcl_answer(const Solid3<double>& a, const Solid3<double>& b);

/// libccd's ccdGJKIntersect, which Debian builds for double.
std::optional<bool> libccd_answer(const Solid3<double>& a, const Solid3<double>& b);

/// ODE's dCollide, which Debian builds for double: spheres, boxes, capsules, and half-spaces, which it calls planes.
std::optional<bool> ode_answer(const Solid3<double>& a, const Solid3<double>& b);

/// The formulas of textbook.hpp.
std::optional<bool> textbook_answer(const Solid3<float>& a, const Solid3<float>& b);
std::optional<bool> textbook_answer(const Solid3<double>& a, const Solid3<double>& b);

template <class T>
inline constexpr std::nullptr_t verdict_rivals = nullptr;
template <>
inline constexpr Rival<OfPair<bool, float>> verdict_rivals<float>[] = {
    {"textbook", textbook_answer}, {"Bullet", bullet_answer}, {"FCL", fcl_answer}};
template <>
inline constexpr Rival<OfPair<bool, double>> verdict_rivals<double>[] = {
    {"textbook", textbook_answer}, {"FCL", fcl_answer}, {"libccd", libccd_answer}, {"ODE", ode_answer}};

// ---- Depth

/// A program's contact of two shapes.
struct Proximity {
  bool meets = false;
  double depth = 0;
  Vec<3, double> normal = Vec<3, double>(0.0);  ///< From a to b, unit length; only if they overlap.
  bool is_either_way = false;                   ///< The sign of the normal is unspecified: the better one counts.
};

/// btGjkPairDetector, as for verdicts.
std::optional<Proximity> bullet_parting(const Solid3<float>& a, const Solid3<float>& b);

/// fcl::collide with contacts; for triangles the test for shapes, but not the one for two of them, whose depth refers
/// to their planes alone. Where its own GJK answers, depths and normals come with either sign, so signs are ignored.
std::optional<Proximity> fcl_parting(const Solid3<float>& a, const Solid3<float>& b);
std::optional<Proximity> fcl_parting(const Solid3<double>& a, const Solid3<double>& b);

/// libccd's ccdGJKPenetration.
std::optional<Proximity> libccd_parting(const Solid3<double>& a, const Solid3<double>& b);

/// The deepest of the contacts from ODE's dCollide.
std::optional<Proximity> ode_parting(const Solid3<double>& a, const Solid3<double>& b);

/// The formulas of textbook_depth.hpp.
std::optional<Proximity> textbook_parting(const Solid3<float>& a, const Solid3<float>& b);
std::optional<Proximity> textbook_parting(const Solid3<double>& a, const Solid3<double>& b);

template <class T>
inline constexpr std::nullptr_t contact_rivals = nullptr;
template <>
inline constexpr Rival<OfPair<Proximity, float>> contact_rivals<float>[] = {
    {"textbook", textbook_parting}, {"Bullet", bullet_parting}, {"FCL", fcl_parting}};
template <>
inline constexpr Rival<OfPair<Proximity, double>> contact_rivals<double>[] = {
    {"textbook", textbook_parting}, {"FCL", fcl_parting}, {"libccd", libccd_parting}, {"ODE", ode_parting}};

// ---- Manifolds. libccd returns one point for all shapes.

/// One point of a contact.
struct PatchPoint {
  Vec<3, double> place = Vec<3, double>(0.0);  ///< On one of the shapes, or between them.
  double depth = 0;
};

/// All points of a contact; none if the shapes are apart.
using ContactPatch = std::vector<PatchPoint>;

/// Bullet's btBoxBoxDetector for two boxes; for others the single point of btGjkPairDetector. Bullet accumulates more
/// of them from step to step.
std::optional<ContactPatch> bullet_patch(const Solid3<float>& a, const Solid3<float>& b);

/// All contacts of fcl::collide, up to eight, as in fcl_parting.
std::optional<ContactPatch> fcl_patch(const Solid3<float>& a, const Solid3<float>& b);
std::optional<ContactPatch> fcl_patch(const Solid3<double>& a, const Solid3<double>& b);

/// All contacts of ODE's dCollide, up to eight.
std::optional<ContactPatch> ode_patch(const Solid3<double>& a, const Solid3<double>& b);

template <class T>
inline constexpr std::nullptr_t manifold_rivals = nullptr;
template <>
inline constexpr Rival<OfPair<ContactPatch, float>> manifold_rivals<float>[] = {{"Bullet", bullet_patch},
                                                                                {"FCL", fcl_patch}};
template <>
inline constexpr Rival<OfPair<ContactPatch, double>> manifold_rivals<double>[] = {{"FCL", fcl_patch},
                                                                                  {"ODE", ode_patch}};

// ---- Distance. libccd and ODE have no such query: they only tell whether shapes intersect, and how deep.

/// A program's distance of two shapes.
struct Separation {
  bool meets = false;
  double distance = 0;                           ///< Only if they are apart; NaN if the program gave up.
  Vec<3, double> point_a = Vec<3, double>(0.0);  ///< Of a, nearest to b.
  Vec<3, double> point_b = Vec<3, double>(0.0);
};

/// btGjkPairDetector, as for verdicts.
std::optional<Separation> bullet_separation(const Solid3<float>& a, const Solid3<float>& b);

/// The function that fcl::distance uses for two shapes, with nearest points, by FCL's own GJK; for triangles its tests
/// for them. Not for planes and half-spaces, for which its GJK has no support function.
std::optional<Separation> fcl_separation(const Solid3<float>& a, const Solid3<float>& b);
std::optional<Separation> fcl_separation(const Solid3<double>& a, const Solid3<double>& b);

/// The same with the GJK that FCL builds on parts of libccd, its default. Only in float: in double, as Debian builds
/// it, an assertion of that GJK ends the program for some of these cases.
std::optional<Separation> fcl_separation_by_libccd(const Solid3<float>& a, const Solid3<float>& b);

template <class T>
inline constexpr std::nullptr_t distance_rivals = nullptr;
template <>
inline constexpr Rival<OfPair<Separation, float>> distance_rivals<float>[] = {
    {"Bullet", bullet_separation}, {"FCL", fcl_separation}, {"FCL, libccd", fcl_separation_by_libccd}};
template <>
inline constexpr Rival<OfPair<Separation, double>> distance_rivals<double>[] = {{"FCL", fcl_separation}};

// ---- Ray casts

/// A program's result for a ray.
struct RayVerdict {
  bool hits = false;
  double distance = 0;  ///< From the origin, only if it hits.
};

/// For the ray up to a length of `reach` if it must be finite.
template <class T>
using OfRay = std::optional<RayVerdict>(const Solid3<T>& shape, const Ray<3, T>& ray, double reach);

/// Bullet's btCollisionWorld::rayTestSingle, shapes without margin as for verdicts.
std::optional<RayVerdict> bullet_sight(const Solid3<float>& shape, const Ray<3, float>& ray, double reach);

/// ODE's dCollide for a ray: spheres, boxes, capsules.
std::optional<RayVerdict> ode_sight(const Solid3<double>& shape, const Ray<3, double>& ray, double reach);

/// The formulas of textbook_ray.hpp.
std::optional<RayVerdict> textbook_sight(const Solid3<float>& shape, const Ray<3, float>& ray, double reach);
std::optional<RayVerdict> textbook_sight(const Solid3<double>& shape, const Ray<3, double>& ray, double reach);

template <class T>
inline constexpr std::nullptr_t ray_rivals = nullptr;
template <>
inline constexpr Rival<OfRay<float>> ray_rivals<float>[] = {{"textbook", textbook_sight}, {"Bullet", bullet_sight}};
template <>
inline constexpr Rival<OfRay<double>> ray_rivals<double>[] = {{"textbook", textbook_sight}, {"ODE", ode_sight}};

// ---- Shape casts. libccd and ODE have no such query.

/// A program's result for a motion.
struct Meeting {
  bool hits = false;
  double t = 0;  ///< From 0 to 1, only if it hits; NaN if the program gave up.
};

template <class T>
using OfMotion = std::optional<Meeting>(const Solid3<T>& a, const Vec<3, T>& motion, const Solid3<T>& b);

/// Bullet's btContinuousConvexCollision, which its world's sweeps use, shapes without margin as for verdicts.
std::optional<Meeting> bullet_meeting(const Solid3<float>& a, const Vec<3, float>& motion, const Solid3<float>& b);

/// fcl::continuousCollide by conservative advancement, with FCL's own GJK; not for triangles, which it supports only in
/// meshes, nor for planes and half-spaces. Only in double, as it is built; the float version would have to be compiled
/// completely.
std::optional<Meeting> fcl_meeting(const Solid3<double>& a, const Vec<3, double>& motion, const Solid3<double>& b);

template <class T>
inline constexpr std::nullptr_t cast_rivals = nullptr;
template <>
inline constexpr Rival<OfMotion<float>> cast_rivals<float>[] = {{"Bullet", bullet_meeting}};
template <>
inline constexpr Rival<OfMotion<double>> cast_rivals<double>[] = {{"FCL", fcl_meeting}};

// ---- Times of impact with rotation: each about the center of its bounds, by no more than `most_turn`.

/// Bullet rotates bodies by at most 45 degrees.
inline constexpr double most_turn = 0.75;

template <class T>
using OfTurns = std::optional<Meeting>(const test::Moving<3, T>& moving);

/// Bullet's btContinuousConvexCollision, as for casts.
std::optional<Meeting> bullet_impact(const test::Moving<3, float>& moving);

/// fcl::continuousCollide by conservative advancement along its motions between two poses, which rotate about the
/// center of each shape, with FCL's own GJK; for the same types as fcl_meeting, only in double, as it is built.
std::optional<Meeting> fcl_impact(const test::Moving<3, double>& moving);

template <class T>
inline constexpr std::nullptr_t impact_rivals = nullptr;
template <>
inline constexpr Rival<OfTurns<float>> impact_rivals<float>[] = {{"Bullet", bullet_impact}};
template <>
inline constexpr Rival<OfTurns<double>> impact_rivals<double>[] = {{"FCL", fcl_impact}};

// ---- Which points are corners of their convex hull, as indices. None if the program gives up.

template <Dim N>
using OfPoints = std::optional<std::vector<std::size_t>>(const std::vector<Vec<N, double>>& points);

/// qhull with its default options, which merge what is nearly coplanar. It gives up if all points are coplanar.
std::optional<std::vector<std::size_t>> qhull_corners(const std::vector<Vec<2, double>>& points);
std::optional<std::vector<std::size_t>> qhull_corners(const std::vector<Vec<3, double>>& points);

/// Bullet's btConvexHullComputer, which calculates in integers on a grid over the points.
std::optional<std::vector<std::size_t>> bullet_corners(const std::vector<Vec<3, double>>& points);

template <Dim N>
inline constexpr std::nullptr_t hull_rivals = nullptr;
template <>
inline constexpr Rival<OfPoints<2>> hull_rivals<2>[] = {{"qhull", qhull_corners}};
template <>
inline constexpr Rival<OfPoints<3>> hull_rivals<3>[] = {{"qhull", qhull_corners}, {"Bullet", bullet_corners}};

}  // namespace graze::exam
