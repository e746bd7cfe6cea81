// SPDX-License-Identifier: MIT
#pragma once

namespace graze {

/// How an iteration ended.
enum class Status {
  converged,   ///< The bounds met, to the stated tolerance.
  best_bound,  ///< Precision or the step limit ended it: the bounds given hold, but are not as close as wanted.
};

}  // namespace graze
