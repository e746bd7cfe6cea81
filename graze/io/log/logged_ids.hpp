// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <graze/io/log/logged_answer.hpp>
#include <graze/io/log/logged_call.hpp>
#include <graze/scene/object.hpp>

namespace graze::io {

/// Turns the ids of a running scene into those of a log, and back. A scene's number is known from the first id that it
/// gives; no id of its own exists before.
class LoggedIds {
 public:
  /// The scene gave this id.
  void learn_from(const ObjectId& id) { owner_ = id.owner; }

  ObjectId logged(const ObjectId& id) const {
    if (id == ObjectId{}) return id;
    return {id.index, id.generation, id.owner == owner_ ? logged_scene : other_scene};
  }

  /// An id of another scene becomes one that is none of this one.
  ObjectId real(const ObjectId& id) const {
    if (id == ObjectId{}) return id;
    return {id.index, id.generation, id.owner == logged_scene ? owner_ : owner_ + 1};
  }

  LoggedAnswer logged(LoggedAnswer answer) const {
    for (AnswerRow& row : answer.rows) {
      for (ObjectId& id : row.ids) id = logged(id);
    }
    return answer;
  }

 private:
  std::uint32_t owner_ = 0;
};

}  // namespace graze::io
