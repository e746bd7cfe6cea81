// SPDX-License-Identifier: MIT
/// @file
/// A world of shapes that are added, moved and removed.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include <graze/broad/executor.hpp>
#include <graze/math/platform/export.hpp>
#include <graze/math/vec.hpp>
#include <graze/scene/events.hpp>
#include <graze/scene/object.hpp>
#include <graze/scene/scene_view.hpp>
#include <graze/scene/update/pair_keeper.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze {

/// A move of one of many objects.
template <Dim N, class T = float>
struct ObjectMove {
  ObjectId id;           ///< Names the object.
  AnyShape<N, T> shape;  ///< The new shape.
};

namespace detail {

/// The alternatives of AnyShape except compounds, whose copy can throw.
template <class S, Dim N, class T>
concept CopiedIntoAnyShape = requires(const S& shape) {
  { AnyShape<N, T>(shape) }
  noexcept;
};

}  // namespace detail

/// A collection of shapes with names, layers and lifetimes; the queries are in SceneView. Reading is const and safe
/// from many threads at once; writing needs exclusive access. A call that throws leaves the scene unchanged. No tuning
/// is needed: each `update` recomputes the pairs or repairs the known ones, whichever is less work, and queries account
/// for moved objects themselves. No result depends on that. Instantiated for 2D and 3D, float and double.
///
/// Results are values: a loop over `pairs()`, `ids()`, `overlapping(...)` and others may add, move and remove objects
/// and continues with the state at the query; ids of objects that it removes become stale (`contains`). References are
/// valid for a shorter time: that of `object` until the next add, move or remove of any object, that of `layer_names`
/// until the next `layer`, those of `update` and `events` until the next `update`, even one that throws. References
/// from a snapshot are valid as long as it lives.
template <Dim N, class T = float>
class GRAZE_EXPORT Scene : public SceneView<N, T> {
 public:
  /// Adds an object. Throws std::invalid_argument, naming the fault, if the shape is invalid (see `defect`), the name
  /// is taken or the layer is not below `max_layers`, and std::length_error beyond `max_objects`.
  ObjectId add(AnyShape<N, T> shape, ObjectOptions options = {});

  /// Continues a saved scene, so that its ids are valid here: the objects added next get the indices and generations of
  /// `next`, in this order; then vacant places are used as `vacant` lists them (see SceneView::vacant_ids). Throws
  /// std::logic_error if an object was ever added, and std::invalid_argument unless the indices are 0, 1, ..., each
  /// once, and generations odd in `next`, up to 4294967293, and even in `vacant`.
  void plan_ids(std::span<const ObjectId> next, std::span<const ObjectId> vacant);

  /// Replaces an object's shape. Throws std::invalid_argument if the shape is invalid and std::out_of_range if the id
  /// names no object.
  void move(ObjectId id, AnyShape<N, T> shape);

  /// Replaces the shapes of many objects, or of none if it throws. If an object is named twice, its last shape counts.
  /// Throws like the move of one.
  void move(std::span<const ObjectMove<N, T>> moves);

  /// Replaces the shapes of many objects by shapes of one type: faster than a list of any shapes. For compounds use
  /// that list. Also throws std::invalid_argument unless there are as many shapes as ids.
  template <detail::CopiedIntoAnyShape<N, T> S>
  void move(std::span<const ObjectId> ids, std::span<const S> shapes);

  /// The overload for vectors, from which the spans' template arguments cannot be deduced.
  template <class S>
  void move(const std::vector<ObjectId>& ids, const std::vector<S>& shapes) {
    move(std::span<const ObjectId>(ids.data(), ids.size()), std::span<const S>(shapes.data(), shapes.size()));
  }

  /// Removes an object; its id is never valid again. Throws std::out_of_range if the id names no object.
  void remove(ObjectId id);

  /// Excludes a pair of objects: from now on no query or update reports it. If it touched at the last update, the next
  /// one ends it. Objects in excepted pairs are found by all other queries, and cost an update a lookup for each
  /// candidate whose objects are both in such pairs. Removing an object forgets its exceptions. Throws
  /// std::out_of_range if an id names no object and std::invalid_argument if both name the same.
  void except(ObjectId a, ObjectId b);

  /// Undoes `except`: the pair is reported again if it touches. Throws likewise.
  void accept(ObjectId a, ObjectId b);

  /// The layer with this name, created if there is none. Throws std::length_error beyond `max_layers`.
  Layer layer(std::string_view name);

  /// Finds the pairs that touch now and how they changed since the last update, or since the scene was created.
  /// Afterwards `pairs` is only a copy, until the next change. The events stay unchanged until the next update: a loop
  /// over them may add, move and remove objects, which counts for the next update, but must not call `update`.
  const SceneEvents& update(const Executor& executor = default_executor());

  /// The events of the last update, valid until the next one; empty before the first.
  const SceneEvents& events() const { return *events_; }

  /// A read-only copy of the current state, for readers that keep it while the scene continues. It accepts the same
  /// ids. It copies no objects: it costs two pointers per 64 places, 4 bytes per place and again per vacant one, and
  /// the names of the layers, after it has brought the index of the queries up to date. Afterwards the scene copies
  /// what it changes: the block of 64 objects, or all names, events, or the index, at the first change of each. Counts
  /// as writing; readers of other snapshots are not affected.
  std::shared_ptr<const SceneView<N, T>> snapshot() { return this->share(); }

 private:
  using View = SceneView<N, T>;
  using View::events_;
  using View::exceptions_;
  using View::ids_;
  using View::index_;
  using View::is_current_;
  using View::layer_names_;
  using View::names_;
  using View::objects_;

  template <class S>
  void prepare_move(ObjectId id, const S& shape);
  void prepare_move(ObjectId id);
  bool are_ready_to_move(std::span<const ObjectId> ids) const;

  /// Prefetches what a move to a shape of this type will write.
  template <class S>
  void prefetch_move(std::uint32_t slot) const {
    objects_.template prefetch_first_of<sizeof(Aabb<N, T>) + sizeof(S)>(slot);
    keeper_.prefetch_slot(slot);
  }

  /// The room for the slot is already reserved.
  void note_moved(std::uint32_t slot, const Object<N, T>& object) noexcept {
    index_.note(slot);
    keeper_.note_moved(slot, object);
    is_current_ = false;
  }

  /// Replaces an object's shape and marks it as moved. Everything that can fail comes before.
  template <class S>
  void put(std::uint32_t slot, const S& shape) noexcept;
  void put(std::uint32_t slot, const Aabb<N, T>& box) noexcept;
  void write_box(std::uint32_t slot, const Aabb<N, T>& box) noexcept;

  /// The same for many objects.
  template <class S>
  void put_all(std::span<const ObjectId> ids, std::span<const S> shapes) noexcept;
  void put_all(std::span<const ObjectId> ids, std::span<const Aabb<N, T>> boxes) noexcept;

  detail::PairKeeper<N, T> keeper_;
  std::uint64_t last_changes_ = 0;  // ids_.changes() at the last update
  detail::YoungMarks young_;        // belongs to the last events, if the keeper has listed them
  detail::NextEvents next_;         // memory for the next update's events
  detail::EventsEdit next_edit_;    // and for the changes to the last ones
};

}  // namespace graze
