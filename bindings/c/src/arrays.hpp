// SPDX-License-Identifier: MIT
// Arrays of the caller: rows of numbers to read, and buffers for results.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <graze/broad/executor.hpp>

#include "../graze.h"
#include "errors.hpp"

namespace graze::c {

/// Rows of numbers as vectors, boxes or rays: in place if they are, without gaps, where such values may lie.
template <class Row>
class RowsIn {
 public:
  /// Throws Error, naming the argument, for rows that overlap or are missing.
  RowsIn(std::string_view role, const graze_rows& rows) {
    require_array(role, rows.data, rows.count);
    const std::size_t stride = rows.stride == 0 ? sizeof(Row) : rows.stride;
    if (stride < sizeof(Row)) {
      throw Error(GRAZE_INVALID_ARGUMENT, std::string(role) + " has a stride of " + std::to_string(stride) +
                                              " bytes, but its rows have " + std::to_string(sizeof(Row)));
    }
    if (stride == sizeof(Row) && reinterpret_cast<std::uintptr_t>(rows.data) % alignof(Row) == 0) {
      span_ = {static_cast<const Row*>(rows.data), rows.count};
      return;
    }
    copied_.resize(rows.count);
    const char* from = static_cast<const char*>(rows.data);
    for (std::size_t i = 0; i < rows.count; ++i) std::memcpy(&copied_[i], from + i * stride, sizeof(Row));
    span_ = copied_;
  }
  RowsIn(const RowsIn&) = delete;
  RowsIn& operator=(const RowsIn&) = delete;

  std::span<const Row> span() const { return span_; }

 private:
  std::vector<Row> copied_;
  std::span<const Row> span_;
};

/// A buffer for any number of results.
template <class Result>
class Buffer {
 public:
  /// Throws Error for null pointers.
  Buffer(Result* out, std::size_t capacity, std::size_t* count)
      : out_(out), capacity_(capacity), count_(required("count", count)) {
    require_array("out", out, capacity);
  }

  std::size_t capacity() const { return capacity_; }

  /// Writes convert(value) of as many values as fit.
  template <class Values, class Convert>
  graze_status fill(const Values& values, const Convert& convert) const {
    for (std::size_t i = 0; i < values.size() && i < capacity_; ++i) out_[i] = convert(values[i]);
    count_ = values.size();
    return values.size() > capacity_ ? GRAZE_TRUNCATED : GRAZE_OK;
  }

 private:
  Result* out_;
  std::size_t capacity_;
  std::size_t& count_;
};

/// The executor for an argument `threads`; 0 means all.
class Threads {
 public:
  explicit Threads(std::uint32_t threads) : limited_(threads == 0 ? nullptr : limited_executor(threads)) {}
  const Executor& executor() const { return limited_ ? *limited_ : default_executor(); }

 private:
  std::unique_ptr<Executor> limited_;
};

}  // namespace graze::c
