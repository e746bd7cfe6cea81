// SPDX-License-Identifier: MIT
// A world of shapes that come, move and go.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include <graze/broad/executor.hpp>
#include <graze/math/vec.hpp>
#include <graze/scene/events.hpp>
#include <graze/scene/object.hpp>
#include <graze/scene/scene_view.hpp>
#include <graze/scene/update/pair_keeper.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze {

/// One of many objects to be moved at once.
template <Dim N, class T = float>
struct ObjectMove {
  ObjectId id;
  AnyShape<N, T> shape;  ///< Where it is now.
};

namespace detail {

/// What AnyShape holds but compounds, which can fail to be copied.
template <class S, Dim N, class T>
concept CopiedIntoAnyShape = requires(const S& shape) {
  { AnyShape<N, T>(shape) }
  noexcept;
};

}  // namespace detail

/// Shapes with names, layers and lifetimes; what can be asked of them is in SceneView. Reading is const and safe from
/// many threads at once; writing is for one, while none reads. A call that throws leaves the scene as it was. Nothing
/// needs tuning: each `update` finds pairs anew or mends those it knows, as less work is to do, and queries catch up
/// with what has moved by themselves. No answer depends on that. Instantiated for 2D and 3D, float and double.
///
/// Answers are values: a loop through `pairs()`, `ids()`, `overlapping(...)` or any other may add, move and remove in
/// its body, and goes on through what was so when it asked; an id of what it has removed is stale, as `contains` says.
/// References are good for less long: what `object` returns until the next add, move or remove of any object, what
/// `layer_names` returns until the next `layer`, what `update` and `events` return until the next `update`, also one
/// that throws. A snapshot's are good as long as it lives.
template <Dim N, class T = float>
class Scene : public SceneView<N, T> {
 public:
  /// Adds an object. Throws std::invalid_argument, naming the fact, when the shape is not valid (see `defect`),
  /// the name is taken or the layer is not below `max_layers`; std::length_error beyond `max_objects`.
  ObjectId add(AnyShape<N, T> shape, ObjectOptions options = {});

  /// Makes a scene go on as a saved one did, whose ids have then a meaning here: the objects added next get the indexes
  /// and generations of `next` in this order, and then free places are used as `vacant` says (see
  /// SceneView::vacant_ids). Throws std::logic_error when an object was ever added; std::invalid_argument unless the
  /// indexes are 0, 1, ..., each once, and generations odd in `next`, up to 4294967293, and even in `vacant`.
  void plan_ids(std::span<const ObjectId> next, std::span<const ObjectId> vacant);

  /// Replaces an object's shape. Throws like `add` and `object`.
  void move(ObjectId id, AnyShape<N, T> shape);

  /// Replaces the shapes of many objects, or of none if it throws. Of an object that is named twice, the last shape
  /// counts.
  void move(std::span<const ObjectMove<N, T>> moves);

  /// The same for objects that are all to have a shape of one type: sooner than by a list of any shapes. Compounds go
  /// by that list. Throws std::invalid_argument unless there are as many shapes as ids.
  template <detail::CopiedIntoAnyShape<N, T> S>
  void move(std::span<const ObjectId> ids, std::span<const S> shapes);

  /// The same for vectors, whose types deduce where those of spans do not.
  template <class S>
  void move(const std::vector<ObjectId>& ids, const std::vector<S>& shapes) {
    move(std::span<const ObjectId>(ids.data(), ids.size()), std::span<const S>(shapes.data(), shapes.size()));
  }

  /// Removes an object; its id is never valid again. Throws like `object`.
  void remove(ObjectId id);

  /// The layer of that name; made if there is none yet. Throws std::length_error beyond `max_layers`.
  Layer layer(std::string_view name);

  /// Finds the pairs that touch now, and what has changed since the last update, or since the scene was empty. `pairs`
  /// is but a copy from then on, until the next change. The events stay as they are until the next update: a loop
  /// through them may add, move and remove, which is for the next, but not update.
  const SceneEvents& update(const Executor& executor = default_executor());

  /// What the last update found, good as long as what that returned; nothing before the first.
  const SceneEvents& events() const { return *events_; }

  /// The scene as it is now, for readers that keep it while this one goes on. Answers to the same ids. It copies no
  /// object: it costs two pointers for every 64 places, 4 bytes for each place and as many again for a vacant one, and
  /// the names of the layers, once queries have caught up with what has moved, which it has them do. Afterwards this
  /// one copies what it changes first: of objects those of the same 64, and all names, events, or the index of the
  /// queries at the first change to each. Writing, as to threads; readers of other snapshots go on.
  std::shared_ptr<const SceneView<N, T>> snapshot() { return this->share(); }

 private:
  using View = SceneView<N, T>;
  using View::events_;
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

  /// Asks for what a move to a shape of this type will write.
  template <class S>
  void prefetch_move(std::uint32_t slot) const {
    objects_.template prefetch_first_of<sizeof(Aabb<N, T>) + sizeof(S)>(slot);
    keeper_.prefetch_slot(slot);
  }

  /// Room for the slot was made before.
  void note_moved(std::uint32_t slot, const Object<N, T>& object) noexcept {
    index_.note(slot);
    keeper_.note_moved(slot, object);
    is_current_ = false;
  }

  /// Gives an object a shape of one type and notes that it has moved. Everything that can fail was done before.
  template <class S>
  void put(std::uint32_t slot, const S& shape) noexcept;
  void put(std::uint32_t slot, const Aabb<N, T>& box) noexcept;
  void write_box(std::uint32_t slot, const Aabb<N, T>& box) noexcept;

  /// The same with many.
  template <class S>
  void put_all(std::span<const ObjectId> ids, std::span<const S> shapes) noexcept;
  void put_all(std::span<const ObjectId> ids, std::span<const Aabb<N, T>> boxes) noexcept;

  detail::PairKeeper<N, T> keeper_;
  std::uint64_t last_changes_ = 0;  // of ids, at the last update
  detail::YoungMarks young_;        // of the last events, where the keeper has listed them
  detail::NextEvents next_;         // room for those of the next update,
  detail::EventsEdit next_edit_;    // and for what becomes others
};

extern template class Scene<2, float>;
extern template class Scene<3, float>;
extern template class Scene<2, double>;
extern template class Scene<3, double>;

}  // namespace graze
