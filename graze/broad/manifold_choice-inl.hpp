// SPDX-License-Identifier: MIT
// LaneChoice of query/obb_choice.hpp for many pairs at a time: four corners of more than four, by the same calculations
// in float. Included once for each instruction set, hence no ordinary guard.
#if defined(GRAZE_BROAD_MANIFOLD_CHOICE_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BROAD_MANIFOLD_CHOICE_INL_HPP
#undef GRAZE_BROAD_MANIFOLD_CHOICE_INL_HPP
#else
#define GRAZE_BROAD_MANIFOLD_CHOICE_INL_HPP
#endif

#include <cstddef>
#include <limits>

#include <hwy/highway.h>

#include <graze/broad/manifold_clip-inl.hpp>
#include <graze/math/tolerance.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {

/// As many floats as there are pairs.
using FloatTag = hn::Rebind<float, Tag<double>>;
using Floats = hn::Vec<FloatTag>;

HWY_INLINE Floats all_floats(float value) { return hn::Set(FloatTag(), value); }
HWY_INLINE Floats narrowed(Doubles v) { return hn::DemoteTo(FloatTag(), v); }

/// The rank of the first corner of each pair.
HWY_INLINE Doubles first_rank(const ClipLanes& clip) {
  const Doubles none = both(std::numeric_limits<double>::infinity());
  return over_lines(Least(), [&](std::size_t s) { return hn::IfThenElse(clip.is_left(s), clip.rank(s), none); });
}

class ChoiceLanes {
 public:
  /// `on_incident` where the points are laid on the second box.
  HWY_INLINE ChoiceLanes(const ClipLanes& clip, const FaceLanes& incident, const Point& normal, DoublesMask on_incident)
      : first_(narrowed(first_rank(clip))), doubts_(all_floats(0)) {
    set_measures(clip, incident, normal, on_incident);
    const Doubles first = first_rank(clip);
    const auto at_first = [&](std::size_t k) {
      return over_lines(Common(), [&](std::size_t s) {
        const DoublesMask is_first = hn::And(clip.is_left(s), hn::Eq(clip.rank(s), first));
        return hn::IfThenElseZero(is_first, clip.within(s, k));
      });
    };
    const Doubles origin[2] = {at_first(0), at_first(1)};
    // What is not left counts as the first corner once more.
    for (std::size_t s = 0; s < clip_lines; ++s) {
      const auto seen = [&](std::size_t k) {
        return narrowed(hn::IfThenElseZero(clip.is_left(s), hn::Sub(clip.within(s, k), origin[k])));
      };
      x_[s] = seen(0);
      y_[s] = seen(1);
      rank_[s] = narrowed(hn::IfThenElse(clip.is_left(s), clip.rank(s), first));
    }
    run();
  }

  /// Whether a corner is one of the four.
  HWY_INLINE DoublesMask has(Doubles rank) const {
    const auto is = [&rank](Floats chosen) { return hn::Eq(rank, hn::PromoteTo(Tag<double>(), chosen)); };
    return hn::Or(hn::Or(is(chosen_[0]), is(chosen_[1])), hn::Or(is(chosen_[2]), is(chosen_[3])));
  }

  /// Where corners are too nearly as good as each other to say which is the first of the best.
  HWY_INLINE DoublesMask is_open() const { return hn::Gt(hn::PromoteTo(Tag<double>(), doubts_), both(0)); }

 private:
  struct Values {
    Floats at[clip_lines];
  };

  HWY_INLINE void set_measures(const ClipLanes& clip, const FaceLanes& face, const Point& normal,
                               DoublesMask on_incident) {
    const Doubles longest = max_of(dot(face.right, face.right), dot(face.up, face.up));
    const Doubles scale = hn::Div(both(1), longest);
    const Doubles flat[2] = {hn::IfThenZeroElse(on_incident, clip.climb(0)),
                             hn::IfThenZeroElse(on_incident, clip.climb(1))};
    const auto measured = [&](const Point& a, const Point& b, Doubles high) { return hn::Sub(dot(a, b), high); };
    xx_ = narrowed(hn::Mul(measured(face.right, face.right, hn::Mul(flat[0], flat[0])), scale));
    yy_ = narrowed(hn::Mul(measured(face.up, face.up, hn::Mul(flat[1], flat[1])), scale));
    xy_ = narrowed(hn::Mul(hn::Mul(both(2), measured(face.right, face.up, hn::Mul(flat[0], flat[1]))), scale));
    area_ = narrowed(hn::Mul(dot(cross(face.right, face.up), normal), scale));
    const Doubles down = hn::Neg(hn::Sqrt(longest));
    sink_[0] = narrowed(hn::Div(clip.climb(0), down));
    sink_[1] = narrowed(hn::Div(clip.climb(1), down));
  }

