// SPDX-License-Identifier: MIT
/// @file
/// Moving boxes, with what belongs to them, to the ranks that own them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include <mpi.h>

#include <graze/distributed/mpi/communicator.hpp>
#include <graze/distributed/partition.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze {

/// A payload of nothing.
struct NoPayload {};

/// A box with its id and whatever travels with it: any type that can be copied byte by byte.
template <Dim N, class T = float, class Payload = NoPayload>
struct Body {
  Aabb<N, T> box;        ///< Where it is.
  std::uint64_t id = 0;  ///< Its name in the whole world.
  Payload payload;       ///< The user's data.
};

/// Sends each body to the rank given for it, possibly this one, and returns the bodies that arrive here, ascending by
/// id. No body is lost or copied. Collective. Throws std::invalid_argument on all ranks if the numbers of bodies and
/// ranks differ, or if a rank does not exist.
template <Dim N, class T, class Payload>
std::vector<Body<N, T, Payload>> exchange(MPI_Comm comm, std::span<const Body<N, T, Payload>> bodies,
                                          std::span<const int> ranks) {
  using Sent = Body<N, T, Payload>;
  static_assert(std::is_trivially_copyable_v<Sent>, "exchange: the payload must be trivially copyable");
  detail::Communicator own(comm);
  detail::ByRank<Sent> sent;
  own.together([&] {
    if (bodies.size() != ranks.size()) {
      throw std::invalid_argument("exchange: there are " + std::to_string(bodies.size()) + " bodies, but " +
                                  std::to_string(ranks.size()) + " ranks");
    }
    sent.counts.assign(static_cast<std::size_t>(own.size()), 0);
    for (const int rank : ranks) {
      if (rank < 0 || rank >= own.size()) {
        throw std::invalid_argument("exchange: rank " + std::to_string(rank) + " does not exist; there are " +
                                    std::to_string(own.size()));
      }
      ++sent.counts[static_cast<std::size_t>(rank)];
    }
    std::vector<std::size_t> next(sent.counts.size());
    std::exclusive_scan(sent.counts.begin(), sent.counts.end(), next.begin(), std::size_t{0});
    sent.records.resize(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i)
      sent.records[next[static_cast<std::size_t>(ranks[i])]++] = bodies[i];
  });
  detail::Traffic traffic;
  detail::ByRank<Sent> received = detail::swap(own, sent, traffic);
  std::stable_sort(received.records.begin(), received.records.end(),
                   [](const Sent& a, const Sent& b) { return a.id < b.id; });
  return std::move(received.records);
}

/// Sends each body to the rank that owns its box.
template <Dim N, class T, class Payload>
std::vector<Body<N, T, Payload>> exchange(MPI_Comm comm, std::span<const Body<N, T, Payload>> bodies,
                                          const Partition<N>& partition) {
  std::vector<int> ranks;
  together(comm, [&] {
    for (const Body<N, T, Payload>& body : bodies) ranks.push_back(owner(partition, body.box));
  });
  return exchange(comm, bodies, ranks);
}

}  // namespace graze
