// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <variant>
#include <vector>

#include <graze/broad/batch/tasks.hpp>
#include <graze/broad/contacts.hpp>
#include <graze/broad/contacts/2d/contacts.hpp>
#include <graze/broad/contacts/contact_kernels.hpp>
#include <graze/broad/contacts/mixed_contacts.hpp>
#include <graze/broad/contacts/obb/obb_kernels.hpp>
#include <graze/broad/executor.hpp>
#include <graze/broad/touching/pair_tasks.hpp>
#include <graze/query/manifold.hpp>
#include <graze/query/relation.hpp>
#include <graze/shape/fields/shape_order.hpp>

namespace graze {
namespace detail {
namespace {

/// Candidates per task, each taking some hundredths of a microsecond.
constexpr std::size_t candidates_per_task = 4096;

/// Manifolds per task, each taking some hundredths of a microsecond or more: the maximum of a kernel's batch.
constexpr std::size_t manifolds_per_task = most_obbs_to_contact;

/// A touching pair, and the axis test's result if both are 3D oriented boxes.
struct TouchingPair {
  Pair pair;
  ObbAxisTest look;
};

template <Dim N, class T>
ShapePair<N, T> shapes_of(std::span<const AnyShape<N, T>> shapes, const Pair& pair) {
  return {&shapes[pair.a], &shapes[pair.b]};
}

template <Dim N, class T>
bool is_obb(const AnyShape<N, T>& shape) {
  return std::holds_alternative<Obb<N, T>>(shape);
}

/// The address of the box in a shape that is one.
template <Dim N, class T>
const Obb<N, T>* obb_of(const AnyShape<N, T>& shape) {
  const auto* box = std::get_if<Obb<N, T>>(&shape);
#ifdef __GNUC__
  if (box == nullptr) __builtin_unreachable();
#endif
  return box;
}

/// test_axes for at most one batch.
template <class T, class ShapesAt>
void look_at_some_boxes(std::size_t count, const ShapesAt& shapes_at, ObbAxisTest* looks) {
  std::array<TwoObbs<T>, most_obbs_to_contact> boxes;
  std::array<std::uint16_t, most_obbs_to_contact> places;
  std::size_t box_count = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const ShapePair<3, T> shapes = shapes_at(i);
    if (!is_obb(*shapes.a) || !is_obb(*shapes.b)) continue;
    boxes[box_count] = {obb_of(*shapes.a), obb_of(*shapes.b)};
    places[box_count++] = static_cast<std::uint16_t>(i);
  }
  const auto some = std::span(boxes).first(box_count);
  if (box_count == count) return obb_kernels<T>().look(some, FirstBox::in_order, looks);
  std::array<ObbAxisTest, most_obbs_to_contact> found;
  obb_kernels<T>().look(some, FirstBox::in_order, found.data());
  for (std::size_t i = 0; i < box_count; ++i) looks[places[i]] = found[i];
}

/// Tests the axes of those of `count` pairs, shapes_at(0) ..., that are 3D oriented boxes; leaves the results of the
/// others unchanged.
template <Dim N, class T, class ShapesAt>
void test_axes(std::size_t count, const ShapesAt& shapes_at, ObbAxisTest* looks) {
  if constexpr (N == 3) {
    for (std::size_t first = 0; first < count; first += most_obbs_to_contact) {
      look_at_some_boxes<T>(
          std::min(most_obbs_to_contact, count - first),
          [&shapes_at, first](std::size_t i) { return shapes_at(first + i); }, looks + first);
    }
  }
}

/// Which candidates of a task touch. For nearly all 3D oriented boxes, the axis test that their contact needs anyway
/// decides.
template <Dim N, class T>
class CandidatesOfTask {
 public:
  CandidatesOfTask(std::span<const AnyShape<N, T>> shapes, std::span<const Pair> candidates)
      : shapes_(shapes), candidates_(candidates) {
    test_axes<N, T>(
        candidates.size(), [this](std::size_t i) { return shapes_of<N, T>(shapes_, candidates_[i]); }, looks_.data());
    judge_open();
  }

  /// Writes the touching pairs to `out`, which has space for all, in order. Returns their number.
  std::size_t keep_touching(TouchingPair* out) const {
    TouchingPair* end = out;
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      end->pair = candidates_[i];  // member by member: GCC would copy the struct with other widths than it was written
      end->look = looks_[i];
      end += looks_[i].is_apart() ? 0 : 1;
    }
    return static_cast<std::size_t>(end - out);
  }

