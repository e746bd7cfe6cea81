// SPDX-License-Identifier: MIT
#include <array>
#include <cstddef>
#include <cstdint>
#include <variant>

#include <graze/broad/contacts.hpp>
#include <graze/broad/executor.hpp>
#include <graze/broad/manifold_kernels.hpp>
#include <graze/broad/manifolds.hpp>
#include <graze/broad/pair_tasks.hpp>

namespace graze {
namespace {

/// Manifolds per task, each a tenth of a microsecond or a few: as many as a kernel takes in one go.
constexpr std::size_t manifolds_per_task = 256;

/// The contacts of a task's pairs. Of oriented boxes in space those are collected that a kernel can take, which are
/// most; to take others of a kind together gains nothing, since a manifold takes far longer than it takes to find its
/// kind.
template <Dim N, class T>
class ContactsOfTask {
 public:
  explicit ContactsOfTask(std::span<const AnyShape<N, T>> shapes) : shapes_(shapes) {}

  /// `out` has room for as many.
  void run(std::span<const Pair> pairs, PairContact<N, T>* out) {
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      out[i].pair = pairs[i];
      if (!collect(out[i])) contact_one(out[i]);
    }
    if constexpr (N == 3) contact_collected();
  }

 private:
  static_assert(manifolds_per_task <= detail::most_obbs_to_contact);

  bool collect([[maybe_unused]] PairContact<N, T>& contact) {
    if constexpr (N == 3) {
      const auto* a = std::get_if<Obb<3, T>>(&shapes_[contact.pair.a]);
      const auto* b = std::get_if<Obb<3, T>>(&shapes_[contact.pair.b]);
      if (a == nullptr || b == nullptr) return false;
      boxes_[count_] = {a, b, &contact.manifold};
      of_boxes_[count_++] = &contact;
      return true;
    } else {
      return false;
    }
  }

  void contact_collected() {
    std::array<std::uint32_t, detail::most_obbs_to_contact> left;
    const std::size_t left_count = detail::manifold_kernel<T>()(std::span(boxes_).first(count_), left.data());
    for (std::size_t i = 0; i < left_count; ++i) contact_one(*of_boxes_[left[i]]);
  }

  void contact_one(PairContact<N, T>& contact) const {
    contact.manifold = manifold(shapes_[contact.pair.a], shapes_[contact.pair.b]);
  }

  std::span<const AnyShape<N, T>> shapes_;
  std::array<detail::ObbsToContact<T>, N == 3 ? detail::most_obbs_to_contact : 1> boxes_;
  std::array<PairContact<N, T>*, N == 3 ? detail::most_obbs_to_contact : 1> of_boxes_;
  std::size_t count_ = 0;
};

}  // namespace

template <Dim N, class T>
std::vector<PairContact<N, T>> contacts(std::span<const AnyShape<N, T>> shapes, std::span<const Pair> candidates,
                                        const TouchOptions& options) {
  detail::check_pairs(candidates, shapes.size(), "contacts");
  const std::vector<Pair> touching = touching_pairs(shapes, candidates, options);
  std::vector<PairContact<N, T>> result(touching.size());
  const Executor& executor = detail::executor_of(options);
  detail::in_tasks(touching.size(), manifolds_per_task, executor, [&](std::size_t first, std::size_t last) {
    ContactsOfTask<N, T>(shapes).run(std::span(touching).subspan(first, last - first), &result[first]);
  });
  return result;
}

#define GRAZE_INSTANTIATE(N, T)                                                                            \
  template std::vector<PairContact<N, T>> contacts(std::span<const AnyShape<N, T>>, std::span<const Pair>, \
                                                   const TouchOptions&);

GRAZE_INSTANTIATE(2, float)
GRAZE_INSTANTIATE(3, float)
GRAZE_INSTANTIATE(2, double)
GRAZE_INSTANTIATE(3, double)

#undef GRAZE_INSTANTIATE

}  // namespace graze
