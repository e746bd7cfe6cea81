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

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include <hwy/highway.h>

#include <graze/broad/manifold_kernels.hpp>
#include <graze/broad/manifold_lanes-inl.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/query/obb_touch.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {

/// Bits of each pair.
using BitsTag = hn::RebindToUnsigned<Tag<double>>;

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
/// for the same reason; and whether the boxes meet. The gaps and the bands are those of axes_of in query/obb_axes.hpp,
/// in double.
struct AxesLanes {
  DoublesMask candidates[15];
  DoublesMask is_known;
  DoublesMask is_overlapping;
  DoublesMask is_apart;

  /// Where the faces of all pairs show that they are apart, nothing else is looked at.
  HWY_INLINE explicit AxesLanes(const BoxPair& pair) : is_known(no_lane()), is_overlapping(no_lane()) {
    see(pair.box[0], pair.box[1]);
    skew_ =
        hn::Add(hn::Max(skew_of_axes(pair.box[0]), skew_of_axes(pair.box[1])), both(tolerance::measured_skew<double>));
    size_ = find_face_gaps(pair);
    band_ = hn::Mul(hn::Mul(both(tolerance::box_filter), skew_), size_);
    widest_ = gaps_[0];
    for (std::size_t i = 1; i < 6; ++i) widest_ = hn::Max(widest_, gaps_[i]);
    const DoublesMask has_size = hn::And(hn::Gt(size_, both(0x1p-30)), hn::Lt(size_, both(0x1p30)));
    is_apart = hn::And(has_size, hn::Gt(widest_, band_));
    if (!hn::AllTrue(Tag<double>(), is_apart)) look_across_edges(pair, has_size);
  }

  /// Bit 3 i + j for axis i of the first box and j of the second that are at right angles to each other, or so nearly
  /// that they may be by the tolerance of manifolds and how far axes may be from orthonormal.
  HWY_INLINE hn::Vec<BitsTag> right_angles() const {
    constexpr double least = 1e-3;
    auto bits = hn::Zero(BitsTag());
    for (Dim i = 0; i < 3; ++i) {
      for (Dim j = 0; j < 3; ++j) {
        const auto bit = hn::BitCast(Tag<double>(), hn::Set(BitsTag(), std::uint64_t{1} << (3 * i + j)));
        const Doubles found = hn::IfThenElseZero(hn::Le(shadow_[i][j], both(least)), bit);
        bits = hn::Or(bits, hn::BitCast(BitsTag(), found));
      }
    }
    return bits;
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
  HWY_INLINE Doubles find_face_gaps(const BoxPair& pair) {
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
      gaps_[i] = hn::Sub(hn::Abs(between_[i]), reach);
      gaps_[3 + i] = hn::Sub(hn::Abs(inner(b.axes[i], b.center)), reach_of_b);
      size = hn::Add(size, hn::Add(hn::Abs(between_[i]), reach));
    }
    return size;
  }

  HWY_INLINE void look_across_edges(const BoxPair& pair, DoublesMask has_size) {
    const Doubles parallel = hn::Mul(both(2 * tolerance::box_filter), skew_);
    const Doubles squared_parallel = hn::Mul(hn::Mul(both(0.5), parallel), parallel);
    Doubles squared_length[9];
    Doubles least_squared = hn::Mul(size_, size_);
    Doubles widest_across = hn::Neg(size_);
    DoublesMask are_open = no_lane();
    for (Dim i = 0; i < 3; ++i) {
      for (Dim j = 0; j < 3; ++j) {
        const Dim k = 3 * i + j;
        const Doubles gap = gap_across_edges(pair, i, j);
        gaps_[6 + k] = gap;
        squared_length[k] = hn::MulAdd(along_[i1(i)][j], along_[i1(i)][j], hn::Mul(along_[i2(i)][j], along_[i2(i)][j]));
        const Doubles deepest = hn::Sub(gap, band_);
        least_squared =
            hn::Min(least_squared, hn::Div(hn::Mul(deepest, deepest), hn::Max(squared_length[k], both(1e-30))));
        widest_across = hn::Max(widest_across, gap);
        are_open = hn::Or(are_open,
                          hn::And(hn::Ge(hn::Add(gap, band_), both(0)), hn::Ge(squared_length[k], squared_parallel)));
      }
    }
    is_apart = hn::Or(is_apart, hn::And(has_size, hn::Gt(widest_across, band_)));
    is_known = hn::AndNot(is_apart, has_size);
    is_overlapping = hn::And(is_known, hn::AndNot(are_open, hn::Lt(widest_, hn::Mul(both(-8), band_))));
    find_candidates(squared_length, least_squared);
  }

