// SPDX-License-Identifier: MIT
// Performs the calls of a query log again and compares the answers.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include <graze/io/log/logged_answer.hpp>
#include <graze/io/log/query_log.hpp>
#include <graze/io/log/side_by_side.hpp>
#include <graze/math/vec.hpp>

namespace graze::io {

/// A call whose answer is not what it should be.
struct ReplayDifference {
  std::size_t entry = 0;                 ///< Its place in the log.
  LoggedAnswer given;                    ///< By the subject.
  LoggedAnswer expected;                 ///< By the judge.
  std::optional<LoggedAnswer> recorded;  ///< In the log, if it has an answer.
  bool is_from_judge = false;            ///< The subject does not say what the judge says.
  bool is_from_record = false;           ///< The subject does not say what the log says.
};

struct ReplayReport {
  std::size_t calls = 0;                     ///< Performed.
  std::size_t differing = 0;                 ///< Calls whose answers differ.
  std::vector<ReplayDifference> first = {};  ///< The first of them, at most `most_differences`.
};

inline constexpr std::size_t most_differences = 10;

/// Performs all calls on a new subject and a new judge. Answers must be the same to the bit, of refusals only that they
/// are refusals. `on_call` is told how many calls are done.
template <Dim N>
ReplayReport replay(const QueryLog<N>& log, const ReplayTargets<N>& targets,
                    const std::function<void(std::size_t)>& on_call = {});

}  // namespace graze::io
