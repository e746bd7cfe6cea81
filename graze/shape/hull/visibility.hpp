// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <graze/math/vec.hpp>
#include <graze/shape/hull/frame.hpp>
#include <graze/shape/hull/quickhull.hpp>

namespace graze::detail {

/// Finds the face of a hull that a point faces: the one hit by the ray from a point inside the hull ("center") to it. A
/// point is strictly outside of the hull exactly if it is strictly outside of that face, so no other face needs a test.
///
/// The search walks from face to face, through planes spanned by the center and an edge that the point is beyond. Such
/// a walk never cycles, because the cones from the center over the faces form a regular complex (Edelsbrunner, "An
/// Acyclicity Theorem for Cell Complexes in d Dimensions", 1990). If the side of a plane is uncertain, both faces are
/// walked.
template <class T>
class HullVisibility {
 public:
  /// The hull must outlive this object and must not change.
  explicit HullVisibility(const Quickhull<T>& hull) : hull_(&hull) {
    find_middle();
    if (!is_clear_) return;
    planes_of_.assign(hull.faces().size(), HullPoint::none);
    seen_for_.assign(hull.faces().size(), 0);
    std::uint32_t any = 0;
    while (!hull.faces()[any].is_alive) ++any;
    start_.fill(any);
  }

  /// Whether a point strictly inside was found, as in any hull clearly thicker than rounding. If false, do not call
  /// `faces_before`.
  bool is_clear() const { return is_clear_; }

  /// The face that a point of the frame faces, or several candidates if the point is so near to edges that rounding
  /// hides which. Empty if there are too many, or if a corner of the hull coincides with the point. Valid until the
  /// next call. The face in the point's link, if any, is tried first.
  std::span<const std::uint32_t> faces_before(const HullPoint& point) {
    begin();
    if (point.link < hull_->faces().size() && hull_->faces()[point.link].is_alive) walk(point.link, point);
    if (found_.empty() && !is_at_corner_) {
      std::uint32_t& start = start_[cell_of(point.place)];
      begin();
      walk_far(start, point);
      if (!found_.empty()) start = found_.front();
    }
    if (found_.size() > most_found || is_at_corner_) found_.clear();
    return found_;
  }

  /// Whether the last point coincides with a corner of the hull.
  bool is_at_corner() const { return is_at_corner_; }

 private:
  /// The planes through the center and each side of a face; their normals point away from the face.
  using SidePlanes = std::array<HullPlane, 3>;

  static constexpr std::int32_t cells = 16;      // along each side of a square
  static constexpr std::size_t most_found = 64;  // faces

  /// Sets the center to the mean of the hull's first corners, if it is strictly inside after rounding.
  void find_middle() {
    Vec<3, double> sum(0.0);
    for (const std::uint32_t corner : hull_->base()) sum += 0.25 * wide<3, T>(hull_->frame().point(corner));
    const Vec<3, T> middle(sum);
    middle_ = hull_->frame().seen(middle);
    const Vec<3, double> half = hull_->frame().half_extents();
    for (Dim i = 0; i < 3; ++i) to_units_[i] = half[i] > 0 ? 1 / half[i] : 1;
    is_clear_ = true;
    for (const auto& face : hull_->faces()) {
      if (!face.is_alive || face.plane.height(middle_.place) < -face.plane.doubt) continue;
      is_clear_ = is_clear_ && hull_->frame().orientation_of(hull_->indices_of(face), middle) < 0;
    }
  }

  /// The cell of a position on an octahedron around the center, whose upper and lower halves are each unfolded to a
  /// square. Branch-free, because a branch would be mispredicted.
  std::size_t cell_of(const Vec<3, double>& place) const {
    const Vec<3, double> way = (place - middle_.place) * to_units_;
    const double to_cells = 0.5 * cells / std::max(sum_abs(way), std::numeric_limits<double>::min());
    const auto along = [&](double x) {
      return std::min(cells - 1, static_cast<std::int32_t>(x * to_cells + 0.5 * cells));
    };
    const std::int32_t row = (way.z > 0 ? cells : 0) + along(way.x);
    return static_cast<std::size_t>(row) * cells + static_cast<std::size_t>(along(way.y));
  }

