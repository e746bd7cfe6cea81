// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include <mpi.h>

#include <graze/distributed/together.hpp>

namespace graze::detail {

/// What this rank has sent to other ranks, without the few numbers of each collective operation.
struct Traffic {
  std::uint64_t messages = 0;
  std::uint64_t bytes = 0;
};

/// Throws std::runtime_error that names the call, unless `code` is MPI_SUCCESS. By default MPI ends the job instead of
/// returning another code.
void require_success(int code, const char* call);

/// Bytes from or for all ranks, one after the other, by rank.
template <class Byte>
struct BytesByRank {
  std::span<Byte> bytes;
  std::span<const std::size_t> counts;  ///< How many of each rank.
};

/// A private copy of the user's communicator, so that messages of the two cannot be confused. Creation is collective.
/// Everything here is collective unless stated otherwise. Operations that allocate do so with `together`.
class Communicator {
 public:
  /// The largest number of bytes in one message: MPI counts in `int`.
  static constexpr std::size_t largest_message = std::size_t{1} << 30U;

  explicit Communicator(MPI_Comm comm);
  ~Communicator();
  Communicator(Communicator&& other) noexcept;
  Communicator& operator=(Communicator&& other) noexcept;

  MPI_Comm handle() const { return comm_; }
  int rank() const { return rank_; }
  int size() const { return size_; }

  /// See together.hpp.
  template <class Work>
  void together(Work&& work) const {
    graze::together(comm_, std::forward<Work>(work));
  }

  /// The bits that are set on at least one rank.
  unsigned any(unsigned bits) const;
  std::uint64_t sum(std::uint64_t mine) const;
  /// Replaces each number by its sum over all ranks, the same bits on each.
  void add_up(std::span<double> numbers) const;
  double greatest(double mine) const;
  /// The number of every rank, by rank; valid until the next call.
  std::span<const std::uint64_t> all(std::uint64_t mine);
  /// Tells every rank its number and returns what all have told this one, by rank; valid until the next call.
  std::span<const std::size_t> swap_counts(std::span<const std::size_t> counts);

  /// Allocates what swap_bytes needs, which is then the only part that communicates. Not collective.
  void prepare_swap(std::span<const std::size_t> out_bytes, std::span<const std::size_t> in_bytes,
                    std::size_t largest = largest_message);

  /// Sends out.counts[r] bytes to each rank r and receives in.counts[r] from it. A rank sends nothing where the number
  /// is 0, and copies what it sends to itself. Longer data is split into messages of at most `largest` bytes. Call
  /// prepare_swap with the same numbers before.
  void swap_bytes(const BytesByRank<const std::byte>& out, const BytesByRank<std::byte>& in, Traffic& traffic,
                  std::size_t largest = largest_message);

 private:
  void release();

  MPI_Comm comm_ = MPI_COMM_NULL;
  int rank_ = 0;
  int size_ = 1;
  std::vector<std::uint64_t> numbers_;
  std::vector<std::size_t> counts_;
  std::vector<MPI_Request> requests_;
};

/// Records from or for all ranks, one after the other, by rank.
template <class R>
struct ByRank {
  std::vector<R> records;
  std::vector<std::size_t> counts;  ///< How many of each rank.
};

/// Swaps records whose numbers are known on both sides: counts[r] of them to each rank r, stored by rank. First runs
/// `prepare`, which may write the records and both counts, as `together` does. The memory of `received` is reused.
template <class R, class Prepare>
void swap_known(Communicator& comm, const Prepare& prepare, const ByRank<R>& sent, ByRank<R>& received,
                Traffic& traffic) {
  static_assert(std::is_trivially_copyable_v<R>);
  std::vector<std::size_t> out;
  std::vector<std::size_t> in;
  comm.together([&] {
    prepare();
    std::size_t total = 0;
    for (const std::size_t count : sent.counts) out.push_back(count * sizeof(R));
    for (const std::size_t count : received.counts) {
      in.push_back(count * sizeof(R));
      total += count;
    }
    received.records.resize(total);
    comm.prepare_swap(out, in);
  });
  comm.swap_bytes({std::as_bytes(std::span<const R>(sent.records)), out},
                  {std::as_writable_bytes(std::span<R>(received.records)), in}, traffic);
}

/// Swaps records: counts[r] of them to each rank r, stored by rank.
template <class R>
ByRank<R> swap(Communicator& comm, const ByRank<R>& sent, Traffic& traffic) {
  ByRank<R> received;
  const std::span<const std::size_t> incoming = comm.swap_counts(sent.counts);
  const auto keep_counts = [&] { received.counts.assign(incoming.begin(), incoming.end()); };
  swap_known(comm, keep_counts, sent, received, traffic);
  return received;
}

}  // namespace graze::detail
