// SPDX-License-Identifier: MIT
// The scene after the calls of a query log.
#pragma once

#include <string>

#include <graze/io/log/query_log.hpp>
#include <graze/math/platform/export.hpp>
#include <graze/math/vec.hpp>
#include <graze/scene/scene.hpp>

namespace graze::io {

/// Executes the calls of a log that change a scene and were not refused; a last call without an answer changes nothing.
/// Shapes are stored in double, which represents float exactly. Objects have the order, ids, names and layers of the
/// log. `source` names the log in messages. Throws InputError, naming the line, where a scene refuses a call that the
/// log says was accepted.
template <Dim N>
GRAZE_EXPORT Scene<N, double> scene_after(const QueryLog<N>& log, const std::string& source);

}  // namespace graze::io
