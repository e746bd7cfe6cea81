// SPDX-License-Identifier: MIT
/// @file
/// The options of contact(a, b, options) and manifold(a, b, options).
#pragma once

namespace graze {

/// Which shapes have a contact. The default is that those that meet do.
struct ContactOptions {
  /// Shapes that are up to this far apart have contacts too, with their distance as a negative depth: a length, at
  /// least zero. See contact.hpp and manifold.hpp.
  double margin = 0;
};

}  // namespace graze
