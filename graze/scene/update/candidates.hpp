// SPDX-License-Identifier: MIT
// The pairs of slots that could touch, kept while boxes move little.
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
#include <graze/math/platform/export.hpp>
#include <graze/math/vec.hpp>
#include <graze/scene/object.hpp>
#include <graze/scene/storage/pair_exceptions.hpp>
#include <graze/scene/update/pair_graph.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::detail {

/// The boxes of slots, and the pairs of slots that could touch. Each box has a fat box: a previous state of the box
/// enlarged by a margin. A candidate is a pair of slots whose filters admit each other and whose fat boxes overlap
/// within touching_bounds. So as long as boxes stay inside their fat boxes, all pairs that could touch are candidates
/// (Catto 2019, "Dynamic bounding volume hierarchies"). Margins depend only on how far boxes have moved, as noted here.
///
/// Candidates are a list, for when most boxes move, or a graph, for when few do. Before the first call, and after a
/// call that threw, they may be neither; the next call then finds them anew. Every call is given the same exceptions as
/// the last one, up to the changes that `set_exceptions` and `put` have announced.
template <Dim N, class T>
class GRAZE_EXPORT Candidates {
 public:
  using Box = Aabb<N, T>;

  Candidates() = default;
  Candidates(Candidates&&) noexcept = default;
  Candidates& operator=(Candidates&&) noexcept = default;
  ~Candidates() = default;

  /// A copy contains the boxes, and the graph if there is one; it finds lists anew.
  Candidates(const Candidates& other);
  Candidates& operator=(const Candidates& other);

  /// Reserves memory for this many slots, so that `put` and `move` cannot fail.
  void reserve(std::size_t slots);

  /// The slot has a new object, or none, whose box is Box::nothing().
  void put(std::uint32_t slot, const Box& box, const PairFilter& filter) noexcept;

  /// The slot's object is now in an excepted pair, or in none, or has other ones: its pairs will be found anew.
  void set_exceptions(std::uint32_t slot, bool has_exceptions) noexcept;

  /// The slot's object has moved.
  void move(std::uint32_t slot, const Box& box) noexcept { boxes_[slot] = box; }

  /// The same for these objects, whose boxes are not empty.
  void move_all(std::span<const ObjectId> ids, std::span<const Box> boxes) noexcept {
    Box* const row = boxes_.data();
    const bool asks_ahead = boxes.size() * sizeof(Box) > bytes_near;
    for (std::size_t i = 0; i < ids.size(); ++i) {
      if (asks_ahead && i + prefetch_distance < ids.size()) prefetch(&row[ids[i + prefetch_distance].index]);
      row[ids[i].index] = boxes[i];
    }
  }

  /// The slots' boxes, plus one more element.
  const Box* boxes() const { return boxes_.data(); }
  void prefetch_slot(std::uint32_t slot) const { prefetch(&boxes_[slot]); }

  /// A bound on the magnitude of all finite coordinates of boxes. Valid after `list` and `follow`.
  T largest() const { return largest_; }

  /// Whether the filters of the two objects admit each other, and they are not excepted.
  bool is_admitted(const Pair& pair, const PairExceptions& exceptions) const {
    if (choosy_ == 0) return true;
    const PairFilter& a = filters_[pair.a];
    const PairFilter& b = filters_[pair.b];
    return may_touch(a, b) && !(a.has_exceptions && b.has_exceptions && exceptions.contains(pair.a, pair.b));
  }

  /// All candidates of the first `slots` slots, which must include all occupied ones, ascending. They may include pairs
  /// of removed objects that filters no longer admit, until the next call. Throws what the executor and allocation
  /// throw. Discards the graph.
  std::span<const Pair> list(std::size_t slots, const Executor& executor, const PairExceptions& exceptions = {});

  /// The number of the last such list: greater than zero, and different for each different list.
  std::uint64_t list_number() const { return list_number_; }

  /// Builds the graph of the candidates, of which those in `touching`, ascending, touch. Throws like `list`.
  void link(std::size_t slots, std::span<const Pair> touching, const Executor& executor,
            const PairExceptions& exceptions = {});

  bool is_linked() const { return form_ == Form::graph; }

  /// Updates the graph to contain all candidates, provided that only these slots have changed. It may keep pairs that
  /// are no longer candidates: those that touch or did touch, and those that filters no longer admit. Throws like
  /// `list`; the graph is then still valid for the next call.
  void follow(std::span<const std::uint32_t> changed, const Executor& executor, const PairExceptions& exceptions = {});

  PairGraph& graph() { return graph_; }
  const PairGraph& graph() const { return graph_; }

  /// Updates a pair that no longer touches, by its number in the graph.
  void part(const Pair& pair, std::uint32_t edge) noexcept;

 private:
  enum class Form : std::uint8_t { none, list, graph };

  bool is_at_home(std::uint32_t slot) const;
  bool have_stayed(std::size_t slots);
  T margin_for_all();
  T margin_for_graph(std::size_t slots) const;
  T margin_for(std::uint32_t slot) const;
  void set_filter(std::uint32_t slot, const PairFilter& filter) noexcept;
  void make_list(std::size_t slots, T margin, const Executor& executor, const PairExceptions& exceptions);
  void make_fat_boxes(std::size_t slots, T margin);
  void measure_sides(std::size_t slots) noexcept;
  void place(std::uint32_t slot);
  void find_around_strays(const Executor& executor, const PairExceptions& exceptions);
  void mend_graph();

  PageVector<Box> boxes_;           // by slot
  PageVector<Box> fat_boxes_;       // by slot
  PageVector<T> margins_;           // by slot: margin of its fat box
  PageVector<PairFilter> filters_;  // by slot
  std::size_t choosy_ = 0;          // number of filters that do not admit all
  T largest_ = 0;
  T mean_side_ = 0;  // mean side of boxes, when all were last measured

  Form form_ = Form::none;

  // The list.
  bool has_new_ = false;     // an object was added since it was made
  std::size_t uses_ = 0;     // how many times it was requested
  T margin_ = 0;             // margin of the fat boxes when it was made
  T step_ = 0;               // longest step of a box from then until the second request
  unsigned pause_ = 0;       // this many more lists are made without a margin
  unsigned next_pause_ = 1;  // the pause if the next margin is not worth it
  PairFinder<N, T> finder_;
  PageVector<Box> reaches_;    // touching_bounds of fat boxes
  PageVector<Pair> admitted_;  // used if the filters do not admit all
  std::span<const Pair> list_;
  std::uint64_t list_number_ = 0;

  // The graph.
  PairGraph graph_;
  BvhTree<N, T> tree_{0};      // the fat boxes
  PageVector<char> is_held_;   // by slot: its fat box is in the tree
  PageVector<char> is_stray_;  // by slot: its candidates are unknown
  PageVector<std::uint32_t> strays_;
  std::vector<std::vector<Pair>> found_;  // candidates of strays, by task
  PageVector<std::uint32_t> marks_;       // by slot: the last stray that has it as a candidate
  std::uint32_t mark_ = 0;
};

}  // namespace graze::detail
