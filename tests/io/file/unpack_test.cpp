// SPDX-License-Identifier: MIT
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <graze/io/file/unpack.hpp>

namespace graze::io::unpack_test {
namespace {

// The numbers 1 to 4 in four bytes each, packed by other programs (Python's zlib and gzip, libzstd).
const std::string plain("\1\0\0\0\2\0\0\0\3\0\0\0\4\0\0\0", 16);
constexpr std::string_view by_zlib = "eJxjZGBgYAJiZiBmAWIAAGAACw==";
constexpr std::string_view by_gzip = "H4sIAAAAAAACA2NkYGBgAmJmIGYBYgDv1AWvEAAAAA==";
constexpr std::string_view by_zstd = "KLUv/SQQgQAAAQAAAAIAAAADAAAABAAAAKYUxW4=";

std::string bytes_of(std::string_view base64) { return decoded_base64(base64).bytes; }

std::string fault_of(const Unpacked& result) { return result.fault ? result.fault->fact : "no fault"; }

TEST(Unpack, DecodesBase64) {
  const std::vector<std::pair<std::string_view, std::string>> table = {
      {"", ""},
      {"Zg==", "f"},
      {"Zm8=", "fo"},
      {"Zm9v", "foo"},
      {"Zm9vYg==", "foob"},
      {"Zm8", "fo"},
      {" Zm\n9v\t", "foo"},
      {"+/+/", "\xfb\xff\xbf"},
      {"AAAA", std::string(3, '\0')},
  };
  for (const auto& [text, bytes] : table) {
    const Unpacked result = decoded_base64(text);
    EXPECT_EQ(fault_of(result), "no fault") << text;
    EXPECT_EQ(result.bytes, bytes) << text;
  }
}

TEST(Unpack, RefusesWhatIsNoBase64) {
  EXPECT_EQ(fault_of(decoded_base64("Zm9v-")), "is not base64: character 5 is not one of A-Z, a-z, 0-9, + and /");
  EXPECT_EQ(fault_of(decoded_base64("Zg==Zg==")), "is not base64: it continues after \"=\"");
  EXPECT_EQ(fault_of(decoded_base64("Zm9vY")), "is not base64: it ends in the middle of a byte; is the file cut off?");
}

TEST(Unpack, UnpacksWhatOthersHavePacked) {
  EXPECT_EQ(unpacked(plain, Packing::none, 16).bytes, plain);
  if (!can_unpack(Packing::zstd)) GTEST_SKIP() << "this build has no zlib and no Zstandard";
  for (const auto& [packed, packing] :
       {std::pair(by_zlib, Packing::zlib), {by_gzip, Packing::gzip}, {by_zstd, Packing::zstd}}) {
    const Unpacked result = unpacked(bytes_of(packed), packing, 16);
    EXPECT_EQ(fault_of(result), "no fault");
    EXPECT_EQ(result.bytes, plain);
  }
}

TEST(Unpack, RefusesMoreOrFewerBytesThanExpected) {
  EXPECT_EQ(fault_of(unpacked(plain, Packing::none, 17)), "has 16 bytes, but its cells need 17");
  if (!can_unpack(Packing::zstd)) GTEST_SKIP() << "this build has no zlib and no Zstandard";
  for (const auto& [packed, packing] :
       {std::pair(by_zlib, Packing::zlib), {by_gzip, Packing::gzip}, {by_zstd, Packing::zstd}}) {
    EXPECT_EQ(fault_of(unpacked(bytes_of(packed), packing, 12)),
              "unpacks to more than the 12 bytes that its cells need");
    EXPECT_EQ(fault_of(unpacked(bytes_of(packed), packing, 0)), "unpacks to more than the 0 bytes that its cells need");
    EXPECT_EQ(fault_of(unpacked(bytes_of(packed), packing, 20)), "unpacks to 16 bytes, but its cells need 20");
  }
}

TEST(Unpack, RefusesWhatIsBrokenOrCutOffAnywhere) {
  if (!can_unpack(Packing::zstd)) GTEST_SKIP() << "this build has no zlib and no Zstandard";
  for (const auto& [text, packing] :
       {std::pair(by_zlib, Packing::zlib), {by_gzip, Packing::gzip}, {by_zstd, Packing::zstd}}) {
    const std::string packed = bytes_of(text);
    for (std::size_t size = 0; size < packed.size(); ++size) {
      EXPECT_TRUE(unpacked(packed.substr(0, size), packing, 16).fault) << size;
    }
    std::string broken = packed;
    broken[0] = '!';
    EXPECT_NE(fault_of(unpacked(broken, packing, 16)).find("is broken"), std::string::npos);
  }
  EXPECT_EQ(fault_of(unpacked(bytes_of(by_zlib).substr(0, 8), Packing::zlib, 16)),
            "ends before it is complete; is the file cut off?");
}

}  // namespace
}  // namespace graze::io::unpack_test
