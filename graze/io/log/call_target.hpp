// SPDX-License-Identifier: MIT
// What the calls of a query log are performed on.
#pragma once

#include <functional>
#include <memory>

#include <graze/io/log/logged_answer.hpp>
#include <graze/io/log/logged_call.hpp>
#include <graze/io/log/query_log.hpp>
#include <graze/math/vec.hpp>

namespace graze::io {

/// A scene that begins empty and takes calls as a log has them. Virtual because a replay is given what to try: the
/// library's scene, the one that asks every object, or, in a test, one with a fault. Beside the calls themselves, the
/// calls of a virtual function cost nothing.
template <Dim N>
class CallTarget {
 public:
  virtual ~CallTarget() = default;

  /// Performs a call without a fault and gives its answer; an exception becomes a refusal. Ids are those that this
  /// target gave, with owners as in a log.
  virtual LoggedAnswer perform(const LoggedCall<N>& call) = 0;

 protected:
  CallTarget() = default;
  CallTarget(const CallTarget&) = default;
  CallTarget& operator=(const CallTarget&) = default;
};

/// Makes a new, empty target.
template <Dim N>
using TargetMaker = std::function<std::unique_ptr<CallTarget<N>>()>;

/// Makes scenes of the library.
template <Dim N>
TargetMaker<N> scene_targets(NumberType numbers);

/// Makes plain scenes, which ask every object.
template <Dim N>
TargetMaker<N> plain_scene_targets(NumberType numbers);

}  // namespace graze::io
