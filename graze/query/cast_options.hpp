// SPDX-License-Identifier: MIT
/// @file
/// The options of shape_cast(a, motion, b, options).
#pragma once

namespace graze {

/// What stops a `shape_cast`. The default is that the first touch does.
struct CastOptions {
  /// What is not approached does not stop the cast, so that a box that rests on a floor slides along it, leaves it, and
  /// still hits a wall. See shape_cast.hpp.
  bool ignore_initial_touch = false;
  /// The cast stops when the shapes are this near: a length, at least zero. Zero: when they touch.
  double target_distance = 0;

  friend bool operator==(const CastOptions&, const CastOptions&) = default;
};

}  // namespace graze
