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

#include <graze/math/exact/exact_determinant.hpp>
#include <graze/math/platform/throw.hpp>
#include <graze/math/rounding.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/hull/base.hpp>
#include <graze/shape/hull/frame.hpp>
#include <graze/shape/hull/point_buffer.hpp>

namespace graze::detail {

/// Grows a 3D convex hull face by face, adding the point farthest outside a face. Barber, Dobkin, Huhdanpaa, "The
/// Quickhull Algorithm for Convex Hulls" (1996), with exact tests of sides instead of tolerances: a point outside a
/// face is strictly outside, so the faces that see it form a disk, no new face is degenerate, and each point that is
/// still outside sees one of the new faces.
///
/// Points whose side is uncertain in double are set aside until all others are decided. If many points are collinear or
/// coplanar up to rounding, only few of them then need an exact decision; see undecided_points.hpp. The points outside
/// of faces are on one stack, those of the newest faces on top. The newest face grows first, so memory is accessed in
/// order.
template <class T>
class Quickhull {
 public:
  static constexpr std::uint32_t none = HullPoint::none;

  /// A half-edge is 4 * face + side; side i runs from corner i to the next, counter-clockwise seen from outside.
  struct Face {
    HullPlane plane;
    std::array<std::uint32_t, 3> corners{};  ///< Indices into `corners`.
    std::array<std::uint32_t, 3> twins{};    ///< The opposite half-edges, of the neighbours.
    std::size_t first = 0;                   ///< Begin of the range of points that see the face, on the stack.
    std::size_t last = 0;                    ///< End of that range.
    std::size_t farthest = 0;                ///< Of these points, approximately.
    std::uint32_t whole = none;              ///< Index of its plane in integer units, once needed.
    bool is_alive = true;
    bool is_waiting = false;  ///< Has points outside.
    bool sees = false;        ///< Sees the point that is being added.
    bool has_whole = false;   ///< False if the plane at that index belongs to an earlier face.
  };

  /// An empty hull, which only holds memory.
  Quickhull() = default;

  /// The hull of candidates: some points of the frame, at least one, including all its corners. Undecided points are
  /// set aside until they are added. The frame must outlive the hull.
  Quickhull(const HullFrame<T>& frame, std::vector<HullPoint> candidates) { start(frame, candidates); }

  /// The same, reusing the memory of the previous hull. `candidates` is swapped with an empty list that has memory. If
  /// `settles_undecided`, undecided points are decided exactly at once; none is set aside, and the hull is complete.
  void start(const HullFrame<T>& frame, std::vector<HullPoint>& candidates, bool settles_undecided = false) {
    frame_ = &frame;
    undecided_.swap(candidates);
    candidates.clear();
    forget_faces();
    used_ = 0;
    aside_.clear();
    integer_points_.clear();
    settles_undecided_ = settles_undecided;
    if (settles_undecided) {
      integer_points_.reserve(frame.size());
      for (std::uint32_t i = 0; i < frame.size(); ++i) integer_points_.push_back(frame.integer_point(i));
    }
    base_ = HullBase<T>(frame, undecided_);
    if (base().size() < 4) return;
    begin();
    grow_all();
  }

  /// A point and a face, by index.
  struct Facing {
    std::uint32_t face;
    std::uint32_t point;
  };

  /// The points that were set aside: undecided about one face, which may no longer exist or be another one now, and
  /// outside of no other. If there are none, the hull is complete.
  std::span<const Facing> aside() const { return aside_; }

  /// Returns the points that were set aside and clears the list.
  std::vector<Facing> take_aside() { return std::exchange(aside_, {}); }

  /// Adds those of the points that are strictly outside of their faces. The hull must be complete except for points set
  /// aside.
  void add_outside(std::vector<Facing> points) {
    std::sort(points.begin(), points.end(), [](const Facing& a, const Facing& b) { return a.face < b.face; });
    outside_.make_room(points.size(), 0);
    used_ = 0;
    for (auto i = points.begin(); i != points.end();) {
      const std::uint32_t face = i->face;
      undecided_.clear();
      for (; i != points.end() && i->face == face; ++i) undecided_.push_back(frame_->at(i->point));
      faces_[face].first = used_;
      divide_exactly(face);
      enqueue(face);
    }
    grow_all();
  }

  /// From now on, undecided points are decided exactly instead of being set aside.
  void settle_undecided() { settles_undecided_ = true; }

