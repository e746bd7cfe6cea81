// SPDX-License-Identifier: MIT
// The axis of least depth of many pairs of oriented boxes: first, candidates among the fifteen by a test in float as in
// query/fast_contact/obb/axes.hpp, then the choice among them as in MeetingObbs. Included once per instruction set, so
// it has no ordinary include guard.
#if defined(GRAZE_BROAD_CONTACTS_OBB_AXES_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BROAD_CONTACTS_OBB_AXES_INL_HPP
#undef GRAZE_BROAD_CONTACTS_OBB_AXES_INL_HPP
#else
#define GRAZE_BROAD_CONTACTS_OBB_AXES_INL_HPP
#endif

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

#include <hwy/highway.h>

#include <graze/broad/contacts/manifold_lanes-inl.hpp>
#include <graze/broad/contacts/obb/obb_kernels.hpp>
#include <graze/broad/touching/boxes-inl.hpp>
#include <graze/broad/touching/lanes-inl.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/query/contact/boxes.hpp>
#include <graze/query/fast_contact/obb/contact.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {

/// Given the right angles between edges of two boxes (bit 3 i + j for axis i of the first and j of the second): the
/// axes that may be parallel to a face's normal that is not their own. The normal across axis j of the second box is
/// parallel to one of the first box if two of the latter's edges are perpendicular to j; the axis across edges i and j
/// is parallel to a normal of either box if another edge of that box is perpendicular to the other's.
inline constexpr auto axes_along_faces = [] {
  std::array<std::uint32_t, 512> result{};
  for (std::uint32_t found = 0; found < 512; ++found) {
    const auto has = [found](Dim i, Dim j) { return (found >> (3 * (i % 3) + j % 3) & 1U) != 0; };
    BoxesAxes axes = 0;
    for (Dim j = 0; j < 3; ++j) {
      const bool along_a = (has(0, j) && (has(1, j) || has(2, j))) || (has(1, j) && has(2, j));
      axes |= BoxesAxes{along_a} << (3 + j);
      for (Dim i = 0; i < 3; ++i) {
        const bool along_either = has(i + 1, j) || has(i + 2, j) || has(i, j + 1) || has(i, j + 2);
        axes |= BoxesAxes{along_either} << (6 + 3 * i + j);
      }
    }
    result[found] = axes;
  }
  return result;
}();

/// The result of an axis test in float for a vector of pairs, as bits: the axes that the search must not skip, as
/// axes_of in query/fast_contact/obb/axes.hpp finds them, or a few more or less that do not matter for the same reason;
/// and further bits.
class AxesLook {
 public:
  static constexpr std::uint32_t axes = (1U << 15U) - 1;
  static constexpr std::uint32_t overlapping = ObbAxisTest::overlapping;
  static constexpr std::uint32_t apart = ObbAxisTest::apart;
  static constexpr int first_right_angle = 17;  ///< And the subsequent bits, as in axes_along_faces.

  using BitsTag = hn::RebindToUnsigned<Tag<float>>;
  using Bits = hn::Vec<BitsTag>;

  /// For boxes near the origin.
  HWY_INLINE AxesLook(const LaneObb<3, float>& a, const LaneObb<3, float>& b)
      : view_(a, b),
        orthonormality_error_(hn::Add(hn::Max(orthonormality_error_of(a), orthonormality_error_of(b)),
                                      all(tolerance::measured_orthonormality_error<float>))),
        size_(find_face_gaps()),
        band_(hn::Mul(hn::Mul(all(static_cast<float>(tolerance::box_filter)), orthonormality_error_), size_)),
        bits_(hn::Zero(BitsTag())) {
    widest_ = gaps_[0];
    for (std::size_t i = 1; i < 6; ++i) widest_ = hn::Max(widest_, gaps_[i]);
    const Mask has_size = hn::And(hn::Gt(size_, all(0x1p-30F)), hn::Lt(size_, all(0x1p30F)));
    const Mask apart_by_faces = hn::And(has_size, hn::Gt(widest_, band_));
    if (hn::AllTrue(Tag<float>(), apart_by_faces)) {
      bits_ = hn::Set(BitsTag(), apart);
    } else {
      look_across_edges(has_size, apart_by_faces);
    }
  }

  /// For each pair. Without axes, nothing is known.
  Bits bits() const { return bits_; }

 private:
  using Mask = hn::Mask<Tag<float>>;

  HWY_INLINE void add(Mask where, std::uint32_t bit) {
    bits_ = hn::Or(bits_, hn::IfThenElseZero(hn::RebindMask(BitsTag(), where), hn::Set(BitsTag(), bit)));
  }

