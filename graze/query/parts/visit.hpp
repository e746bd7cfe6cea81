// SPDX-License-Identifier: MIT
// visit_parts(whole, may_matter, order, visit): the parts of a compound, or the faces of a mesh, that may decide a
// query, by the tree if there is one. With and without it the answers are the same, bit for bit, if the query keeps two
// rules: a box is refused only if no part in it can change the answer, and of two parts that are equally good, the one
// with the lesser index wins, not the first visited.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/mesh.hpp>
#include <graze/shape/parts/part_tree.hpp>
#include <graze/shape/triangle.hpp>

namespace graze::detail {

template <class S>
inline constexpr bool is_compound = false;
template <Dim N, class T>
inline constexpr bool is_compound<Compound<N, T>> = true;

template <class S>
inline constexpr bool is_mesh = false;
template <Dim N, class T>
inline constexpr bool is_mesh<Mesh<N, T>> = true;

/// A shape that queries decide part by part.
template <class S>
concept HasParts = is_compound<S> || is_mesh<S>;

/// A face of a mesh as a part of it.
template <Dim N, class T>
struct FacePart {
  Triangle<N, T> shape;
};

template <Dim N, class T>
const AnyShape<N, T>& part_of(const Compound<N, T>& compound, std::size_t index) {
  return compound.parts[index].shape;
}
template <Dim N, class T>
Triangle<N, T> part_of(const Mesh<N, T>& mesh, std::size_t index) {
  return mesh.triangle(index);
}

template <Dim N, class T>
std::size_t count_of_parts(const Compound<N, T>& compound) {
  return compound.parts.size();
}
template <Dim N, class T>
std::size_t count_of_parts(const Mesh<N, T>& mesh) {
  return mesh.faces().size();
}

/// For `visit_parts`: all of them.
struct AnyPart {
  template <class BoxOrPart>
  bool operator()(const BoxOrPart&) const {
    return true;
  }
};

/// For `visit_parts`: refers to what it calls, of any type. Queries on two shapes pass this unless a part is decided in
/// a few comparisons. So the way through a tree is compiled once and not again for each type of the other shape.
template <HasParts Whole>
class PartVisitor {
 public:
  static constexpr Dim N = dimension_of<Whole>;
  using T = scalar_of<Whole>;
  using Part = std::conditional_t<is_mesh<Whole>, FacePart<N, T>, graze::Part<N, T>>;

  template <class Visit>
  explicit PartVisitor(const Visit& visit)
      : visit_(&visit), call_([](const void* of_type, const Part& part, std::size_t index) {
          return (*static_cast<const Visit*>(of_type))(part, index);
        }) {}

  bool operator()(const Part& part, std::size_t index) const { return call_(visit_, part, index); }

 private:
  const void* visit_;
  bool (*call_)(const void*, const Part&, std::size_t);
};

/// Which of the parts visited so far decides: the one with the least value, of several the first of the whole.
class FirstPart {
 public:
  /// Whether a part decides, which is then remembered.
  bool is_replaced_by(double value, std::size_t index) {
    const bool is_better = is_none_ || value < value_ || (value == value_ && index < index_);
    if (!is_better) return false;
    is_none_ = false;
    value_ = value;
    index_ = index;
    return true;
  }

  bool is_none() const { return is_none_; }
  std::size_t index() const { return index_; }

 private:
  bool is_none_ = true;
  double value_ = 0;
  std::size_t index_ = 0;
};

/// For `visit_parts`: whether a part may touch what has a box, grown as by touching_bounds.
template <Dim N, class T>
struct MayTouch {
  bool operator()(const Aabb<N, T>& grown) const { return boxes_overlap(grown, box); }
#ifdef GRAZE_HAS_LANES
  LaneMask lanes(const BoxBlock<N, T>& grown) const { return overlapping_lanes(grown, box); }
#endif
  bool operator()(const Part<N, T>& part) const { return may_part_touch(part, box); }