  HWY_INLINE void find_candidates(const Doubles (&squared_length)[9], Doubles least_squared) {
    const Doubles least = hn::Sub(hn::Max(hn::Sub(widest_, band_), hn::Neg(hn::Sqrt(least_squared))), band_);
    for (std::size_t i = 0; i < 6; ++i) candidates[i] = hn::Ge(gaps_[i], least);
    const Doubles squared_least = hn::Mul(hn::Mul(both(1.001), least), least);
    for (std::size_t k = 0; k < 9; ++k) {
      const Doubles short_by = hn::Add(gaps_[6 + k], band_);
      candidates[6 + k] = hn::Or(hn::Ge(short_by, both(0)),
                                 hn::Le(hn::Mul(short_by, short_by), hn::Mul(squared_length[k], squared_least)));
    }
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
  Doubles skew_;
  Doubles size_;
  Doubles band_;
  Doubles widest_;  ///< Of the gaps across faces.
  Doubles gaps_[15];
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
#pragma GCC unroll 15
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

/// Whether a face may look along the axis at a place, other than the one that it is the normal of, given which axes are
/// at right angles. The normal of the second box' face is then along an axis of the first and across the two others;
/// that across two edges is along an axis of one box, to which the other's edge is at right angles.
HWY_INLINE bool may_be_along_face(std::size_t place, std::uint64_t right_angles) {
  static constexpr auto bits = [] {
    std::array<std::uint64_t, 16> result{};
    const auto bit = [](std::size_t i, std::size_t j) { return std::uint64_t{1} << (3 * (i % 3) + j % 3); };
    for (std::size_t i = 0; i < 3; ++i) {
      result[3 + i] = bit(0, i) | bit(1, i) | bit(2, i);
      for (std::size_t j = 0; j < 3; ++j) {
        result[6 + 3 * i + j] = bit(i + 1, j) | bit(i + 2, j) | bit(i, j + 1) | bit(i, j + 2);
      }
    }
    return result;
  }();
  const std::uint64_t found = right_angles & bits[place];
  return place < 6 ? (found & (found - 1)) != 0 : found != 0;
}

/// As ObbsLook.
struct LooksLanes {
  Doubles place;
  hn::Vec<BitsTag> right_angles;
  DoublesMask is_overlapping;
  DoublesMask is_apart;

  HWY_INLINE explicit LooksLanes(const BoxPair& pair) {
    const AxesLanes axes(pair);
    is_overlapping = axes.is_overlapping;
    is_apart = axes.is_apart;
    right_angles = axes.right_angles();
    place = both(ObbsLook::no_axis);
    if (hn::AllTrue(Tag<double>(), is_apart)) return;
    place = both(0);
    Doubles count = both(0);
    for (std::size_t i = 0; i < 15; ++i) {
      place = hn::IfThenElse(axes.candidates[i], both(static_cast<double>(i)), place);
      count = hn::Add(count, hn::IfThenElseZero(axes.candidates[i], both(1)));
    }
    const DoublesMask are_several = hn::And(axes.is_known, hn::Gt(count, both(1)));
    const DoublesMask is_one = hn::And(axes.is_known, hn::Eq(count, both(1)));
    place = hn::IfThenElse(is_one, place, both(ObbsLook::no_axis));
    if (hn::AllFalse(Tag<double>(), are_several)) return;
    const SearchLanes search(pair, axes, are_several);
    place = hn::IfThenElse(hn::AndNot(search.is_open(), are_several), search.place(), place);
  }
};

}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
