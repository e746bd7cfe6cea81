// SPDX-License-Identifier: MIT
#include "bridge.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <emscripten/bind.h>
#include <fmt/format.h>
#include <malloc.h>

namespace graze::wasm {
namespace {

/// An element of the input buffer, so that the vector is aligned for the largest type of number.
struct alignas(16) Chunk {
  std::byte bytes[16];
};

std::vector<Chunk> input_chunks;
std::vector<double> answer_numbers;
std::string error_message;

/// The state that JavaScript reads after a call.
struct CallState {
  enum : std::uint32_t { good = 0, failed = 1, refused = 2 } end = good;
  const double* answer = nullptr;
  std::size_t size = 0;
} call_state;

constexpr double places = 536870912;                // 2^29
constexpr double least_inexact = 9007199254740992;  // 2^53

std::size_t input_address(std::size_t bytes) { return reinterpret_cast<std::size_t>(reserve_input(bytes)); }
std::size_t call_state_address() { return reinterpret_cast<std::size_t>(&call_state); }

std::string version() { return GRAZE_VERSION; }

/// The number of bytes currently allocated.
std::size_t used_bytes() { return static_cast<std::size_t>(mallinfo().uordblks); }

std::string take_error() {
  call_state.end = CallState::good;
  return std::move(error_message);
}

}  // namespace

std::byte* reserve_input(std::size_t bytes) {
  const std::size_t chunks = (bytes + sizeof(Chunk) - 1) / sizeof(Chunk);
  if (chunks > input_chunks.size()) {
    input_chunks = {};  // first, so that the old memory can be reused
    input_chunks.resize(chunks);
  }
  return reinterpret_cast<std::byte*>(input_chunks.data());
}

template <class T>
std::span<const T> input(std::size_t count) {
  return {reinterpret_cast<const T*>(input_chunks.data()), count};
}

template std::span<const float> input(std::size_t);
template std::span<const double> input(std::size_t);

std::vector<double>& answer() { return answer_numbers; }

void publish_answer() {
  call_state.answer = answer_numbers.data();
  call_state.size = answer_numbers.size();
}

void keep_error(const std::exception& error) {
  error_message = error.what();
  call_state.end = dynamic_cast<const Refused*>(&error) != nullptr ? CallState::refused : CallState::failed;
}

double packed_id(std::uint32_t index, std::uint32_t generation) {
  const double id = index + places * generation;
  if (!(index < places && id < least_inexact)) {
    throw std::length_error("a slot was reused more often than an id in JavaScript can represent");
  }
  return id;
}

UnpackedId unpacked_id(double id) {
  if (!(id >= 0 && id < least_inexact && id == std::floor(id))) {
    throw std::invalid_argument(fmt::format("an id is an integer returned by graze; {} is not", id));
  }
  const double generation = std::floor(id / places);
  return {static_cast<std::uint32_t>(id - generation * places), static_cast<std::uint32_t>(generation)};
}

EMSCRIPTEN_BINDINGS(graze_bridge) {
  using namespace emscripten;  // NOLINT(google-build-using-namespace): as embind is written
  function("inputAddress", &Guarded<&input_address>::call);
  function("callStateAddress", &call_state_address);
  function("takeError", &take_error);
  function("version", &version);
  function("usedBytes", &used_bytes);
}

}  // namespace graze::wasm