  HWY_INLINE void run() {
    const Floats equal = all_floats(static_cast<float>(tolerance::aligned));
    const Floats squared = largest(squared_from(all_floats(0), all_floats(0)));
    Values values;
    for (std::size_t s = 0; s < clip_lines; ++s) {
      values.at[s] = hn::Add(hn::Mul(x_[s], sink_[0]), hn::Mul(y_[s], sink_[1]));
    }
    choose(0, values, hn::Mul(equal, hn::Sqrt(squared)));
    const Floats start_x = at_chosen(0, x_);
    const Floats start_y = at_chosen(0, y_);
    const Floats slack = hn::Mul(equal, squared);
    choose(1, squared_from(start_x, start_y), slack);
    const Floats way_x = hn::Mul(hn::Sub(at_chosen(1, x_), start_x), area_);
    const Floats way_y = hn::Mul(hn::Sub(at_chosen(1, y_), start_y), area_);
    Values opposite;
    for (std::size_t s = 0; s < clip_lines; ++s) {
      values.at[s] = hn::Sub(hn::Mul(way_x, hn::Sub(y_[s], start_y)), hn::Mul(way_y, hn::Sub(x_[s], start_x)));
      opposite.at[s] = hn::Neg(values.at[s]);
    }
    choose(2, values, slack);
    choose(3, opposite, slack);
  }

  HWY_INLINE Values squared_from(Floats start_x, Floats start_y) const {
    Values result;
    for (std::size_t s = 0; s < clip_lines; ++s) {
      const Floats x = hn::Sub(x_[s], start_x);
      const Floats y = hn::Sub(y_[s], start_y);
      result.at[s] =
          hn::Add(hn::Mul(hn::Mul(x, x), xx_), hn::Add(hn::Mul(hn::Mul(y, y), yy_), hn::Mul(hn::Mul(x, y), xy_)));
    }
    return result;
  }

  HWY_INLINE static Floats largest(const Values& values) {
    return over_lines(Largest(), [&](std::size_t s) { return values.at[s]; });
  }

  /// What stands for the chosen corner once more has the same numbers.
  HWY_INLINE Floats at_chosen(std::size_t which, const Floats (&numbers)[clip_lines]) const {
    return over_lines(Common(),
                      [&](std::size_t s) { return hn::IfThenElseZero(hn::Eq(rank_[s], chosen_[which]), numbers[s]); });
  }

  /// The first of those as good as the best up to the slack, if it is the first corner or the only one.
  HWY_INLINE void choose(std::size_t which, const Values& values, Floats slack) {
    const Floats least = hn::Sub(largest(values), slack);
    const Floats none = all_floats(std::numeric_limits<float>::infinity());
    const Floats chosen =
        over_lines(Least(), [&](std::size_t s) { return hn::IfThenElse(hn::Ge(values.at[s], least), rank_[s], none); });
    const Floats count = over_lines(
        Total(), [&](std::size_t s) { return hn::IfThenElseZero(hn::Ge(values.at[s], least), all_floats(1)); });
    chosen_[which] = chosen;
    const auto is_clear = hn::Or(hn::Eq(chosen, first_), hn::Eq(count, all_floats(1)));
    if (hn::AllTrue(FloatTag(), is_clear)) return;
    doubts_ = hn::IfThenElse(hn::Or(is_clear, is_first_of_good(which, values, slack)), doubts_, all_floats(1));
  }

  /// Whether one corner after the other, each taken if it is better by more than the slack, ends with that one: it is
  /// better than all that are not as good as the best, and none is better than it.
  HWY_INLINE hn::Mask<FloatTag> is_first_of_good(std::size_t which, const Values& values, Floats slack) const {
    const Floats least = hn::Sub(largest(values), slack);
    const Floats value = at_chosen(which, values.at);
    const Floats limit = hn::Add(value, slack);
    auto result = hn::Lt(chosen_[which], all_floats(std::numeric_limits<float>::infinity()));
    for (std::size_t s = 0; s < clip_lines; ++s) {
      const auto is_good = hn::Ge(values.at[s], least);
      const auto is_less = hn::Gt(value, hn::Add(values.at[s], slack));
      result = hn::And(result, hn::And(hn::Le(values.at[s], limit), hn::Or(is_good, is_less)));
    }
    return result;
  }

  Floats first_;
  Floats doubts_;
  Floats xx_, yy_, xy_, area_;
  Floats sink_[2];
  Floats x_[clip_lines], y_[clip_lines], rank_[clip_lines];
  Floats chosen_[4];
};

}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
