// SPDX-License-Identifier: MIT
// The axis of a capsule over a face of a box: what pairs_over of manifold_points.hpp leaves of a segment, which is cut
// at the four sides of a rectangle and at one height above it, in closed form. Include manifold.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/cores/surface_point_box.hpp>
#include <graze/query/patch/clipped.hpp>
#include <graze/query/patch/manifold_points.hpp>
#include <graze/query/patch/patch.hpp>
#include <graze/shape/obb.hpp>

namespace graze::detail {

/// A capsule and a box, both seen from where the capsule's axis starts.
struct CapsuleAndBox {
  Vec<3, double> origin;  ///< The start as it is.
  Vec<3, double> way;     ///< From there to the end.
  double radius;
  Obb<3, double> box;
  bool turns;  ///< Whether the capsule is the first of both.

  /// The sum of the coordinates.
  double size() const { return sum_abs(way) + sum_abs(box.center) + sum_abs(box.half_extents) + radius; }
};

/// What lies over the face is a piece of the axis, which is cut only where it is asked for: a contact alone wants the
/// lowest place, which is seldom at a cut.
class AxisOverFace {
 public:
  AxisOverFace(const CapsuleAndBox& pair, double size, const BoxFaceNumbers& face)
      : origin_(pair.origin),
        way_(pair.way),
        radius_(pair.radius),
        turns_(pair.turns),
        face_(face),
        margin_(least_clear * size),
        thin_(tolerance::known_direction * size),
        up_(normal_of(pair.box, face)),
        top_(dot(up_, middle_of(pair.box, face))),
        rise_(dot(up_, pair.way)),
        is_level_(std::fabs(rise_) <= tolerance::rounding * size) {
    const Mat<3, double>& axes = pair.box.axes;
    const Vec<3, double>& half = pair.box.half_extents;
    const Vec<3, double> middle = middle_of(pair.box, face);
    const auto slab = [&](Dim axis, Dim other) -> Slab {
      const Vec<3, double> along = cross(axes[other], up_);
      const double scale = 1 / dot(along, axes[axis]);  // about 1 or -1
      const double way = dot(along, pair.way) * scale;
      return {-(dot(along, middle) * scale), way, 1 / way, half[axis]};
    };
    slabs_[0] = slab(face.next(), face.last());
    slabs_[1] = slab(face.last(), face.next());
    find_lowest();
  }

  const Vec<3, double>& up() const { return up_; }
  bool is_level() const { return is_level_; }

  /// Whether the lowest place of the axis is over the face: an end, or of an axis that is level any.
  bool is_lowest_over() const { return is_lowest_over_; }

  std::uint32_t lowest_end() const { return is_end_lowest_ ? 1 : 0; }
  double lowest_gap() const { return gap(lowest_place_); }

  SurfacePair<3> lowest_pair() const { return pair_at(lowest_place_); }

  /// Puts the ends of the piece, in their order along the axis, if all is told by more than rounding. Returns how many.
  std::size_t put_points(SurfacePair<3>* points) const {
    const Piece piece = is_level_ ? piece_ : cut();
    if (!piece.is_clear) return 0;
    points[0] = pair_at(piece.low.place);
    points[1] = pair_at(piece.high.place);
    name(piece.low, {FeatureKind::vertex, 0}, points[0]);
    name(piece.high, {FeatureKind::vertex, 1}, points[1]);
    return 2;
  }

 private:
  // The way of all shapes may find the normal turned by the root of what rounding is: of places beside each other that
  // are as near up to rounding it takes any.
  static constexpr double least_clear = 1e-7;

  /// The coordinate of the axis between two opposite sides of the face, which stand up from it along its normal.
  struct Slab {
    double start;
    double way;
    double per_way;  ///< A way of zero passes the sides at infinity.
    double half;

    double enters() const { return (-std::copysign(half, way) - start) * per_way; }
    double leaves() const { return (std::copysign(half, way) - start) * per_way; }
    double room(double place) const { return half - std::fabs(start + way * place); }
  };

  /// Where what lies over the face ends, and on what.
  struct End {
    double place;
    bool is_vertex;
    int side;  ///< The slab that it is at a side of; 2 for the height of the radius.
    bool is_clear;
  };

  struct Piece {
    End low;
    End high;
    bool is_clear;
  };

  static Vec<3, double> normal_of(const Obb<3, double>& box, const BoxFaceNumbers& face) {
    const Vec<3, double> adjoint = adjoint_column(box.axes, face.axis);
    const Vec<3, double> across = adjoint * (1 / std::sqrt(dot(adjoint, adjoint)));  // about 1
    return (dot(across, box.axes[face.axis]) < 0) == face.is_far ? -across : across;
  }

  static Vec<3, double> middle_of(const Obb<3, double>& box, const BoxFaceNumbers& face) {
    const double half = box.half_extents[face.axis];
    return box.center + box.axes[face.axis] * (face.is_far ? half : -half);
  }

  double gap(double place) const { return rise_ * place - top_; }

