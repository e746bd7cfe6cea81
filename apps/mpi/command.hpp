// SPDX-License-Identifier: MIT
// The commands of graze-mpi. All ranks parse the same arguments and run the same command.
#pragma once

#include <functional>

#include <CLI/CLI.hpp>
#include <mpi.h>

namespace graze::mpi {

/// A subcommand: its options, and the function to call once they have been parsed.
struct Command {
  CLI::App* app = nullptr;
  std::function<void()> run;
};

/// Each function adds its subcommand to the program.
Command add_pairs(CLI::App& program);
Command add_bench(CLI::App& program);

inline int rank_of_this() {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  return rank;
}

inline int number_of_ranks() {
  int size = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  return size;
}

}  // namespace graze::mpi
