// SPDX-License-Identifier: MIT
// Runs the tests on all ranks of an MPI job. Rank 0 reports; the others only print what fails on them.
#include <array>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>

#include <gtest/gtest.h>
#include <mpi.h>

#include "ranks.hpp"

namespace {

/// Prints the failures of a rank other than 0.
class FailuresOnly final : public testing::EmptyTestEventListener {
  void OnTestPartResult(const testing::TestPartResult& result) override {
    if (!result.failed()) return;
    std::fprintf(stderr, "rank %d: %s:%d: %s\n", graze::test::world_rank(),
                 result.file_name() != nullptr ? result.file_name() : "?", result.line_number(), result.summary());
  }
};

/// Properties draw the same cases on all ranks: with the seed of the environment, or with a random one of rank 0.
void share_seed() {
  const char* const given = std::getenv("RC_PARAMS");
  std::string text = given != nullptr ? given : "";
  if (text.find("seed=") == std::string::npos) text += " seed=" + std::to_string(std::random_device()());
  std::array<char, 1000> shared{};
  text.copy(shared.data(), shared.size() - 1);
  MPI_Bcast(shared.data(), static_cast<int>(shared.size()), MPI_CHAR, 0, MPI_COMM_WORLD);
  setenv("RC_PARAMS", shared.data(), 1);
}

}  // namespace

int main(int argc, char** argv) {
  int level = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &level);
  share_seed();
  testing::InitGoogleTest(&argc, argv);
  if (graze::test::world_rank() != 0) {
    testing::TestEventListeners& listeners = testing::UnitTest::GetInstance()->listeners();
    delete listeners.Release(listeners.default_result_printer());
    listeners.Append(new FailuresOnly);
  }
  const bool passed = graze::test::on_all(MPI_COMM_WORLD, RUN_ALL_TESTS() == 0);
  MPI_Finalize();
  return passed ? 0 : 1;
}
