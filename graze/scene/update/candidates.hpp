// SPDX-License-Identifier: MIT
// Which pairs of slots could touch, kept while boxes move a little.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <graze/broad/bvh/tree.hpp>
#include <graze/broad/executor.hpp>
#include <graze/broad/memory/buffer.hpp>
#include <graze/broad/memory/prefetch.hpp>
#include <graze/broad/pair.hpp>
#include <graze/broad/pairs.hpp>
#include <graze/math/vec.hpp>
#include <graze/scene/object.hpp>
#include <graze/scene/update/pair_graph.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::detail {

/// The boxes of slots, and the pairs of them that could touch. Each box has a room: the box as it was at some time,
/// grown by a margin. A candidate is a pair of slots whose rooms overlap, or nearly, as touching_bounds has it, and
/// whose filters admit each other; so as long as boxes stay within their rooms, all pairs that could touch are
/// candidates (enlarged boxes: Catto 2019, "Dynamic bounding volume hierarchies"). How large rooms are depends on how
/// far boxes have moved, and on nothing but what was noted.
///
/// Candidates are a list, for when most boxes move, or a graph, for when few do. Before the first call, and when one
/// has thrown, they may be neither: then the next call finds them anew.
template <Dim N, class T>
class Candidates {
 public:
  using Box = Aabb<N, T>;

  Candidates() = default;
  Candidates(Candidates&&) noexcept = default;
  Candidates& operator=(Candidates&&) noexcept = default;
  ~Candidates() = default;

  /// A copy knows the boxes, and the graph if there is one; a list it has to find again.
  Candidates(const Candidates& other);
  Candidates& operator=(const Candidates& other);

  /// Makes room for so many slots, so that `put` and `move` cannot fail.
  void reserve(std::size_t slots);

  /// Another object, or none, has come into the slot. The box of none is Box::nothing().
  void put(std::uint32_t slot, const Box& box, const PairFilter& filter) noexcept;

  /// The slot's object has another box.
  void move(std::uint32_t slot, const Box& box) noexcept { boxes_[slot] = box; }

  /// These objects have, and each box has points.
  void move_all(std::span<const ObjectId> ids, std::span<const Box> boxes) noexcept {
    Box* const row = boxes_.data();
    const bool asks_ahead = boxes.size() * sizeof(Box) > bytes_near;
    for (std::size_t i = 0; i < ids.size(); ++i) {
      if (asks_ahead && i + prefetch_distance < ids.size()) prefetch(&row[ids[i + prefetch_distance].index]);
      row[ids[i].index] = boxes[i];
    }
  }

  /// The slots' boxes, and one more.
  const Box* boxes() const { return boxes_.data(); }
  void prefetch_slot(std::uint32_t slot) const { prefetch(&boxes_[slot]); }

  /// After `list` and `follow`: no coordinate of a box is farther from zero, infinite ones aside.
  T largest() const { return largest_; }

  /// Whether the filters of the present objects admit each other.
  bool is_admitted(const Pair& pair) const { return choosy_ == 0 || may_touch(filters_[pair.a], filters_[pair.b]); }

  /// All candidates of the first `slots` slots, which must be all that hold anything, ascending. Among them may be some
  /// that filters no longer admit: those of slots whose object has gone. They stay until the next call. Throws what the
  /// executor and the memory throw. A graph is given up.
  std::span<const Pair> list(std::size_t slots, const Executor& executor);

  /// Of the last such list: greater than zero, and another for each that is not the same.
  std::uint64_t list_number() const { return list_number_; }

  /// Makes the graph of the candidates, of which those in `touching`, ascending, touch. Throws as `list` does.
  void link(std::size_t slots, std::span<const Pair> touching, const Executor& executor);

  bool is_linked() const { return form_ == Form::graph; }

  /// Sees to it that the graph has all candidates, where no other slot than these has changed. Among its pairs may be
  /// some that are none: which touch, or did, or which filters no longer admit. Throws as `list` does; the graph is
  /// then still good for the next call.
  void follow(std::span<const std::uint32_t> changed, const Executor& executor);

  PairGraph& graph() { return graph_; }
  const PairGraph& graph() const { return graph_; }

  /// Takes a pair that no longer touches, by its number in the graph, for what it is now.
  void part(const Pair& pair, std::uint32_t edge) noexcept;

 private:
  enum class Form : std::uint8_t { none, list, graph };

  bool is_at_home(std::uint32_t slot) const;
  bool have_stayed(std::size_t slots);
  T margin_for_all();
  T margin_for_graph(std::size_t slots) const;
  T margin_for(std::uint32_t slot) const;
  void make_list(std::size_t slots, T margin, const Executor& executor);
  void make_fat_boxes(std::size_t slots, T margin);
  void measure_sides(std::size_t slots) noexcept;
  void place(std::uint32_t slot);
  void find_around_strays(const Executor& executor);
  void mend_graph();

  PageVector<Box> boxes_;           // by slot
  PageVector<Box> fat_boxes_;       // by slot
  PageVector<T> margins_;           // by slot: of its room
  PageVector<PairFilter> filters_;  // by slot
  std::size_t choosy_ = 0;          // filters that do not admit all
  T largest_ = 0;
  T mean_side_ = 0;  // of boxes, at the last look at all of them

  Form form_ = Form::none;

  // The list.
  bool has_new_ = false;     // an object has come since it was made
  std::size_t uses_ = 0;     // how often it was wanted
  T margin_ = 0;             // of the rooms that it was made with
  T step_ = 0;               // the farthest that a box went after that, until it was wanted again
  unsigned pause_ = 0;       // so many lists are made without a margin
  unsigned next_pause_ = 1;  // if the next margin does not pay
  PairFinder<N, T> finder_;
  PageVector<Box> reaches_;    // touching_bounds of rooms
  PageVector<Pair> admitted_;  // where not all are
  std::span<const Pair> list_;
  std::uint64_t list_number_ = 0;

  // The graph.
  PairGraph graph_;
  BvhTree<N, T> tree_{0};      // of the rooms
  PageVector<char> is_held_;   // by slot: its room is in the tree
  PageVector<char> is_stray_;  // by slot: its candidates are not known
  PageVector<std::uint32_t> strays_;
  std::vector<std::vector<Pair>> found_;  // around the strays, by task
  PageVector<std::uint32_t> marks_;       // by slot: the last stray that has it as a candidate
  std::uint32_t mark_ = 0;
};

extern template class Candidates<2, float>;
extern template class Candidates<3, float>;
extern template class Candidates<2, double>;
extern template class Candidates<3, double>;

}  // namespace graze::detail
