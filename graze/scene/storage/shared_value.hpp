// SPDX-License-Identifier: MIT
// A value that can be shared with unchanging copies: writing copies it first.
#pragma once

#include <memory>
#include <utility>

namespace graze::detail {

/// `share` returns a copy at the cost of a pointer; the first change on this side afterwards copies the value. Shared
/// copies are read-only: one thread may change the original while others read them.
template <class Value>
class SharedValue {
 public:
  SharedValue() : value_(std::make_shared<Value>()) {}
  SharedValue(SharedValue&&) noexcept = default;
  SharedValue& operator=(SharedValue&&) noexcept = default;
  ~SharedValue() = default;

  /// A copy that shares nothing.
  SharedValue(const SharedValue& other) : value_(std::make_shared<Value>(*other.value_)) {}

  SharedValue& operator=(const SharedValue& other) {
    if (this != &other) *this = SharedValue(other);
    return *this;
  }

  const Value& operator*() const { return *value_; }
  const Value* operator->() const { return value_.get(); }

  /// The value for writing. May throw what copying it throws, before anything has changed.
  Value& change() {
    if (!is_own_) {
      value_ = std::make_shared<Value>(*value_);
      is_own_ = true;
    }
    return *value_;
  }

  /// Replaces the value by another one. The old value is moved to `other` unless it is shared; then `other` is left
  /// empty. May throw std::bad_alloc, before anything has changed.
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

  /// A read-only copy of the current value.
  SharedValue share() {
    is_own_ = false;
    return SharedValue(value_, false);
  }

 private:
  SharedValue(std::shared_ptr<Value> value, bool is_own) : value_(std::move(value)), is_own_(is_own) {}

  std::shared_ptr<Value> value_;
  bool is_own_ = true;  // not shared
};

}  // namespace graze::detail
