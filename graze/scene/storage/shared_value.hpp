// SPDX-License-Identifier: MIT
// One value that can be shared with copies that stay as they are: whoever writes copies it first.
#pragma once

#include <memory>
#include <utility>

namespace graze::detail {

/// `share` gives a copy at the price of a pointer; the first change on this side afterwards copies the value. A copy
/// that was shared is for reading alone: one thread may change the original while others read what was shared.
template <class Value>
class SharedValue {
 public:
  SharedValue() : value_(std::make_shared<Value>()) {}
  SharedValue(SharedValue&&) noexcept = default;
  SharedValue& operator=(SharedValue&&) noexcept = default;
  ~SharedValue() = default;

  /// A copy with nothing in common.
  SharedValue(const SharedValue& other) : value_(std::make_shared<Value>(*other.value_)) {}

  SharedValue& operator=(const SharedValue& other) {
    if (this != &other) *this = SharedValue(other);
    return *this;
  }

  const Value& operator*() const { return *value_; }
  const Value* operator->() const { return value_.get(); }

  /// The value, to be changed. May throw what copying it throws, before anything has changed.
  Value& change() {
    if (!is_own_) {
      value_ = std::make_shared<Value>(*value_);
      is_own_ = true;
    }
    return *value_;
  }

  /// Puts another value in the place of this one, which is handed out for `other` unless a copy goes on reading it:
  /// then that is left empty. May throw std::bad_alloc, before anything has changed.
  void exchange(Value& other) {
    if (is_own_) {
      std::swap(*value_, other);
      return;
    }
    auto fresh = std::make_shared<Value>();
    std::swap(*fresh, other);
    value_ = std::move(fresh);
    is_own_ = true;
  }

  /// What is here now, for reading.
  SharedValue share() {
    is_own_ = false;
    return SharedValue(value_, false);
  }

 private:
  SharedValue(std::shared_ptr<Value> value, bool is_own) : value_(std::move(value)), is_own_(is_own) {}

  std::shared_ptr<Value> value_;
  bool is_own_ = true;  // nobody else reads it
};

}  // namespace graze::detail