  /// Returns the size of both boxes.
  HWY_INLINE Lanes<float> find_face_gaps() {
    Lanes<float> size = all(0.0F);
    unrolled<3>([&](auto i) GRAZE_INLINE_LAMBDA {
      Lanes<float> reach = view_.half.at[i];
      Lanes<float> gap = hn::Sub(hn::Abs(inner(view_.between, view_.directions[i])), view_.other_half.at[i]);
      unrolled<3>([&](auto j) GRAZE_INLINE_LAMBDA {
        reach = hn::MulAdd(view_.other_half.at[j], view_.shadow[j].at[i], reach);
        gap = hn::NegMulAdd(view_.half.at[j], view_.shadow[i].at[j], gap);
      });
      gaps_[i] = hn::Sub(hn::Abs(view_.between.at[i]), reach);
      gaps_[3 + i] = gap;
      size = hn::Add(size, hn::Add(hn::Abs(view_.between.at[i]), reach));
    });
    return size;
  }

  HWY_INLINE void look_across_edges(Mask has_size, Mask apart_by_faces) {
    const auto parallel = hn::Mul(all(static_cast<float>(2 * tolerance::box_filter)), orthonormality_error_);
    const auto squared_parallel = hn::Mul(hn::Mul(all(0.5F), parallel), parallel);
    Lanes<float> squared_length[9];
    Lanes<float> least_squared = hn::Mul(size_, size_);
    Lanes<float> widest_across = hn::Neg(size_);
    Mask are_open = hn::Lt(size_, hn::Zero(Tag<float>()));
    unrolled<9>([&](auto k) GRAZE_INLINE_LAMBDA {
      constexpr Dim i = k / 3;
      constexpr Dim j = k % 3;
      const auto gap = gap_across(view_, i, j);
      const auto next = view_.directions[j].at[(i + 1) % 3];
      const auto last = view_.directions[j].at[(i + 2) % 3];
      gaps_[6 + k] = gap;
      squared_length[k] = hn::MulAdd(next, next, hn::Mul(last, last));
      const auto deepest = hn::Sub(gap, band_);
      least_squared =
          hn::Min(least_squared, hn::Div(hn::Mul(deepest, deepest), hn::Max(squared_length[k], all(1e-15F))));
      widest_across = hn::Max(widest_across, gap);
      are_open = hn::Or(are_open, hn::And(hn::Ge(hn::Add(gap, band_), hn::Zero(Tag<float>())),
                                          hn::Ge(squared_length[k], squared_parallel)));
    });
    const Mask is_apart = hn::Or(apart_by_faces, hn::And(has_size, hn::Gt(widest_across, band_)));
    find_candidates(squared_length, least_squared);
    const Mask is_deep = hn::Lt(widest_, hn::Mul(all(-8.0F), band_));
    add(hn::AndNot(are_open, is_deep), overlapping);
    add_right_angles();
    const Bits known = hn::IfThenElseZero(hn::RebindMask(BitsTag(), has_size), bits_);
    bits_ = hn::IfThenElse(hn::RebindMask(BitsTag(), is_apart), hn::Set(BitsTag(), apart), known);
  }

  HWY_INLINE void find_candidates(const Lanes<float> (&squared_length)[9], Lanes<float> least_squared) {
    const auto least = hn::Sub(hn::Max(hn::Sub(widest_, band_), hn::Neg(hn::Sqrt(least_squared))), band_);
    unrolled<6>([&](auto i) GRAZE_INLINE_LAMBDA { add(hn::Ge(gaps_[i], least), 1U << i); });
    const auto squared_least = hn::Mul(hn::Mul(all(1.001F), least), least);
    unrolled<9>([&](auto k) GRAZE_INLINE_LAMBDA {
      const auto short_by = hn::Add(gaps_[6 + k], band_);
      add(hn::Or(hn::Ge(short_by, hn::Zero(Tag<float>())),
                 hn::Le(hn::Mul(short_by, short_by), hn::Mul(squared_length[k], squared_least))),
          1U << (6 + k));
    });
  }

  /// Adds the edges that are perpendicular to each other, up to the tolerance of manifolds and the orthonormality error
  /// of axes.
  HWY_INLINE void add_right_angles() {
    constexpr float most = 1e-3F;
    unrolled<9>([&](auto k) GRAZE_INLINE_LAMBDA {
      add(hn::Le(view_.shadow[k % 3].at[k / 3], all(most)), 1U << (first_right_angle + k));
    });
  }

