// SPDX-License-Identifier: MIT
// The interface of graze and other libraries in the comparison. Each library is one file, peer_<name>.cpp.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <graze/broad/pair.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::race {

/// One way to find all overlapping pairs in the frames of a scene. Virtual, because contestants are chosen at run time.
template <Dim N, class T>
class Contestant {
 public:
  Contestant() = default;
  virtual ~Contestant() = default;
  Contestant(const Contestant&) = delete;
  Contestant& operator=(const Contestant&) = delete;

  /// Every overlapping pair of boxes (touching counts) exactly once, with a < b, in any order. The boxes are those of
  /// the previous frame, as many, moved a little. The pairs are valid until the next call. This is what is timed.
  virtual std::span<const Pair> find(std::span<const Aabb<N, T>> boxes) = 0;
};

enum class Side { graze, peer };

/// A contestant before it starts.
template <Dim N, class T>
struct Entrant {
  std::string name;      ///< Its name in tables and charts.
  std::string settings;  ///< Version, and how it is used.
  Side side = Side::peer;
  std::size_t threads = 1;
  bool keeps = false;  ///< Whether it keeps a tree, the memory of its list or other data between frames.
  std::size_t most_boxes = std::numeric_limits<std::size_t>::max();
  std::string why_no_more;  ///< The reason for most_boxes.
  /// Prepares it for frames like this one. Not timed: data that is updated from frame to frame is created here.
  std::function<std::unique_ptr<Contestant<N, T>>(std::span<const Aabb<N, T>>)> prepare;
};

template <Dim N, class T>
using Entrants = std::vector<Entrant<N, T>>;

/// Each adds the library's contestants for a space, if any. Those that support several threads enter once with one
/// thread and, if `threads` is more, once with that many.
template <Dim N, class T>
void enter_graze(Entrants<N, T>& field, std::size_t threads);
template <Dim N, class T>
void enter_boost(Entrants<N, T>& field);
template <Dim N, class T>
void enter_embree(Entrants<N, T>& field, std::size_t threads);
template <Dim N, class T>
void enter_cgal(Entrants<N, T>& field, std::size_t threads);
template <Dim N, class T>
void enter_bullet(Entrants<N, T>& field);
template <Dim N, class T>
void enter_fcl(Entrants<N, T>& field);
template <Dim N, class T>
void enter_box2d(Entrants<N, T>& field);
template <Dim N, class T>
void enter_geos(Entrants<N, T>& field);
template <Dim N, class T>
void enter_jolt(Entrants<N, T>& field);  // only with GRAZE_PEERS_JOLT

/// All of them, graze first.
template <Dim N, class T>
Entrants<N, T> all_entrants(std::size_t threads) {
  Entrants<N, T> field;
  enter_graze(field, threads);
  enter_boost(field);
  enter_embree(field, threads);
  enter_cgal(field, threads);
  enter_bullet(field);
  enter_fcl(field);
  enter_box2d(field);
  enter_geos(field);
#ifdef GRAZE_PEERS_JOLT
  enter_jolt(field);
#endif
  return field;
}

/// Whether the memory of a contestant's list is kept between frames, which is faster, or allocated again, as for a
/// single call.
enum class ListMemory { kept, anew };

inline constexpr std::array list_memories{ListMemory::kept, ListMemory::anew};

inline void clear(std::vector<Pair>& list, ListMemory memory) {
  list.clear();
  if (memory == ListMemory::anew) list.shrink_to_fit();
}

/// Appends the treatment of its list to an entrant's name.
template <Dim N, class T>
void set_list_memory(Entrant<N, T>& entrant, ListMemory memory) {
  entrant.keeps = memory == ListMemory::kept;
  if (entrant.keeps) return;
  entrant.name += ", list anew";
  entrant.settings += "; new list of pairs";
}

/// The pair of two indices in any order.
inline Pair ascending(std::size_t i, std::size_t j) {
  const auto a = static_cast<std::uint32_t>(i);
  const auto b = static_cast<std::uint32_t>(j);
  return a < b ? Pair{a, b} : Pair{b, a};
}

}  // namespace graze::race
