// SPDX-License-Identifier: MIT
// Compiled once per instruction set: Highway includes this file again for each.
#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>

#include <graze/broad/contacts/obb/obb_kernels.hpp>
#include <graze/broad/simd/choice.hpp>
#include <graze/math/lanes/lanes.hpp>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "graze/broad/contacts/obb/obb_kernels.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

// Vectors of two doubles gain nothing over single calls, which use the same; and accurate cross products need fused
// multiply-add. Otherwise, all pairs are left.
#undef GRAZE_MANIFOLD_LANES
#if HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128 && HWY_TARGET != HWY_WASM && HWY_HAVE_FLOAT64 && \
    defined(GRAZE_HAS_LANES)
#define GRAZE_MANIFOLD_LANES (HWY_MAX_BYTES >= 32 && HWY_NATIVE_FMA)
#include <graze/broad/contacts/obb/axis_tests-inl.hpp>
#include <graze/broad/contacts/obb/edges-inl.hpp>
#include <graze/broad/contacts/obb/faces-inl.hpp>
#else
#define GRAZE_MANIFOLD_LANES 0
#endif

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {
namespace {

#if GRAZE_MANIFOLD_LANES

template <class T>
void look_at_obbs(std::span<const TwoObbs<T>> pairs, FirstBox first, ObbAxisTest* looks) {
  LooksAtObbs<T>(pairs, first, looks);
}

/// The manifolds of up to most_obbs_to_contact pairs: first those across faces, then those across edges, then those
/// whose axis is parallel to another face's normal, so that lanes run the same code.
template <class T>
class ContactBatch {
 public:
  ContactBatch(std::span<const ObbsToContact<T>> pairs, std::uint32_t* left) : pairs_(pairs), left_(left) {
    for (std::size_t i = 0; i < pairs.size(); ++i) sort_in(i);
    contact_level();
    contact_faces(lists_[on_face], [](const PairGroup<T>& group, FaceContacts<T>& contacts) { fill(group, contacts); });
    contact_edges(lists_[on_edges]);
    contact_faces(lists_[off_axis],
                  [](const PairGroup<T>& group, FaceContacts<T>& contacts) { fill_off_axis(group, true, contacts); });
  }

  std::size_t left_count() const { return left_count_; }

 private:
  enum Kind : std::uint8_t {
    on_face,
    on_edges,
    level,     ///< May have another reference face, otherwise one of the two above.
    off_axis,  ///< The reference face's normal is not the axis.
    unknown,
    kinds
  };

  /// Pairs of a kind: their boxes, the one with the reference face first or else in their contact order, and their axis
  /// tests.
  struct List {
    static constexpr std::size_t room = most_obbs_to_contact + pairs_at_once;

    std::array<const T*, room> first;
    std::array<const T*, room> second;
    std::array<std::uint64_t, room> looks;
    std::array<std::uint16_t, room> pairs;
    std::size_t count = 0;

    HWY_INLINE void add(const T* its_first, const T* its_second, std::uint64_t look, std::size_t pair) {
      first[count] = its_first;
      second[count] = its_second;
      looks[count] = look;
      pairs[count] = static_cast<std::uint16_t>(pair);
      ++count;
    }

    /// Repeats the last pair to fill an incomplete group.
    void fill_last_group() {
      const std::size_t end = count;
      while (count % pairs_at_once != 0) add(first[end - 1], second[end - 1], looks[end - 1], pairs[end - 1]);
      count = end;
    }

    PairGroup<T> group(std::size_t from) const { return {&first[from], &second[from], &looks[from]}; }
  };

  /// The kind of pairs by their axis, plus 16 if that may be parallel to a face normal; and whether the other box is
  /// the first in its list.
  struct Sort {
    Kind kind;
    bool exchanged;
  };

  static constexpr auto sorts = [] {
    std::array<Sort, 32> result{};
    for (std::uint32_t place = 0; place < result.size(); ++place) {
      const std::uint32_t axis = place % 16;
      const Kind across = axis < 6 ? on_face : on_edges;
      result[place].kind = axis == ObbAxisTest::no_axis ? unknown : place >= 16 ? level : across;
      result[place].exchanged = result[place].kind == on_face && axis >= 3;
    }
    return result;
  }();

  HWY_INLINE void sort_in(std::size_t i) {
    const ObbsToContact<T>& pair = pairs_[i];
    const std::uint32_t look = pair.look.bits;
    static_assert(ObbAxisTest::along_face >> 20U == 16);
    const Sort sort = sorts[(look & ObbAxisTest::axis_bits) | (look >> 20U & 16U)];
    put(sort, pair.look.is_turned() != sort.exchanged, numbers_of(*pair.boxes.a), numbers_of(*pair.boxes.b), look, i);
  }

  HWY_INLINE void put(Sort sort, bool turned, const T* a, const T* b, std::uint64_t look, std::size_t i) {
    lists_[sort.kind].add(turned ? b : a, turned ? a : b, look, i);
  }

  /// The pairs of a list. Separate functions, since their long code would otherwise be duplicated and evicted from the
  /// instruction cache.
  template <class Lay>
  void contact_faces(List& list, const Lay& lay_group) {
    list.fill_last_group();
    for (std::size_t from = 0; from < list.count; from += 2 * pairs_at_once) {
      const std::size_t groups = list.count - from > pairs_at_once ? 2 : 1;
      const std::size_t places[2] = {from, from + pairs_at_once};
      FaceContacts<T> contacts[2];
      for (std::size_t g = 0; g < groups; ++g) lay_group(list.group(places[g]), contacts[g]);
      write_two(contacts, places, groups, list);
    }
  }

  HWY_NOINLINE static void fill(const PairGroup<T>& group, FaceContacts<T>& contacts) {
    contacts.fill(clip_input(FacePairs<T>(group)));
  }

  /// Writes one group or two, from these positions of the list on.
  HWY_INLINE void write_two(FaceContacts<T> (&contacts)[2], const std::size_t (&places)[2], std::size_t groups,
                            const List& list) {
    FaceContacts<T>::choose(contacts[0], contacts[groups - 1]);
    for (std::size_t g = 0; g < groups; ++g) write_faces(contacts[g], list, places[g]);
  }

  HWY_NOINLINE void write_faces(FaceContacts<T>& contacts, const List& list, std::size_t from) {
    contacts.set_points();
    write(contacts, list, from);
  }

  /// Writes those of a group.
  template <class Contacts>
  HWY_INLINE void write(const Contacts& contacts, const List& list, std::size_t from) {
    const std::uint32_t open = contacts.open();
    const std::uint32_t turns = contacts.turns();
    const std::size_t count = std::min(pairs_at_once, list.count - from);
    for (std::size_t lane = 0; lane < count; ++lane) {
      const std::size_t i = list.pairs[from + lane];
      if (HWY_UNLIKELY((open >> lane & 1U) != 0)) {
        left_[left_count_++] = static_cast<std::uint32_t>(i);
      } else {
        contacts.write(lane, (turns >> lane & 1U) != 0, *pairs_[i].manifold);
      }
    }
  }

  HWY_INLINE void contact_edges(List& list) {
    list.fill_last_group();
    for (std::size_t from = 0; from < list.count; from += pairs_at_once) {
      const EdgeContacts<T> contacts{EdgePairs<T>(list.group(from))};
      write(contacts, list, from);
    }
  }

  /// For pairs whose axis may be parallel to a face normal: handles groups whose reference faces are all on the first
  /// boxes, and sorts the others by their reference faces.
  HWY_INLINE void contact_level() {
    for (std::size_t i = 0; i < lists_[unknown].count; ++i) left_[left_count_++] = lists_[unknown].pairs[i];
    List& list = lists_[level];
    list.fill_last_group();
    FaceContacts<T> contacts[2];
    std::size_t from[2];
    std::size_t filled = 0;
    for (std::size_t next = 0; next < list.count; next += pairs_at_once) {
      if (!fill_off_axis(list.group(next), false, contacts[filled])) {
        sort_level(list, next);
        continue;
      }
      from[filled++] = next;
      if (filled < 2) continue;
      write_two(contacts, from, filled, list);
      filled = 0;
    }
    if (filled > 0) write_two(contacts, from, filled, list);
  }

  /// For pairs whose reference faces are given by their axis tests. If not `is_known`, returns false unless all are.
  HWY_NOINLINE static bool fill_off_axis(const PairGroup<T>& group, bool is_known, FaceContacts<T>& contacts) {
    const ClipInput lanes = clip_input(OffAxisPairs<T>(group));
    if (!is_known && !hn::AllTrue(Tag<double>(), are_on_face(lanes))) return false;
    contacts.fill(lanes);
    return true;
  }

  HWY_NOINLINE void sort_level(const List& list, std::size_t from) {
    const ReferenceBoxes reference(OffAxisPairs<T>(list.group(from)));
    const std::uint32_t by_first = reference.by_first();
    const std::uint32_t by_second = reference.by_second();
    for (std::size_t lane = 0; lane < std::min(pairs_at_once, list.count - from); ++lane) {
      const std::size_t at = from + lane;
      const bool is_on_face = ((by_first | by_second) >> lane & 1U) != 0;
      const std::uint64_t of_second = (by_second >> lane & 1U) != 0 ? reference_on_second : 0;
      const Sort sort = is_on_face ? Sort{off_axis, false} : sorts[list.looks[at] & ObbAxisTest::axis_bits];
      put(sort, sort.exchanged, list.first[at], list.second[at], list.looks[at] | of_second, list.pairs[at]);
    }
  }

  std::span<const ObbsToContact<T>> pairs_;
  std::uint32_t* left_;
  std::size_t left_count_ = 0;
  std::array<List, kinds> lists_;
};

template <class T>
std::size_t contact_obbs(std::span<const ObbsToContact<T>> pairs, std::uint32_t* left) {
  assert(pairs.size() <= most_obbs_to_contact);
  return ContactBatch<T>(pairs, left).left_count();
}

#else

template <class T>
void look_at_obbs(std::span<const TwoObbs<T>> pairs, FirstBox /*first*/, ObbAxisTest* looks) {
  std::fill_n(looks, pairs.size(), ObbAxisTest{});
}

template <class T>
std::size_t contact_obbs(std::span<const ObbsToContact<T>> pairs, std::uint32_t* left) {
  for (std::size_t i = 0; i < pairs.size(); ++i) left[i] = static_cast<std::uint32_t>(i);
  return pairs.size();
}

#endif

}  // namespace

const AllObbKernels& all_obb_kernels() {
  static const AllObbKernels kernels{{look_at_obbs<float>, contact_obbs<float>},
                                     {look_at_obbs<double>, contact_obbs<double>}};
  return kernels;
}

}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graze::detail {
namespace {
HWY_EXPORT(all_obb_kernels);
}

template <class T>
const ObbKernels<T>& obb_kernels() {
  return HWY_DYNAMIC_DISPATCH(all_obb_kernels)().template of<T>();
}

template const ObbKernels<float>& obb_kernels<float>();
template const ObbKernels<double>& obb_kernels<double>();

}  // namespace graze::detail
#endif