  LaneView<3, float> view_;
  Lanes<float> gaps_[15];
  Lanes<float> orthonormality_error_;
  Lanes<float> size_;
  Lanes<float> band_;
  Lanes<float> widest_;  ///< Of the gaps across faces.
  Bits bits_;
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

/// As in query/convex/zonotope.hpp.
HWY_INLINE Point cross_of_directions(const Point& a, const Point& b) {
  const Point product = cross(a, b);
  const Doubles least = hn::Mul(hn::Mul(both(1.0 / 64), dot(a, a)), dot(b, b));
  const Point accurate{{difference_of_products(a.at[1], b.at[2], a.at[2], b.at[1]),
                        difference_of_products(a.at[2], b.at[0], a.at[0], b.at[2]),
                        difference_of_products(a.at[0], b.at[1], a.at[1], b.at[0])}};
  return one_of(hn::Gt(dot(product, product), least), product, accurate);
}

/// The search among several axes like MeetingObbs::search, for the lanes that need one.
class SearchLanes {
 public:
  HWY_INLINE SearchLanes(const BoxPair& pair, Bits candidates)
      : pair_(pair),
        size_(hn::Add(size_of(pair.box[0]), size_of(pair.box[1]))),
        margin_(hn::Mul(both(tolerance::rounding), size_)),
        gap_(both(-std::numeric_limits<double>::infinity())),
        place_(both(0)),
        is_open_(no_lane()) {
#pragma GCC unroll 15
    for (std::size_t i = 0; i < 15; ++i) {
      const DoublesMask tried = has_bit(candidates, i);
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
  /// Whether the axis is across nearly parallel edges.
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

  /// Takes the edges' axis where it is better; the previous one is discarded there.
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
    if (!hn::AllFalse(Tag<double>(), better)) {
      take(place, hn::Mul(gap, hn::Div(both(1), hn::Sqrt(edges.squared))), better);
    }
    return better;
  }

  const BoxPair& pair_;
  Doubles size_;
  Doubles margin_;
  Doubles gap_;
  Doubles place_;
  DoublesMask is_open_;
};

/// The orthonormality error of axes, as orthonormal_error.
HWY_INLINE Doubles orthonormality_error_of_axes(const Point (&axes)[3]) {
  auto orthonormality_error = both(0);
  for (Dim i = 0; i < 3; ++i) {
    orthonormality_error = hn::Max(orthonormality_error, hn::Abs(hn::Sub(dot(axes[i], axes[i]), both(1))));
    orthonormality_error = hn::Max(orthonormality_error, hn::Abs(dot(axes[i], axes[(i + 1) % 3])));
  }
  return orthonormality_error;
}

/// repeated_axes, for many pairs.
HWY_INLINE Bits repeated_axes(const Point (&a)[3], const Point (&b)[3]) {
  Doubles cosines[3][3];
  auto least = both(std::numeric_limits<double>::infinity());
  for (Dim i = 0; i < 3; ++i) {
    for (Dim j = 0; j < 3; ++j) {
      cosines[j][i] = hn::Abs(dot(a[i], b[j]));
      least = hn::Min(least, cosines[j][i]);
    }
  }
  Bits result = hn::Zero(BitsTag());
  if (hn::AllTrue(Tag<double>(), hn::Gt(least, both(2 * same_axis)))) return result;
  const Doubles orthonormality_error =
      hn::Mul(both(1.5), hn::Max(orthonormality_error_of_axes(a), orthonormality_error_of_axes(b)));
  for (Dim j = 0; j < 3; ++j) {
    const auto& c = cosines[j];
    for (Dim i = 0; i < 3; ++i) {
      const Doubles larger = hn::Max(c[(i + 1) % 3], c[(i + 2) % 3]);
      const DoublesMask along = hn::Le(hn::Mul(both(1.5), hn::Add(larger, orthonormality_error)), both(same_axis));
      result = hn::Or(result, hn::Or(bit_where(along, 3 + j), bit_where(along, 6 + 3 * i + j)));
      const Doubles in_a = hn::Min(c[(i + 1) % 3], c[(i + 2) % 3]);
      const Doubles in_b = hn::Min(cosines[(j + 1) % 3][i], cosines[(j + 2) % 3][i]);
      const Doubles off = hn::Add(hn::Min(in_a, in_b), orthonormality_error);
      const Doubles squared_sine = hn::Sub(both(1), hn::Mul(c[i], c[i]));
      result = hn::Or(result, bit_where(hn::Le(hn::Mul(off, off), hn::Mul(both(same_axis * same_axis), squared_sine)),
                                        6 + 3 * i + j));
    }
  }
  return result;
}

}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
