// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include <graze/math/rounding.hpp>
#include <graze/math/vec.hpp>
#include <graze/math/whole_determinant.hpp>
#include <graze/shape/hull_base.hpp>
#include <graze/shape/hull_frame.hpp>
#include <graze/shape/index_lists.hpp>

namespace graze::detail {

/// Grows a convex hull in space by the point that is farthest outside of a face, face by face. Barber, Dobkin,
/// Huhdanpaa, "The Quickhull Algorithm for Convex Hulls" (1996), with exact tests of sides instead of their tolerances:
/// a point outside a face is strictly outside, so the faces that see it are a disk, none of the new ones is degenerate,
/// and each point that is still outside sees one of these.
///
/// Points that rounding hides the side of are first set aside, with a face that they may be outside of, until all
/// others are decided: where many are on a line or a plane up to their rounding, few of these have then to be decided
/// exactly, see hull_doubts.hpp.
///
/// The points outside of a face lie together on one stack, those of the newest faces on top, and the newest face grows
/// first: so memory is read and written in rows, and what is left of older faces is close at hand.
template <class T>
class Quickhull {
 public:
  static constexpr std::uint32_t none = HullPoint::none;

  /// A half-edge is 4 * face + side; side i runs from corner i to the next, counter-clockwise seen from outside.
  struct Face {
    HullPlane plane;
    std::array<std::uint32_t, 3> corners{};  ///< Places in `corners`.
    std::array<std::uint32_t, 3> twins{};    ///< The half-edge the other way, of the neighbour.
    std::size_t first = 0;                   ///< Of the points that see it, on the stack.
    std::size_t last = 0;                    ///< Behind them.
    std::size_t farthest = 0;                ///< Of these, roughly.
    std::uint32_t doubted = none;            ///< The first of the points in doubt that were set aside with it.
    bool is_alive = true;
    bool is_waiting = false;  ///< To grow.
    bool sees = false;        ///< The point that is being added.
  };

  /// Of nothing: only memory for hulls.
  Quickhull() = default;

  /// Of the candidates, some points of the frame, at least one, that none of its corners is missing from; but those in
  /// doubt are not in it until they are added, and where many are, it may not be finished. The frame must outlive it.
  Quickhull(const HullFrame<T>& frame, std::vector<HullPoint> candidates) { start(frame, candidates); }

  /// The same, in the memory of the hull before. In exchange for the candidates there is memory for others.
  void start(const HullFrame<T>& frame, std::vector<HullPoint>& candidates) {
    frame_ = &frame;
    undecided_.swap(candidates);
    candidates.clear();
    forget();
    base_ = HullBase<T>(frame, undecided_);
    if (base().size() < 4) return;
    begin();
    grow_all();
  }

  /// Whether all but the points in doubt have been added. Else there are many of these, asked again and again, and it
  /// is time to `sift` them.
  bool is_finished() const { return waiting_.empty(); }

  /// Goes on to the end without.
  void finish() {
    is_sifting_worthwhile_ = false;
    grow_all();
  }

  /// Forgets points in doubt near faces, those without a mark at their place, which must not be corners of the hull of
  /// all, and goes on.
  void sift(const std::vector<bool>& is_kept) {
    const std::size_t before = doubted_.size();
    for (Face& face : faces_) {
      std::uint32_t old = std::exchange(face.doubted, none);
      doubted_.drain(old, [&](std::uint32_t point) {
        if (is_kept[point]) doubted_.add(face.doubted, point);
      });
    }
    is_sifting_worthwhile_ = doubted_.size() <= before / 2;
    count_asked_again_ = 0;
    grow_all();
  }

  /// Whether points are in doubt: if none are, the hull is that of all.
  bool has_doubts() const { return !loose_.empty() || doubted_.size() > 0; }

  /// Calls `visit` with the places of the points in doubt that were last found near the plane of a face.
  template <class Visit>
  void for_each_doubted(std::uint32_t face, const Visit& visit) const {
    doubted_.for_each(faces_[face].doubted, visit);
  }

  /// The others: those found inside of the faces that took the place of one they were near.
  std::span<const std::uint32_t> loose() const { return loose_; }

