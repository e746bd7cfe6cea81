// SPDX-License-Identifier: MIT
// Which parts of a compound may be the first to touch a shape, if the compound translates. Include shape_cast.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/impact.hpp>
#include <graze/query/parts/visit.hpp>
#include <graze/query/ray/parts.hpp>
#include <graze/query/ray/verdict.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze::detail {

/// The box of all points that a box passes as it moves.
template <Dim N, class T>
Aabb<N, double> box_swept_by(const Aabb<N, T>& box, const Vec<N, double>& motion) {
  Aabb<N, double> swept{wide<N, T>(box.min), wide<N, T>(box.max)};
  swept.grow(Aabb<N, double>{swept.min + motion, swept.max + motion});
  return swept;
}

/// For `visit_parts`: whether what moves by `motion` may come as near as `distance` to a fixed box, the target, which
/// is grown as by touching_bounds.
template <Dim N, class T>
class MayReach {
 public:
  MayReach(const Vec<N, double>& motion, const Aabb<N, T>& target, double distance)
      : motion_(motion),
        target_{wide<N, T>(target.min) - distance, wide<N, T>(target.max) + distance},
        size_(static_cast<double>(size_of_box(target)) + distance + sum_abs(motion)),
        is_target_bounded_(is_bounded(target)),
        line_(Path<N>{Vec<N, double>(0.0), motion, 1}) {}

  /// Ends the motion at t.
  void end_at(double t) {
    end_ = t;
    line_.end_at(t);
  }

  /// Where the motion brings a box, grown likewise, to the target, up to the end; NaN if it does not. An impact with a
  /// part in the box may be reported early by at most a few times `tolerance::impact`, relative to the sizes and the
  /// motion; the key is early by as much.
  double key(const Aabb<N, T>& box) const {
    const double size = size_ + static_cast<double>(std::max(max_abs(box.min), max_abs(box.max)));  // or infinity
    const double margin = 16 * tolerance::impact * size;
    const Aabb<N, double> target{target_.min - margin, target_.max + margin};
    if (!boxes_overlap(box_swept_by(box, motion_ * end_), target)) return std::numeric_limits<double>::quiet_NaN();
    if (!(size < 0x1p500) || !is_target_bounded_) return 0;
    return line_.key(difference_of(target, box));
  }
  bool admits(double key) const { return line_.admits(key); }

  bool operator()(const Aabb<N, T>& box) const { return admits(key(box)); }
  bool operator()(const Part<N, T>& part) const { return (*this)(touching_bounds(part.box)) || is_hidden_by_box(part); }

 private:
  /// The positions, relative to its own, at which a box touches the target. Where the motion is not along an axis, the
  /// line to them says more than the swept box.
  static Aabb<N, double> difference_of(const Aabb<N, double>& target, const Aabb<N, T>& box) {
    return {target.min - wide<N, T>(box.max), target.max - wide<N, T>(box.min)};
  }

  Vec<N, double> motion_;
  Aabb<N, double> target_;
  double size_;
  bool is_target_bounded_;
  double end_ = 1;
  RestOfPath<N> line_;  ///< From zero along the motion.
};

/// Whether the impact of one part counts instead of that of another one.
template <Dim N>
bool comes_before(const CastHit<N>& a, std::size_t index_a, const CastHit<N>& b, std::size_t index_b) {
  if (a.t != b.t) return a.t < b.t;
  return a.depth != b.depth ? a.depth > b.depth : index_a < index_b;
}

/// The first part to touch the shape, of several the first in order. `cast(part)` casts one. After a part has touched,
/// only the motion before that matters for the others. `motion` is that of the parts relative to the shape; a part
/// touches when it is as near as `distance`. Of parts that touch at one t the deepest counts.
template <Dim N, class T, template <Dim, class> class Whole, class S, class Cast>
std::optional<CastHit<N>> cast_hit_of_parts(const Whole<N, T>& whole, const Vec<N, double>& motion, const S& shape,
                                            double distance, const Cast& cast) {
  std::optional<CastHit<N>> best;
  std::size_t best_index = 0;
  MayReach<N, T> may_reach(motion, touching_bounds(shape), distance);
  const auto visit = [&](const auto& part, std::size_t index) {
    const std::optional<CastHit<N>> found = cast(part.shape);
    if (!found || (best && !comes_before(*found, index, *best, best_index))) return true;
    best = found;
    best_index = index;
    may_reach.end_at(found->t);
    return true;
  };
  visit_parts(whole, may_reach, ByKey(), PartVisitor<Whole<N, T>>(visit));
  return best;
}

}  // namespace graze::detail
