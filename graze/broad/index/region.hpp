// SPDX-License-Identifier: MIT
// The regions of queries on a spatial index, and how they prune.
#pragma once

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <graze/broad/index/box_limits.hpp>
#include <graze/broad/index/frustum_filter.hpp>
#include <graze/broad/index/path_filter.hpp>
#include <graze/math/platform/throw.hpp>
#include <graze/math/rounding.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/intersects.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/frustum.hpp>
#include <graze/shape/ray.hpp>
#include <graze/shape/segment.hpp>
#include <graze/shape/shape.hpp>

namespace graze {

/// A region that a spatial index can be queried with: any shape, a frustum, or a user's type with `support`. Indexes
/// prune by its bounding box, so unbounded regions cost more.
template <class R, Dim N, class T>
concept RegionIn = SameSpace<R, Aabb<N, T>> && requires(const R& region) {
  { bounds(region) } -> std::same_as<Aabb<N, T>>;
};

/// A region extended by the rounding error of `intersects`, to find candidates: every shape that touches the region
/// according to `intersects` is in a box that meets the inflated region. For unbounded compounds this holds for the box
/// from `touching_bounds`.
template <Shape R>
struct Inflated {
  const R& region;  ///< Must outlive this object.
};

template <Shape R>
struct ShapeTraits<Inflated<R>> : Space<dimension_of<R>, scalar_of<R>> {};

/// The box of the region itself.
template <Shape R>
Aabb<dimension_of<R>, scalar_of<R>> bounds(const Inflated<R>& inflated) {
  return bounds(inflated.region);
}

namespace detail {

template <Dim N, class T>
bool has_nan_coordinate(const Aabb<N, T>& box) {
  for (Dim i = 0; i < N; ++i) {
    if (std::isnan(box.min[i]) || std::isnan(box.max[i])) return true;
  }
  return false;
}

[[noreturn]] inline void refuse_nan_in_region() {
  GRAZE_THROW(std::invalid_argument("SpatialIndex: the region has a coordinate that is not a number"));
}

/// The largest magnitude of the finite coordinates.
template <Dim N, class T>
double finite_size(const Aabb<N, T>& box) {
  double size = 0;
  for (Dim i = 0; i < N; ++i) {
    for (const T side : {box.min[i], box.max[i]}) {
      const double magnitude = std::fabs(static_cast<double>(side));
      if (magnitude < std::numeric_limits<double>::infinity() && magnitude > size) size = magnitude;
    }
  }
  return size;
}

/// Branch-free boxes_overlap, for unpredictable answers.
template <Dim N, class T>
bool boxes_overlap_at_once(const Aabb<N, T>& a, const Aabb<N, T>& b) {
  unsigned apart = 0;
  for (Dim i = 0; i < N; ++i) {
    apart |= static_cast<unsigned>(!(a.min[i] <= b.max[i])) | static_cast<unsigned>(!(b.min[i] <= a.max[i]));
  }
  return apart == 0;
}

/// The intersection of two boxes; none if they do not overlap.
template <Dim N, class T>
Aabb<N, T> shared_box(const Aabb<N, T>& a, const Aabb<N, T>& b) {
  Aabb<N, T> shared;
  for (Dim i = 0; i < N; ++i) {
    shared.min[i] = a.min[i] > b.min[i] ? a.min[i] : b.min[i];
    shared.max[i] = a.max[i] < b.max[i] ? a.max[i] : b.max[i];
  }
  return shared;
}

/// Decides most boxes before `intersects` is called; most regions have nothing but their bounds.
template <class R>
struct RegionFilter {
  static constexpr bool exists = false;
  explicit RegionFilter(const R&) {}
};

template <Dim N, class T>
struct RegionFilter<Frustum<N, T>> : FrustumFilter<N> {
  static constexpr bool exists = true;
  using FrustumFilter<N>::FrustumFilter;
};

template <Dim N, class T>
struct RegionFilter<Ray<N, T>> : PathFilter<N> {
  static constexpr bool exists = true;
  using PathFilter<N>::PathFilter;
};

template <Dim N, class T>
struct RegionFilter<RayUntil<N, T>> : PathFilter<N> {
  static constexpr bool exists = true;
  using PathFilter<N>::PathFilter;
};

template <Dim N, class T>
struct RegionFilter<Segment<N, T>> : PathFilter<N> {
  static constexpr bool exists = true;
  using PathFilter<N>::PathFilter;
};

/// A region during one query. A box meets it if `intersects(region, box)`. A box with infinite sides is first clipped
/// to the region's bounds; if it is still infinite, the bounds decide. Throws std::invalid_argument for an invalid
/// region.
template <Shape R>
class RegionProbe {
 public:
  static constexpr Dim N = dimension_of<R>;
  using T = scalar_of<R>;
  using Box = Aabb<N, T>;

