// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <initializer_list>
#include <memory>
#include <utility>
#include <vector>

#include <graze/math/vec.hpp>
#include <graze/shape/parts/part_tree.hpp>

namespace graze {

/// A shape and a box around it; defined in any_shape.hpp.
template <Dim N, class T>
struct Part;

template <Dim N, class T>
class Parts;

namespace detail {
template <Dim N, class T>
Parts<N, T> parts_with_tree(std::vector<Part<N, T>> list, PartTree<N, T> tree);
template <Dim N, class T>
const PartTree<N, T>* tree_of(const Parts<N, T>& parts);
}  // namespace detail

/// The parts of a compound: a std::vector that also keeps the tree by which queries find parts, if `compound_of` has
/// built one. Copies share the tree. Every function that could change a part, including non-const access to one, drops
/// the tree for good, so that it always belongs to the parts; then queries test all of them, with the same answers. So
/// read the parts of a compound through a const reference, or std::as_const. The members that are not listed in the
/// reference are those of std::vector.
template <Dim N, class T = float>
class Parts {
 public:
  /// @cond as in std::vector
  using value_type = Part<N, T>;
  using size_type = std::size_t;
  using difference_type = std::ptrdiff_t;
  using reference = Part<N, T>&;
  using const_reference = const Part<N, T>&;
  using iterator = typename std::vector<Part<N, T>>::iterator;
  using const_iterator = typename std::vector<Part<N, T>>::const_iterator;

  Parts() = default;
  /// @endcond
  /// From parts with their boxes, without a tree.
  Parts(std::vector<Part<N, T>> list) : list_(std::move(list)) {}
  /// @cond as in std::vector
  Parts(std::initializer_list<Part<N, T>> list) : list_(list) {}
  Parts(const Parts& other) : list_(other.list_), tree_(shared(other.tree_)) {}
  Parts(Parts&& other) noexcept = default;
  /// Into new memory, because references to the parts before may still exist.
  Parts& operator=(const Parts& other) { return *this = Parts(other); }
  Parts& operator=(Parts&& other) noexcept = default;
  ~Parts() = default;

  std::size_t size() const { return list_.size(); }
  bool empty() const { return list_.empty(); }
  const Part<N, T>& operator[](std::size_t index) const { return list_[index]; }
  const Part<N, T>& at(std::size_t index) const { return list_.at(index); }
  const Part<N, T>& front() const { return list_.front(); }
  const Part<N, T>& back() const { return list_.back(); }
  const Part<N, T>* data() const { return list_.data(); }
  const_iterator begin() const { return list_.begin(); }
  const_iterator end() const { return list_.end(); }
  const_iterator cbegin() const { return list_.cbegin(); }
  const_iterator cend() const { return list_.cend(); }
  /// @endcond

  /// The parts as a vector, to read.
  operator const std::vector<Part<N, T>>&() const { return list_; }

  /// The parts as a vector, to change them in any way.
  std::vector<Part<N, T>>& edit() {
    tree_.reset();
    return list_;
  }
  /// @cond as in std::vector
  Part<N, T>& operator[](std::size_t index) { return edit()[index]; }
  Part<N, T>& at(std::size_t index) { return edit().at(index); }
  Part<N, T>& front() { return edit().front(); }
  Part<N, T>& back() { return edit().back(); }
  Part<N, T>* data() { return edit().data(); }
  iterator begin() { return edit().begin(); }
  iterator end() { return edit().end(); }
  void reserve(std::size_t capacity) { edit().reserve(capacity); }
  void resize(std::size_t size) { edit().resize(size); }
  void clear() { edit().clear(); }
  void pop_back() { edit().pop_back(); }
  void push_back(Part<N, T> part) { edit().push_back(std::move(part)); }
  template <class... Arguments>
  iterator insert(const Arguments&... arguments) {
    return edit().insert(arguments...);
  }
  template <class... Places>
  iterator erase(const Places&... places) {
    return edit().erase(places...);
  }
  /// @endcond

 private:
  using Tree = std::shared_ptr<const detail::PartTree<N, T>>;

  friend Parts<N, T> detail::parts_with_tree<N, T>(std::vector<Part<N, T>> list, detail::PartTree<N, T> tree);
  friend const detail::PartTree<N, T>* detail::tree_of<N, T>(const Parts<N, T>& parts);

  static std::unique_ptr<const Tree> shared(const std::unique_ptr<const Tree>& tree) {
    return tree ? std::make_unique<const Tree>(*tree) : nullptr;
  }

  std::vector<Part<N, T>> list_;
  // One pointer, because with two, a compound in 2D would be larger than any other alternative of AnyShape.
  std::unique_ptr<const Tree> tree_;
};

namespace detail {

template <Dim N, class T>
Parts<N, T> parts_with_tree(std::vector<Part<N, T>> list, PartTree<N, T> tree) {
  using Tree = typename Parts<N, T>::Tree;
  Parts<N, T> parts(std::move(list));
  parts.tree_ = std::make_unique<const Tree>(std::make_shared<const PartTree<N, T>>(std::move(tree)));
  return parts;
}

/// The tree over the parts; null if there is none.
template <Dim N, class T>
const PartTree<N, T>* tree_of(const Parts<N, T>& parts) {
  return parts.tree_ ? parts.tree_->get() : nullptr;
}

}  // namespace detail

}  // namespace graze
