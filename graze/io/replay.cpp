// SPDX-License-Identifier: MIT
#include <optional>
#include <set>
#include <utility>

#include <graze/io/replay.hpp>

namespace graze::io {

template <Dim N>
ReplayReport replay(const QueryLog<N>& log, const ReplayTargets<N>& targets,
                    const std::function<void(std::size_t)>& on_call) {
  ReplayReport report;
  const std::set<ObjectId> no_names;
  SideBySide<N> run(targets, no_names);
  for (std::size_t i = 0; i < log.entries.size(); ++i) {
    const LogEntry<N>& entry = log.entries[i];
    auto step = run.perform(entry);
    if (on_call) on_call(i + 1);
    if (!step) continue;
    ++report.calls;
    const bool from_judge = !say_the_same(step->given, step->expected);
    const bool from_record = entry.answer && !say_the_same(step->given, *entry.answer);
    if (!from_judge && !from_record) continue;
    ++report.differing;
    if (report.first.size() == most_differences) continue;
    report.first.push_back(
        {i, std::move(step->given), std::move(step->expected), entry.answer, from_judge, from_record});
  }
  return report;
}

template ReplayReport replay(const QueryLog<2>&, const ReplayTargets<2>&, const std::function<void(std::size_t)>&);
template ReplayReport replay(const QueryLog<3>&, const ReplayTargets<3>&, const std::function<void(std::size_t)>&);

}  // namespace graze::io
