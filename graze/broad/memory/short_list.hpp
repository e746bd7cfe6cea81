// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace graze::detail {

/// A stack with storage for `Room` elements in the object itself; it allocates only beyond that. For traversals, which
/// seldom need more.
template <class Element, std::size_t Room>
class ShortList {
  static_assert(std::is_trivially_copyable_v<Element>);

 public:
  ShortList() = default;
  ShortList(const ShortList&) = delete;
  ShortList& operator=(const ShortList&) = delete;

  bool empty() const { return size_ == 0; }
  std::size_t size() const { return size_; }
  Element* begin() { return room_ == Room ? here_.data() : elsewhere_.data(); }
  Element* end() { return begin() + size_; }

  void push(const Element& element) {
    if (size_ == room_) grow();
    *end() = element;
    ++size_;
  }

  /// Branch-free conditional push.
  void push_if(bool condition, const Element& element) {
    if (size_ == room_) grow();
    *end() = element;
    size_ += condition ? 1U : 0U;
  }

  /// Space for `more` elements behind the last one. `append` says how many were written there.
  Element* room_for(std::size_t more) {
    while (room_ - size_ < more) grow();
    return end();
  }
  void append(std::size_t written) { size_ += written; }

  Element pop() {
    --size_;
    return *end();
  }

 private:
  void grow() {
    std::vector<Element> larger(2 * room_);
    std::copy(begin(), end(), larger.begin());
    elsewhere_ = std::move(larger);
    room_ *= 2;
  }

  std::array<Element, Room> here_;  // NOLINT(*-member-init): only what was pushed is read
  std::vector<Element> elsewhere_;
  std::size_t size_ = 0;
  std::size_t room_ = Room;
};

/// A heap on a ShortList: `pop` returns the element that comes before all others.
template <class Element, std::size_t Room, class Before>
class ShortHeap {
 public:
  bool empty() const { return elements_.empty(); }

  /// What `pop` would return.
  const Element& top() { return *elements_.begin(); }

  void push(const Element& element) {
    elements_.push(element);
    std::push_heap(elements_.begin(), elements_.end(), after_);
  }

  Element pop() {
    std::pop_heap(elements_.begin(), elements_.end(), after_);
    return elements_.pop();
  }

 private:
  struct After {
    bool operator()(const Element& a, const Element& b) const { return Before{}(b, a); }
  };

  ShortList<Element, Room> elements_;
  After after_;
};

}  // namespace graze::detail
