// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>

#include <graze/io/log/call_target.hpp>
#include <graze/io/log/logged_answer.hpp>
#include <graze/io/log/logged_call.hpp>
#include <graze/io/log/query_log.hpp>
#include <graze/math/vec.hpp>
#include <graze/scene/object.hpp>

namespace graze::io {

/// What is put to the test, and what is taken to be right.
template <Dim N>
struct ReplayTargets {
  TargetMaker<N> subject;
  TargetMaker<N> judge;
};

/// The library's scene, judged by the one that asks every object.
template <Dim N>
ReplayTargets<N> library_targets(NumberType numbers) {
  return {scene_targets<N>(numbers), plain_scene_targets<N>(numbers)};
}

/// A call as both targets were given it, and what they said.
template <Dim N>
struct ReplayStep {
  LoggedCall<N> call;
  LoggedAnswer given;     ///< By the subject.
  LoggedAnswer expected;  ///< By the judge.
};

/// The subject and the judge, performing the same calls. The ids of a log are names here: objects are found again under
/// whatever ids the subject gives, so that calls can be left out.
template <Dim N>
class SideBySide {
 public:
  /// `names` are the ids of the log that name objects; calls about those that were not added here are left out. All
  /// other ids are taken as they are. It must outlive this.
  explicit SideBySide(const ReplayTargets<N>& targets, const std::set<ObjectId>& names)
      : subject_(targets.subject()), judge_(targets.judge()), names_(names) {}

  /// Performs a call of the log; of moves of many objects those that are here. None when nothing is left of it. A call
  /// with a fault is not performed, and refused by both.
  std::optional<ReplayStep<N>> perform(const LogEntry<N>& entry);

  /// The log's answer with the ids that objects have here, without the rows that name others.
  LoggedAnswer translated(const LoggedAnswer& answer) const;

  /// Whether the id names an object that was added here.
  bool was_added(const ObjectId& name) const { return here_.contains(name); }

 private:
  std::optional<ObjectId> here(const ObjectId& name) const;
  std::optional<LoggedCall<N>> translated(const LoggedCall<N>& call) const;

  std::unique_ptr<CallTarget<N>> subject_;
  std::unique_ptr<CallTarget<N>> judge_;
  const std::set<ObjectId>& names_;
  std::map<ObjectId, ObjectId> here_;  // by the log's ids
};

/// The id that an answered `add` gave.
std::optional<ObjectId> added_id(CallKind kind, const LoggedAnswer& answer);

/// The ids that a log's `add`s gave.
template <Dim N>
std::set<ObjectId> added_ids(const std::vector<LogEntry<N>>& entries);

}  // namespace graze::io
