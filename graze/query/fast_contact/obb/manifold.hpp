// SPDX-License-Identifier: MIT
// The points of the manifold of two oriented boxes, each rounded at its final location: clearing or copying them takes
// as long as a fast contact. Include manifold.hpp, whose ManifoldPoint is the `Point` here.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include <graze/math/lanes/lanes.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/fast_contact/obb/faces.hpp>
#include <graze/query/patch/clipped.hpp>

#ifdef GRAZE_HAS_LANES

namespace graze::detail {

/// A separate function: the compiler would clear several points at once by an instruction for long ranges, which takes
/// as long as a fast contact.
template <class Point>
[[gnu::noinline]] Point no_point() {
  return {};
}

/// Converts results in double to points.
template <class Point>
class ObbPoints {
 public:
  using R = decltype(Point::depth);

  /// Coordinates are relative to `origin`; `turns` if the first box of the pair is the user's second box.
  [[gnu::always_inline]] ObbPoints(const PairedVec& origin, bool turns)
      : origin_(origin), takes_second_(turns ? ~0U : 0U), second_first_(LanePairBits{} - (turns ? 1 : 0)) {}

  [[gnu::always_inline]] Point rounded(const PairedPoints& pair) const {
    const PairedVec first = pair.point_a + origin_;
    const PairedVec second = pair.point_b + origin_;
    return {rounded_vec<R>((first + second) * 0.5),
            rounded_vec<R>(detail::one_of(first, second, second_first_)),
            rounded_vec<R>(detail::one_of(second, first, second_first_)),
            static_cast<R>(pair.depth),
            {one_of(pair.feature_a, pair.feature_b), one_of(pair.feature_b, pair.feature_a), 0, 0}};
  }

 private:
  /// Branch-free, and without an array, which would be read in other sizes than it was written.
  [[gnu::always_inline]] Feature one_of(const Feature& first, const Feature& second) const {
    const auto choose = [this](std::uint32_t a, std::uint32_t b) { return a ^ ((a ^ b) & takes_second_); };
    return {static_cast<FeatureKind>(
                choose(static_cast<std::uint32_t>(first.kind), static_cast<std::uint32_t>(second.kind))),
            choose(first.index, second.index)};
  }

  PairedVec origin_;
  std::uint32_t takes_second_;
  LanePairBits second_first_;
};

/// The selected corners of a clipped face, one after the other.
template <class Point>
class CornersInTurn {
 public:
  [[gnu::always_inline]] CornersInTurn(const FaceOverFace& over, unsigned chosen, const ObbPoints<Point>& points)
      : over_(over), left_(chosen), points_(points) {}

  /// Empty if there are no more.
  [[gnu::noinline]] Point next() {
    if (left_ == 0) return {};
    const auto line = static_cast<std::size_t>(std::countr_zero(left_));
    left_ &= left_ - 1;
    ++count_;
    return points_.rounded(over_.pair(line));
  }

  std::size_t count() const { return count_; }

 private:
  const FaceOverFace& over_;
  unsigned left_;
  std::size_t count_ = 0;
  const ObbPoints<Point>& points_;
};

}  // namespace graze::detail
#endif
