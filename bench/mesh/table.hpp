// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "race.hpp"

namespace mesh_bench {

std::string_view title_of(Work work);

/// All times of one work.
std::string times_of(const Heat& heat);

/// graze beside the fastest peer of each work, with the ratio that is aimed for; then the wrong answers.
std::string table_of(const RaceResult& result);

}  // namespace mesh_bench
