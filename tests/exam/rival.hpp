// SPDX-License-Identifier: MIT
// Other programs: what each answers to a question, and which programs have the question at all. Each is one file,
// rival_<name>.cpp. A function returns none where its program has no test for these types.
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

/// What is asked of two shapes.
template <class Answer, class T>
using OfPair = std::optional<Answer>(const Solid3<T>& a, const Solid3<T>& b);

// ---- Whether a and b share a point

/// Bullet's narrow phase for convex pairs: btGjkPairDetector with EPA behind it, in float. Boxes, triangles and hulls
/// without margin, so that they are no larger than they should be; the radius of spheres and capsules is theirs.
std::optional<bool> bullet_answer(const Solid3<float>& a, const Solid3<float>& b);

/// FCL's fcl::collide with its own GJK; of triangles the tests that it uses for meshes.
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

// ---- How deep

/// What a program says of the contact of two shapes.
struct Parting {
  bool meets = false;
  double depth = 0;
  Vec<3, double> normal = Vec<3, double>(0.0);  ///< From a to b, of length 1; only where they meet.
  bool is_either_way = false;                   ///< It gives the normal in no certain direction: the better one counts.
};

/// btGjkPairDetector, as for verdicts.
std::optional<Parting> bullet_parting(const Solid3<float>& a, const Solid3<float>& b);

/// fcl::collide with contacts; of triangles the test for shapes, but not the one for two of them, whose depth is over
/// their planes alone. Where its own GJK answers, depths come with either sign, and so do normals: they are taken
/// without.
std::optional<Parting> fcl_parting(const Solid3<float>& a, const Solid3<float>& b);
std::optional<Parting> fcl_parting(const Solid3<double>& a, const Solid3<double>& b);

/// libccd's ccdGJKPenetration.
std::optional<Parting> libccd_parting(const Solid3<double>& a, const Solid3<double>& b);

/// The deepest of the contacts that ODE's dCollide gives.
std::optional<Parting> ode_parting(const Solid3<double>& a, const Solid3<double>& b);

/// The formulas of textbook_depth.hpp.
std::optional<Parting> textbook_parting(const Solid3<float>& a, const Solid3<float>& b);
std::optional<Parting> textbook_parting(const Solid3<double>& a, const Solid3<double>& b);

template <class T>
inline constexpr std::nullptr_t contact_rivals = nullptr;
template <>
inline constexpr Rival<OfPair<Parting, float>> contact_rivals<float>[] = {
    {"textbook", textbook_parting}, {"Bullet", bullet_parting}, {"FCL", fcl_parting}};
template <>
inline constexpr Rival<OfPair<Parting, double>> contact_rivals<double>[] = {
    {"textbook", textbook_parting}, {"FCL", fcl_parting}, {"libccd", libccd_parting}, {"ODE", ode_parting}};

// ---- Where two shapes lie on each other. libccd gives one point, whatever the shapes.

/// One point of a contact.
struct PatchPoint {
  Vec<3, double> place = Vec<3, double>(0.0);  ///< Of one of the shapes, or between them.
  double depth = 0;
};

/// All points of a contact; none if the shapes are apart.
using ContactPatch = std::vector<PatchPoint>;

/// Bullet's btBoxBoxDetector for two boxes; of others the one point of btGjkPairDetector. Bullet gathers more of those
/// from step to step.
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

// ---- How far apart. libccd and ODE have no such question: they tell whether shapes meet, and how deep.

/// What a program says of the distance of two shapes.
struct Separation {
  bool meets = false;
  double distance = 0;                           ///< Only where they do not; NaN if it gave up.
  Vec<3, double> point_a = Vec<3, double>(0.0);  ///< Of a, nearest to b.
  Vec<3, double> point_b = Vec<3, double>(0.0);
};

/// btGjkPairDetector, as for verdicts.
std::optional<Separation> bullet_separation(const Solid3<float>& a, const Solid3<float>& b);

/// What fcl::distance asks for two shapes, with nearest points, by FCL's own GJK; of triangles its tests for them. Not
/// of planes and half-spaces, which its GJK has no supports of.
std::optional<Separation> fcl_separation(const Solid3<float>& a, const Solid3<float>& b);
std::optional<Separation> fcl_separation(const Solid3<double>& a, const Solid3<double>& b);

/// The same by the GJK that FCL has built on parts of libccd, which is its default. In float alone: in double, as
/// Debian builds it, an assertion of that GJK ends the program among these cases.
std::optional<Separation> fcl_separation_by_libccd(const Solid3<float>& a, const Solid3<float>& b);