 private:
  void judge_open() {
    const auto is_open = [](ObbAxisTest look) {
      return (look.bits & (ObbAxisTest::overlapping | ObbAxisTest::apart)) == 0;
    };
    std::size_t open_count = 0;
    for (std::size_t i = 0; i < candidates_.size(); ++i) open_count += is_open(looks_[i]) ? 1 : 0;
    if (open_count == 0) return;
    std::vector<ShapePair<N, T>> open;
    std::vector<std::uint32_t> places;
    open.reserve(open_count);
    places.reserve(open_count);
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      if (!is_open(looks_[i])) continue;
      open.push_back(shapes_of<N, T>(shapes_, candidates_[i]));
      places.push_back(static_cast<std::uint32_t>(i));
    }
    std::vector<Relation> relations(open.size());
    relations_of<N, T>(open, relations.data());
    for (std::size_t i = 0; i < open.size(); ++i) {
      looks_[places[i]].bits |= relations[i] == Relation::apart ? ObbAxisTest::apart : 0;
    }
  }

  std::span<const AnyShape<N, T>> shapes_;
  std::span<const Pair> candidates_;
  std::array<ObbAxisTest, candidates_per_task> looks_{};
};

/// Collects 3D pairs of spheres, capsules and boxes, except an oriented box with another box, by kind for the kernels
/// that write their manifolds.
template <class T>
class PrimitivePairs {
 public:
  using Shapes = ShapePair<3, T>;

  /// False for other pairs. The capacity is one task.
  bool add(const Shapes& shapes, Manifold<3, T>* manifold, std::size_t place) {
    if (const auto* sphere = std::get_if<Sphere3>(shapes.a))
      return add_sphere(*sphere, *shapes.b, false, manifold, place);
    if (const auto* sphere = std::get_if<Sphere3>(shapes.b))
      return add_sphere(*sphere, *shapes.a, true, manifold, place);
    if (const auto* capsule = std::get_if<Capsule3>(shapes.a);
        capsule != nullptr && add_capsule(*capsule, *shapes.b, false, manifold, place)) {
      return true;
    }
    if (const auto* capsule = std::get_if<Capsule3>(shapes.b);
        capsule != nullptr && add_capsule(*capsule, *shapes.a, true, manifold, place)) {
      return true;
    }
    return add_alike<Capsule3>(PrimitiveKind::capsule_capsule, shapes, manifold, place) ||
           add_alike<Aabb<3, T>>(PrimitiveKind::aabb_aabb, shapes, manifold, place);
  }

  /// Calls contact_one(index) for the pairs that the kernels leave.
  template <class ContactOne>
  void contact(const ContactOne& contact_one) const {
    for (std::size_t kind = 0; kind < primitive_kinds; ++kind) {
      const List& list = lists_[kind];
      if (list.count == 0) continue;
      std::array<std::uint32_t, manifolds_per_task> left;
      const std::size_t left_count = contact_kernels<T>()[kind](std::span(list.pairs).first(list.count), left.data());
      for (std::size_t i = 0; i < left_count; ++i) contact_one(list.places[left[i]]);
    }
  }

 private:
  using Sphere3 = Sphere<3, T>;
  using Capsule3 = Capsule<3, T>;

  struct List {
    std::array<PrimitivesToContact<3, T>, manifolds_per_task> pairs;
    std::array<std::uint16_t, manifolds_per_task> places;
    std::size_t count = 0;
  };

  bool add_sphere(const Sphere3& sphere, const AnyShape<3, T>& other, bool turned, Manifold<3, T>* manifold,
                  std::size_t place) {
    const auto add_to = [&](PrimitiveKind kind, const auto* held) {
      if (held != nullptr) put(kind, {numbers(sphere), numbers(*held), turned, manifold}, place);
      return held != nullptr;
    };
    return add_to(PrimitiveKind::sphere_sphere, std::get_if<Sphere3>(&other)) ||
           add_to(PrimitiveKind::sphere_capsule, std::get_if<Capsule3>(&other)) ||
           add_to(PrimitiveKind::sphere_aabb, std::get_if<Aabb<3, T>>(&other)) ||
           add_to(PrimitiveKind::sphere_obb, std::get_if<Obb<3, T>>(&other));
  }

  /// With a box.
  bool add_capsule(const Capsule3& capsule, const AnyShape<3, T>& other, bool turned, Manifold<3, T>* manifold,
                   std::size_t place) {
    const auto add_to = [&](PrimitiveKind kind, const auto* held) {
      if (held != nullptr) put(kind, {numbers(capsule), numbers(*held), turned, manifold}, place);
      return held != nullptr;
    };
    return add_to(PrimitiveKind::capsule_aabb, std::get_if<Aabb<3, T>>(&other)) ||
           add_to(PrimitiveKind::capsule_obb, std::get_if<Obb<3, T>>(&other));
  }

