// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>

#include <graze/io/log/logged_answer.hpp>
#include <graze/io/log/logged_call.hpp>
#include <graze/io/log/query_log.hpp>
#include <graze/math/vec.hpp>
#include <graze/scene/object.hpp>

namespace graze::io {

/// The state of each object according to the entries of a log, as text, by the log's ids. Two scenes with equal texts
/// and equal `excepted_after` give equal answers.
template <Dim N>
std::map<ObjectId, std::string> state_after(std::span<const LogEntry<N>> entries);

/// The excepted pairs according to the entries of a log, by the log's ids.
template <Dim N>
std::set<ObjectPair> excepted_after(std::span<const LogEntry<N>> entries);

/// The answer that a scene would have given if only the objects with `is_here(id)` had ever existed. None if that
/// cannot be known: because another object might have come first, or because the log has a digest only.
template <class IsHere>
std::optional<LoggedAnswer> without_others(CallKind kind, const LoggedAnswer& answer, const IsHere& is_here) {
  LoggedAnswer result = answer;
  const auto names_another = [&is_here](const AnswerRow& row) {
    for (const ObjectId& id : row.ids) {
      if (!is_here(id)) return true;
    }
    return false;
  };
  const std::size_t left_out = std::erase_if(result.rows, names_another);
  const bool lists_all = kind != CallKind::nearest && kind != CallKind::nearest_to && kind != CallKind::ray_cast &&
                         kind != CallKind::shape_cast && kind != CallKind::time_of_impact && kind != CallKind::find;
  if (answer.digest || (left_out > 0 && !lists_all)) return std::nullopt;
  return result;
}

}  // namespace graze::io
