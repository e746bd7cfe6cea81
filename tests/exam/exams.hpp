// SPDX-License-Identifier: MIT
// All questions in all spaces.
#pragma once

#include <vector>

#include <graze/math/vec.hpp>

#include "exam/exam.hpp"
#include "exam/settings.hpp"

namespace graze::exam {

/// Adds the tasks of one space that the settings select. They refer to both arguments. Compiled by exams.cpp.in.
template <Dim N, class T>
void add_tasks_of_space(const Settings& settings, RegressionLog& regressions, std::vector<Task>& tasks);

}  // namespace graze::exam
