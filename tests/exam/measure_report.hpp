// SPDX-License-Identifier: MIT
// The tables of distances, contacts, manifolds, rays, casts and impacts, as Markdown.
#pragma once

#include <string>
#include <vector>

#include "exam/measure.hpp"

namespace graze::exam {

/// What graze said of the distance of each pair, and beside its rivals; empty if there were no cases.
std::string distance_tables(const std::vector<MeasuredPair>& tallies);

/// The same of contacts.
std::string contact_tables(const std::vector<MeasuredPair>& tallies);

/// The same of manifolds.
std::string manifold_tables(const std::vector<MeasuredPair>& tallies);

/// The same of each shape and rays.
std::string ray_tables(const std::vector<MeasuredPair>& tallies);

/// The same of each pair of which one moves.
std::string cast_tables(const std::vector<MeasuredPair>& tallies);

/// The same of each pair of which both move and turn.
std::string impact_tables(const std::vector<MeasuredPair>& tallies);

}  // namespace graze::exam
