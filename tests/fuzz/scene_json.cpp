// SPDX-License-Identifier: MIT
// Any text as a scene in graze's own format: it is rejected with a message, or read; what was read can be written and
// read again.
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include <graze/io/json_scene.hpp>
#include <graze/io/scene_file.hpp>

#include "fuzz/input.hpp"
#include "fuzz/texts.hpp"

using namespace graze;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = test::fuzz::Input(data, size).rest();
  const auto file = test::fuzz::read_or_refuse([&] { return io::parse_json_scene(text, "scene"); });
  if (!file) return 0;
  test::fuzz::require_survival(*file);
  // The function for all formats recognises this one.
  const auto told = test::fuzz::read_or_refuse([&] { return io::parse_scene(text, "scene", "no folder"); });
  test::fuzz::require(told && test::fuzz::written(*told) == test::fuzz::written(*file), [&](std::ostream& out) {
    out << "a scene in graze's format must be recognised, except\n" << text;
  });
  return 0;
}