  /// Of points in doubt some that none of the hull's corners is missing from. They are decided exactly.
  void add(std::span<const std::uint32_t> points) {
    settles_doubts_ = true;
    loose_.clear();
    doubted_.clear();
    is_sifting_worthwhile_ = false;
    undecided_.clear();
    for (const std::uint32_t index : points) undecided_.push_back(frame_->at(index));
    used_ = 0;
    const std::size_t alive = faces_.size() - free_.size();
    // What it takes to ask all faces about all of them, beside what it takes to begin anew with all that is left.
    constexpr std::size_t tests_of_a_point = 256;
    if (undecided_.size() * alive <= tests_of_a_point * (undecided_.size() + corners_.size())) {
      new_faces_.clear();
      for (std::uint32_t face = 0; face < faces_.size(); ++face) {
        faces_[face].doubted = none;
        if (faces_[face].is_alive) new_faces_.push_back(face);
      }
      deal();
    } else {
      undecided_.insert(undecided_.end(), corners_.begin(), corners_.end());
      forget_faces();
      begin();
    }
    grow_all();
  }

  /// Places of points that span what all of them span: one that all are at, two on the line they are on, three on the
  /// plane they are on, or four. Exactly.
  std::span<const std::uint32_t> base() const { return base_.places(); }

  /// The candidates, if those span no volume: then there are no faces.
  std::span<const HullPoint> flat_candidates() const {
    return base().size() < 4 ? std::span<const HullPoint>(undecided_) : std::span<const HullPoint>();
  }

  const HullFrame<T>& frame() const { return *frame_; }

  /// Those that are alive are the surface of the hull, none if all points lie on one plane: triangles that share their
  /// edges two by two, none of them without area. Flat parts of the surface come in several.
  std::span<const Face> faces() const { return faces_; }

  /// What corners of faces are in the list of points; some of them may be in the middle of a flat part or of an edge.
  std::span<const HullPoint> corners() const { return corners_; }

  std::uint32_t twin(std::uint32_t half_edge) const { return faces_[half_edge / 4].twins[half_edge % 4]; }
  std::uint32_t origin(std::uint32_t half_edge) const { return faces_[half_edge / 4].corners[half_edge % 4]; }

  /// Around its face.
  static std::uint32_t next(std::uint32_t half_edge) { return half_edge % 4 == 2 ? half_edge - 2 : half_edge + 1; }

  /// Whether the faces on both sides of a half-edge are on different planes, exactly.
  bool is_bent(std::uint32_t half_edge) const {
    const Face& face = faces_[half_edge / 4];
    const HullPoint& beyond = corners_[origin(next(next(twin(half_edge))))];
    if (face.plane.height(beyond.place) < -face.plane.doubt) return true;
    return !frame_->is_exact() && frame_->orientation_of(indices_of(face), beyond.index) != 0;
  }

 private:
  struct HorizonEdge {
    std::uint32_t from;
    std::uint32_t beyond;  ///< The half-edge of the face that stays.
  };

  /// The link of a point in doubt that no face is known to be near.
  static constexpr std::uint32_t loose_link = none - 1;

  std::array<std::uint32_t, 3> indices_of(const Face& face) const {
    return {corners_[face.corners[0]].index, corners_[face.corners[1]].index, corners_[face.corners[2]].index};
  }

  bool is_outside(const Face& face, const HullPoint& point) const {
    const double height = face.plane.height(point.place);
    if (height > face.plane.doubt) return true;
    if (height <= -face.plane.doubt) return false;
    return frame_->orientation_of(indices_of(face), point.index) > 0;
  }

  /// What it has found of points before.
  void forget() {
    forget_faces();
    used_ = 0;
    loose_.clear();
    doubted_.clear();
    count_asked_again_ = 0;
    is_sifting_worthwhile_ = true;
    is_any_in_doubt_ = false;
    settles_doubts_ = false;
  }

  void forget_faces() {
    corners_.clear();
    faces_.clear();
    free_.clear();
    waiting_.clear();
  }

  /// A tetrahedron, and the points that are outside of its faces.
  void begin() {
    for (const std::uint32_t index : base()) corners_.push_back(frame_->at(index));
    // The last corner is on the inner side of the first three.
    add_face({0, 1, 2}, {4, 8, 12});
    add_face({1, 0, 3}, {0, 14, 9});
    add_face({2, 1, 3}, {1, 6, 13});
    add_face({0, 2, 3}, {2, 10, 5});
    new_faces_ = {0, 1, 2, 3};
    deal();
  }

