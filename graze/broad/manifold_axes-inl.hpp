// SPDX-License-Identifier: MIT
// The axis of least depth of many pairs of oriented boxes: first which of the fifteen it can be, as query/obb_axes.hpp
// finds out, then the choice among those as MeetingObbs makes it. Included once for each instruction set, hence no
// ordinary guard.
#if defined(GRAZE_BROAD_MANIFOLD_AXES_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BROAD_MANIFOLD_AXES_INL_HPP
#undef GRAZE_BROAD_MANIFOLD_AXES_INL_HPP
#else
#define GRAZE_BROAD_MANIFOLD_AXES_INL_HPP
#endif

#include <cstddef>
#include <limits>

#include <hwy/highway.h>

#include <graze/broad/manifold_lanes-inl.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/query/obb_touch.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {

/// How far axes are from orthonormal.
HWY_INLINE Doubles skew_of_axes(const BoxLanes& box) {
  auto skew = both(0);
  for (Dim i = 0; i < 3; ++i) {
    skew = hn::Max(skew, hn::Abs(hn::Sub(inner(box.axes[i], box.axes[i]), both(1))));
    skew = hn::Max(skew, hn::Abs(inner(box.axes[i], box.axes[(i + 1) % 3])));
  }
  return skew;
}

/// Which axes the search may not leave out, by their places: those of ObbAxes, or a few more or less that do not matter
/// for the same reason. The gaps are those of axes_of in query/obb_axes.hpp in double, the bands the same.
struct AxesLanes {
  DoublesMask candidates[15];
  DoublesMask is_known;

  HWY_INLINE explicit AxesLanes(const BoxPair& pair) {
    see(pair.box[0], pair.box[1]);
    const Doubles skew = hn::Add(hn::Max(skew_of_axes(pair.box[0]), skew_of_axes(pair.box[1])),
                                 both(static_cast<double>(tolerance::measured_skew<float>)));
    Doubles gaps[15];
    const Doubles size = find_face_gaps(pair, gaps);
    const Doubles band = hn::Mul(hn::Mul(both(tolerance::box_filter), skew), size);
    Doubles widest = gaps[0];
    for (std::size_t i = 1; i < 6; ++i) widest = hn::Max(widest, gaps[i]);
    is_known = hn::And(hn::And(hn::Gt(size, both(0x1p-30)), hn::Lt(size, both(0x1p30))), hn::Le(widest, band));

    Doubles squared_length[9];
    Doubles least_squared = hn::Mul(size, size);
    for (Dim i = 0; i < 3; ++i) {
      for (Dim j = 0; j < 3; ++j) {
        const Dim k = 3 * i + j;
        gaps[6 + k] = gap_across_edges(pair, i, j);
        squared_length[k] = hn::MulAdd(along_[i1(i)][j], along_[i1(i)][j], hn::Mul(along_[i2(i)][j], along_[i2(i)][j]));
        const Doubles deepest = hn::Sub(gaps[6 + k], band);
        least_squared =
            hn::Min(least_squared, hn::Div(hn::Mul(deepest, deepest), hn::Max(squared_length[k], both(1e-30))));
      }
    }
    const Doubles least = hn::Sub(hn::Max(hn::Sub(widest, band), hn::Neg(hn::Sqrt(least_squared))), band);
    for (std::size_t i = 0; i < 6; ++i) candidates[i] = hn::Ge(gaps[i], least);
    const Doubles squared_least = hn::Mul(hn::Mul(both(1.001), least), least);
    for (std::size_t k = 0; k < 9; ++k) {
      const Doubles short_by = hn::Add(gaps[6 + k], band);
      candidates[6 + k] = hn::Or(hn::Ge(short_by, both(0)),
                                 hn::Le(hn::Mul(short_by, short_by), hn::Mul(squared_length[k], squared_least)));
    }
  }

 private:
  HWY_INLINE static Dim i1(Dim i) { return (i + 1) % 3; }
  HWY_INLINE static Dim i2(Dim i) { return (i + 2) % 3; }

  HWY_INLINE void see(const BoxLanes& a, const BoxLanes& b) {
    for (Dim i = 0; i < 3; ++i) {
      between_[i] = inner(a.axes[i], b.center);
      for (Dim j = 0; j < 3; ++j) {
        along_[i][j] = inner(a.axes[i], b.axes[j]);
        shadow_[i][j] = hn::Abs(along_[i][j]);
      }
    }
  }

