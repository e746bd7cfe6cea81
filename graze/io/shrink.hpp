// SPDX-License-Identifier: MIT
// Makes a failing query log small.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include <graze/io/log/query_log.hpp>
#include <graze/io/log/side_by_side.hpp>
#include <graze/math/vec.hpp>

namespace graze::io {

/// A small log that fails as a log does, or none if it does not fail. No call of it, and no object of a call that moves
/// many, can be left out; it may still not be the smallest that there is.
///
/// A log fails first of all when the subject does not say what the judge says. Then calls go (ddmin), objects of bulk
/// moves go, and what is left gets simpler values: no names, layers and masks, rounder numbers. Otherwise it fails when
/// the subject does not say what the log says, for instance because it was written by another program: then only what
/// says nothing about the first such answer goes, that is other questions and objects with all calls about them, and
/// the objects that stay are where they were. The new log holds what the subject says; of an answer in the log that
/// it contradicts, what the log said of the objects that stay.
///
/// Both targets are made and run again for every try; `on_try` is told how many there were. A subject that ends the
/// process cannot be shrunk.
template <Dim N>
std::optional<QueryLog<N>> shrunk(const QueryLog<N>& log, const ReplayTargets<N>& targets,
                                  const std::function<void(std::size_t)>& on_try = {});

}  // namespace graze::io
