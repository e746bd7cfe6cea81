// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <graze/io/log/side_by_side.hpp>

namespace graze::io {

std::optional<ObjectId> added_id(CallKind kind, const LoggedAnswer& answer) {
  const bool is_id = kind == CallKind::add && answer.rows.size() == 1 && answer.rows.front().ids.size() == 1;
  if (!is_id) return std::nullopt;
  return answer.rows.front().ids.front();
}

template <Dim N>
std::set<ObjectId> added_ids(const std::vector<LogEntry<N>>& entries) {
  std::set<ObjectId> ids;
  for (const LogEntry<N>& entry : entries) {
    if (!entry.answer) continue;
    if (const auto id = added_id(entry.call.kind, *entry.answer)) ids.insert(*id);
  }
  return ids;
}

template <Dim N>
std::optional<ObjectId> SideBySide<N>::here(const ObjectId& name) const {
  const auto found = here_.find(name);
  if (found != here_.end()) return found->second;
  if (names_.contains(name)) return std::nullopt;
  return name;
}

template <Dim N>
std::optional<LoggedCall<N>> SideBySide<N>::translated(const LoggedCall<N>& call) const {
  LoggedCall<N> result = call;
  result.except.clear();
  for (const ObjectId& name : call.except) {
    if (const auto id = here(name)) result.except.push_back(*id);
  }
  if (call.kind == CallKind::plan_ids || call.ids.empty()) return result;
  result.ids.clear();
  std::vector<AnyShape<N, double>> shapes;
  for (std::size_t i = 0; i < call.ids.size(); ++i) {
    const auto id = here(call.ids[i]);
    if (!id) continue;
    result.ids.push_back(*id);
    if (i < call.shapes.size()) shapes.push_back(call.shapes[i]);
  }
  const bool is_of_two = call.kind == CallKind::except || call.kind == CallKind::accept;
  if (result.ids.empty() || (is_of_two && result.ids.size() != call.ids.size())) return std::nullopt;
  result.shapes = std::move(shapes);
  return result;
}

template <Dim N>
LoggedAnswer SideBySide<N>::translated(const LoggedAnswer& answer) const {
  LoggedAnswer result = answer;
  result.rows.clear();
  for (AnswerRow row : answer.rows) {
    bool is_here = true;
    for (ObjectId& id : row.ids) {
      const auto translated = here(id);
      is_here = is_here && translated;
      if (translated) id = *translated;
    }
    if (is_here) result.rows.push_back(std::move(row));
  }
  return result;
}

template <Dim N>
std::optional<ReplayStep<N>> SideBySide<N>::perform(const LogEntry<N>& entry) {
  if (!entry.call.fault.empty()) {
    const LoggedAnswer refused{.refusal = entry.call.fault};
    return ReplayStep<N>{entry.call, refused, refused};
  }
  auto call = translated(entry.call);
  if (!call) return std::nullopt;
  ReplayStep<N> step{*std::move(call), {}, {}};
  step.given = subject_->perform(step.call);
  step.expected = judge_->perform(step.call);
  const auto name = entry.answer ? added_id(entry.call.kind, *entry.answer) : std::nullopt;
  const auto id = added_id(entry.call.kind, step.given);
  if (name && id) here_[*name] = *id;
  return step;
}

template std::set<ObjectId> added_ids(const std::vector<LogEntry<2>>&);
template std::set<ObjectId> added_ids(const std::vector<LogEntry<3>>&);
template class SideBySide<2>;
template class SideBySide<3>;

}  // namespace graze::io
