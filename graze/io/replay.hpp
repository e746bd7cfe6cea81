// SPDX-License-Identifier: MIT
/// @file
/// Performs the calls of a query log again and compares the results.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include <graze/io/log/logged_answer.hpp>
#include <graze/io/log/query_log.hpp>
#include <graze/io/log/side_by_side.hpp>
#include <graze/math/platform/export.hpp>
#include <graze/math/vec.hpp>

namespace graze::io {

/// A call whose result differs from the expected one.
struct ReplayDifference {
  std::size_t entry = 0;                 ///< Index of the call in the log.
  LoggedAnswer given;                    ///< Result of the subject.
  LoggedAnswer expected;                 ///< Result of the judge.
  std::optional<LoggedAnswer> recorded;  ///< Result in the log, if there is one.
  bool is_from_judge = false;            ///< The subject differs from the judge.
  bool is_from_record = false;           ///< The subject differs from the log.
};

/// The result of `replay`.
struct ReplayReport {
  std::size_t calls = 0;                     ///< Number of calls performed.
  std::size_t differing = 0;                 ///< Number of calls whose results differ.
  std::vector<ReplayDifference> first = {};  ///< The first of these, at most `most_differences`.
};

/// The number of differences that a report describes.
inline constexpr std::size_t most_differences = 10;

/// Performs all calls on a new subject and a new judge, and compares the results bit for bit; exceptions count as equal
/// whatever their messages. `on_call` is called with the number of calls done.
template <Dim N>
GRAZE_EXPORT ReplayReport replay(const QueryLog<N>& log, const ReplayTargets<N>& targets,
                                 const std::function<void(std::size_t)>& on_call = {});

}  // namespace graze::io
