// SPDX-License-Identifier: MIT
// Causes an error. With OWN_THROW, errors are reported by this program's own macro.
#ifdef OWN_THROW
#include <cstdio>
#include <cstdlib>
#define GRAZE_THROW(error) (std::printf("own: %s\n", (error).what()), std::exit(3))
#endif

#include <vector>

#include <graze/shape/polytope.hpp>

int main() { return static_cast<int>(graze::convex_hull(std::vector<graze::Vec<3>>{}).vertices().size()); }
