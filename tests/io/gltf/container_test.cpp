// SPDX-License-Identifier: MIT
#include <cstdint>
#include <string>

#include <gtest/gtest.h>

#include <graze/io/gltf/container.hpp>
#include <graze/io/mesh/bytes.hpp>

#include "io/scene_text.hpp"

namespace graze::io::glb_container_test {
namespace {

std::string chunk(std::uint32_t type, const std::string& content) {
  std::string bytes;
  append_number(bytes, static_cast<std::uint32_t>(content.size()));
  append_number(bytes, type);
  return bytes + content;
}

std::string glb(const std::string& chunks, std::uint32_t version = 2) {
  std::string bytes = "glTF";
  append_number(bytes, version);
  append_number(bytes, static_cast<std::uint32_t>(glb_head_bytes + chunks.size()));
  return bytes + chunks;
}

std::string refusal(const std::string& bytes) {
  return error_of([&bytes] { read_glb(bytes, "a.glb"); });
}

TEST(GlbContainer, JsonAndBinaryChunksAreFoundAndOthersSkipped) {
  const std::string bytes = glb(chunk(glb_json_chunk, "{}  ") + chunk(glb_binary_chunk, "1234") + chunk(7, "abcd"));
  const GlbChunks chunks = read_glb(bytes, "a.glb");
  EXPECT_EQ(chunks.json, "{}  ");
  EXPECT_EQ(chunks.binary, "1234");
  const std::string alone = glb(chunk(glb_json_chunk, std::string("{}\0\0", 4)));
  EXPECT_EQ(read_glb(alone, "a.glb").json, "{}");
  EXPECT_FALSE(read_glb(alone, "a.glb").binary);
}

TEST(GlbContainer, EveryCutIsRefused) {
  const std::string whole = glb(chunk(glb_json_chunk, "{}  ") + chunk(glb_binary_chunk, "1234"));
  for (std::size_t size = 4; size < whole.size(); ++size) {
    EXPECT_NE(refusal(whole.substr(0, size)).find("a.glb: byte "), std::string::npos) << size;
  }
}

TEST(GlbContainer, FaultsAreRefusedWithTheirPlace) {
  EXPECT_EQ(refusal("glTF"), "a.glb: byte 4: the header is cut off; it has 12 bytes");
  EXPECT_EQ(refusal(glb("", 1)), "a.glb: byte 4: this is glTF 1; graze reads glTF 2.0, so export it as that");
  EXPECT_EQ(refusal(glb("")), "a.glb: byte 12: there is no chunk; the first one must be JSON");
  EXPECT_EQ(refusal(glb("abcd")), "a.glb: byte 12: chunk 0 is cut off");
  EXPECT_EQ(refusal(glb(chunk(glb_binary_chunk, "1234"))), "a.glb: byte 16: the first chunk must be JSON");
  std::string long_chunk = glb(chunk(glb_json_chunk, "{}"));
  long_chunk[15] = '\x7f';
  EXPECT_EQ(refusal(long_chunk),
            "a.glb: byte 12: chunk 0 promises 2130706434 bytes, but 2 follow; is the file cut off?");
  EXPECT_EQ(refusal(glb(chunk(glb_json_chunk, "{}")).substr(0, 20)),
            "a.glb: byte 8: the header promises 22 bytes, but the file has 20; is it cut off?");
}

}  // namespace
}  // namespace graze::io::glb_container_test