  explicit RegionProbe(const R& region) : region_(region), bounds_(sized_box(region, bounds(region))), filter_(region) {
    if constexpr (requires { defect(region); }) {
      if (!is_valid(region))
        GRAZE_THROW(std::invalid_argument("SpatialIndex: the region " + std::string(defect(region))));
    }
    if (has_nan_coordinate(bounds_)) refuse_nan_in_region();
    slack_ = band * finite_size(bounds_);
  }

  /// False only if no box inside this one meets the region. The box is finite, or that of a single object.
  bool may_meet(const Box& box) const {
    const double slack = slack_with(box);
    for (Dim i = 0; i < N; ++i) {
      const double above = static_cast<double>(box.min[i]) - static_cast<double>(bounds_.max[i]);
      const double below = static_cast<double>(bounds_.min[i]) - static_cast<double>(box.max[i]);
      if (!(above <= slack && below <= slack)) return false;  // an empty region gives NaN or infinity
    }
    return true;
  }

  static constexpr bool is_box = false;

  /// A box that overlaps every box with coordinates up to `size` that may meet the region.
  Box reach(double size) const {
    const double slack = 2 * (slack_ + band * size);  // may_meet rounds, too
    Box box;
    for (Dim i = 0; i < N; ++i) {
      box.min[i] = round_down<T>(static_cast<double>(bounds_.min[i]) - slack);
      box.max[i] = round_up<T>(static_cast<double>(bounds_.max[i]) + slack);
    }
    return box;
  }

  /// For a box that may meet the region's bounds: whether it may meet the region itself. More expensive; use it where
  /// it can prune much.
  bool may_meet_closely(const Box& box) const {
    if (is_nothing(box)) return false;
    if constexpr (RegionFilter<R>::exists) {
      return !filter_.part(box, slack_with(box));
    } else {
      return intersects(region_, inflated(box, round_up<T>(slack_with(box))));
    }
  }

  bool meets(const Box& box) const {
    if (!may_meet(box)) return false;
    if (is_valid(box)) return meets_finite(box);
    const Box near = shared_box(box, bounds_);
    return is_valid(near) ? meets_finite(near) : !is_nothing(near);
  }

 private:
  /// Greater than the band in which `intersects` reports touching for separate shapes; a user's shape may calculate in
  /// T.
  static constexpr double band =
      SupportsIn<R, N, double> || !SupportsIn<R, N, T> ? tolerance::box_slack : 4 * tolerance::convex_in<T>;

  double slack_with(const Box& box) const { return slack_ + band * finite_size(box); }

  bool meets_finite(const Box& box) const {
    if constexpr (RegionFilter<R>::exists) {
      if (filter_.part(box, slack_with(box))) return false;
      if (filter_.share_point(box, slack_with(box))) return true;
    }
    return intersects(region_, box);
  }

  const R& region_;
  Box bounds_;
  double slack_ = 0;
  RegionFilter<R> filter_;
};

/// Like the region itself, but a box may be off by the slack. A box with infinite sides is met if its bounds may be
/// met.
template <Shape R>
class RegionProbe<Inflated<R>> {
 public:
  using Box = typename RegionProbe<R>::Box;

  explicit RegionProbe(const Inflated<R>& inflated) : probe_(inflated.region) {}

  static constexpr bool is_box = false;

  bool may_meet(const Box& box) const { return probe_.may_meet(box); }
  Box reach(double size) const { return probe_.reach(size); }
  bool may_meet_closely(const Box& box) const { return probe_.may_meet_closely(box); }
  bool meets(const Box& box) const { return may_meet(box) && (!is_valid(box) || may_meet_closely(box)); }

 private:
  RegionProbe<R> probe_;
};

/// A box as region, tested exactly. It may have infinite sides; with min above max it is empty, and nothing meets it.
template <Dim M, class U>
class RegionProbe<Aabb<M, U>> {
 public:
  using Box = Aabb<M, U>;

  /// Always inlined: a walk with a box is so short that loading these members twice would matter.
  [[gnu::always_inline]] explicit RegionProbe(const Box& region) : region_(region) {
    if (has_nan_coordinate(region)) refuse_nan_in_region();
    if (is_nothing(region)) region_.min = Vec<M, U>(std::numeric_limits<U>::quiet_NaN());  // overlaps no box at all
    limits_ = BoxLimits<M, U>(region_);
  }

  static constexpr bool is_box = true;  // meets every box that shares a point with its reach

  bool may_meet(const Box& box) const { return limits_.meets(box); }
  Box reach(double /*size*/) const { return region_; }
  bool may_meet_closely(const Box&) const { return true; }  // nothing is tighter than may_meet
  bool meets(const Box& box) const { return limits_.meets(box); }

 private:
  Box region_;
  BoxLimits<M, U> limits_{region_};
};

}  // namespace detail
}  // namespace graze
