// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include <graze/distributed/mpi/communicator.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::detail {

/// A point with a weight.
template <Dim N>
struct WeightedPoint {
  Vec<N, double> at;
  float weight = 1;
};

/// Cuts all of space into one cell per rank, such that the points of all ranks in each cell have about the same weight:
/// recursive coordinate bisection (Berger and Bokhari 1987), by Zoltan. The cells are indexed by rank and the same on
/// every rank; outer ones extend to infinity. Where there are fewer points than ranks, some are `nothing`. Coordinates
/// must be finite. Collective.
template <Dim N>
std::vector<Aabb<N, double>> bisected(const Communicator& comm, std::span<const WeightedPoint<N>> points);

}  // namespace graze::detail
