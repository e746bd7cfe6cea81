// SPDX-License-Identifier: MIT
// What queries of one and two shapes answer, for random shapes and for cases from a list.
#pragma once

#include <istream>
#include <ostream>

#include <graze/math/vec.hpp>

namespace graze::test {

/// A line for every two types of shapes, several times.
template <Dim N, class T>
void write_queries(std::ostream& out);

/// Two lines for each case, in double and in float, or one if it names a number type. A case is a line with a space,
/// what is asked, and two shapes, separated by tabs, as the published cases have them
/// (tests/query/published_cases.hpp): "3D", "double relation", "sphere 0 0 0 1", "point 1 0 0". "-" is no second shape;
/// then it is the first one again.
void write_cases(std::istream& cases, std::ostream& out);

}  // namespace graze::test
