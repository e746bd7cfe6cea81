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

/// The number of objects or pairs of each kind. An object counts by the closest pair that contains it.
struct Counts {
  std::size_t near = 0;  ///< Reported, but apart.
  std::size_t touching = 0;
  std::size_t overlapping = 0;

  void add(Relation relation);
  std::size_t all() const { return near + touching + overlapping; }
};

/// The content of a picture's header.
struct Summary {
  std::string source;  ///< A path; its last part becomes the heading.
  Dim dimension = 2;
  std::size_t free = 0;  ///< Objects in no pair.
  Counts objects;
  Counts pairs;
  std::size_t too_far = 0;  ///< Objects that are not drawn.
};

/// The heading, and the legend: a sample of each colour and pattern with its count, and of each mark.
std::string header(const Summary& summary);

/// The mark of a touching or overlapping pair, as one element.
std::string pair_mark(Relation relation, const Vec<2, double>& place);

/// What was not read of the file, "not read: 3 x tile layer", as one line below the card, missing shapes first; empty
/// if everything was read.
std::string omission_note(const Frame& frame, std::span<const Omission> omissions);

/// An axis of the scene as drawn: its name, and the screen vector of a unit step along it.
struct Axis {
  std::string name;
  Vec<2, double> step;
};

/// The directions of the axes, and a scale bar whose length is a round number of units (the same along all isometric
/// axes).
std::string footer(const Frame& frame, std::span<const Axis> axes);

}  // namespace graze::io::svg
