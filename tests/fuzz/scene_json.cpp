// SPDX-License-Identifier: MIT
// Any text as a scene of our own format: it is refused in words, or read; what was read survives being written.
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
  // The door for all formats sees which one it is.
  const auto told = test::fuzz::read_or_refuse([&] { return io::parse_scene(text, "scene", "no folder"); });
  test::fuzz::require(told && test::fuzz::written(*told) == test::fuzz::written(*file), [&](std::ostream& out) {
    out << "a scene of ours is taken for one, but not\n" << text;
  });
  return 0;
}