  /// Returns the size of both.
  HWY_INLINE Doubles find_face_gaps(const BoxPair& pair, Doubles (&gaps)[15]) const {
    const BoxLanes& a = pair.box[0];
    const BoxLanes& b = pair.box[1];
    Doubles size = both(0);
    for (Dim i = 0; i < 3; ++i) {
      Doubles reach = a.half[i];
      Doubles reach_of_b = b.half[i];
      for (Dim j = 0; j < 3; ++j) {
        reach = hn::MulAdd(b.half[j], shadow_[i][j], reach);
        reach_of_b = hn::MulAdd(a.half[j], shadow_[j][i], reach_of_b);
      }
      gaps[i] = hn::Sub(hn::Abs(between_[i]), reach);
      gaps[3 + i] = hn::Sub(hn::Abs(inner(b.axes[i], b.center)), reach_of_b);
      size = hn::Add(size, hn::Add(hn::Abs(between_[i]), reach));
    }
    return size;
  }

  HWY_INLINE Doubles gap_across_edges(const BoxPair& pair, Dim i, Dim j) const {
    const Doubles along = hn::NegMulAdd(between_[i1(i)], along_[i2(i)][j], hn::Mul(between_[i2(i)], along_[i1(i)][j]));
    const BoxLanes& a = pair.box[0];
    const BoxLanes& b = pair.box[1];
    Doubles gap = hn::NegMulAdd(a.half[i1(i)], shadow_[i2(i)][j], hn::Abs(along));
    gap = hn::NegMulAdd(a.half[i2(i)], shadow_[i1(i)][j], gap);
    gap = hn::NegMulAdd(b.half[i1(j)], shadow_[i][i2(j)], gap);
    return hn::NegMulAdd(b.half[i2(j)], shadow_[i][i1(j)], gap);
  }

  Doubles between_[3];
  Doubles along_[3][3];
  Doubles shadow_[3][3];
};

HWY_INLINE DoublesMask are_equal(const Point& a, const Point& b) {
  return hn::And(hn::And(hn::Eq(a.at[0], b.at[0]), hn::Eq(a.at[1], b.at[1])), hn::Eq(a.at[2], b.at[2]));
}

HWY_INLINE Doubles product_error(Doubles a, Doubles b, Doubles product) { return hn::MulSub(a, b, product); }

/// As in math/rounding.hpp.
HWY_INLINE Doubles difference_of_products(Doubles a, Doubles b, Doubles c, Doubles d) {
  const Doubles first = hn::Mul(a, b);
  const Doubles second = hn::Mul(c, d);
  const Doubles error = hn::Sub(product_error(a, b, first), product_error(c, d, second));
  const Doubles negative = hn::Neg(second);
  const Doubles value = hn::Add(first, negative);
  const Doubles b_part = hn::Sub(value, first);
  const Doubles a_part = hn::Sub(value, b_part);
  const Doubles rest = hn::Add(hn::Sub(first, a_part), hn::Sub(negative, b_part));
  return hn::Add(value, hn::Add(rest, error));
}

/// As in query/zonotope.hpp.
HWY_INLINE Point cross_of_directions(const Point& a, const Point& b) {
  const Point product = cross(a, b);
  const Doubles least = hn::Mul(hn::Mul(both(1.0 / 64), dot(a, a)), dot(b, b));
  const Point accurate{{difference_of_products(a.at[1], b.at[2], a.at[2], b.at[1]),
                        difference_of_products(a.at[2], b.at[0], a.at[0], b.at[2]),
                        difference_of_products(a.at[0], b.at[1], a.at[1], b.at[0])}};
  return one_of(hn::Gt(dot(product, product), least), product, accurate);
}

/// The search among several axes as MeetingObbs::search makes it, in the lanes that need one.
class SearchLanes {
 public:
  HWY_INLINE SearchLanes(const BoxPair& pair, const AxesLanes& axes, DoublesMask searched)
      : pair_(pair),
        size_(hn::Add(size_of(pair.box[0]), size_of(pair.box[1]))),
        margin_(hn::Mul(both(tolerance::rounding), size_)),
        gap_(both(-std::numeric_limits<double>::infinity())),
        place_(both(0)),
        is_open_(no_lane()) {
    for (std::size_t i = 0; i < 15; ++i) {
      const DoublesMask tried = hn::And(searched, axes.candidates[i]);
      if (hn::AllFalse(Tag<double>(), tried)) continue;
      const auto place = static_cast<Dim>(i);
      if (place < 6) {
        try_face(place, tried);
      } else {
        try_edges(place, tried);
      }
    }
  }

