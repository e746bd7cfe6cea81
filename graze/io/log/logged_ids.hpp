// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <graze/io/log/logged_answer.hpp>
#include <graze/io/log/logged_call.hpp>
#include <graze/scene/object.hpp>

namespace graze::io {

/// Converts between the ids of a running scene and those of a log. A scene's number becomes known with the first id
/// that it returns; before that, none of its ids exists.
class LoggedIds {
 public:
  /// Notes an id that the scene returned.
  void learn_from(const ObjectId& id) { owner_ = id.owner; }

  ObjectId logged(const ObjectId& id) const {
    if (id == ObjectId{}) return id;
    return {id.index, id.generation, id.owner == owner_ ? logged_scene : other_scene};
  }

  /// An id of another scene is converted to one that does not belong to this scene.
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
