// SPDX-License-Identifier: MIT
// The manifolds of many pairs of an oriented box and an AABB, by the kernels of oriented boxes: both as oriented boxes
// in double, relative to the oriented one's center as in query/fast_contact/obb/boxes_in_frame.hpp, so that the answers
// are bit-identical to single calls.
#pragma once

#include <algorithm>
#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <variant>

#include <graze/broad/contacts/obb/obb_kernels.hpp>
#include <graze/broad/touching_pairs.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/fast_contact/obb/boxes_in_frame.hpp>
#include <graze/query/manifold.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/obb.hpp>

namespace graze::detail {

/// Rounds a manifold found relative to `origin`, as ObbPoints of query/fast_contact/obb/manifold.hpp. `to` is
/// value-initialised, or `from` itself.
template <class T>
void move_manifold(const Manifold<3, double>& from, const Vec<3, double>& origin, Manifold<3, T>& to) {
  const auto rounded = [](const Vec<3, double>& v) { return Vec<3, T>(v) + T(0); };  // adding zero turns -0 into +0
  for (std::size_t i = 0; i < from.size; ++i) {
    const ManifoldPoint<3, double>& found = from.points[i];
    const Vec<3, double> a = found.point_a + origin;
    const Vec<3, double> b = found.point_b + origin;
    to.points[i] = {rounded((a + b) * 0.5), rounded(a), rounded(b), static_cast<T>(found.depth), found.id};
  }
  to.size = from.size;
  to.normal = rounded(from.normal);
  to.error = from.error;
}

/// Collects the touching pairs of this kind of a task.
template <class T>
class MixedPairs {
 public:
  /// False for other pairs. The capacity is one kernel batch.
  bool add(const ShapePair<3, T>& shapes, Manifold<3, T>* manifold, std::size_t place) {
    const auto* a = std::get_if<Obb<3, T>>(shapes.a);
    const auto* b = std::get_if<Obb<3, T>>(shapes.b);
    const auto* along_axes = std::get_if<Aabb<3, T>>(a != nullptr ? shapes.b : shapes.a);
    if ((a == nullptr) == (b == nullptr) || along_axes == nullptr) return false;
    pairs_[count_++] = {a != nullptr ? a : b, along_axes, manifold, static_cast<std::uint16_t>(place), a == nullptr};
    return true;
  }

  /// Calls contact_one(index) for the pairs that the kernels leave.
  template <class ContactOne>
  void contact(const ContactOne& contact_one) const {
    for (std::size_t from = 0; from < count_; from += at_once) {
      contact_some(std::span(pairs_).subspan(from, std::min(at_once, count_ - from)), contact_one);
    }
  }

 private:
  static constexpr std::size_t at_once = 64;  ///< So few that their data stay in the cache.

  struct Kept {
    const Obb<3, T>* oriented;
    const Aabb<3, T>* along_axes;
    Manifold<3, T>* manifold;
    std::uint16_t place;
    bool is_turned;  ///< The oriented box is the second one.
  };

  /// The manifolds as the kernels write them: directly to their destination if they are in double.
  struct Seen {
    std::array<Manifold<3, double>, std::is_same_v<T, double> ? 0 : at_once> manifolds;

    Manifold<3, double>* at(std::size_t i, const Kept& pair) {
      if constexpr (std::is_same_v<T, double>) {
        return pair.manifold;
      } else {
        return &manifolds[i];
      }
    }
  };

  template <class ContactOne>
  static void contact_some(std::span<const Kept> pairs, const ContactOne& contact_one) {
    std::array<MixedBoxes, at_once> boxes;
    std::array<TwoObbs<double>, at_once> named;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      boxes[i] = mixed_boxes(*pairs[i].oriented, *pairs[i].along_axes);
      named[i] = {&boxes[i].oriented, &boxes[i].along_axes};
    }
    std::array<ObbAxisTest, at_once> looks;
    obb_kernels<double>().look(std::span(named).first(pairs.size()), FirstBox::as_named, looks.data());
    Seen seen;
    std::array<ObbsToContact<double>, at_once> known;
    std::array<std::uint8_t, at_once> places;
    std::size_t known_count = 0;
    std::bitset<at_once> is_left;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      is_left[i] = looks[i].axis() == ObbAxisTest::no_axis;
      if (is_left[i]) continue;
      known[known_count] = to_contact(named[i], looks[i], pairs[i].is_turned, seen.at(i, pairs[i]));
      places[known_count++] = static_cast<std::uint8_t>(i);
    }
    std::array<std::uint32_t, at_once> left;
    const std::size_t left_count = obb_kernels<double>().contact(std::span(known).first(known_count), left.data());
    for (std::size_t i = 0; i < left_count; ++i) is_left[places[left[i]]] = true;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if (is_left[i]) {
        contact_one(pairs[i].place);
      } else {
        move_manifold(*seen.at(i, pairs[i]), wide<3, T>(pairs[i].oriented->center), *pairs[i].manifold);
      }
    }
  }

  static ObbsToContact<double> to_contact(const TwoObbs<double>& named, ObbAxisTest look, bool is_turned,
                                          Manifold<3, double>* manifold) {
    if (!is_turned) return {named, look, manifold};
    return {{named.b, named.a}, {look.bits | ObbAxisTest::turned}, manifold};
  }

  std::array<Kept, most_obbs_to_contact> pairs_;
  std::size_t count_ = 0;
};

}  // namespace graze::detail
