// SPDX-License-Identifier: MIT
/// @file
/// Reduces a failing query log.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include <graze/io/log/query_log.hpp>
#include <graze/io/log/side_by_side.hpp>
#include <graze/math/platform/export.hpp>
#include <graze/math/vec.hpp>

namespace graze::io {

/// A small log that fails as the given one does, or none if that does not fail. No single call of it, and no single
/// object of a bulk move, can be left out; there may still be smaller logs.
///
/// A log fails if a result of the subject differs from the judge's. To shrink such a log, calls are removed (ddmin),
/// then objects of bulk moves, and the remaining calls get simpler values: no names, layers and masks, rounder numbers.
///
/// If subject and judge agree, a log fails if a result of the subject differs from the recorded one, for instance
/// because another program wrote the log. Then only what does not concern the first such result is removed: other
/// queries, and objects with all calls about them. The remaining objects stay where they were.
///
/// The new log contains the subject's results; where the subject contradicts the log, it contains the recorded result
/// for the remaining objects.
///
/// Both targets are created and run for every try; `on_try` is called with the number of tries. A subject that ends the
/// process cannot be shrunk.
template <Dim N>
GRAZE_EXPORT std::optional<QueryLog<N>> shrunk(const QueryLog<N>& log, const ReplayTargets<N>& targets,
                                               const std::function<void(std::size_t)>& on_try = {});

}  // namespace graze::io
