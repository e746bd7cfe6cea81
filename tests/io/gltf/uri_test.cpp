// SPDX-License-Identifier: MIT
#include <optional>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include <graze/io/gltf/uri.hpp>

namespace graze::io::gltf_uri_test {
namespace {

TEST(GltfUri, PathsInTheFolderAreDecoded) {
  EXPECT_EQ(file_of_gltf_uri("a.bin"), "a.bin");
  EXPECT_EQ(file_of_gltf_uri("buffers/a%20b%c3%A9.bin"), "buffers/a b\xc3\xa9.bin");
  EXPECT_EQ(file_of_gltf_uri("./a..b/..c"), "./a..b/..c");
  EXPECT_EQ(file_of_gltf_uri("100%.bin"), "100%.bin");
  EXPECT_EQ(file_of_gltf_uri("%4"), "%4");
}

TEST(GltfUri, NothingLeadsOutOfTheFolder) {
  for (const std::string_view uri : {"", "/etc/passwd", "%2Fetc/passwd", "../a.bin", "a/../../b", "a/%2e%2E/b", "..",
                                     "http://a/b", "file:a", "C:a", "a\\b", "..%5Cb", "a%00b"}) {
    EXPECT_EQ(file_of_gltf_uri(uri), std::nullopt) << uri;
  }
}

}  // namespace
}  // namespace graze::io::gltf_uri_test
