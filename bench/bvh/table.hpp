// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "race.hpp"

namespace bench {

/// The times of all, and how many times as long as graze's the fastest peer takes, beside what graze aims at: marked
/// where it falls short.
std::string table_of(const RaceResult& result);

}  // namespace bench