  /// Two shapes of the same kind, in the order of their contact.
  template <class S>
  bool add_alike(PrimitiveKind kind, const Shapes& shapes, Manifold<3, T>* manifold, std::size_t place) {
    const auto* a = std::get_if<S>(shapes.a);
    const auto* b = std::get_if<S>(shapes.b);
    if (a == nullptr || b == nullptr) return false;
    const bool turned = !is_in_order(*a, *b);
    put(kind, {numbers(turned ? *b : *a), numbers(turned ? *a : *b), turned, manifold}, place);
    return true;
  }

  /// The address of its numbers: the struct contains nothing else.
  template <class S>
  static const T* numbers(const S& shape) {
    static_assert(std::is_standard_layout_v<S> && sizeof(S) % sizeof(T) == 0);
    return reinterpret_cast<const T*>(&shape);
  }

  void put(PrimitiveKind kind, const PrimitivesToContact<3, T>& pair, std::size_t place) {
    List& list = lists_[static_cast<std::size_t>(kind)];
    list.pairs[list.count] = pair;
    list.places[list.count++] = static_cast<std::uint16_t>(place);
  }

  std::array<List, primitive_kinds> lists_;
};

/// Writes the manifolds of a task's touching pairs: `count` of them, at most a task's worth. The one of shapes_at(i)
/// goes to manifold_at(i); look_at(i) is the result of its axis test. 3D pairs that kernels support, which are most
/// pairs of spheres, capsules and boxes, are collected for them. Grouping the others by kind gains nothing, since a
/// manifold takes far longer than finding its kind.
template <Dim N, class T, class ShapesAt, class LookAt, class ManifoldAt>
void write_manifolds(std::size_t count, const ShapesAt& shapes_at, const LookAt& look_at,
                     const ManifoldAt& manifold_at) {
  const auto contact_one = [&](std::size_t i) {
    const ShapePair<N, T> shapes = shapes_at(i);
    manifold_at(i) = manifold(*shapes.a, *shapes.b);
  };
  if constexpr (N == 3) {
    std::array<ObbsToContact<T>, manifolds_per_task> boxes;
    std::array<std::uint16_t, manifolds_per_task> places;
    std::size_t box_count = 0;
    PrimitivePairs<T> primitives;
    MixedPairs<T> mixed;
    for (std::size_t i = 0; i < count; ++i) {
      const ObbAxisTest look = look_at(i);
      const ShapePair<N, T> shapes = shapes_at(i);
      if (look.axis() == ObbAxisTest::no_axis) {
        if (!primitives.add(shapes, &manifold_at(i), i) && !mixed.add(shapes, &manifold_at(i), i)) contact_one(i);
        continue;
      }
      boxes[box_count] = {{obb_of(*shapes.a), obb_of(*shapes.b)}, look, &manifold_at(i)};
      places[box_count++] = static_cast<std::uint16_t>(i);
    }
    std::array<std::uint32_t, manifolds_per_task> left;
    const std::size_t left_count = obb_kernels<T>().contact(std::span(boxes).first(box_count), left.data());
    for (std::size_t i = 0; i < left_count; ++i) contact_one(places[left[i]]);
    primitives.contact(contact_one);
    mixed.contact(contact_one);
  } else {
    Pairs2d<T, manifolds_per_task> pairs;
    for (std::size_t i = 0; i < count; ++i) {
      if (!pairs.add(shapes_at(i), &manifold_at(i), i)) contact_one(i);
    }
    pairs.contact(contact_one);
  }
}

}  // namespace

template <Dim N, class T>
void contacts_of(std::span<const ShapesToContact<N, T>> pairs) {
  for (std::size_t first = 0; first < pairs.size(); first += manifolds_per_task) {
    const auto some = pairs.subspan(first, std::min(manifolds_per_task, pairs.size() - first));
    const auto shapes_at = [some](std::size_t i) { return some[i].shapes; };
    std::array<ObbAxisTest, manifolds_per_task> looks{};
    test_axes<N, T>(some.size(), shapes_at, looks.data());
    write_manifolds<N, T>(
        some.size(), shapes_at,
        [&looks](std::size_t i) { return looks[i]; }, [some](std::size_t i) -> auto& { return *some[i].manifold; });
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
  using Found = PairContact<N, T>;
  return detail::written_by_tasks<Found>(
      touching.size(), detail::manifolds_per_task, executor, [&](std::size_t first, std::size_t last, Found* out) {
        const detail::TouchingPair* const pairs = touching.data() + first;
        for (std::size_t i = 0; i < last - first; ++i) out[i].pair = pairs[i].pair;
        detail::write_manifolds<N, T>(
            last - first, [=](std::size_t i) { return detail::shapes_of<N, T>(shapes, pairs[i].pair); },
            [pairs](std::size_t i) { return pairs[i].look; },
            [out](std::size_t i) -> auto& { return out[i].manifold; });
      });
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
