// SPDX-License-Identifier: MIT
// Compiled once per instruction set: Highway includes this file anew for each.
#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <graze/broad/manifold_kernels.hpp>
#include <graze/broad/simd_choice.hpp>
#include <graze/query/lanes.hpp>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "graze/broad/manifold_kernels.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

// Vectors of two doubles gain nothing over single calls, whose own are as long; and careful cross products are made by
// instructions that round a product and a sum once. Elsewhere all pairs are left.
#undef GRAZE_MANIFOLD_LANES
#if HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128 && HWY_TARGET != HWY_WASM && HWY_HAVE_FLOAT64 && \
    defined(GRAZE_HAS_LANES)
#define GRAZE_MANIFOLD_LANES (HWY_MAX_BYTES >= 32 && HWY_NATIVE_FMA)
#include <graze/broad/manifold_edges-inl.hpp>
#include <graze/broad/manifold_faces-inl.hpp>
#include <graze/broad/manifold_looks-inl.hpp>
#else
#define GRAZE_MANIFOLD_LANES 0
#endif

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {
namespace {

#if GRAZE_MANIFOLD_LANES

template <class T>
void look_at_obbs(std::span<const TwoObbs<T>> pairs, ObbsLook* looks) {
  LooksAtObbs<T>(pairs, looks);
}

/// The manifolds of up to most_obbs_to_contact pairs: those across faces, then those across edges, then those whose
/// axis is along another face, so that lanes have the same to do.
template <class T>
class ContactBatch {
 public:
  ContactBatch(std::span<const ObbsToContact<T>> pairs, std::uint32_t* left) : pairs_(pairs), left_(left) {
    for (std::size_t i = 0; i < pairs.size(); ++i) sort_in(i);
    for (std::size_t i = 0; i < level_.count; i += pairs_at_once) find_carrying(i);
    for (std::size_t i = 0; i < faces_.count; i += 2 * pairs_at_once) contact_faces(i);
    for (std::size_t i = 0; i < edges_.count; i += pairs_at_once) contact_edges(i);
    for (std::size_t i = 0; i < carried_.count; i += 2 * pairs_at_once) contact_carried(i);
  }

  std::size_t left_count() const { return left_count_; }

 private:
  static constexpr std::size_t room = most_obbs_to_contact + pairs_at_once;

  struct List {
    std::array<std::uint16_t, room> pairs;
    std::size_t count = 0;
  };

  void sort_in(std::size_t i) {
    const TwoObbs<T>& boxes = pairs_[i].boxes;
    const std::array<const T*, 2> numbers{numbers_of(*boxes.a), numbers_of(*boxes.b)};
    const bool turned = pairs_[i].look.is_turned();
    turned_[i] = turned;
    first_[i] = numbers[turned ? 1 : 0];
    second_[i] = numbers[turned ? 0 : 1];
    is_by_second_[i] = false;
    is_carried_[i] = false;
    const auto place = static_cast<std::uint8_t>(pairs_[i].look.axis());
    place_[i] = place;
    List& list = pairs_[i].look.may_be_along_face() ? level_ : list_of(i);
    list.pairs[list.count] = static_cast<std::uint16_t>(i);
    list.count += place < ObbsLook::no_axis ? 1 : 0;
    if (place == ObbsLook::no_axis) left_[left_count_++] = static_cast<std::uint32_t>(i);
  }

  List& list_of(std::size_t i) { return place_[i] < 6 ? faces_ : edges_; }

  using Group = std::array<std::uint16_t, pairs_at_once>;

  /// The pairs of a group, the first in the place of those that are missing.
  static Group group_of(const List& list, std::size_t from) {
    Group group;
    for (std::size_t lane = 0; lane < pairs_at_once; ++lane) {
      group[lane] = list.pairs[from + lane < list.count ? from + lane : from];
    }
    return group;
  }

  void contact_faces(std::size_t from) {
    contact_two_groups(faces_, from, [this](const Group& group) { return face_pairs(group); });
  }

  /// Those of a list from there on, as many as two groups have. Functions of their own, or their many instructions
  /// would be there twice, and not stay near.
  template <class PairsOf>
  void contact_two_groups(const List& list, std::size_t from, const PairsOf& pairs_of) {
    const std::size_t count = std::min(list.count - from, 2 * pairs_at_once);
    const std::size_t groups = count > pairs_at_once ? 2 : 1;
    FaceContacts<T> contacts[2];
    for (std::size_t g = 0; g < groups; ++g) lay(pairs_of(group_of(list, from + g * pairs_at_once)), contacts[g]);
    FaceContacts<T>::choose(contacts[0], contacts[groups - 1]);
    for (std::size_t g = 0; g < groups; ++g) {
      write_faces(contacts[g], group_of(list, from + g * pairs_at_once), count - g * pairs_at_once);
    }
  }

  template <class Pairs>
  HWY_NOINLINE static void lay(const Pairs& pairs, FaceContacts<T>& contacts) {
    contacts.lay(carried_lanes(pairs));
  }

  HWY_NOINLINE void write_faces(FaceContacts<T>& contacts, const Group& group, std::size_t count) {
    contacts.set_points();
    const std::uint32_t open = contacts.open();
    for (std::size_t lane = 0; lane < std::min(pairs_at_once, count); ++lane) {
      const std::size_t i = group[lane];
      if ((open >> lane & 1U) != 0) {
        left_[left_count_++] = static_cast<std::uint32_t>(i);
      } else {
        contacts.write(lane, turned_[i] != is_of_second(i), *pairs_[i].manifold);
      }
    }
  }

  /// Whether the box that carries the points is the second in the order of the contact.
  bool is_of_second(std::size_t i) const { return is_by_second_[i] || (!is_carried_[i] && place_[i] >= 3); }

  FacePairs<T> face_pairs(const Group& group) const {
    FacePairs<T> pairs;
    for (std::size_t lane = 0; lane < pairs_at_once; ++lane) {
      const std::size_t i = group[lane];
      const bool of_b = place_[i] >= 3;
      const std::array<const T*, 2> numbers{first_[i], second_[i]};
      pairs.own[lane] = numbers[of_b ? 1 : 0];
      pairs.other[lane] = numbers[of_b ? 0 : 1];
      pairs.axis.of[lane] = place_[i] - (of_b ? 3 : 0);
      pairs.of_b.of[lane] = of_b ? 1 : 0;
      pairs.turned.of[lane] = turned_[i] ? 1 : 0;
    }
    return pairs;
  }

  HWY_INLINE void contact_edges(std::size_t from) {
    const auto group = group_of(edges_, from);
    EdgePairs<T> pairs;
    for (std::size_t lane = 0; lane < pairs_at_once; ++lane) {
      const std::size_t i = group[lane];
      pairs.first[lane] = first_[i];
      pairs.second[lane] = second_[i];
      pairs.edge_a.of[lane] = (place_[i] - 6) / 3;
      pairs.edge_b.of[lane] = place_[i] % 3;
      pairs.turned.of[lane] = turned_[i] ? 1 : 0;
    }
    const EdgeContacts<T> contacts(pairs);
    const std::uint32_t open = contacts.open();
    for (std::size_t lane = 0; lane < std::min(pairs_at_once, edges_.count - from); ++lane) {
      const std::size_t i = group[lane];
      if ((open >> lane & 1U) != 0) {
        left_[left_count_++] = static_cast<std::uint32_t>(i);
      } else {
        contacts.write(lane, turned_[i], *pairs_[i].manifold);
      }
    }
  }

  /// Which box' face carries the points of pairs whose axis may be along one.
  HWY_INLINE void find_carrying(std::size_t from) {
    const auto group = group_of(level_, from);
    const CarryingBoxes carrying(carried_pairs(group));
    const std::uint32_t by_first = carrying.by_first();
    const std::uint32_t by_second = carrying.by_second();
    for (std::size_t lane = 0; lane < std::min(pairs_at_once, level_.count - from); ++lane) {
      const std::size_t i = group[lane];
      is_by_second_[i] = (by_second >> lane & 1U) != 0;
      is_carried_[i] = ((by_first | by_second) >> lane & 1U) != 0;
      List& list = is_carried_[i] ? carried_ : list_of(i);
      list.pairs[list.count++] = static_cast<std::uint16_t>(i);
    }
  }

  CarriedPairs<T> carried_pairs(const Group& group) const {
    CarriedPairs<T> pairs;
    for (std::size_t lane = 0; lane < pairs_at_once; ++lane) {
      const std::size_t i = group[lane];
      const std::uint8_t place = place_[i];
      pairs.first[lane] = first_[i];
      pairs.second[lane] = second_[i];
      pairs.is_on_edges.of[lane] = place >= 6 ? 1 : 0;
      pairs.axis_a.of[lane] = place >= 6 ? (place - 6) / 3 : 0;
      pairs.axis_b.of[lane] = place % 3;
      pairs.of_b.of[lane] = is_by_second_[i] ? 1 : 0;
      pairs.turned.of[lane] = turned_[i] ? 1 : 0;
    }
    return pairs;
  }

  void contact_carried(std::size_t from) {
    contact_two_groups(carried_, from, [this](const Group& group) { return carried_pairs(group); });
  }

  std::span<const ObbsToContact<T>> pairs_;
  std::uint32_t* left_;
  std::size_t left_count_ = 0;
  std::array<const T*, room> first_;
  std::array<const T*, room> second_;
  std::array<bool, room> turned_;
  std::array<std::uint8_t, room> place_;
  List level_;  ///< That may be in the last of these lists, or else in one of the others.
  List faces_;
  List edges_;
  List carried_;
  std::array<bool, room> is_carried_;    ///< In the last list.
  std::array<bool, room> is_by_second_;  ///< Of those, else false.
};

template <class T>
std::size_t contact_obbs(std::span<const ObbsToContact<T>> pairs, std::uint32_t* left) {
  assert(pairs.size() <= most_obbs_to_contact);
  return ContactBatch<T>(pairs, left).left_count();
}

#else

template <class T>
void look_at_obbs(std::span<const TwoObbs<T>> pairs, ObbsLook* looks) {
  std::fill_n(looks, pairs.size(), ObbsLook{});
}

template <class T>
std::size_t contact_obbs(std::span<const ObbsToContact<T>> pairs, std::uint32_t* left) {
  for (std::size_t i = 0; i < pairs.size(); ++i) left[i] = static_cast<std::uint32_t>(i);
  return pairs.size();
}

#endif

}  // namespace

const AllManifoldKernels& all_manifold_kernels() {
  static const AllManifoldKernels kernels{{look_at_obbs<float>, contact_obbs<float>},
                                          {look_at_obbs<double>, contact_obbs<double>}};
  return kernels;
}

}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graze::detail {
namespace {
HWY_EXPORT(all_manifold_kernels);
}

template <class T>
const ManifoldKernels<T>& manifold_kernels() {
  const AllManifoldKernels& kernels = HWY_DYNAMIC_DISPATCH(all_manifold_kernels)();
  if constexpr (std::is_same_v<T, float>) {
    return kernels.of_floats;
  } else {
    return kernels.of_doubles;
  }
}

template const ManifoldKernels<float>& manifold_kernels<float>();
template const ManifoldKernels<double>& manifold_kernels<double>();

}  // namespace graze::detail
#endif
