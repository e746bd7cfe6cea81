// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <span>

#include <graze/broad/pairs.hpp>
#include <graze/math/vec.hpp>
#include <graze/scene/object.hpp>
#include <graze/scene/scene_view.hpp>

namespace graze {

/// Takes candidates by the block; false asks for no more.
using CandidateVisitor = std::function<bool(std::span<const ObjectPair>)>;

/// The pairs of `scene.candidates(margin)` in the same order, given to a visitor by blocks of at most 4096. Memory
/// grows with the objects, not with the pairs, and pairs begin to come before all are found. Throws like `candidates`.
template <Dim N, class T>
void visit_candidates(const SceneView<N, T>& scene, const CandidateVisitor& visit, double margin = 0);

namespace detail {

/// How the boxes of a scene are held against each other, so that no pair within the margin is missed. Throws
/// std::invalid_argument for a margin that is negative or not finite.
template <class T>
PairOptions candidate_options(double margin);

}  // namespace detail

}  // namespace graze
