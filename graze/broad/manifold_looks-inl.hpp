// SPDX-License-Identifier: MIT
// Looks at the axes of many pairs of oriented boxes: of each the one of least depth, and whether the boxes meet.
// Included once for each instruction set, hence no ordinary guard.
#if defined(GRAZE_BROAD_MANIFOLD_LOOKS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BROAD_MANIFOLD_LOOKS_INL_HPP
#undef GRAZE_BROAD_MANIFOLD_LOOKS_INL_HPP
#else
#define GRAZE_BROAD_MANIFOLD_LOOKS_INL_HPP
#endif

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include <hwy/highway.h>

#include <graze/broad/manifold_axes-inl.hpp>
#include <graze/broad/manifold_choice-inl.hpp>
#include <graze/broad/manifold_kernels.hpp>
#include <graze/broad/manifold_lanes-inl.hpp>
#include <graze/broad/manifold_points-inl.hpp>
#include <graze/query/closest_points.hpp>
#include <graze/query/penetration_boxes.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {
#if HWY_TARGET != HWY_SCALAR  // which has no vectors of two groups of pairs

template <class T>
const T* numbers_of(const Obb<3, T>& box) {
  return reinterpret_cast<const T*>(&box);
}

/// As is_in_order of the two the other way round.
template <class T>
HWY_INLINE bool is_turned(const TwoObbs<T>& boxes) {
  return !is_in_order(*boxes.a, *boxes.b);
}

/// As many pairs as floats are in a vector, seen from the first boxes' centers.
template <class T>
class PairsToLookAt;

template <>
class PairsToLookAt<float> {
 public:
  HWY_INLINE PairsToLookAt(const float* const* first, const float* const* second) : first_(first), second_(second) {}

  HWY_INLINE AxesLook look() const {
    LaneObb<3, float> a(first_);
    LaneObb<3, float> b(second_);
    b.center = difference(b.center, a.center);
    for (Dim i = 0; i < 3; ++i) a.center.at[i] = hn::Zero(Tag<float>());
    return AxesLook(a, b);
  }

  /// Axes are rounded to float: hardly any is another one's once more.
  HWY_INLINE void leave_distinct(std::uint32_t*) const {}

 private:
  const float* const* first_;
  const float* const* second_;
};

template <>
class PairsToLookAt<double> {
 public:
  HWY_INLINE PairsToLookAt(const double* const* first, const double* const* second) {
    for (std::size_t group = 0; group < 2; ++group) {
      load_numbers_of_boxes(first + group * pairs_at_once, first_[group]);
      load_numbers_of_boxes(second + group * pairs_at_once, second_[group]);
    }
  }

  HWY_INLINE AxesLook look() const {
    Lanes<float> a[15];
    Lanes<float> b[15];
    for (std::size_t k = 0; k < 15; ++k) {
      const auto way = [&](std::size_t group) { return hn::Sub(second_[group][k], first_[group][k]); };
      a[k] = k < 3 ? hn::Zero(Tag<float>()) : joined(first_[0][k], first_[1][k]);
      b[k] = k < 3 ? joined(way(0), way(1)) : joined(second_[0][k], second_[1][k]);
    }
    return AxesLook(LaneObb<3, float>(a), LaneObb<3, float>(b));
  }

  /// Leaves out axes that are another one once more, of which the pairs have several.
  HWY_INLINE void leave_distinct(std::uint32_t* axes) const {
    for (std::size_t group = 0; group < 2; ++group) {
      Point a[3];
      Point b[3];
      for (std::size_t k = 0; k < 9; ++k) {
        a[k / 3].at[k % 3] = first_[group][6 + k];
        b[k / 3].at[k % 3] = second_[group][6 + k];
      }
      Row<std::uint64_t> repeated;
      store(repeated_axes(a, b), repeated);
      for (std::size_t lane = 0; lane < pairs_at_once; ++lane, ++axes) {
        *axes = distinct_axes(*axes, static_cast<BoxesAxes>(repeated.of[lane]));
      }
    }
  }

 private:
  Doubles first_[2][15];
  Doubles second_[2][15];
};

/// Looks at many pairs, and puts those aside of which several axes may be that of least depth.
template <class T>
class LooksAtObbs {
 public:
  LooksAtObbs(std::span<const TwoObbs<T>> pairs, ObbsLook* looks) : pairs_(pairs), looks_(looks) {
    for (std::size_t from = 0; from < pairs.size(); from += at_once) look(from);
    while (ties_ > 0) choose();
  }

