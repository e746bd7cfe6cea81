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

/// The two scenes of a replay.
template <Dim N>
struct ReplayTargets {
  TargetMaker<N> subject;  ///< Makes the scene under test.
  TargetMaker<N> judge;    ///< Makes the scene whose results are taken as right.
};

/// `Scene` as the subject and `PlainScene`, which tests every object, as the judge.
template <Dim N>
ReplayTargets<N> library_targets(NumberType numbers) {
  return {scene_targets<N>(numbers), plain_scene_targets<N>(numbers)};
}

/// A call as both scenes performed it, and their results.
template <Dim N>
struct ReplayStep {
  LoggedCall<N> call;     ///< With the ids of this replay.
  LoggedAnswer given;     ///< The result of the subject.
  LoggedAnswer expected;  ///< The result of the judge.
};

/// Performs the same calls on the subject and the judge. The ids of the log are translated to those that the subject
/// returns, so calls can be left out.
template <Dim N>
class SideBySide {
 public:
  /// `names` are the ids of objects in the log and must outlive this object. Calls about an object that was not added
  /// in this replay are left out. All other ids are used unchanged.
  explicit SideBySide(const ReplayTargets<N>& targets, const std::set<ObjectId>& names)
      : subject_(targets.subject()), judge_(targets.judge()), names_(names) {}

  /// Performs a call of the log; a bulk move only for the objects added in this replay. Returns none if nothing of the
  /// call is left. A call with a fault is not performed and counts as rejected by both.
  std::optional<ReplayStep<N>> perform(const LogEntry<N>& entry);

  /// A result in the log with the ids of this replay, without the rows of objects that were not added.
  LoggedAnswer translated(const LoggedAnswer& answer) const;

  /// Whether the id is of an object that was added in this replay.
  bool was_added(const ObjectId& name) const { return here_.contains(name); }

 private:
  std::optional<ObjectId> here(const ObjectId& name) const;
  std::optional<LoggedCall<N>> translated(const LoggedCall<N>& call) const;

  std::unique_ptr<CallTarget<N>> subject_;
  std::unique_ptr<CallTarget<N>> judge_;
  const std::set<ObjectId>& names_;
  std::map<ObjectId, ObjectId> here_;  // by the log's ids
};

/// The id that an `add` returned; none for other calls and exceptions.
std::optional<ObjectId> added_id(CallKind kind, const LoggedAnswer& answer);

/// The ids that the `add` calls of a log returned.
template <Dim N>
std::set<ObjectId> added_ids(const std::vector<LogEntry<N>>& entries);

}  // namespace graze::io
