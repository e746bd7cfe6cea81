// SPDX-License-Identifier: MIT
// Passes many pairs to a kernel in groups of one pair per lane. Included once per instruction set, so it has no
// ordinary include guard.
#if defined(GRAZE_BROAD_CONTACTS_CONTACT_GROUPS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BROAD_CONTACTS_CONTACT_GROUPS_INL_HPP
#undef GRAZE_BROAD_CONTACTS_CONTACT_GROUPS_INL_HPP
#else
#define GRAZE_BROAD_CONTACTS_CONTACT_GROUPS_INL_HPP
#endif

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include <hwy/highway.h>

#include <graze/broad/contacts/contact_kernels.hpp>
#include <graze/broad/contacts/manifold_lanes-inl.hpp>

HWY_BEFORE_NAMESPACE();
namespace graze::detail::HWY_NAMESPACE {

/// Writes the manifolds of the pairs that it does not leave, as a ContactKernel. contacts_of(first, second, turned)
/// calculates those of a group: the arguments are the addresses of the shapes' numbers, and one bit per pair for
/// `turned`.
template <Dim N, class T, class ContactsOf>
HWY_INLINE std::size_t contact_groups(std::span<const PrimitivesToContact<N, T>> pairs, std::uint32_t* left,
                                      const ContactsOf& contacts_of) {
  std::size_t left_count = 0;
  for (std::size_t from = 0; from < pairs.size(); from += pairs_at_once) {
    const std::size_t count = std::min(pairs_at_once, pairs.size() - from);
    const T* first[pairs_at_once];
    const T* second[pairs_at_once];
    std::uint32_t turned = 0;
    for (std::size_t lane = 0; lane < pairs_at_once; ++lane) {
      const PrimitivesToContact<N, T>& pair = pairs[lane < count ? from + lane : from];
      first[lane] = pair.first;
      second[lane] = pair.second;
      turned |= std::uint32_t{pair.turned} << lane;
    }
    const auto contacts = contacts_of(first, second, turned);
    for (std::size_t lane = 0; lane < count; ++lane) {
      if (HWY_LIKELY(contacts.is_clear(lane))) {
        contacts.write(lane, *pairs[from + lane].manifold);
      } else {
        left[left_count++] = static_cast<std::uint32_t>(from + lane);
      }
    }
  }
  return left_count;
}

}  // namespace graze::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
