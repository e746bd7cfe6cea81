// SPDX-License-Identifier: MIT
// The scene that the calls of a query log leave behind.
#pragma once

#include <string>

#include <graze/io/log/query_log.hpp>
#include <graze/math/vec.hpp>
#include <graze/scene/scene.hpp>

namespace graze::io {

/// Performs the calls of a log that change a scene and were not refused; one without an answer, which the program did
/// not survive, changes nothing. Shapes are kept in double, which loses nothing of those in float. Objects are in the
/// order, and have the ids, names and layers, that the log has. `source` names the log in messages. Throws InputError,
/// which names the line, where a scene refuses what the log says it took.
template <Dim N>
Scene<N, double> scene_after(const QueryLog<N>& log, const std::string& source);

}  // namespace graze::io