  void grow_all() {
    constexpr std::size_t few = 4096;
    while (!waiting_.empty()) {
      if (is_sifting_worthwhile_ && count_asked_again_ > doubted_.size() + few) return;
      const std::uint32_t face = waiting_.back();
      waiting_.pop_back();
      faces_[face].is_waiting = false;
      if (faces_[face].is_alive) {
        grow(face);
      } else {
        free_.push_back(face);
      }
    }
  }

  std::uint32_t add_face(const std::array<std::uint32_t, 3>& corners, const std::array<std::uint32_t, 3>& twins) {
    auto place = static_cast<std::uint32_t>(faces_.size());
    if (!free_.empty()) {
      place = free_.back();
      free_.pop_back();
    } else {
      constexpr std::size_t most = none / 4;
      if (faces_.size() == most) throw std::length_error("the convex hull has more than 2^30 triangles");
      faces_.emplace_back();
    }
    Face face;
    face.corners = corners;
    face.twins = twins;
    face.plane = frame_->plane(corners_[corners[0]], corners_[corners[1]], corners_[corners[2]]);
    faces_[place] = face;
    return place;
  }

  /// Puts each of the undecided points on the stack, with others of the first of the new faces that it is outside of,
  /// or sets it aside, or forgets it.
  void deal() {
    for (const std::uint32_t place : new_faces_) {
      if (undecided_.empty()) return;
      take_outside(place);
      Face& face = faces_[place];
      if (face.first == face.last) continue;
      face.is_waiting = true;
      waiting_.push_back(place);
    }
    if (!is_any_in_doubt_) return;
    for (const HullPoint& point : undecided_) set_aside(point);
    is_any_in_doubt_ = false;
  }

  /// Whether a plane is along two axes, so that `orientation` has to compare two coordinates at most.
  static bool is_along_axes(const HullPlane& plane) {
    const Vec<3, double>& normal = plane.normal;
    return (normal.x == 0 ? 1 : 0) + (normal.y == 0 ? 1 : 0) + (normal.z == 0 ? 1 : 0) >= 2;
  }

  /// Whether a plane has a thinner layer of points that are in doubt about it than another one.
  static bool is_sharper(const HullPlane& plane, const HullPlane& other) {
    return plane.doubt * sum_abs(other.normal) < other.doubt * sum_abs(plane.normal);
  }

  /// Moves the undecided points that are outside of a face to the stack.
  void take_outside(std::uint32_t place) {
    Face& face = faces_[place];
    const HullPlane plane = face.plane;
    const bool settles_doubts = settles_doubts_ || is_along_axes(plane);
    std::optional<WholePlane> whole;
    const auto is_exactly_above = [&](std::uint32_t point) {
      if (!whole) whole.emplace(frame_->whole_plane(indices_of(face)));
      const std::optional<int> side = whole->side_of(wide<3, T>(frame_->point(point)));
      return (side ? *side : frame_->orientation_of(indices_of(face), point)) > 0;
    };
    double largest = -std::numeric_limits<double>::infinity();
    std::size_t last = used_;
    std::size_t kept = 0;
    for (HullPoint point : undecided_) {
      const double height = plane.height(point.place);
      bool is_above = height > plane.doubt;
      if (!is_above && height > -plane.doubt) {
        if (settles_doubts) {
          is_above = is_exactly_above(point.index);
        } else {
          if (point.link >= loose_link || is_sharper(plane, faces_[point.link].plane)) point.link = place;
          is_any_in_doubt_ = true;
        }
      }
      if (last == outside_.size()) outside_.resize(last + last / 2 + 1024);
      // Both are written and one is kept: a branch would be guessed wrong every other time.
      outside_[last] = {point.place, point.index};
      undecided_[kept] = point;
      last += is_above ? 1 : 0;
      kept += is_above ? 0 : 1;
      if (is_above && height > largest) {
        largest = height;
        face.farthest = last - 1;
      }
    }
    undecided_.resize(kept);
    face.first = used_;
    face.last = last;
    used_ = last;
  }

  /// Keeps a point that is outside of no new face if it is in doubt: near one of them, or one that is gone. That it is
  /// inside of the faces that took the place of that one says nothing about others it may be outside of.
  void set_aside(const HullPoint& point) {
    if (point.link == none) return;
    if (point.link == loose_link) {
      loose_.push_back(point.index);
      return;
    }
    Face& face = faces_[point.link];
    const auto is_at = [&](std::uint32_t corner) { return frame_->point(corner) == frame_->point(point.index); };
    const std::array<std::uint32_t, 3> corners = indices_of(face);
    if (is_at(corners[0]) || is_at(corners[1]) || is_at(corners[2])) return;
    doubted_.add(face.doubted, point.index);
  }