  /// Adds points, which must include all missing corners, and decides all of them exactly. Discards points set aside.
  void add(std::span<const std::uint32_t> points) {
    settle_undecided();
    aside_.clear();
    undecided_.clear();
    for (const std::uint32_t index : points) undecided_.push_back(frame_->at(index));
    used_ = 0;
    const std::size_t alive = faces_.size() - free_.size();
    // Compares the cost of testing all points against all faces with the cost of starting again with all points that
    // remain.
    constexpr std::size_t tests_of_a_point = 256;
    if (undecided_.size() * alive <= tests_of_a_point * (undecided_.size() + corners_.size())) {
      new_faces_.clear();
      for (std::uint32_t face = 0; face < faces_.size(); ++face) {
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

  /// Indices of points that span the affine hull of all, exactly: one if all coincide, two on a line, three in a plane,
  /// otherwise four.
  std::span<const std::uint32_t> base() const { return base_.places(); }

  /// The candidates if they have no volume; then there are no faces.
  std::span<const HullPoint> flat_candidates() const {
    return base().size() < 4 ? std::span<const HullPoint>(undecided_) : std::span<const HullPoint>();
  }

  const HullFrame<T>& frame() const { return *frame_; }

  /// The faces with `is_alive` form the surface of the hull: a closed mesh of triangles, none of them degenerate. Flat
  /// parts consist of several triangles. Empty if all points are coplanar.
  std::span<const Face> faces() const { return faces_; }

  /// The corners of faces, with their indices in the list of points. Some may be inside a flat part or an edge.
  std::span<const HullPoint> corners() const { return corners_; }

  std::uint32_t twin(std::uint32_t half_edge) const { return faces_[half_edge / 4].twins[half_edge % 4]; }
  std::uint32_t origin(std::uint32_t half_edge) const { return faces_[half_edge / 4].corners[half_edge % 4]; }

  /// The next half-edge around the face.
  static std::uint32_t next(std::uint32_t half_edge) { return half_edge % 4 == 2 ? half_edge - 2 : half_edge + 1; }

  /// Whether a point is strictly outside of a face, decided exactly.
  bool is_outside(std::uint32_t face, const HullPoint& point) { return height_of(face, point).value > 0; }

  /// The indices of the face's corners in the list of points.
  std::array<std::uint32_t, 3> indices_of(const Face& face) const {
    return {corners_[face.corners[0]].index, corners_[face.corners[1]].index, corners_[face.corners[2]].index};
  }

  /// Whether the faces on both sides of a half-edge are not coplanar, decided exactly.
  bool is_bent(std::uint32_t half_edge) const {
    const Face& face = faces_[half_edge / 4];
    const HullPoint& beyond = corners_[origin(next(next(twin(half_edge))))];
    if (face.plane.height(beyond.place) < -face.plane.doubt) return true;
    return !frame_->is_exact() && frame_->orientation_of(indices_of(face), beyond.index) != 0;
  }

 private:
  struct HorizonEdge {
    std::uint32_t from;
    std::uint32_t beyond;  ///< The half-edge of the face that remains.
  };

  IntegerPoint whole(std::uint32_t point) const {
    return integer_points_.empty() ? frame_->integer_point(point) : integer_points_[point];
  }

  /// A number with the exact sign of `orientation` of a face and a point, approximately proportional to the height.
  double exact_height(std::uint32_t place, std::uint32_t point) {
    Face& face = faces_[place];
    if (!face.has_whole) {
      const std::array<std::uint32_t, 3> corners = indices_of(face);
      const IntegerPlane plane = frame_->integer_plane({whole(corners[0]), whole(corners[1]), whole(corners[2])});
      if (face.whole == none) {
        face.whole = static_cast<std::uint32_t>(wholes_.size());
        wholes_.push_back(plane);
      } else {
        wholes_[face.whole] = plane;
      }
      face.has_whole = true;
    }
    const std::optional<double> height = wholes_[face.whole].height_of(whole(point));
    return height ? *height : frame_->orientation_of(indices_of(face), point);
  }

  /// The height of a point above a face; positive exactly if the point is strictly outside. Clear heights compare
  /// greater than all others, because the two kinds have different units.
  struct Height {
    double value = 0;
    bool is_clear = false;

    bool operator<(const Height& other) const {
      return is_clear == other.is_clear ? value < other.value : other.is_clear;
    }
  };

  Height height_of(std::uint32_t face, const HullPoint& point) {
    const HullPlane& plane = faces_[face].plane;
    const double height = plane.height(point.place);
    if (height > plane.doubt || height <= -plane.doubt) return {height, true};
    return {exact_height(face, point.index), false};
  }

  void forget_faces() {
    corners_.clear();
    faces_.clear();
    wholes_.clear();
    free_.clear();
    waiting_.clear();
  }

  /// Builds a tetrahedron and assigns the points to its faces.
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
    while (!waiting_.empty()) {
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
      if (faces_.size() == most) GRAZE_THROW(std::length_error("the convex hull has more than 2^30 triangles"));
      faces_.emplace_back();
    }
    Face& face = faces_[place];
    face.plane = frame_->plane(corners_[corners[0]], corners_[corners[1]], corners_[corners[2]]);
    face.corners = corners;
    face.twins = twins;
    face.first = face.last = 0;
    face.is_alive = true;
    face.is_waiting = face.sees = face.has_whole = false;
    return place;
  }

  /// Assigns each undecided point to the first new face that it is outside of, sets it aside, or drops it.
  void deal() {
    for (const std::uint32_t place : new_faces_) {
      if (undecided_.empty()) return;
      take_outside(place);
      enqueue(place);
    }
    for (const HullPoint& point : undecided_) {
      if (point.link != none) aside_.push_back({point.link, point.index});
    }
  }

  /// Queues a face if any point is outside of it; these are on the stack from `face.first` to the top.
  void enqueue(std::uint32_t place) {
    Face& face = faces_[place];
    face.last = used_;
    if (face.first == face.last) return;
    face.is_waiting = true;
    waiting_.push_back(place);
  }

  /// Whether the normal is parallel to an axis, so that `orientation` compares one coordinate only.
  static bool is_along_axes(const HullPlane& plane) {
    const Vec<3, double>& normal = plane.normal;
    return (normal.x == 0 ? 1 : 0) + (normal.y == 0 ? 1 : 0) + (normal.z == 0 ? 1 : 0) >= 2;
  }

  /// Moves the undecided points that are outside of a face to the stack.
  void take_outside(std::uint32_t place) {
    const std::size_t most = used_ + undecided_.size();
    outside_.make_room(most, used_);
    Face& face = faces_[place];
    face.first = used_;
    if (settles_undecided_ || is_along_axes(face.plane)) {
      divide_exactly(place);
    } else {
      divide_clear(place);
    }
  }

  void divide_exactly(std::uint32_t place) {
    Height largest;
    std::size_t kept = 0;
    for (const HullPoint& point : undecided_) {
      const Height height = height_of(place, point);
      if (!(height.value > 0)) {
        undecided_[kept++] = point;
        continue;
      }
      if (largest < height) {
        largest = height;
        faces_[place].farthest = used_;
      }
      outside_[used_++] = point;
    }
    undecided_.resize(kept);
  }

  /// Moves only the points that are outside by more than rounding. Each point is written to both lists, and one list
  /// advances: a branch would be mispredicted half of the time.
  void divide_clear(std::uint32_t place) {
    const HullPlane plane = faces_[place].plane;
    double largest = plane.doubt;
    HullPoint* const first = &outside_[used_];
    HullPoint* last = first;
    HullPoint* farthest = first;
    HullPoint* kept = undecided_.data();
    for (const HullPoint& undecided : undecided_) {
      const double height = plane.height(undecided.place);
      const std::uint32_t link = undecided.link;
      const std::uint32_t in_doubt = height > -plane.doubt ? ~std::uint32_t{0} : 0;
      const HullPoint point = undecided;  // a copy that stays in registers
      *last = point;
      *kept = point;
      kept->link = link ^ ((link ^ place) & in_doubt);
      farthest = height > largest ? last : farthest;
      largest = height > largest ? height : largest;
      last += height > plane.doubt ? 1 : 0;
      kept += height > plane.doubt ? 0 : 1;
    }
    undecided_.resize(static_cast<std::size_t>(kept - undecided_.data()));
    faces_[place].farthest = used_ + static_cast<std::size_t>(farthest - first);
    used_ += static_cast<std::size_t>(last - first);
  }

  /// Adds the farthest point outside of a face. The face must be the last one queued.
  void grow(std::uint32_t face) {
    const std::size_t top = faces_[face].first;
    const HullPoint point = outside_[faces_[face].farthest];
    outside_[faces_[face].farthest] = outside_[--faces_[face].last];
    find_horizon(face, point);
    undecided_.clear();
    for (const std::uint32_t seen : seen_) {
      Face& old = faces_[seen];
      undecided_.insert(undecided_.end(), outside_.at(old.first), outside_.at(old.last));
      old.is_alive = false;
      if (!old.is_waiting) free_.push_back(seen);
    }
    for (HullPoint& undecided : undecided_) undecided.link = none;
    used_ = top;  // everything above belongs to removed faces
    add_cone(point);
    deal();
  }

  /// Finds the faces that see a point and the horizon around them, in order.
  void find_horizon(std::uint32_t face, const HullPoint& point) {
    std::uint32_t start = none;
    seen_.assign(1, face);
    faces_[face].sees = true;
    for (std::size_t k = 0; k < seen_.size(); ++k) {
      const std::array<std::uint32_t, 3> twins = faces_[seen_[k]].twins;
      for (std::uint32_t side = 0; side < 3; ++side) {
        Face& other = faces_[twins[side] / 4];
        if (other.sees) continue;
        if (is_outside(twins[side] / 4, point)) {
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

  /// Adds a face from each horizon edge to a point.
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
  std::vector<IntegerPlane> wholes_;          // of some faces
  std::vector<IntegerPoint> integer_points_;  // of all points, or empty
  std::vector<std::uint32_t> free_;           // indices of removed faces
  std::vector<std::uint32_t> waiting_;        // faces with points outside when they were created, the newest last
  HullPointBuffer outside_;                   // the stack of these points, in the order of `waiting_`
  std::size_t used_ = 0;                      // size of that stack
  std::vector<Facing> aside_;                 // undecided points
  bool settles_undecided_ = false;            // decide exactly at once
  std::vector<std::uint32_t> seen_;
  std::vector<std::uint32_t> new_faces_;
  std::vector<HorizonEdge> horizon_;
};

}  // namespace graze::detail