template <class T>
inline constexpr std::nullptr_t distance_rivals = nullptr;
template <>
inline constexpr Rival<OfPair<Separation, float>> distance_rivals<float>[] = {
    {"Bullet", bullet_separation}, {"FCL", fcl_separation}, {"FCL, libccd", fcl_separation_by_libccd}};
template <>
inline constexpr Rival<OfPair<Separation, double>> distance_rivals<double>[] = {{"FCL", fcl_separation}};

// ---- Where a ray hits

/// What a program says of a ray.
struct RayVerdict {
  bool hits = false;
  double distance = 0;  ///< From the origin, only if it hits.
};

/// Of the ray up to a length of `reach` if it has to have an end.
template <class T>
using OfRay = std::optional<RayVerdict>(const Solid3<T>& shape, const Ray<3, T>& ray, double reach);

/// Bullet's btCollisionWorld::rayTestSingle, shapes without margin as for verdicts.
std::optional<RayVerdict> bullet_sight(const Solid3<float>& shape, const Ray<3, float>& ray, double reach);

/// ODE's dCollide of a ray: spheres, boxes, capsules.
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

// ---- When a shape that moves meets another. libccd and ODE have no such question.

/// What a program says of a motion.
struct Meeting {
  bool hits = false;
  double t = 0;  ///< From 0 to 1, only if it hits; NaN if it gave up.
};

template <class T>
using OfMotion = std::optional<Meeting>(const Solid3<T>& a, const Vec<3, T>& motion, const Solid3<T>& b);

/// Bullet's btContinuousConvexCollision, which its world's sweeps use, shapes without margin as for verdicts.
std::optional<Meeting> bullet_meeting(const Solid3<float>& a, const Vec<3, float>& motion, const Solid3<float>& b);

/// fcl::continuousCollide by conservative advancement, with FCL's own GJK; not of triangles, which it has in meshes
/// alone, nor of planes and half-spaces. In double alone, as it is built: of float it would have to be compiled whole.
std::optional<Meeting> fcl_meeting(const Solid3<double>& a, const Vec<3, double>& motion, const Solid3<double>& b);

template <class T>
inline constexpr std::nullptr_t cast_rivals = nullptr;
template <>
inline constexpr Rival<OfMotion<float>> cast_rivals<float>[] = {{"Bullet", bullet_meeting}};
template <>
inline constexpr Rival<OfMotion<double>> cast_rivals<double>[] = {{"FCL", fcl_meeting}};

// ---- When two shapes that move and turn meet: each about the middle of its bounds, by no more than `most_turn`.

/// Bullet turns bodies by an eighth of a turn at most.
inline constexpr double most_turn = 0.75;

template <class T>
using OfTurns = std::optional<Meeting>(const test::Moving<3, T>& moving);

/// Bullet's btContinuousConvexCollision, as for casts.
std::optional<Meeting> bullet_impact(const test::Moving<3, float>& moving);

/// fcl::continuousCollide by conservative advancement along its motions between two poses, which turn about the middle
/// of each shape, with FCL's own GJK; of what fcl_meeting has, in double alone, as it is built.
std::optional<Meeting> fcl_impact(const test::Moving<3, double>& moving);

template <class T>
inline constexpr std::nullptr_t impact_rivals = nullptr;
template <>
inline constexpr Rival<OfTurns<float>> impact_rivals<float>[] = {{"Bullet", bullet_impact}};
template <>
inline constexpr Rival<OfTurns<double>> impact_rivals<double>[] = {{"FCL", fcl_impact}};

// ---- Which points are corners of their convex hull: their places among the points. None if the program gives up.

template <Dim N>
using OfPoints = std::optional<std::vector<std::size_t>>(const std::vector<Vec<N, double>>& points);

/// qhull with its default options, which merge what is nearly coplanar. It gives up where all points are on a plane.
std::optional<std::vector<std::size_t>> qhull_corners(const std::vector<Vec<2, double>>& points);
std::optional<std::vector<std::size_t>> qhull_corners(const std::vector<Vec<3, double>>& points);

/// Bullet's btConvexHullComputer, which works with whole numbers of a grid that it lays over the points.
std::optional<std::vector<std::size_t>> bullet_corners(const std::vector<Vec<3, double>>& points);

template <Dim N>
inline constexpr std::nullptr_t hull_rivals = nullptr;
template <>
inline constexpr Rival<OfPoints<2>> hull_rivals<2>[] = {{"qhull", qhull_corners}};
template <>
inline constexpr Rival<OfPoints<3>> hull_rivals<3>[] = {{"qhull", qhull_corners}, {"Bullet", bullet_corners}};

}  // namespace graze::exam
