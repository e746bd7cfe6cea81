// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>

#include <graze/broad/pair.hpp>

namespace graze::detail {

/// Asked once how many pairs there are, gives the room for them.
using PairRoom = std::function<Pair*(std::size_t count)>;

}  // namespace graze::detail
