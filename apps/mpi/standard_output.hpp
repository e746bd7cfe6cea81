// SPDX-License-Identifier: MIT
#pragma once

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <string>

namespace graze::mpi {

/// Writes to the standard output of this rank. Throws std::runtime_error if that fails.
inline void write_out(const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0) return;
  throw std::runtime_error(std::string("the standard output cannot be written: ") + std::strerror(errno));
}

}  // namespace graze::mpi
