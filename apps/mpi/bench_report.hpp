// SPDX-License-Identifier: MIT
// The result of graze-mpi bench, for people and for programs. docs/distributed.md documents the fields.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <graze/distributed/distributed_pair_finder.hpp>

namespace graze::mpi {

/// What one rank did in a frame, as it is sent to rank 0.
struct RankFrame {
  double milliseconds = 0;
  DistributedFrame frame;
  std::uint64_t checksum = 0;  ///< Of the rank's pairs; the sum over the ranks does not depend on their number.
};

/// One frame on all ranks.
struct FrameResult {
  std::vector<RankFrame> ranks;
  double ghosts_model = 0;  ///< How many ghosts the cost model expects in a uniform world.
};

struct MpiBenchReport {
  std::string world;
  std::uint64_t seed = 1;
  std::uint64_t boxes = 0;
  std::uint64_t threads = 1;
  double skin = 0;
  std::vector<FrameResult> frames;
};

std::string table_of(const MpiBenchReport& report);
std::string json_of(const MpiBenchReport& report);

}  // namespace graze::mpi
