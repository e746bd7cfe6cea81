// SPDX-License-Identifier: MIT
// What tests on several ranks share. All ranks run the same tests and build the same worlds, of which each takes a
// part.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include <mpi.h>

#include <graze/distributed/id_pair.hpp>
#include <graze/distributed/mpi/communicator.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::test {

inline int rank_in(MPI_Comm comm) {
  int rank = 0;
  MPI_Comm_rank(comm, &rank);
  return rank;
}

inline int ranks_of(MPI_Comm comm) {
  int size = 1;
  MPI_Comm_size(comm, &size);
  return size;
}

inline int world_rank() { return rank_in(MPI_COMM_WORLD); }
inline int world_ranks() { return ranks_of(MPI_COMM_WORLD); }

/// True if it is true on all ranks, so that they go on or stop together.
inline bool on_all(MPI_Comm comm, bool mine) {
  int all = 0;
  const int one = mine ? 1 : 0;
  MPI_Allreduce(&one, &all, 1, MPI_INT, MPI_MIN, comm);
  return all == 1;
}

/// A communicator of the first `size` ranks of all; null on the others.
class FirstRanks {
 public:
  explicit FirstRanks(int size) {
    MPI_Comm_split(MPI_COMM_WORLD, world_rank() < size ? 0 : MPI_UNDEFINED, world_rank(), &comm_);
  }
  FirstRanks(const FirstRanks&) = delete;
  FirstRanks& operator=(const FirstRanks&) = delete;
  ~FirstRanks() {
    if (comm_ != MPI_COMM_NULL) MPI_Comm_free(&comm_);
  }
  MPI_Comm comm() const { return comm_; }
  explicit operator bool() const { return comm_ != MPI_COMM_NULL; }

 private:
  MPI_Comm comm_ = MPI_COMM_NULL;
};

/// This rank's part of a world: box i has the id ids_of_all[i].
template <Dim N, class T>
struct Share {
  std::vector<Aabb<N, T>> boxes;
  std::vector<std::uint64_t> ids;
};

/// The share of this rank; rank_of(i) tells who passes box i.
template <Dim N, class T>
Share<N, T> share_of(MPI_Comm comm, std::span<const Aabb<N, T>> world, std::span<const std::uint64_t> ids,
                     const std::function<int(std::size_t)>& rank_of) {
  Share<N, T> share;
  for (std::size_t i = 0; i < world.size(); ++i) {
    if (rank_of(i) != rank_in(comm)) continue;
    share.boxes.push_back(world[i]);
    share.ids.push_back(ids[i]);
  }
  return share;
}

/// The message of the exception of type E that the action throws; "none" or "another" otherwise.
template <class E, class Action>
std::string message_of(const Action& action) {
  try {
    action();
  } catch (const E& error) {
    return error.what();
  } catch (...) {
    return "another";
  }
  return "none";
}

}  // namespace graze::test