  void begin() {
    ++call_;
    found_.clear();
    ways_.clear();
    is_at_corner_ = false;
  }

  /// If the point faces that face up to rounding, finds all such faces; otherwise finds none.
  void walk(std::uint32_t face, const HullPoint& point) {
    seen_for_[face] = call_;
    look(face, point);
    if (!found_.empty()) walk_on(point);
  }

  /// The same, starting at any face.
  void walk_far(std::uint32_t face, const HullPoint& point) {
    seen_for_[face] = call_;
    look(face, point);
    walk_on(point);
  }

  void walk_on(const HullPoint& point) {
    while (!ways_.empty() && found_.size() <= most_found && !is_at_corner_) {
      const std::uint32_t face = ways_.back();
      ways_.pop_back();
      look(face, point);
    }
  }

  /// Tests whether a point may face this face, and queues the neighbours to visit.
  void look(std::uint32_t face, const HullPoint& point) {
    const SidePlanes& planes = planes_of(face);
    std::array<bool, 3> may_be_beyond{};
    for (std::size_t side = 0; side < 3; ++side) {
      const double height = planes[side].height(point.place);
      may_be_beyond[side] = height > -planes[side].doubt;
      if (!(height > planes[side].doubt)) continue;
      go_through(face, side);  // this way also leads to what is beyond the other sides
      return;
    }
    found_.push_back(face);
    for (std::size_t side = 0; side < 3; ++side) {
      if (!may_be_beyond[side]) continue;
      go_through(face, side);
      if (may_be_beyond[(side + 1) % 3] && is_at(face, (side + 1) % 3, point)) is_at_corner_ = true;
    }
  }

  bool is_at(std::uint32_t face, std::size_t corner, const HullPoint& point) const {
    const HullPoint& at = hull_->corners()[hull_->faces()[face].corners[corner]];
    return hull_->frame().point(at.index) == hull_->frame().point(point.index);
  }

  void go_through(std::uint32_t face, std::size_t side) {
    const std::uint32_t beyond = hull_->faces()[face].twins[side] / 4;
    if (seen_for_[beyond] == call_) return;
    seen_for_[beyond] = call_;
    ways_.push_back(beyond);
  }

  const SidePlanes& planes_of(std::uint32_t face) {
    std::uint32_t& place = planes_of_[face];
    if (place == HullPoint::none) {
      place = static_cast<std::uint32_t>(planes_.size());
      const auto& corners = hull_->faces()[face].corners;
      SidePlanes& planes = planes_.emplace_back();
      for (std::size_t side = 0; side < 3; ++side) {
        const HullPoint& from = hull_->corners()[corners[side]];
        const HullPoint& to = hull_->corners()[corners[(side + 1) % 3]];
        planes[side] = hull_->frame().plane(middle_, to, from);
      }
    }
    return planes_[place];
  }

  const Quickhull<T>* hull_;
  HullPoint middle_;
  Vec<3, double> to_units_ = Vec<3, double>(1.0);
  bool is_clear_ = false;
  std::vector<SidePlanes> planes_;                          // of visited faces
  std::vector<std::uint32_t> planes_of_;                    // their indices by face, or none
  std::array<std::uint32_t, 2UL * cells * cells> start_{};  // a face to start from, by cell
  std::vector<std::uint32_t> seen_for_;                     // the call in which a face was queued, by face
  std::uint32_t call_ = 0;
  std::vector<std::uint32_t> ways_;  // faces to visit
  std::vector<std::uint32_t> found_;
  bool is_at_corner_ = false;
};

}  // namespace graze::detail
