// SPDX-License-Identifier: MIT
// Any text as a map, tileset or template in Tiled's XML: it is rejected with a message, or read; what was read of a map
// can be written and read again.
#include <cstddef>
#include <cstdint>
#include <string>

#include <graze/io/tiled/xml.hpp>

#include "fuzz/input.hpp"
#include "fuzz/texts.hpp"
#include "fuzz/tiled_texts.hpp"

using namespace graze;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = test::fuzz::Input(data, size).rest();
  const io::TiledText file{"file", text};
  test::fuzz::read_or_refuse([&] { return io::read_tiled_xml_map(file); });
  test::fuzz::read_or_refuse([&] { return io::read_tiled_xml_tileset(file); });
  test::fuzz::read_or_refuse([&] { return io::read_tiled_xml_template(file); });
  test::fuzz::check_map(text);
  return 0;
}
