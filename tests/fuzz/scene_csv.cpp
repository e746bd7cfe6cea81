// SPDX-License-Identifier: MIT
// Any text as a scene in CSV: it is rejected with a message, or read; what was read can be written and read again.
#include <cstddef>
#include <cstdint>
#include <string>

#include <graze/io/csv/scene.hpp>

#include "fuzz/input.hpp"
#include "fuzz/texts.hpp"

using namespace graze;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = test::fuzz::Input(data, size).rest();
  const auto file = test::fuzz::read_or_refuse([&] { return io::parse_csv_scene(text, "table"); });
  if (file) test::fuzz::require_survival(*file);
  return 0;
}
