// SPDX-License-Identifier: MIT
#include <algorithm>
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
namespace detail {
namespace {

/// Candidates per task, each some hundredths of a microsecond.
constexpr std::size_t candidates_per_task = 4096;

/// Manifolds per task, each some hundredths of a microsecond or more: as many as a kernel takes in one go.
constexpr std::size_t manifolds_per_task = most_obbs_to_contact;

/// A pair that touches, and what is known of it if both are oriented boxes in space.
struct TouchingPair {
  Pair pair;
  ObbsLook look;
};

template <Dim N, class T>
ShapePair<N, T> shapes_of(std::span<const AnyShape<N, T>> shapes, const Pair& pair) {
  return {&shapes[pair.a], &shapes[pair.b]};
}

/// Two shapes, if they are oriented boxes in space.
template <Dim N, class T>
TwoObbs<T> obbs_of([[maybe_unused]] const ShapePair<N, T>& shapes) {
  if constexpr (N == 3) {
    const auto* a = std::get_if<Obb<3, T>>(shapes.a);
    const auto* b = std::get_if<Obb<3, T>>(shapes.b);
    if (a != nullptr && b != nullptr) return {a, b};
  }
  return {nullptr, nullptr};
}

/// Looks at the axes of those of `count` pairs, shapes_at(0) ..., that are oriented boxes in space, and leaves the
/// looks of the others as they are.
template <Dim N, class T, class ShapesAt>
void look_at_boxes(std::size_t count, const ShapesAt& shapes_at, ObbsLook* looks) {
  std::array<TwoObbs<T>, most_obbs_to_contact> boxes;
  std::array<std::uint32_t, most_obbs_to_contact> places;
  std::size_t box_count = 0;
  const auto look = [&] {
    std::array<ObbsLook, most_obbs_to_contact> found;
    manifold_kernels<T>().look(std::span(boxes).first(box_count), found.data());
    for (std::size_t i = 0; i < box_count; ++i) looks[places[i]] = found[i];
    box_count = 0;
  };
  for (std::size_t i = 0; i < count; ++i) {
    boxes[box_count] = obbs_of<N, T>(shapes_at(i));
    places[box_count] = static_cast<std::uint32_t>(i);
    box_count += boxes[box_count].a != nullptr ? 1 : 0;
    if (box_count == boxes.size()) look();
  }
  if (box_count > 0) look();
}

/// Which candidates of a task touch. Oriented boxes in space show it, nearly all, by the look at their axes that their
/// contact needs.
template <Dim N, class T>
class CandidatesOfTask {
 public:
  CandidatesOfTask(std::span<const AnyShape<N, T>> shapes, std::span<const Pair> candidates)
      : shapes_(shapes), candidates_(candidates) {
    look_at_boxes<N, T>(
        candidates.size(), [this](std::size_t i) { return shapes_of<N, T>(shapes_, candidates_[i]); }, looks_.data());
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
  void judge_open() {
    std::vector<ShapePair<N, T>> open;
    std::vector<std::uint32_t> places;
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      if (looks_[i].is_overlapping != 0 || looks_[i].is_apart != 0) continue;
      open.push_back(shapes_of<N, T>(shapes_, candidates_[i]));
      places.push_back(static_cast<std::uint32_t>(i));
    }
    std::vector<Relation> relations(open.size());
    relations_of<N, T>(open, relations.data());
    for (std::size_t i = 0; i < open.size(); ++i) looks_[places[i]].is_apart = relations[i] == Relation::apart ? 1 : 0;
  }

