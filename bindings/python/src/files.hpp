// SPDX-License-Identifier: MIT
// Pictures of shapes, for notebooks, and what readers of files have in common.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <graze/io/omission.hpp>

#include "shape.hpp"

namespace graze::python {

/// A picture of one shape as SVG.
std::string svg_of_shape(const HeldShape& shape);

/// From a str, bytes or os.PathLike. Throws TypeError for anything else.
std::filesystem::path path_of(const py::object& path);

/// What was not read, in words.
py::list texts_of(const std::vector<io::Omission>& omissions);

}  // namespace graze::python
