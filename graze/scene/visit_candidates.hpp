// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <span>

#include <graze/broad/pairs.hpp>
#include <graze/math/platform/export.hpp>
#include <graze/math/vec.hpp>
#include <graze/scene/object.hpp>
#include <graze/scene/scene_view.hpp>

namespace graze {

/// Receives a block of candidates; returns false to stop.
using CandidateVisitor = std::function<bool(std::span<const ObjectPair>)>;

/// Passes the pairs of `scene.candidates(margin)`, in the same order, to a visitor in blocks of at most 4096. Memory
/// grows with the objects, not with the pairs, and the first pairs come before all are found. Throws
/// std::invalid_argument if the margin is negative or not finite, and what the visitor throws.
template <Dim N, class T>
GRAZE_EXPORT void visit_candidates(const SceneView<N, T>& scene, const CandidateVisitor& visit, double margin = 0);

namespace detail {

/// The options to compare the boxes of a scene so that no pair within the margin is missed. Throws
/// std::invalid_argument if the margin is negative or not finite.
template <class T>
GRAZE_EXPORT PairOptions candidate_options(double margin);

}  // namespace detail

}  // namespace graze
