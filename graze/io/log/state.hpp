// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>

#include <graze/io/log/logged_answer.hpp>
#include <graze/io/log/logged_call.hpp>
#include <graze/io/log/query_log.hpp>
#include <graze/math/vec.hpp>
#include <graze/scene/object.hpp>

namespace graze::io {

/// What the entries of a log say that the objects of a scene are, as text, by the ids of the log. Two scenes with the
/// same texts answer the same.
template <Dim N>
std::map<ObjectId, std::string> state_after(std::span<const LogEntry<N>> entries);

/// What an answer would have been, had only some objects ever been there: those for which `is_here(id)`. None where
/// that cannot be known: another object might come first, or there is but a digest.
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
  const bool lists_all = kind != CallKind::nearest && kind != CallKind::ray_cast && kind != CallKind::find;
  if (answer.digest || (left_out > 0 && !lists_all)) return std::nullopt;
  return result;
}

}  // namespace graze::io
