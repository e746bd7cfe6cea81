// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <iterator>
#include <span>
#include <type_traits>

namespace graze::detail {

/// A vector that does not allocate: it holds at most `Room` elements in the object itself. Check `is_full` before
/// adding (asserted). Unused elements are neither written nor copied.
template <class Element, std::size_t Room>
class InplaceVector {
  static_assert(std::is_trivially_copyable_v<Element>);

 public:
  using value_type = Element;

  InplaceVector() = default;
  explicit InplaceVector(std::span<const Element> elements) : size_(elements.size()) {
    assert(size_ <= Room);
    std::copy(elements.begin(), elements.end(), begin());
  }
  InplaceVector(const InplaceVector& other) : size_(other.size_) { std::copy(other.begin(), other.end(), begin()); }
  InplaceVector& operator=(const InplaceVector& other) {
    size_ = other.size_;
    if (this != &other) std::copy(other.begin(), other.end(), begin());
    return *this;
  }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  bool is_full() const { return size_ == Room; }

  std::span<const Element> all() const { return {elements_.data(), size_}; }

  Element* begin() { return elements_.data(); }
  Element* end() { return begin() + size_; }
  const Element* begin() const { return elements_.data(); }
  const Element* end() const { return begin() + size_; }
  auto rbegin() const { return std::make_reverse_iterator(end()); }
  auto rend() const { return std::make_reverse_iterator(begin()); }

  Element& operator[](std::size_t i) { return elements_[i]; }
  const Element& operator[](std::size_t i) const { return elements_[i]; }
  const Element& back() const { return elements_[size_ - 1]; }

  void push_back(const Element& element) {
    assert(!is_full());
    elements_[size_++] = element;
  }

  void pop_back() { --size_; }

  /// Removes all elements from `first_gone` on.
  void end_at(const Element* first_gone) { size_ = static_cast<std::size_t>(first_gone - begin()); }

 private:
  std::array<Element, Room> elements_;  // NOLINT(*-member-init): only what was put in is read
  std::size_t size_ = 0;
};

}  // namespace graze::detail