  /// Of an axis that is level an end that is over the face, the start before the end.
  void find_lowest() {
    if (is_level_) {
      piece_ = cut();
      is_end_lowest_ = piece_.high.is_vertex && !piece_.low.is_vertex;
      lowest_place_ = is_end_lowest_ ? piece_.high.place : piece_.low.place;
      is_lowest_over_ = piece_.is_clear;
    } else {
      is_end_lowest_ = rise_ < 0;
      lowest_place_ = is_end_lowest_ ? 1 : 0;
      is_lowest_over_ = slabs_[0].room(lowest_place_) > margin_ && slabs_[1].room(lowest_place_) > margin_ &&
                        radius_ - gap(lowest_place_) > margin_;
    }
  }

  /// A box that is nearly flat has other names for what is cut.
  Piece cut() const {
    Piece piece{low_end(), high_end(), false};
    piece.is_clear = piece.low.is_clear && piece.high.is_clear && slabs_[0].half > thin_ && slabs_[1].half > thin_;
    return piece;
  }

  /// Where the axis passes the height of the radius: a rise of zero does so at infinity, or nowhere.
  double at_height() const { return (radius_ + top_) / rise_; }

  End low_end() const {
    constexpr double never = -1;
    const std::array<double, 3> places{slabs_[0].enters(), slabs_[1].enters(), rise_ < 0 ? at_height() : never};
    const double last = std::max(std::max(places[0], places[1]), places[2]);
    End low = end_at(std::max(last, 0.0), !(last > 0), places);
    // The second last, so that the last has something to cut off.
    const double before =
        std::max(std::max(std::min(places[0], places[1]), std::min(std::max(places[0], places[1]), places[2])), 0.0);
    low.is_clear = low.is_clear && (low.is_vertex || is_cut_clear(last - before, low.side));
    return low;
  }

  End high_end() const {
    constexpr double never = 2;
    const std::array<double, 3> places{slabs_[0].leaves(), slabs_[1].leaves(), rise_ > 0 ? at_height() : never};
    const double first = std::min(std::min(places[0], places[1]), places[2]);
    End high = end_at(std::min(first, 1.0), !(first < 1), places);
    const double next =
        std::min(std::min(std::max(places[0], places[1]), std::max(std::min(places[0], places[1]), places[2])), 1.0);
    high.is_clear = high.is_clear && (high.is_vertex || is_cut_clear(next - first, high.side));
    return high;
  }

  /// Clear if it is under all other planes that cut.
  End end_at(double place, bool is_vertex, const std::array<double, 3>& places) const {
    End end{place, is_vertex, 0, true};
    if (place == places[1]) end.side = 1;
    if (place == places[2]) end.side = 2;
    const std::array<double, 3> rooms{slabs_[0].room(place), slabs_[1].room(place), radius_ - gap(place)};
    for (int i = 0; i < 3; ++i) {
      const bool is_at = !is_vertex && i == end.side;
      end.is_clear = end.is_clear && (is_at || rooms[static_cast<std::size_t>(i)] > margin_);
    }
    return end;
  }

  /// Whether a plane cuts off so much of the way, and is not passed at so small an angle that rounding moves the place.
  bool is_cut_clear(double share, int side) const { return share * rate(side) > margin_ && rate(side) > thin_; }

  double rate(int side) const { return std::fabs(side == 2 ? rise_ : slabs_[static_cast<std::size_t>(side)].way); }

  /// Without names.
  SurfacePair<3> pair_at(double place) const {
    const Vec<3, double> on_axis = way_ * place;
    const Vec<3, double> on_box = origin_ + (on_axis - up_ * gap(place));
    const Vec<3, double> on_capsule = origin_ + (on_axis - up_ * radius_);
    SurfacePair<3> result;
    result.point_a = turns_ ? on_capsule : on_box;
    result.point_b = turns_ ? on_box : on_capsule;
    result.depth = std::max(0.0, radius_ - gap(place));
    return result;
  }

  void name(const End& end, const Feature& vertex, SurfacePair<3>& pair) const {
    const Feature of_capsule = end.is_vertex ? vertex : Feature{FeatureKind::edge, 0};
    const Feature of_box = end.is_vertex || end.side == 2 ? Feature{FeatureKind::face, face_.face()} : side_at(end);
    pair.feature_a = turns_ ? of_capsule : of_box;
    pair.feature_b = turns_ ? of_box : of_capsule;
  }

  Feature side_at(const End& end) const {
    const Slab& slab = slabs_[static_cast<std::size_t>(end.side)];
    const bool is_far = slab.start + slab.way * end.place > 0;
    if (end.side == 0) return {FeatureKind::edge, face_.edge(is_far ? 1 : 3)};
    return {FeatureKind::edge, face_.edge(is_far ? 2 : 0)};
  }

  Vec<3, double> origin_;
  Vec<3, double> way_;
  double radius_;
  bool turns_;
  BoxFaceNumbers face_;
  double margin_;  ///< What is in doubt of a place over the face.
  double thin_;
  Vec<3, double> up_;
  double top_;   ///< How high the face is.
  double rise_;  ///< How much higher the end of the axis is than its start.
  std::array<Slab, 2> slabs_;
  bool is_level_;
  bool is_end_lowest_;
  bool is_lowest_over_;
  double lowest_place_;
  Piece piece_;  ///< Of an axis that is level.
};

}  // namespace graze::detail
