// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstring>
#include <stdexcept>
#include <string>

#include <graze/distributed/mpi/communicator.hpp>

namespace graze::detail {
namespace {

constexpr int tag = 1;

template <class Number>
Number reduced(MPI_Comm comm, Number mine, MPI_Datatype type, MPI_Op operation) {
  Number result{};
  require_success(MPI_Allreduce(&mine, &result, 1, type, operation, comm), "MPI_Allreduce");
  return result;
}

/// Calls block(rank, offset, bytes) for each message.
template <class Block>
void visit_messages(std::span<const std::size_t> bytes, std::size_t largest, int without, const Block& block) {
  std::size_t offset = 0;
  for (std::size_t rank = 0; rank < bytes.size(); ++rank) {
    for (std::size_t done = 0; static_cast<int>(rank) != without && done < bytes[rank]; done += largest) {
      block(static_cast<int>(rank), offset + done, static_cast<int>(std::min(largest, bytes[rank] - done)));
    }
    offset += bytes[rank];
  }
}

std::size_t offset_of(std::span<const std::size_t> bytes, int rank) {
  std::size_t offset = 0;
  for (int r = 0; r < rank; ++r) offset += bytes[static_cast<std::size_t>(r)];
  return offset;
}

}  // namespace

void require_success(int code, const char* call) {
  if (code == MPI_SUCCESS) return;
  std::array<char, MPI_MAX_ERROR_STRING> text{};
  int length = 0;
  MPI_Error_string(code, text.data(), &length);
  throw std::runtime_error(std::string(call) + " failed: " + text.data());
}

Communicator::Communicator(MPI_Comm comm) {
  require_success(MPI_Comm_dup(comm, &comm_), "MPI_Comm_dup");
  require_success(MPI_Comm_rank(comm_, &rank_), "MPI_Comm_rank");
  require_success(MPI_Comm_size(comm_, &size_), "MPI_Comm_size");
  try {
    together([this] {
      numbers_.resize(static_cast<std::size_t>(size_));
      counts_.resize(static_cast<std::size_t>(size_));
    });
  } catch (...) {
    release();
    throw;
  }
}

Communicator::~Communicator() { release(); }

Communicator::Communicator(Communicator&& other) noexcept { *this = std::move(other); }

Communicator& Communicator::operator=(Communicator&& other) noexcept {
  std::swap(comm_, other.comm_);
  std::swap(rank_, other.rank_);
  std::swap(size_, other.size_);
  std::swap(numbers_, other.numbers_);
  std::swap(counts_, other.counts_);
  std::swap(requests_, other.requests_);
  return *this;
}

void Communicator::release() {
  if (comm_ == MPI_COMM_NULL) return;
  int finalized = 0;
  MPI_Finalized(&finalized);
  if (finalized == 0) MPI_Comm_free(&comm_);
  comm_ = MPI_COMM_NULL;
}

unsigned Communicator::any(unsigned bits) const { return reduced(comm_, bits, MPI_UNSIGNED, MPI_BOR); }
std::uint64_t Communicator::sum(std::uint64_t mine) const { return reduced(comm_, mine, MPI_UINT64_T, MPI_SUM); }
double Communicator::greatest(double mine) const { return reduced(comm_, mine, MPI_DOUBLE, MPI_MAX); }

void Communicator::add_up(std::span<double> numbers) const {
  require_success(
      MPI_Allreduce(MPI_IN_PLACE, numbers.data(), static_cast<int>(numbers.size()), MPI_DOUBLE, MPI_SUM, comm_),
      "MPI_Allreduce");
}

std::span<const std::uint64_t> Communicator::all(std::uint64_t mine) {
  require_success(MPI_Allgather(&mine, 1, MPI_UINT64_T, numbers_.data(), 1, MPI_UINT64_T, comm_), "MPI_Allgather");
  return numbers_;
}

std::span<const std::size_t> Communicator::swap_counts(std::span<const std::size_t> counts) {
  static_assert(sizeof(std::size_t) == sizeof(std::uint64_t));
  require_success(MPI_Alltoall(counts.data(), 1, MPI_UINT64_T, counts_.data(), 1, MPI_UINT64_T, comm_), "MPI_Alltoall");
  return counts_;
}

void Communicator::prepare_swap(std::span<const std::size_t> out_bytes, std::span<const std::size_t> in_bytes,
                                std::size_t largest) {
  std::size_t messages = 0;
  const auto count = [&messages](int, std::size_t, int) { ++messages; };
  visit_messages(out_bytes, largest, rank_, count);
  visit_messages(in_bytes, largest, rank_, count);
  requests_.assign(messages, MPI_REQUEST_NULL);
}

void Communicator::swap_bytes(const BytesByRank<const std::byte>& out, const BytesByRank<std::byte>& in,
                              Traffic& traffic, std::size_t largest) {
  MPI_Request* next = requests_.data();
  visit_messages(in.counts, largest, rank_, [&](int rank, std::size_t offset, int bytes) {
    require_success(MPI_Irecv(in.bytes.data() + offset, bytes, MPI_BYTE, rank, tag, comm_, next++), "MPI_Irecv");
  });
  visit_messages(out.counts, largest, rank_, [&](int rank, std::size_t offset, int bytes) {
    require_success(MPI_Isend(out.bytes.data() + offset, bytes, MPI_BYTE, rank, tag, comm_, next++), "MPI_Isend");
    traffic.messages += 1;
    traffic.bytes += static_cast<std::uint64_t>(bytes);
  });
  if (const std::size_t own = out.counts[static_cast<std::size_t>(rank_)]; own > 0) {
    std::memcpy(in.bytes.data() + offset_of(in.counts, rank_), out.bytes.data() + offset_of(out.counts, rank_), own);
  }
  require_success(MPI_Waitall(static_cast<int>(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE),
                  "MPI_Waitall");
}

}  // namespace graze::detail