  Doubles place() const { return place_; }
  /// Where the axis is across edges that are nearly parallel.
  DoublesMask is_open() const { return is_open_; }

 private:
  HWY_INLINE void take(Dim place, Doubles gap, DoublesMask better) {
    gap_ = hn::IfThenElse(better, gap, gap_);
    place_ = hn::IfThenElse(better, both(static_cast<double>(place)), place_);
    is_open_ = hn::AndNot(better, is_open_);
  }

  HWY_INLINE void try_face(Dim place, DoublesMask tried) {
    const bool of_b = place >= 3;
    const Doubles gap =
        axis_of_face(pair_.box[of_b ? 1 : 0], place % 3, pair_.box[of_b ? 0 : 1], pair_.box[1].center).gap;
    take(place, gap, hn::And(tried, hn::Gt(gap, hn::Add(gap_, margin_))));
  }

  HWY_INLINE void try_edges(Dim place, DoublesMask tried) {
    const BoxLanes& a = pair_.box[0];
    const BoxLanes& b = pair_.box[1];
    const Dim i = (place - 6) / 3;
    const Dim j = (place - 6) % 3;
    const EdgesLanes edges(a, i, b, j);
    const DoublesMask is_wide = hn::Gt(edges.squared, both(least_squared_sine));
    take_edges(place, edges, hn::And(tried, is_wide));
    const DoublesMask careful = hn::AndNot(hn::Or(is_wide, are_equal(a.axes[i], b.axes[j])), tried);
    if (hn::AllFalse(Tag<double>(), careful)) return;
    const EdgesLanes known(a, i, b, j, cross_of_directions(a.axes[i], b.axes[j]));
    is_open_ = hn::Or(is_open_, take_edges(place, known, hn::And(careful, hn::Gt(known.squared, both(0)))));
  }

  /// Where they are better. What was taken before is forgotten.
  HWY_INLINE DoublesMask take_edges(Dim place, const EdgesLanes& edges, DoublesMask tried) {
    const Doubles gap = edges.gap();
    const Doubles least = hn::Add(gap_, margin_);
    const Doubles squares = hn::Mul(hn::Mul(least, least), edges.squared);
    const Doubles squared_gap = hn::Mul(gap, gap);
    const DoublesMask is_below = hn::Lt(least, both(0));
    const DoublesMask better_apart = hn::Or(is_below, hn::Gt(squared_gap, squares));
    const DoublesMask better_deep = hn::And(is_below, hn::Lt(squared_gap, squares));
    const DoublesMask is_apart = hn::Ge(gap, both(0));
    const DoublesMask better =
        hn::And(tried, hn::Or(hn::And(is_apart, better_apart), hn::AndNot(is_apart, better_deep)));
    take(place, hn::Div(gap, hn::Sqrt(edges.squared)), better);
    return better;
  }

  const BoxPair& pair_;
  Doubles size_;
  Doubles margin_;
  Doubles gap_;
  Doubles place_;
  DoublesMask is_open_;
};

/// The axis of each pair by its place, or 15 where it is not clear.
HWY_INLINE Doubles axis_places(const BoxPair& pair) {
  const Tag<double> d;
  const AxesLanes axes(pair);
  Doubles place = both(0);
  Doubles count = both(0);
  for (std::size_t i = 0; i < 15; ++i) {
    place = hn::IfThenElse(axes.candidates[i], both(static_cast<double>(i)), place);
    count = hn::Add(count, hn::IfThenElseZero(axes.candidates[i], both(1)));
  }
  const DoublesMask is_one = hn::And(axes.is_known, hn::Eq(count, both(1)));
  const DoublesMask are_several = hn::And(axes.is_known, hn::Gt(count, both(1)));
  Doubles result = hn::IfThenElse(is_one, place, both(15));
  if (!hn::AllFalse(d, are_several)) {
    const SearchLanes search(pair, axes, are_several);
    result = hn::IfThenElse(hn::AndNot(search.is_open(), are_several), search.place(), result);
  }
  return result;
}

}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
