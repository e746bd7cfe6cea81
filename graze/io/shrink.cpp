// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <graze/io/log/ddmin.hpp>
#include <graze/io/log/state.hpp>
#include <graze/io/shape_numbers.hpp>
#include <graze/io/shrink.hpp>

namespace graze::io {
namespace {

template <Dim N>
using Entries = std::vector<LogEntry<N>>;

/// A bulk move, restricted to the objects that exist here.
template <Dim N>
LogEntry<N> with_objects_of(const LogEntry<N>& entry, const SideBySide<N>& run, const std::set<ObjectId>& names) {
  if (entry.call.kind != CallKind::move_many) return entry;
  LogEntry<N> result = entry;
  result.call.ids.clear();
  result.call.shapes.clear();
  for (std::size_t i = 0; i < entry.call.ids.size(); ++i) {
    const ObjectId& id = entry.call.ids[i];
    if (names.contains(id) && !run.was_added(id)) continue;
    result.call.ids.push_back(id);
    if (i < entry.call.shapes.size()) result.call.shapes.push_back(entry.call.shapes[i]);
  }
  return result;
}

/// Counts and reports the attempts.
template <Dim N>
class Trials {
 public:
  Trials(const ReplayTargets<N>& targets, std::set<ObjectId> names, const std::function<void(std::size_t)>& on_try)
      : targets_(targets), names_(std::move(names)), on_try_(on_try) {}

  const std::set<ObjectId>& names() const { return names_; }

  SideBySide<N> start() {
    ++count_;
    if (on_try_) on_try_(count_);
    return SideBySide<N>(targets_, names_);
  }

 private:
  const ReplayTargets<N>& targets_;
  std::set<ObjectId> names_;
  const std::function<void(std::size_t)>& on_try_;
  std::size_t count_ = 0;
};

/// Executes entries and returns those that were executed, up to the first on which subject and judge disagree.
template <Dim N>
std::optional<Entries<N>> until_they_disagree(Trials<N>& trials, const Entries<N>& entries) {
  SideBySide<N> run = trials.start();
  Entries<N> performed;
  for (const LogEntry<N>& entry : entries) {
    LogEntry<N> narrowed = with_objects_of(entry, run, trials.names());
    const auto step = run.perform(entry);
    if (!step) continue;
    performed.push_back(std::move(narrowed));
    if (!say_the_same(step->given, step->expected)) return performed;
  }
  return std::nullopt;
}

/// Whether the answer to the last of `entries` follows from the log's even if only some of them are executed.
template <Dim N>
class RecordCheck {
 public:
  /// The last of `entries` is the first whose answer is not the recorded one.
  RecordCheck(Trials<N>& trials, const Entries<N>& entries) : trials_(trials), entries_(entries) {
    for (std::size_t i = 0; i < entries_.size(); ++i) entries_[i].line = i;
  }

  const Entries<N>& entries() const { return entries_; }

  /// The executed entries, if the subject still disagrees with the log's answer to them.
  std::optional<Entries<N>> operator()(const Entries<N>& some) {
    if (some.empty() || some.back().line != entries_.back().line || !keeps_what_matters(some)) return std::nullopt;
    SideBySide<N> run = trials_.start();
    Entries<N> performed;
    std::optional<ReplayStep<N>> last;
    for (const LogEntry<N>& entry : some) {
      LogEntry<N> narrowed = with_objects_of(entry, run, trials_.names());
      last = run.perform(entry);
      if (last) performed.push_back(std::move(narrowed));
    }
    const auto recorded = foretold(run);
    if (!last || !recorded || say_the_same(last->given, *recorded)) return std::nullopt;
    return performed;
  }

  /// The log's answer restricted to the objects of a run, with the ids that they have there. A digest can only be used
  /// if all objects exist and have the ids of the log.
  std::optional<LoggedAnswer> foretold(const SideBySide<N>& run) const {
    if (form_of(target().call.kind).is_change)
      return target().answer;  // all changes are executed, so the ids are equal
    if (target().answer->digest) {
      const LoggedAnswer all = logged(std::vector<ObjectId>(trials_.names().begin(), trials_.names().end()));
      return say_the_same(run.translated(all), all) ? target().answer : std::nullopt;
    }
    const auto known = without_others(target().call.kind, *target().answer, [&](const ObjectId& id) {
      return run.was_added(id) || !trials_.names().contains(id);
    });
    if (!known) return std::nullopt;
    return run.translated(*known);
  }

 private:
  const LogEntry<N>& target() const { return entries_.back(); }

  bool keeps_what_matters(const Entries<N>& some) const {
    if (form_of(target().call.kind).is_change) return changes_in(some) == changes_in(entries_);
    if (!is_like(some, some.size(), entries_.size())) return false;
    if (target().call.kind != CallKind::update) return true;
    const std::size_t before = updates_until(some, some.size() - 1);
    const std::size_t all_before = updates_until(entries_, entries_.size() - 1);
    return (before == 0) == (all_before == 0) && is_like(some, before, all_before);
  }

