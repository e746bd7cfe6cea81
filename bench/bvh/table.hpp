// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "race.hpp"

namespace bench {

/// The times of all contestants, and the ratio of the fastest peer's time to graze's, with graze's targets; missed
/// targets are marked.
std::string table_of(const RaceResult& result);

}  // namespace bench
