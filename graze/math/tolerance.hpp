// SPDX-License-Identifier: MIT
/// @file
/// Every tolerance of the library, each with its reason. All are relative: callers multiply by the size of the numbers
/// in question.
#pragma once

#include <limits>
#include <type_traits>

#include <graze/math/vec.hpp>

namespace graze::tolerance {

/// The spacing of doubles just above 1.
inline constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// The error of a sum of a few products, relative to the sum of the products' absolute values. The longest sums are
/// differences of two coordinates multiplied by a cross product and added over three axes: fewer than 8 roundings of
/// epsilon / 2 each; doubled, because the magnitudes are themselves estimated in double.
inline constexpr double rounding = 8 * epsilon;

/// The error bound of fast tests whose verdicts must never contradict the careful ones that decide within it: plain
/// cross products and their products with coordinates (below 12 epsilon) plus twice the careful test's own tolerance
/// (16), with a margin.
inline constexpr double coarse = 8 * rounding;

/// The error of a sum of up to twenty terms in twice the precision of double: twenty errors of an addition, each
/// rounded as often, relative to the largest partial sum; doubled.
inline constexpr double twofold_rounding = 512 * epsilon * epsilon;

/// The smallest enclosing sphere is found if the squared distance of the farthest point exceeds the squared radius by
/// at most this, relatively: both are sums of three squares of differences, with up to five roundings.
inline constexpr double sphere_gap = 4 * epsilon;

/// How far the axes of an oriented box may be from orthonormal. Float rotations stay within it even after a thousand
/// naive multiplications (measured: 7e-5); a matrix with scale or shear, the usual mistake, does not.
inline constexpr double orthonormal = 1e-4;

/// The fast test of boxes leaves pairs to the careful test if they are closer to touching than this times the skew of
/// the axes times the size; its own error is 10, see BoxFilter.
inline constexpr double box_filter = 16;

/// The fast test of two segments leaves pairs to the careful test if they are closer to touching than this times the
/// size; its own error is the rounding of a few products divided by the least squared sine that it accepts, 1/64.
inline constexpr double segment_filter = 4096 * epsilon;

/// What kernels add to the measured skew of axes, both in T: the measurement has 4 roundings, and the 6 units of skew
/// that box_filter has to spare cover the 24 roundings of a gap, each half an epsilon.
template <Scalar T>
inline constexpr T measured_orthonormality_error = T(8) * std::numeric_limits<T>::epsilon();

/// Kernels leave segments to the careful test if they are closer to touching than this times the size. Their verdicts
/// are proved by two points, or by a direction, up to 12 epsilon of T; the careful test's own tolerance, of double, is
/// within segment_filter.
template <Scalar T>
inline constexpr T segment_lanes = std::is_same_v<T, float> ? T(64 * std::numeric_limits<float>::epsilon())
                                                            : T(segment_filter);

/// The fast comparison of a squared distance with a squared reach, in T, leaves to the careful one what differs by less
/// than this times their sum. The careful test's tolerance is 22 epsilon of double of the sum, the error of the squares
/// 4 epsilon of T.
template <Scalar T>
inline constexpr T squares = T(32) * std::numeric_limits<T>::epsilon();

/// The fast test of a ray and a sphere leaves to the careful one squared distances that differ from the squared radius
/// by less than this times the sum of the squares of the radius and of the center's distance from the origin. Its own
/// error is 10 epsilon of that, the careful test's tolerance 300.
inline constexpr double ray_filter = 1024 * epsilon;

/// The fast test of a triangle and a sphere leaves to the careful one squared distances that differ from the squared
/// radius by less than this times the sum of all squares. Its own error is 3500 epsilon, the careful test's tolerance
/// 200.
inline constexpr double triangle_filter = 8192 * epsilon;

/// The error of the height of a point above a plane through three others, relative to the sum of the edges' largest
/// coordinates, if all coordinates are at most 1 with errors of half an epsilon, and the normal is the cross product of
/// two edges: 66 epsilon from the normal (36), the points (6) and the dot products (24), and 1 from the errors of the
/// edges themselves.
inline constexpr double hull_plane = 128 * epsilon;

/// The error of a point whose coordinates HullShear has taken out of each other in twice the precision of double, in
/// units in which no coordinate exceeds 1.
inline constexpr double hull_shear = 8 * epsilon;

/// The error that one step of HullShear adds, relative to the largest coordinate: 11 roundings of a quarter of epsilon
/// squared.
inline constexpr double hull_shear_step = 4 * epsilon * epsilon;

/// `hull_plane` for points of HullShear: 48 epsilon from rounding, and 36 times `hull_shear` from the points.
inline constexpr double hull_sheared_plane = 512 * epsilon;

/// Undecided points count as a needle if they are at most this far from a line, in units in which the longest side of
/// the box around all points is 1 to 2. It is above what `hull_plane` leaves undecided for two faces that meet at an
/// angle of a few thousandths.
inline constexpr double hull_needle = 0x1p-36;

/// A point is dropped as interior to a hull of some points if it is inside by this fraction of its distance from their
/// center: far above the rounding error, 2^-20 by `hull_core_depth`, and far below what dropping points gains.
inline constexpr double hull_core = 1e-6;

/// The condition for `hull_core`: no face of that hull is nearer to the center than this, relative to the box around
/// the points.
inline constexpr double hull_core_depth = 0x1p-20;

/// Decides on which side of an edge of the octagon in hull/octagon.hpp a point lies, relative to |edge| times the
/// greatest distance of points along an axis: nine roundings of half an epsilon bound the height's error, and few
/// points are that near.
inline constexpr double hull_octagon = 8 * epsilon;

/// GJK stops if its upper and lower bounds on the distance agree to this, relative to the upper bound.
inline constexpr double gjk_relative_gap = 1e-12;

/// What GJK and EPA cannot resolve, relative to the largest coordinate of the two shapes: a support point has about
/// four roundings, and the difference and its projection on a unit normal about as many again.
inline constexpr double convex = 32 * epsilon;

/// Bounds the error of the height of a point over a face of EPA's hull: this times the largest coordinate times (1 + 1
/// / the sine of the angle between two sides of the face). Rounded sides turn the normal by 4 epsilon / sine, which
/// matters for points up to four times that coordinate away; doubled.
inline constexpr double growing_hull = 32 * epsilon;

/// Nearest points that are farther apart than this, relative to the size of the pair, determine the direction of the
/// shortest separating translation of two round shapes: rounding turns it by less than 1e-9, and the depth depends only
/// on the square of that.
inline constexpr double known_direction = 1e-5;

/// Faces and edges that deviate by less than this angle from a contact's normal, or from each other, count as parallel
/// in a manifold: it is above the rounding of normals, and hides very little of a depth.
inline constexpr double aligned = 1e-5;

/// An edge at less than this angle to a plane may lie on either side of it. It is far above the few epsilon of rounding
/// in the plane's normal; both sides are tried, which costs only time.
inline constexpr double extreme_edge = 1e-12;

/// Boxes are grown by this, relative to their largest coordinate, before boxes that do not overlap prove that their
/// shapes do not: it is above the tolerance of every verdict, relative to the same coordinate.
inline constexpr double box_slack = 256 * epsilon;

/// A ray enters a box if it is in all slabs at once, up to this, relative to the t at which it leaves: each t is a
/// difference and a quotient, so two of them have an error below 2 epsilon together; doubled.
inline constexpr double ray_slabs = 4 * epsilon;

/// A batch tests a box against a ray in T, and leaves it to the careful test of `ray_slabs` unless the ray misses it by
/// more than this, relatively: a difference, an inverse and a product have an error below 2 epsilon of T together, the
/// careful test 1 epsilon of double and its tolerance.
template <Scalar T>
inline constexpr T ray_lanes = T(8) * std::numeric_limits<T>::epsilon();

/// The error of the side on which a ray passes an edge, direction . (corner x edge) in T, relative to the product of
/// their sizes: below 4 epsilon of T for six products of three factors, two of them differences, and their sum;
/// doubled.
template <Scalar T>
inline constexpr T ray_edges = T(8) * std::numeric_limits<T>::epsilon();

/// The relative error of a squared distance of a box in T, a sum of squared differences: below 4 epsilon of T, plus up
/// to 15 if the lowest four bits hold the number of its lane; with a margin.
template <Scalar T>
inline constexpr T near_lanes = T(24) * std::numeric_limits<T>::epsilon();

/// A ray cast leaves rays to `relation` if they pass the edge of a shape's silhouette nearer than this times its size,
/// seen from the origin: over a hundred times the tolerance of `relation`; its own error is a few epsilon.
inline constexpr double ray_side = 4096 * epsilon;

/// Likewise rays that end at a round shape, or start behind it, nearer than this times its size: see ray_verdict_of.
inline constexpr double ray_end = 0x1p-20;

/// The fast test of a ray and a plane leaves to the careful one a height at either end below this times the sum of its
/// terms' magnitudes: see RayPlaneFilter. The careful test's tolerance is 2^-45 of that.
inline constexpr double ray_plane = 0x1p-32;

/// The fast test of a ray and an oriented box moves the box's sides by this times the size: axes that are off by
/// `orthonormal` move a point by that much, and float rounding by a thousandth of it.
inline constexpr float ray_orthonormality_error = 0x1p-12F;

/// The fast test of a ray and a capsule leaves to the careful one squared distances that differ from the squared radius
/// by less than this times the sum of all squares: both have errors of at most `segment_filter` of the size, and the
/// square of a size, a sum of four lengths, is up to twelve times that sum.
inline constexpr double ray_capsule = 0x1p-35;

/// Moving shapes count as touching if they are nearer than this, relative to their size and path: a thousand times
/// finer than a float can represent a position, and far enough above rounding that no step towards it is lost.
inline constexpr double impact = 0x1p-36;

/// The fraction of the gap before a plane that a step towards an impact may leave. The next plane, which separates the
/// shapes better, costs more than approaching this one; but near the end of this one, it no longer decides.
inline constexpr double impact_plane = 0x1p-10;

/// A motion approaches a surface if the sine of its angle to it is greater: far above the rounding of normals, and
/// above that of motions in T, which turns them by up to an epsilon.
template <Scalar T>
inline constexpr double approach =
    std::is_same_v<T, float> ? 4.0 * double{std::numeric_limits<float>::epsilon()} : 0x1p-40;

/// The resolution for users' shapes, whose support functions may calculate in T.
template <Scalar T>
inline constexpr double convex_in = 32.0 * static_cast<double>(std::numeric_limits<T>::epsilon());

/// A point is on a set without thickness, which hardly any point of T is exactly, if it is nearer than this, relative
/// to the largest coordinate. The point of T nearest to a plane is off by up to sqrt(3) / 2 epsilon; one calculated in
/// T with a handful of roundings by several.
template <Scalar T>
inline constexpr double surface = 8.0 * static_cast<double>(std::numeric_limits<T>::epsilon());

}  // namespace graze::tolerance
