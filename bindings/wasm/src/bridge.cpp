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

/// A piece of input, so that the vector has the alignment of the largest number.
struct alignas(16) Chunk {
  std::byte bytes[16];
};

std::vector<Chunk> input_chunks;
std::vector<double> answer_numbers;
std::string error_message;
std::int32_t has_error = 0;

constexpr double places = 536870912;                // 2^29
constexpr double least_inexact = 9007199254740992;  // 2^53

std::size_t input_address(std::size_t bytes) { return reinterpret_cast<std::size_t>(reserve_input(bytes)); }
std::size_t answer_address() { return reinterpret_cast<std::size_t>(answer_numbers.data()); }
std::size_t answer_size() { return answer_numbers.size(); }
std::size_t error_flag_address() { return reinterpret_cast<std::size_t>(&has_error); }

std::string version() { return GRAZE_VERSION; }

/// The bytes that are allocated now.
std::size_t used_bytes() { return static_cast<std::size_t>(mallinfo().uordblks); }

std::string take_error() {
  has_error = 0;
  return std::move(error_message);
}

}  // namespace

std::byte* reserve_input(std::size_t bytes) {
  const std::size_t chunks = (bytes + sizeof(Chunk) - 1) / sizeof(Chunk);
  if (chunks > input_chunks.size()) {
    input_chunks = {};  // first, so that the old room can be used again
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

void keep_error(const char* message) {
  error_message = message;
  has_error = 1;
}

double packed_id(std::uint32_t index, std::uint32_t generation) {
  const double id = index + places * generation;
  if (!(index < places && id < least_inexact)) {
    throw std::length_error("the place of an object has been used more often than an id in JavaScript can say");
  }
  return id;
}

UnpackedId unpacked_id(double id) {
  if (!(id >= 0 && id < least_inexact && id == std::floor(id))) {
    throw std::invalid_argument(fmt::format("an id is a whole number that graze gave out; {} is not", id));
  }
  const double generation = std::floor(id / places);
  return {static_cast<std::uint32_t>(id - generation * places), static_cast<std::uint32_t>(generation)};
}

EMSCRIPTEN_BINDINGS(graze_bridge) {
  using namespace emscripten;  // NOLINT(google-build-using-namespace): as embind is written
  function("inputAddress", &Guarded<&input_address>::call);
  function("answerAddress", &answer_address);
  function("answerSize", &answer_size);
  function("errorFlagAddress", &error_flag_address);
  function("takeError", &take_error);
  function("version", &version);
  function("usedBytes", &used_bytes);
}

}  // namespace graze::wasm