  /// Makes the points in doubt that were set aside with a face undecided.
  void take_doubted(Face& face) {
    doubted_.drain(face.doubted, [&](std::uint32_t point) {
      undecided_.push_back(frame_->at(point));
      undecided_.back().link = loose_link;
      is_any_in_doubt_ = true;
      ++count_asked_again_;
    });
  }

  /// Adds the farthest of the points outside a face, the last one waiting.
  void grow(std::uint32_t face) {
    const std::size_t top = faces_[face].first;
    const HullPoint point = outside_[faces_[face].farthest];
    outside_[faces_[face].farthest] = outside_[--faces_[face].last];
    find_horizon(face, point);
    undecided_.clear();
    for (const std::uint32_t seen : seen_) {
      Face& old = faces_[seen];
      undecided_.insert(undecided_.end(), outside_.begin() + static_cast<std::ptrdiff_t>(old.first),
                        outside_.begin() + static_cast<std::ptrdiff_t>(old.last));
      take_doubted(old);
      old.is_alive = false;
      if (!old.is_waiting) free_.push_back(seen);
    }
    used_ = top;  // what lies above is of faces that are gone
    add_cone(point);
    deal();
  }

  /// The faces that see a point, and the edges around them, in order.
  void find_horizon(std::uint32_t face, const HullPoint& point) {
    std::uint32_t start = none;
    seen_.assign(1, face);
    faces_[face].sees = true;
    for (std::size_t k = 0; k < seen_.size(); ++k) {
      const std::array<std::uint32_t, 3> twins = faces_[seen_[k]].twins;
      for (std::uint32_t side = 0; side < 3; ++side) {
        Face& other = faces_[twins[side] / 4];
        if (other.sees) continue;
        if (is_outside(other, point)) {
          other.sees = true;
          seen_.push_back(twins[side] / 4);
        } else {
          start = 4 * seen_[k] + side;
        }
      }
    }
    horizon_.clear();
    std::uint32_t edge = start;
    do {
      horizon_.push_back({origin(edge), twin(edge)});
      edge = next(edge);
      while (faces_[twin(edge) / 4].sees) edge = next(twin(edge));
    } while (edge != start);
  }

  /// Faces from all edges of the horizon to a point.
  void add_cone(const HullPoint& point) {
    const auto tip = static_cast<std::uint32_t>(corners_.size());
    corners_.push_back(point);
    new_faces_.clear();
    for (std::size_t i = 0; i < horizon_.size(); ++i) {
      const HorizonEdge& edge = horizon_[i];
      const std::uint32_t to = horizon_[i + 1 == horizon_.size() ? 0 : i + 1].from;
      const std::uint32_t face = add_face({edge.from, to, tip}, {edge.beyond, none, none});
      faces_[edge.beyond / 4].twins[edge.beyond % 4] = 4 * face;
      new_faces_.push_back(face);
    }
    for (std::size_t i = 0; i < new_faces_.size(); ++i) {
      const std::uint32_t following = new_faces_[i + 1 == new_faces_.size() ? 0 : i + 1];
      faces_[new_faces_[i]].twins[1] = 4 * following + 2;
      faces_[following].twins[2] = 4 * new_faces_[i] + 1;
    }
  }

  const HullFrame<T>* frame_ = nullptr;
  std::vector<HullPoint> undecided_;
  HullBase<T> base_;
  std::vector<HullPoint> corners_;
  std::vector<Face> faces_;
  std::vector<std::uint32_t> free_;     // places of faces that are gone
  std::vector<std::uint32_t> waiting_;  // faces that had points outside when they were made, the newest last
  std::vector<HullPoint> outside_;      // the stack of these points, in the order of `waiting_`
  std::size_t used_ = 0;                // of that stack
  IndexLists doubted_;                  // points in doubt, a list for each face
  std::size_t count_asked_again_ = 0;   // how often one of them was taken out of its list since they were sifted
  bool is_sifting_worthwhile_ = true;
  std::vector<std::uint32_t> loose_;  // points in doubt in no list
  bool is_any_in_doubt_ = false;      // of the undecided ones
  bool settles_doubts_ = false;       // exactly, at once
  std::vector<std::uint32_t> seen_;
  std::vector<std::uint32_t> new_faces_;
  std::vector<HorizonEdge> horizon_;
};

}  // namespace graze::detail
