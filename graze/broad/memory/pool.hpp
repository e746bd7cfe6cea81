// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

namespace graze::detail {

/// Reusable objects for tasks, as many as run at the same time. They are kept for later.
template <class Value>
class Pool {
 public:
  /// Exclusive use of one object until destruction.
  class Loan {
   public:
    explicit Loan(Pool& pool) : pool_(pool), value_(pool.take()) {}
    Loan(const Loan&) = delete;
    Loan& operator=(const Loan&) = delete;
    ~Loan() { pool_.give_back(value_); }

    Value& operator*() const { return value_; }
    Value* operator->() const { return &value_; }

   private:
    Pool& pool_;
    Value& value_;
  };

  /// All objects; no loan may exist.
  const std::vector<std::unique_ptr<Value>>& all() const { return all_; }

 private:
  Value& take() {
    const std::lock_guard lock(mutex_);
    if (free_.empty()) {
      free_.reserve(all_.size() + 1);  // so that returning needs no memory
      all_.push_back(std::make_unique<Value>());
      return *all_.back();
    }
    Value& value = *free_.back();
    free_.pop_back();
    return value;
  }

  void give_back(Value& value) noexcept {
    const std::lock_guard lock(mutex_);
    free_.push_back(&value);
  }

  std::mutex mutex_;
  std::vector<std::unique_ptr<Value>> all_;
  std::vector<Value*> free_;
};

}  // namespace graze::detail
