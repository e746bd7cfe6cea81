// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include <graze/io/scene_file.hpp>
#include <graze/io/svg/frame.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/verdict.hpp>

namespace graze::io::svg {

/// How many objects or pairs there are of each kind. Objects count by the closest pair they are in.
struct Counts {
  std::size_t near = 0;  ///< Reported, but apart.
  std::size_t touching = 0;
  std::size_t overlapping = 0;

  void add(Relation relation);
  std::size_t all() const { return near + touching + overlapping; }
};

/// What the header of a picture says.
struct Summary {
  std::string source;  ///< A path; its last part becomes the heading.
  Dim dimension = 2;
  std::size_t free = 0;  ///< Objects in no pair.
  Counts objects;
  Counts pairs;
  std::size_t too_far = 0;  ///< Objects that are not drawn.
};

/// The heading, and the legend: a sample of each colour and pattern with its count, and of each mark where two meet.
std::string header(const Summary& summary);

/// The mark of a pair that touches or overlaps, as one element.
std::string pair_mark(Relation relation, const Vec<2, double>& place);

/// What of the file is not in the picture, "not read: 3 x tile layer", as one line below the card, lost shapes first;
/// empty for nothing.
std::string omission_note(const Frame& frame, std::span<const Omission> omissions);

/// An axis of the scene as the picture shows it: its name, and where a step of length 1 along it leads.
struct Axis {
  std::string name;
  Vec<2, double> step;
};

/// The directions of the axes, and a bar that is a round number of units long along them (isometrically all alike).
std::string footer(const Frame& frame, std::span<const Axis> axes);

}  // namespace graze::io::svg
