// SPDX-License-Identifier: MIT
// Every epsilon of graze, each with its reason. All are relative: a caller multiplies by the size of the numbers at
// hand.
#pragma once

#include <limits>
#include <type_traits>

#include <graze/math/vec.hpp>

namespace graze::tolerance {

/// The spacing of doubles just above 1.
inline constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// How far a sum of a few products can be off, relative to the sum of the products' absolute values. Our longest are
/// differences of two coordinates multiplied by a cross product and summed over three axes: under 8 roundings of
/// epsilon / 2 each; doubled, because the magnitudes are themselves estimated in double.
inline constexpr double rounding = 8 * epsilon;

/// The same for quick tests whose verdicts must never contradict the careful ones that decide within it: plain cross
/// products and their products with coordinates (under 12 epsilon), and twice the careful test's own band (16), with
/// room to spare.
inline constexpr double coarse = 8 * rounding;

/// The same for a sum of up to twenty terms added in twice the precision of double: twenty errors of an addition, each
/// rounded as often, relative to the largest partial sum; doubled.
inline constexpr double twofold_rounding = 512 * epsilon * epsilon;

/// The smallest sphere around points is found when the farthest point's squared distance exceeds its squared radius by
/// no more than this, relatively: both are sums of three squares of differences, with up to five roundings.
inline constexpr double sphere_gap = 4 * epsilon;

/// How far an oriented box's axes may be from orthonormal. Float rotations stay within it though a thousand of them are
/// multiplied without care (measured: 7e-5); a matrix with scale or shear, the usual mistake, does not.
inline constexpr double orthonormal = 1e-4;

/// The quick test of boxes leaves to the careful one what is closer to touching than this times the skew of the axes
/// times the size: its own error is 10, see BoxFilter.
inline constexpr double box_filter = 16;

/// The quick test of two segments leaves to the careful one what is closer to touching than this times the size: its
/// own error is the rounding of a few products divided by the least sine squared that it takes on, 1/64.
inline constexpr double segment_filter = 4096 * epsilon;

/// What kernels add to the skew that they measure of axes, both in T: the measure is rounded 4 times, and the 6 skew
/// that box_filter has to spare hold the 24 roundings of a gap, each half an epsilon.
template <Scalar T>
inline constexpr T measured_orthonormality_error = T(8) * std::numeric_limits<T>::epsilon();

/// Kernels leave to the careful test segments that are closer to touching than this times the size: what they say is
/// proved by two points, or by a direction, up to 12 epsilon of T; and the careful test's own band, of double, is
/// within that of segment_filter.
template <Scalar T>
inline constexpr T segment_lanes = std::is_same_v<T, float> ? T(64 * std::numeric_limits<float>::epsilon())
                                                            : T(segment_filter);

/// The quick comparison of a squared distance with a squared reach, in T, leaves to the careful one what differs by
/// less than this times their sum: that one's own band is 22 epsilon of double of it, the squares' error 4 epsilon of
/// T.
template <Scalar T>
inline constexpr T squares = T(32) * std::numeric_limits<T>::epsilon();

/// The quick test of a ray and a sphere leaves to the careful one squared distances that differ from the squared radius
/// by less than this times the sum of the squares of the center's distance from the origin and the radius: its own
/// error is 10 epsilon of it, the careful test's band 300.
inline constexpr double ray_filter = 1024 * epsilon;

/// The quick test of a triangle and a sphere leaves to the careful one squared distances that differ from the squared
/// radius by less than this times the sum of all squares: its own error is 3500 epsilon, the careful test's band 200.
inline constexpr double triangle_filter = 8192 * epsilon;

/// The height of a point above a plane through three others, all with coordinates up to 1 that are wrong by half an
/// epsilon, the normal as long as the cross product of two edges, is off by less than this times the sum of the edges'
/// largest coordinates: by 66 epsilon of that from the normal (36), the points (6) and the dot products (24), and by
/// 1 of what the edges themselves are wrong by.
inline constexpr double hull_plane = 128 * epsilon;

/// A point whose coordinates were taken out of each other in twice the precision of double, by HullShear, in units that
/// leave none above 1: each is off by this or less.
inline constexpr double hull_shear = 8 * epsilon;

/// What a step of that adds, relative to the largest coordinate: 11 roundings of a quarter of epsilon squared.
inline constexpr double hull_shear_step = 4 * epsilon * epsilon;

/// `hull_plane` for such points: 48 epsilon of that are from rounding, and 36 times `hull_shear` from the points.
inline constexpr double hull_sheared_plane = 512 * epsilon;

/// Points in doubt that are no farther from a line, of a box around all whose longest side is 1 to 2, are seen as a
/// needle: above what `hull_plane` lets be in doubt about two faces that meet at an angle of some thousandths.
inline constexpr double hull_needle = 0x1p-36;

/// A point is dropped as one inside a hull of some points where it is inside by this of its distance from their middle:
/// far above the rounding of that, 2^-20 by `hull_core_depth`, and far less than what is gained by dropping points.
inline constexpr double hull_core = 1e-6;

/// Provided that no face of that hull is nearer to the middle than this, relative to the box around the points.
inline constexpr double hull_core_depth = 0x1p-20;

/// Which side of an edge of the octagon in hull/octagon.hpp a point is on, relative to |edge| times the longest way
/// along an axis between points: nine roundings, a half of epsilon each, bound the height, and few points are so near.
inline constexpr double hull_octagon = 8 * epsilon;

/// GJK stops when its upper and lower bounds on the distance agree to this, relative to the upper bound.
inline constexpr double gjk_relative_gap = 1e-12;

/// What GJK and EPA cannot resolve, relative to the largest coordinate of the two shapes: a support point carries about
/// four roundings, their difference and the projection on a unit normal about as many again.
inline constexpr double convex = 32 * epsilon;

/// Nearest points that are farther apart than this, relative to the size of the pair, show the direction of the least
/// translation that parts two round shapes: it is turned by rounding by less than 1e-9, and no depth sees the square of
/// that.
inline constexpr double known_direction = 1e-5;

/// Faces and edges that are turned by less than this against a contact's normal, or each other, are laid flat on each
/// other in a manifold: more than normals are rounded by, and what it hides of a depth is that of a hair on a house.
inline constexpr double aligned = 1e-5;

/// An edge that makes less than this angle with a plane may lie on either side of it: far above the few epsilon by
/// which the plane's normal is rounded, and where both sides are tried, nothing is lost but time.
inline constexpr double extreme_edge = 1e-12;

/// Boxes are grown by this, relative to their largest coordinate, before boxes that miss each other are taken as proof
/// that their shapes do: more than any verdict's rounding band, relative to the same coordinate.
inline constexpr double box_slack = 256 * epsilon;

/// A ray enters a box when it is in all slabs at once, up to this, relative to the t at which it leaves: each t is a
/// difference and a quotient, so two of them are wrong by under 2 epsilon together; doubled.
inline constexpr double ray_slabs = 4 * epsilon;

/// A box of many is held against a ray in T, and left to the careful test of `ray_slabs` unless it is missed by more
/// than this, relatively: a difference, an inverse and a product are wrong by under 2 epsilon of T together, the
/// careful test by 1 epsilon of double and its band.
template <Scalar T>
inline constexpr T ray_lanes = T(8) * std::numeric_limits<T>::epsilon();

/// The side on which a ray passes an edge, direction . (corner x edge) in T, is wrong by under 4 epsilon of T of the
/// product of their sizes: six products of three factors, two of them differences, and their sum; doubled.
template <Scalar T>
inline constexpr T ray_edges = T(8) * std::numeric_limits<T>::epsilon();

/// A squared distance of a box in T, a sum of squared differences, is wrong by under 4 epsilon of T, relatively, and by
/// up to 15 more where the number of its lane is in its lowest four bits; some to spare.
template <Scalar T>
inline constexpr T near_lanes = T(24) * std::numeric_limits<T>::epsilon();

/// A ray cast leaves to `relation` the rays that pass the edge of a shape's shadow nearer than this times its size,
/// seen from the origin: over a hundred times the band of `relation`, and its own error is a few epsilon.
inline constexpr double ray_side = 4096 * epsilon;

/// And those that end, or start behind the shape, nearer than this times its size, where it is round: see
/// ray_verdict_of.
inline constexpr double ray_end = 0x1p-20;

/// The quick test of a ray and a plane leaves to the careful one a height at either end that is less than this times
/// the sum of its terms' magnitudes: see RayPlaneFilter; the careful test's own band is 2^-45 of those.
inline constexpr double ray_plane = 0x1p-32;

/// The quick test of a ray and an oriented box moves its sides by this times the size: axes that are not orthonormal by
/// `orthonormal` move a place by that, and float by a thousandth of it.
inline constexpr float ray_orthonormality_error = 0x1p-12F;

/// The quick test of a ray and a capsule leaves to the careful one squared distances that differ from the squared
/// radius by less than this times the sum of all squares: both are wrong by `segment_filter` of the size at most, and
/// the square of a size, a sum of four lengths, is up to twelve times the sum.
inline constexpr double ray_capsule = 0x1p-35;

/// Moving shapes have come to touch when they are nearer than this, relative to their size and way: under what a float
/// can tell of a place by a thousand times, and far enough above rounding that no step towards it is lost in that.
inline constexpr double impact = 0x1p-36;

/// How much of the gap before a plane a step towards an impact may leave: the next plane, which parts the shapes
/// better, costs more than closing in on this one's time, but where this one ends, it is no longer the one that counts.
inline constexpr double impact_plane = 0x1p-10;

/// Support functions of a user's shape may calculate in T: the band for their answers.
template <Scalar T>
inline constexpr double convex_in = 32.0 * static_cast<double>(std::numeric_limits<T>::epsilon());

/// A point is on a set without thickness, which hardly any point of T is exactly, when it is nearer than this, relative
/// to the largest coordinate. The point of T nearest to a plane is off by up to sqrt(3) / 2 epsilon; one that was
/// calculated in T with a handful of roundings by several.
template <Scalar T>
inline constexpr double surface = 8.0 * static_cast<double>(std::numeric_limits<T>::epsilon());

}  // namespace graze::tolerance
