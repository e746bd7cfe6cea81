// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include <graze/io/svg_frame.hpp>
#include <graze/math/vec.hpp>

namespace graze::io::svg {

/// What the header of a picture says.
struct Summary {
  std::string source;  ///< A path; its last part becomes the heading.
  Dim dimension = 2;
  std::size_t free = 0;
  std::size_t touching = 0;
  std::size_t pairs = 0;
  std::size_t too_far = 0;  ///< Objects that are not drawn.
};

/// The heading, and the legend: a sample of each colour and pattern with its count.
std::string header(const Summary& summary);

/// An axis of the scene as the picture shows it: its name, and where a step of length 1 along it leads.
struct Axis {
  std::string name;
  Vec<2, double> step;
};

/// The directions of the axes, and a bar that is a round number of units long along them (isometrically all alike).
std::string footer(const Frame& frame, std::span<const Axis> axes);

}  // namespace graze::io::svg