 private:
  static constexpr std::size_t at_once = lanes_of<float>;

  /// The boxes of a pair in the order of their contact.
  HWY_INLINE void order(std::size_t i, const T*& first, const T*& second) const {
    const TwoObbs<T>& boxes = pairs_[i];
    const std::array<const T*, 2> numbers{numbers_of(*boxes.a), numbers_of(*boxes.b)};
    const bool turned = is_turned(boxes);
    first = numbers[turned ? 1 : 0];
    second = numbers[turned ? 0 : 1];
  }

  void look(std::size_t from) {
    const std::size_t count = std::min(at_once, pairs_.size() - from);
    std::array<const T*, at_once> first;
    std::array<const T*, at_once> second;
    for (std::size_t lane = 0; lane < at_once; ++lane) {
      order(lane < count ? from + lane : from, first[lane], second[lane]);
    }
    const PairsToLookAt<T> boxes(first.data(), second.data());
    alignas(64) std::array<std::uint32_t, at_once> bits;
    hn::Store(boxes.look().bits(), AxesLook::BitsTag(), bits.data());
    std::array<std::uint32_t, at_once> axes;
    BoxesAxes several = 0;
    for (std::size_t lane = 0; lane < at_once; ++lane) {
      axes[lane] = bits[lane] & AxesLook::axes;
      several |= axes[lane] & (axes[lane] - 1);
    }
    if (several != 0) boxes.leave_distinct(axes.data());
    for (std::size_t lane = 0; lane < count; ++lane) put(from + lane, bits[lane], axes[lane]);
    while (ties_ >= pairs_at_once) choose();
  }

  HWY_INLINE void put(std::size_t i, std::uint32_t bits, BoxesAxes axes) {
    const std::uint8_t place = place_of(axes);
    const BoxesAxes along_faces = axes_along_faces[bits >> AxesLook::first_right_angle];
    looks_[i] = {place, static_cast<std::uint8_t>((bits & AxesLook::overlapping) != 0 ? 1 : 0),
                 static_cast<std::uint8_t>((bits & AxesLook::apart) != 0 ? 1 : 0),
                 static_cast<std::uint8_t>(along_faces >> place & 1U)};
    tied_[ties_] = {static_cast<std::uint32_t>(i), axes, along_faces};
    ties_ += are_several(axes) ? 1 : 0;
  }

  /// Among the axes of the last pairs put aside.
  HWY_NOINLINE void choose() {
    const std::size_t count = std::min(pairs_at_once, ties_);
    ties_ -= count;
    const Tie* const ties = tied_.data() + ties_;
    std::array<const T*, pairs_at_once> first;
    std::array<const T*, pairs_at_once> second;
    for (std::size_t lane = 0; lane < pairs_at_once; ++lane) {
      order(ties[lane < count ? lane : 0].pair, first[lane], second[lane]);
    }
    BoxPair boxes{{load_boxes(first.data()), load_boxes(second.data())}};
    see_from_first(boxes);
    Row<std::uint64_t> axes;
    store(repeated_axes(boxes.box[0].axes, boxes.box[1].axes), axes);
    for (std::size_t lane = 0; lane < pairs_at_once; ++lane) {
      axes.of[lane] = distinct_axes(ties[lane < count ? lane : 0].axes, static_cast<BoxesAxes>(axes.of[lane]));
    }
    const SearchLanes found(boxes, hn::Load(BitsTag(), axes.of));
    const std::uint32_t open = bits_of<double>(found.is_open());
    Row<double> places;
    store(found.place(), places);
    for (std::size_t lane = 0; lane < count; ++lane) {
      ObbsLook& look = looks_[ties[lane].pair];
      look.axis = (open >> lane & 1U) == 0 ? static_cast<std::uint8_t>(places.of[lane]) : ObbsLook::no_axis;
      look.may_be_along_face = static_cast<std::uint8_t>(ties[lane].along_faces >> look.axis & 1U);
    }
  }

  struct Tie {
    std::uint32_t pair;
    BoxesAxes axes;
    BoxesAxes along_faces;
  };

  std::span<const TwoObbs<T>> pairs_;
  ObbsLook* looks_;
  std::array<Tie, at_once + pairs_at_once> tied_;
  std::size_t ties_ = 0;
};

#endif
}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
