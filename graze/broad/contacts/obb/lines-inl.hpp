// SPDX-License-Identifier: MIT
// A number for each of the nine lines that bound a clipped face, for many pairs: reductions over all lines, and
// selection of one. Included once per instruction set, so it has no ordinary include guard.
#if defined(GRAZE_BROAD_CONTACTS_OBB_LINES_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BROAD_CONTACTS_OBB_LINES_INL_HPP
#undef GRAZE_BROAD_CONTACTS_OBB_LINES_INL_HPP
#else
#define GRAZE_BROAD_CONTACTS_OBB_LINES_INL_HPP
#endif

#include <cstddef>
#include <cstdint>

#include <hwy/highway.h>

#include <graze/broad/simd/lanes-inl.hpp>
#include <graze/query/fast_contact/obb/faces.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {

/// Reduces a number per line by a binary operation. Pairwise, then pairs of pairs: a sequential reduction has nine
/// times the latency.
template <class Operation, class Number>
HWY_INLINE auto over_lines(const Operation& operation, const Number& number) {
  static_assert(face_lines == 9);
  const auto low = operation(operation(number(0), number(1)), operation(number(2), number(3)));
  const auto high = operation(operation(number(4), number(5)), operation(number(6), number(7)));
  return operation(operation(low, high), number(8));
}

struct Least {
  template <class V>
  HWY_INLINE V operator()(const V& a, const V& b) const {
    return hn::Min(a, b);
  }
};
struct Largest {
  template <class V>
  HWY_INLINE V operator()(const V& a, const V& b) const {
    return hn::Max(a, b);
  }
};
/// Bitwise.
struct All {
  template <class V>
  HWY_INLINE V operator()(const V& a, const V& b) const {
    return hn::Or(a, b);
  }
};

/// Selects a line of each pair, given as its bit, by a tree of binary choices on the bits of its index.
template <class NumberTag>
class LineOfEach {
 public:
  template <class LineBits>
  HWY_INLINE explicit LineOfEach(LineBits line)
      : is_odd_(any(line, 0b0'1010'1010)),
        is_second_(any(line, 0b0'1100'1100)),
        is_third_(any(line, 0b0'1111'0000)),
        is_top_(any(line, 0b1'0000'0000)) {}

  template <class Number>
  HWY_INLINE auto of(const Number& number) const {
    const auto low = one_of(is_second_, one_of(is_odd_, number(3), number(2)), one_of(is_odd_, number(1), number(0)));
    const auto high = one_of(is_second_, one_of(is_odd_, number(7), number(6)), one_of(is_odd_, number(5), number(4)));
    return one_of(is_top_, number(top_line), one_of(is_third_, high, low));
  }

 private:
  using Mask = hn::Mask<NumberTag>;

  template <class LineBits>
  HWY_INLINE static Mask any(LineBits line, std::uint64_t places) {
    const hn::DFromV<LineBits> tag;
    const auto found = hn::And(line, hn::Set(tag, static_cast<hn::TFromD<hn::DFromV<LineBits>>>(places)));
    return hn::RebindMask(NumberTag(), hn::Ne(found, hn::Zero(tag)));
  }

  template <class V>
  HWY_INLINE static V one_of(Mask mask, V yes, V no) {
    return hn::IfThenElse(hn::RebindMask(hn::DFromV<V>(), mask), yes, no);
  }

  Mask is_odd_;
  Mask is_second_;
  Mask is_third_;
  Mask is_top_;
};

}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