  /// The number of calls that change something, and of objects in them.
  static std::size_t changes_in(const Entries<N>& entries) {
    std::size_t count = 0;
    for (const LogEntry<N>& entry : entries) {
      if (form_of(entry.call.kind).is_change) count += 1 + entry.call.ids.size();
    }
    return count;
  }

  /// The end of the last update among the first `count` entries; 0 if there is none.
  static std::size_t updates_until(const Entries<N>& entries, std::size_t count) {
    while (count > 0 && entries[count - 1].call.kind != CallKind::update) --count;
    return count;
  }

  /// Whether the objects that `some` adds have the same state after `count` of its entries as after all of `entries`.
  bool is_like(const Entries<N>& some, std::size_t count, std::size_t all) const {
    const std::set<ObjectId> here = added_ids(some);
    auto wanted = state_after<N>(std::span(entries_).first(all));
    std::erase_if(wanted, [&here](const auto& object) { return !here.contains(object.first); });
    auto found = state_after<N>(std::span(some).first(count));
    std::erase_if(found, [&here](const auto& object) { return !here.contains(object.first); });
    return found == wanted && excepted_among(some, count, here) == excepted_among(entries_, all, here);
  }

  static std::set<ObjectPair> excepted_among(const Entries<N>& entries, std::size_t count,
                                             const std::set<ObjectId>& here) {
    std::set<ObjectPair> excepted = excepted_after<N>(std::span(entries).first(count));
    std::erase_if(excepted,
                  [&here](const ObjectPair& pair) { return !here.contains(pair.a) || !here.contains(pair.b); });
    return excepted;
  }

