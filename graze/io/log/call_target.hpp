// SPDX-License-Identifier: MIT
// What the calls of a query log are executed on.
#pragma once

#include <functional>
#include <memory>

#include <graze/io/log/logged_answer.hpp>
#include <graze/io/log/logged_call.hpp>
#include <graze/io/log/query_log.hpp>
#include <graze/math/platform/export.hpp>
#include <graze/math/vec.hpp>

namespace graze::io {

/// A scene that starts empty and executes logged calls. Virtual because a replay chooses the target at run time: the
/// library's scene, the brute-force one or, in tests, a faulty one. A virtual call costs nothing compared to the logged
/// calls.
template <Dim N>
class GRAZE_EXPORT CallTarget {
 public:
  virtual ~CallTarget() = default;

  /// Executes a call without a fault and returns its answer; an exception becomes a refusal. Ids are those that this
  /// target returned, with owners as in a log.
  virtual LoggedAnswer perform(const LoggedCall<N>& call) = 0;

 protected:
  CallTarget() = default;
  CallTarget(const CallTarget&) = default;
  CallTarget& operator=(const CallTarget&) = default;
};

/// Creates a new, empty target.
template <Dim N>
using TargetMaker = std::function<std::unique_ptr<CallTarget<N>>()>;

/// Creates targets with the library's scene.
template <Dim N>
GRAZE_EXPORT TargetMaker<N> scene_targets(NumberType numbers);

/// Creates targets with the brute-force scene (PlainScene).
template <Dim N>
GRAZE_EXPORT TargetMaker<N> plain_scene_targets(NumberType numbers);

}  // namespace graze::io