  Aabb<N, T> box;
};

/// Calls use(may_matter), or use with the form that it has for boxes inside one, and for faces up to `error` away from
/// where the query sees them: may_matter.inside(box, error), which takes less time.
template <class MayMatter, class Box, class Use>
void with_form_inside(const MayMatter& may_matter, const Box& box, double error, const Use& use) {
  if constexpr (requires { may_matter.inside(box, error); }) {
    use(may_matter.inside(box, error));
  } else {
    use(may_matter);
  }
}

/// Out of line, so that small compounds are as fast as without trees.
template <Dim N, class T, class MayMatter, class Order, class Visit>
[[gnu::noinline]] void visit_parts_by_tree(const PartTree<N, T>& tree, const Compound<N, T>& compound,
                                           const MayMatter& may_matter, const Order& order, const Visit& visit) {
  for (const std::uint32_t index : tree.unbounded()) {
    const Part<N, T>& part = compound.parts[index];
    if (may_matter(part) && !visit(part, std::size_t{index})) return;
  }
  const auto visit_at = [&](std::uint32_t index, std::size_t /*place*/) {
    return visit(compound.parts[index], std::size_t{index});
  };
  with_form_inside(may_matter, tree.around(), 0, [&](const auto& form) { tree.visit(form, order, visit_at); });
}

/// Calls visit(part, index) until it returns false, for the parts that may matter: without a tree, those of which
/// may_matter(part) is true, in order; with a tree, those of which may_matter(box) is true for the part's box, grown as
/// by touching_bounds, and for the boxes around that, in the order of `BoxTree::visit`.
template <Dim N, class T, class MayMatter, class Order, class Visit>
[[gnu::always_inline]] inline void visit_parts(const Compound<N, T>& compound, const MayMatter& may_matter,
                                               const Order& order, const Visit& visit) {
  if (const PartTree<N, T>* const tree = tree_of(compound.parts)) {
    return visit_parts_by_tree(*tree, compound, may_matter, order, visit);
  }
  for (std::size_t i = 0; i < compound.parts.size(); ++i) {
    const Part<N, T>& part = compound.parts[i];
    if (may_matter(part) && !visit(part, i)) return;
  }
}

/// For the tree of a mesh that was moved: whether a box may matter at its place.
template <Dim N, class T, class MayMatter>
struct AtPlace {
  bool operator()(const Aabb<N, T>& box) const { return may_matter(faces.at_place(box)); }
  double key(const Aabb<N, T>& box) const { return may_matter.key(faces.at_place(box)); }
  bool admits(double key) const { return may_matter.admits(key); }
#ifdef GRAZE_HAS_LANES
  LaneMask lanes(const BoxBlock<N, T>& block) const requires TestsLanes<MayMatter, N, T> {
    BoxBlock<N, T> placed;
    return may_matter.lanes(faces.at_place(block, placed));
  }
  LaneMask lanes(const BoxBlock<N, T>& block, Row<T>& keys) const requires FindsKeysOfLanes<MayMatter, N, T> {
    BoxBlock<N, T> placed;
    return may_matter.lanes(faces.at_place(block, placed), keys);
  }
  LaneMask lanes(const TriangleBlock<N, T>& block) const requires TestsContents<MayMatter, TriangleBlock<N, T>> {
    TriangleBlock<N, T> placed;
    return may_matter.lanes(faces.at_place(block, placed));
  }
  LaneMask lanes(const TriangleBlock<N, T>& block,
                 Row<T>& keys) const requires FindsKeysOfContents<MayMatter, TriangleBlock<N, T>, T> {
    TriangleBlock<N, T> placed;
    return may_matter.lanes(faces.at_place(block, placed), keys);
  }
#endif

  const PlacedMesh<N, T>& faces;
  const MayMatter& may_matter;
};

/// BoxTree::visit for the faces of a mesh that its tree holds.
template <Dim N, class T, class MayMatter, class Order, class Visit>
void visit_faces(const PlacedMesh<N, T>& faces, const MayMatter& may_matter, const Order& order, const Visit& visit) {
  const auto& tree = faces.data()->tree();
  with_form_inside(may_matter, faces.at_place(tree.around()), faces.error_of_lanes(), [&](const auto& form) {
    if (!faces.is_moved()) return tree.visit(form, order, visit);
    tree.visit(AtPlace<N, T, std::decay_t<decltype(form)>>{faces, form}, order, visit);
  });
}

/// visit_parts for the faces of a mesh, which always has a tree.
template <Dim N, class T, class MayMatter, class Order, class Visit>
void visit_parts(const Mesh<N, T>& mesh, const MayMatter& may_matter, const Order& order, const Visit& visit) {
  const PlacedMesh<N, T>& faces = placed(mesh);
  for (const std::uint32_t face : faces.data()->tree().unbounded()) {
    if (!visit(FacePart<N, T>{faces.triangle(face)}, std::size_t{face})) return;
  }
  visit_faces(faces, may_matter, order, [&](std::uint32_t face, std::size_t place) {
    return visit(FacePart<N, T>{faces.triangle_in_tree(place)}, std::size_t{face});
  });
}

/// The same, in any order.
template <HasParts Whole, class MayMatter, class Visit>
[[gnu::always_inline]] inline void visit_parts(const Whole& whole, const MayMatter& may_matter, const Visit& visit) {
  visit_parts(whole, may_matter, InAnyOrder(), visit);
}

}  // namespace graze::detail
