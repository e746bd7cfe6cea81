// SPDX-License-Identifier: MIT
#include <array>
#include <cstring>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>

#include <graze/distributed/mpi/communicator.hpp>
#include <graze/distributed/together.hpp>

namespace graze::detail {
namespace {

/// The types of exceptions that keep their type when they cross ranks.
enum class Kind : int { invalid_argument, length_error, out_of_memory, other };

/// A failure as it is sent: no allocation may stand between an exception and the others' being told.
struct Failure {
  Kind kind = Kind::other;
  std::array<char, 1000> text{};
};

Failure described(const std::exception_ptr& mine) {
  Failure failure;
  const auto write = [&failure](Kind kind, const char* text) {
    failure.kind = kind;
    std::strncpy(failure.text.data(), text, failure.text.size() - 1);
  };
  try {
    std::rethrow_exception(mine);
  } catch (const std::invalid_argument& error) {
    write(Kind::invalid_argument, error.what());
  } catch (const std::length_error& error) {
    write(Kind::length_error, error.what());
  } catch (const std::bad_alloc&) {
    write(Kind::out_of_memory, "out of memory");
  } catch (const std::exception& error) {
    write(Kind::other, error.what());
  } catch (...) {
    write(Kind::other, "an exception of a type that is not derived from std::exception");
  }
  return failure;
}

[[noreturn]] void raise(const Failure& failure, int rank) {
  if (failure.kind == Kind::out_of_memory) throw std::bad_alloc();
  const std::string text = "rank " + std::to_string(rank) + ": " + failure.text.data();
  if (failure.kind == Kind::invalid_argument) throw std::invalid_argument(text);
  if (failure.kind == Kind::length_error) throw std::length_error(text);
  throw std::runtime_error(text);
}

}  // namespace

void agree(MPI_Comm comm, const std::exception_ptr& mine) {
  int rank = 0;
  int size = 1;
  require_success(MPI_Comm_rank(comm, &rank), "MPI_Comm_rank");
  require_success(MPI_Comm_size(comm, &size), "MPI_Comm_size");
  const int candidate = mine ? rank : size;
  int failing = size;
  require_success(MPI_Allreduce(&candidate, &failing, 1, MPI_INT, MPI_MIN, comm), "MPI_Allreduce");
  if (failing == size) return;
  Failure failure;
  if (failing == rank) failure = described(mine);
  require_success(MPI_Bcast(&failure, sizeof failure, MPI_BYTE, failing, comm), "MPI_Bcast");
  raise(failure, failing);
}

}  // namespace graze::detail