  std::span<const AnyShape<N, T>> shapes_;
  std::span<const Pair> candidates_;
  std::array<ObbsLook, candidates_per_task> looks_{};
};

/// The manifolds of a task's pairs, which touch. Of oriented boxes in space those are collected that a kernel can take,
/// which are most; to take others of a kind together gains nothing, since a manifold takes far longer than it takes to
/// find its kind.
template <Dim N, class T>
class ManifoldsOfTask {
 public:
  /// At most as many as a task has, each with what a look has shown.
  void add(const ShapesToContact<N, T>& pair, [[maybe_unused]] ObbsLook look) {
    if constexpr (N == 3) {
      if (look.axis != ObbsLook::no_axis) {
        boxes_[count_] = {obbs_of<N, T>(pair.shapes), look, pair.manifold};
        of_boxes_[count_++] = pair;
        return;
      }
    }
    contact_one(pair);
  }

  /// To be called once, after the last pair.
  void finish() const {
    if constexpr (N == 3) {
      std::array<std::uint32_t, manifolds_per_task> left;
      const std::size_t left_count = manifold_kernels<T>().contact(std::span(boxes_).first(count_), left.data());
      for (std::size_t i = 0; i < left_count; ++i) contact_one(of_boxes_[left[i]]);
    }
  }

 private:
  static void contact_one(const ShapesToContact<N, T>& pair) {
    *pair.manifold = manifold(*pair.shapes.a, *pair.shapes.b);
  }

  std::array<ObbsToContact<T>, N == 3 ? manifolds_per_task : 1> boxes_;
  std::array<ShapesToContact<N, T>, N == 3 ? manifolds_per_task : 1> of_boxes_;
  std::size_t count_ = 0;
};

}  // namespace

template <Dim N, class T>
void contacts_of(std::span<const ShapesToContact<N, T>> pairs) {
  for (std::size_t first = 0; first < pairs.size(); first += manifolds_per_task) {
    const auto some = pairs.subspan(first, std::min(manifolds_per_task, pairs.size() - first));
    std::array<ObbsLook, manifolds_per_task> looks{};
    look_at_boxes<N, T>(
        some.size(), [&some](std::size_t i) { return some[i].shapes; }, looks.data());
    ManifoldsOfTask<N, T> manifolds;
    for (std::size_t i = 0; i < some.size(); ++i) manifolds.add(some[i], looks[i]);
    manifolds.finish();
  }
}

}  // namespace detail

template <Dim N, class T>
std::vector<PairContact<N, T>> contacts(std::span<const AnyShape<N, T>> shapes, std::span<const Pair> candidates,
                                        const TouchOptions& options) {
  detail::check_pairs(candidates, shapes.size(), "contacts");
  const Executor& executor = detail::executor_of(options);
  const auto touching = detail::kept_of_tasks<detail::TouchingPair>(
      candidates.size(), detail::candidates_per_task, executor,
      [&](std::size_t first, std::size_t last, detail::TouchingPair* out) {
        return detail::CandidatesOfTask<N, T>(shapes, candidates.subspan(first, last - first)).keep_touching(out);
      });
  std::vector<PairContact<N, T>> result(touching.size());
  detail::in_tasks(touching.size(), detail::manifolds_per_task, executor, [&](std::size_t first, std::size_t last) {
    detail::ManifoldsOfTask<N, T> manifolds;
    for (std::size_t i = first; i < last; ++i) {
      result[i].pair = touching[i].pair;
      manifolds.add({detail::shapes_of<N, T>(shapes, touching[i].pair), &result[i].manifold}, touching[i].look);
    }
    manifolds.finish();
  });
  return result;
}

#define GRAZE_INSTANTIATE(N, T)                                                                            \
  template std::vector<PairContact<N, T>> contacts(std::span<const AnyShape<N, T>>, std::span<const Pair>, \
                                                   const TouchOptions&);                                   \
  template void detail::contacts_of(std::span<const detail::ShapesToContact<N, T>>);

GRAZE_INSTANTIATE(2, float)
GRAZE_INSTANTIATE(3, float)
GRAZE_INSTANTIATE(2, double)
GRAZE_INSTANTIATE(3, double)

#undef GRAZE_INSTANTIATE

}  // namespace graze
