// SPDX-License-Identifier: MIT
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include <graze/broad/contacts.hpp>
#include <graze/broad/executor.hpp>
#include <graze/broad/manifold_kernels.hpp>
#include <graze/broad/manifolds.hpp>
#include <graze/broad/pair_tasks.hpp>
#include <graze/broad/relations.hpp>
#include <graze/query/relation.hpp>

namespace graze {
namespace {

/// Candidates per task, each some hundredths of a microsecond.
constexpr std::size_t candidates_per_task = 4096;

/// Manifolds per task, each some hundredths of a microsecond or more: as many as a kernel takes in one go.
constexpr std::size_t manifolds_per_task = detail::most_obbs_to_contact;

/// A pair that touches, and what is known of it if both are oriented boxes in space.
struct TouchingPair {
  Pair pair;
  detail::ObbsLook look;
};

/// Both shapes of a pair, if they are oriented boxes in space.
template <Dim N, class T>
detail::TwoObbs<T> obbs_of([[maybe_unused]] std::span<const AnyShape<N, T>> shapes, [[maybe_unused]] const Pair& pair) {
  if constexpr (N == 3) {
    const auto* a = std::get_if<Obb<3, T>>(&shapes[pair.a]);
    const auto* b = std::get_if<Obb<3, T>>(&shapes[pair.b]);
    if (a != nullptr && b != nullptr) return {a, b};
  }
  return {nullptr, nullptr};
}

/// Which candidates of a task touch. Oriented boxes in space show it, nearly all, by the look at their axes that their
/// contact needs.
template <Dim N, class T>
class CandidatesOfTask {
 public:
  CandidatesOfTask(std::span<const AnyShape<N, T>> shapes, std::span<const Pair> candidates)
      : shapes_(shapes), candidates_(candidates) {
    look_at_boxes();
    judge_open();
  }

  /// Writes those that touch to `out`, which has room for all, in their order. Returns how many.
  std::size_t keep_touching(TouchingPair* out) const {
    TouchingPair* end = out;
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      end->pair = candidates_[i];  // one by one: of a whole struct GCC makes a copy first, read otherwise than written
      end->look = looks_[i];
      end += looks_[i].is_apart != 0 ? 0 : 1;
    }
    return static_cast<std::size_t>(end - out);
  }

 private:
  void look_at_boxes() {
    std::array<detail::TwoObbs<T>, detail::most_obbs_to_contact> boxes;
    std::array<std::uint32_t, detail::most_obbs_to_contact> places;
    std::size_t count = 0;
    const auto look = [&] {
      std::array<detail::ObbsLook, detail::most_obbs_to_contact> looks;
      detail::manifold_kernels<T>().look(std::span(boxes).first(count), looks.data());
      for (std::size_t i = 0; i < count; ++i) looks_[places[i]] = looks[i];
      count = 0;
    };
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      boxes[count] = obbs_of<N, T>(shapes_, candidates_[i]);
      places[count] = static_cast<std::uint32_t>(i);
      count += boxes[count].a != nullptr ? 1 : 0;
      if (count == boxes.size()) look();
    }
    if (count > 0) look();
  }

  void judge_open() {
    std::vector<detail::ShapePair<N, T>> open;
    std::vector<std::uint32_t> places;
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      if (looks_[i].is_overlapping != 0 || looks_[i].is_apart != 0) continue;
      open.push_back({&shapes_[candidates_[i].a], &shapes_[candidates_[i].b]});
      places.push_back(static_cast<std::uint32_t>(i));
    }
    std::vector<Relation> relations(open.size());
    detail::relations_of<N, T>(open, relations.data());
    for (std::size_t i = 0; i < open.size(); ++i) looks_[places[i]].is_apart = relations[i] == Relation::apart ? 1 : 0;
  }

  std::span<const AnyShape<N, T>> shapes_;
  std::span<const Pair> candidates_;
  std::array<detail::ObbsLook, candidates_per_task> looks_{};
};

/// The contacts of a task's pairs. Of oriented boxes in space those are collected that a kernel can take, which are
/// most; to take others of a kind together gains nothing, since a manifold takes far longer than it takes to find its
/// kind.
template <Dim N, class T>
class ContactsOfTask {
 public:
  explicit ContactsOfTask(std::span<const AnyShape<N, T>> shapes) : shapes_(shapes) {}

  /// `out` has room for as many.
  void run(std::span<const TouchingPair> pairs, PairContact<N, T>* out) {
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      out[i].pair = pairs[i].pair;
      if (pairs[i].look.axis == detail::ObbsLook::no_axis || !collect(pairs[i].look, out[i])) contact_one(out[i]);
    }
    if constexpr (N == 3) contact_collected();
  }

 private:
  bool collect([[maybe_unused]] detail::ObbsLook look, [[maybe_unused]] PairContact<N, T>& contact) {
    if constexpr (N == 3) {
      boxes_[count_] = {obbs_of<N, T>(shapes_, contact.pair), look, &contact.manifold};
      of_boxes_[count_++] = &contact;
      return true;
    } else {
      return false;
    }
  }

  void contact_collected() {
    std::array<std::uint32_t, detail::most_obbs_to_contact> left;
    const std::size_t left_count = detail::manifold_kernels<T>().contact(std::span(boxes_).first(count_), left.data());
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
  const Executor& executor = detail::executor_of(options);
  const auto touching = detail::kept_of_tasks<TouchingPair>(
      candidates.size(), candidates_per_task, executor, [&](std::size_t first, std::size_t last, TouchingPair* out) {
        return CandidatesOfTask<N, T>(shapes, candidates.subspan(first, last - first)).keep_touching(out);
      });
  std::vector<PairContact<N, T>> result(touching.size());
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
