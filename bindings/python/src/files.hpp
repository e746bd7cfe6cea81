// SPDX-License-Identifier: MIT
// Pictures of shapes, for notebooks.
#pragma once

#include <string>

#include "shape.hpp"

namespace graze::python {

/// A picture of one shape as SVG.
std::string svg_of_shape(const HeldShape& shape);

}  // namespace graze::python
