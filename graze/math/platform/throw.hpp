// SPDX-License-Identifier: MIT
// GRAZE_THROW(error): how headers report errors. It throws; without exceptions it prints the message and aborts. A
// program may define it before including graze, identically in all its files; it must not return.
#pragma once

#ifndef GRAZE_THROW

#ifdef __cpp_exceptions
#define GRAZE_THROW(...) throw __VA_ARGS__
#else

#include <cstdio>
#include <cstdlib>
#include <exception>

namespace graze::detail {

[[noreturn]] inline void stop(const std::exception& error) {
  std::fprintf(stderr, "graze: %s\n", error.what());
  std::abort();
}

}  // namespace graze::detail

#define GRAZE_THROW(...) ::graze::detail::stop(__VA_ARGS__)
#endif

#endif