  Trials<N>& trials_;
  Entries<N> entries_;
};

/// Removes whole calls, then objects from bulk moves, until nothing more can be removed.
template <Dim N, class StillFails>
Entries<N> fewest(Entries<N> entries, const StillFails& still_fails) {
  std::size_t size_before = 0;
  const auto size_of = [](const Entries<N>& list) {
    return std::accumulate(list.begin(), list.end(), std::size_t{0},
                           [](std::size_t sum, const auto& entry) { return sum + 1 + entry.call.ids.size(); });
  };
  do {
    size_before = size_of(entries);
    entries = ddmin(std::move(entries), still_fails);
    for (std::size_t i = entries.size(); i-- > 0;) {
      if (i >= entries.size() || entries[i].call.kind != CallKind::move_many) continue;
      std::vector<std::size_t> places(entries[i].call.ids.size());
      std::iota(places.begin(), places.end(), std::size_t{0});
      const auto with = [&](const std::vector<std::size_t>& kept) {
        Entries<N> fewer = entries;
        fewer[i].call.ids.clear();
        fewer[i].call.shapes.clear();
        for (const std::size_t place : kept) {
          fewer[i].call.ids.push_back(entries[i].call.ids[place]);
          fewer[i].call.shapes.push_back(entries[i].call.shapes[place]);
        }
        return fewer;
      };
      const auto kept = ddmin(places, [&](const std::vector<std::size_t>& some) {
        return still_fails(with(some)) ? std::optional(some) : std::nullopt;
      });
      if (kept.size() < places.size()) entries = *still_fails(with(kept));
    }
  } while (size_of(entries) < size_before);
  return entries;
}

/// A shape whose numbers are multiples of a power of two; unchanged if rounding would make it invalid, and for
/// compounds.
template <Dim N>
AnyShape<N, double> rounder(const AnyShape<N, double>& shape, double per_unit) {
  if (std::holds_alternative<Compound<N, double>>(shape)) return shape;
  const auto round = [per_unit](double number) {
    const double rounded = std::round(number * per_unit) / per_unit;
    return std::isfinite(rounded) ? rounded + 0.0 : number;  // never minus zero
  };
  const ShapeNumbers<double, decltype(round)> numbers(round);
  AnyShape<N, double> result = numbers(shape);
  return defect(result).empty() ? result : shape;
}

/// Ways to simplify a call, the most effective first.
template <Dim N>
std::vector<LoggedCall<N>> simpler_calls(const LoggedCall<N>& call) {
  std::vector<LoggedCall<N>> result;
  const auto add_if_other = [&](const LoggedCall<N>& simpler) {
    if (call_line(simpler) != call_line(call)) result.push_back(simpler);
  };
  if (!call.fault.empty()) return result;
  for (const double per_unit : {1.0, 4.0, 64.0}) {
    LoggedCall<N> simpler = call;
    for (AnyShape<N, double>& shape : simpler.shapes) shape = rounder<N>(shape, per_unit);
    add_if_other(simpler);
  }
  if (call.kind == CallKind::add) {
    const auto with = [&](auto change) {
      LoggedCall<N> simpler = call;
      change(simpler.options);
      add_if_other(simpler);
    };
    with([](ObjectOptions& options) { options = {}; });
    with([](ObjectOptions& options) { options.name.clear(); });
    with([](ObjectOptions& options) { options.user = 0; });
    with([](ObjectOptions& options) { options.mask = all_layers; });
    with([](ObjectOptions& options) { options.layer = 0; });
    with([](ObjectOptions& options) { options.mobility = Mobility::moving; });
  }
  LoggedCall<N> without_exceptions = call;
  without_exceptions.except.clear();
  add_if_other(without_exceptions);
  LoggedCall<N> on_all_layers = call;
  on_all_layers.layers = all_layers;
  add_if_other(on_all_layers);
  return result;
}

template <Dim N, class StillFails>
Entries<N> simplest(Entries<N> entries, const StillFails& still_fails) {
  for (std::size_t i = 0; i < entries.size(); ++i) {
    // Simplified calls are simplified further, until no simpler one fails.
    for (bool is_simpler = true; is_simpler;) {
      is_simpler = false;
      for (LoggedCall<N>& call : simpler_calls(entries[i].call)) {
        Entries<N> changed = entries;
        changed[i].call = std::move(call);
        const auto failing = still_fails(changed);
        if (!failing || failing->size() != entries.size()) continue;
        entries = *failing;
        is_simpler = true;
        break;
      }
    }
  }
  return entries;
}

/// The entries with the ids and answers of the subject.
template <Dim N>
QueryLog<N> performed(Trials<N>& trials, const Entries<N>& entries, NumberType numbers) {
  SideBySide<N> run = trials.start();
  QueryLog<N> log{numbers, {}};
  for (const LogEntry<N>& entry : entries) {
    auto step = run.perform(entry);
    if (step) log.entries.push_back({std::move(step->call), std::move(step->given), 0});
  }
  return log;
}

/// The index of the first entry whose answer in the log differs from the subject's.
template <Dim N>
std::optional<std::size_t> first_contradiction(Trials<N>& trials, const QueryLog<N>& log) {
  SideBySide<N> run = trials.start();
  for (std::size_t i = 0; i < log.entries.size(); ++i) {
    const LogEntry<N>& entry = log.entries[i];
    const auto step = run.perform(entry);
    if (step && entry.answer && !say_the_same(step->given, *entry.answer)) return i;
  }
  return std::nullopt;
}

/// Shrinks entries whose last one is the first contradiction.
template <Dim N>
QueryLog<N> shrunk_contradiction(const Entries<N>& entries, NumberType numbers, const ReplayTargets<N>& targets,
                                 const std::function<void(std::size_t)>& on_try) {
  Trials<N> trials(targets, added_ids(entries), on_try);
  RecordCheck<N> check(trials, entries);
  const Entries<N> left = fewest<N>(check.entries(), [&check](const Entries<N>& some) { return check(some); });
  QueryLog<N> result = performed(trials, left, numbers);
  SideBySide<N> run = trials.start();
  for (const LogEntry<N>& entry : left) run.perform(entry);
  if (auto recorded = check.foretold(run)) result.entries.back().answer = *std::move(recorded);
  return result;
}

/// Shrinks a log on which subject and judge disagree; none if they agree.
template <Dim N>
std::optional<QueryLog<N>> shrunk_disagreement(Trials<N>& trials, const QueryLog<N>& log) {
  const auto disagree = [&trials](const Entries<N>& entries) { return until_they_disagree(trials, entries); };
  auto entries = disagree(log.entries);
  if (!entries) return std::nullopt;
  entries = simplest<N>(fewest<N>(*std::move(entries), disagree), disagree);
  return performed(trials, fewest<N>(*std::move(entries), disagree), log.numbers);
}

}  // namespace

template <Dim N>
std::optional<QueryLog<N>> shrunk(const QueryLog<N>& log, const ReplayTargets<N>& targets,
                                  const std::function<void(std::size_t)>& on_try) {
  Trials<N> trials(targets, added_ids(log.entries), on_try);
  if (auto small = shrunk_disagreement(trials, log)) return small;
  const auto contradicted = first_contradiction(trials, log);
  if (!contradicted) return std::nullopt;
  const auto end = log.entries.begin() + static_cast<std::ptrdiff_t>(*contradicted) + 1;
  return shrunk_contradiction(Entries<N>(log.entries.begin(), end), log.numbers, targets, on_try);
}

template std::optional<QueryLog<2>> shrunk(const QueryLog<2>&, const ReplayTargets<2>&,
                                           const std::function<void(std::size_t)>&);
template std::optional<QueryLog<3>> shrunk(const QueryLog<3>&, const ReplayTargets<3>&,
                                           const std::function<void(std::size_t)>&);

}  // namespace graze::io
