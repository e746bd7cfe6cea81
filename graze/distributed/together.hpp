// SPDX-License-Identifier: MIT
#pragma once

#include <exception>
#include <utility>

#include <mpi.h>

namespace graze {

namespace detail {

/// Ends a phase in which each rank has worked alone: collective. Returns if no rank passes an exception, and otherwise
/// throws on all ranks what `together` promises.
void agree(MPI_Comm comm, const std::exception_ptr& mine);

}  // namespace detail

/// Runs `work` on every rank and throws on all of them if it throws on one, so that none waits for a rank that has
/// left: an exception of the type that the lowest failing rank threw (std::invalid_argument, std::length_error,
/// std::bad_alloc; any other becomes std::runtime_error), whose message begins with that rank. `work` must not
/// communicate. Collective; costs one reduction of an integer.
template <class Work>
void together(MPI_Comm comm, Work&& work) {
  std::exception_ptr failure;
  try {
    std::forward<Work>(work)();
  } catch (...) {
    failure = std::current_exception();
  }
  detail::agree(comm, failure);
}

}  // namespace graze
