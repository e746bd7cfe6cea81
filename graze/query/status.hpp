// SPDX-License-Identifier: MIT
#pragma once

namespace graze {

/// How an iterative algorithm ended.
enum class Status {
  converged,   ///< The bounds met within the stated tolerance.
  best_bound,  ///< Rounding or the step limit ended it: the bounds hold, but are wider than intended.
};

}  // namespace graze
