// SPDX-License-Identifier: MIT
#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include <graze/io/file/unpack.hpp>
#include <graze/io/text/in_quotes.hpp>
#include <graze/io/tiled/data.hpp>

namespace graze::io {
namespace {

constexpr std::string_view csv_space = " \t\r\n";

std::optional<Packing> packing_named(std::string_view name) {
  if (name.empty()) return Packing::none;
  if (name == "zlib") return Packing::zlib;
  if (name == "gzip") return Packing::gzip;
  if (name == "zstd") return Packing::zstd;
  return std::nullopt;
}

/// Four bytes each, little endian.
std::vector<std::uint32_t> gids_of_bytes(std::string_view bytes) {
  std::vector<std::uint32_t> gids(bytes.size() / 4);
  const auto byte = [&](std::size_t i) { return std::uint32_t{static_cast<unsigned char>(bytes[i])}; };
  for (std::size_t i = 0; i < gids.size(); ++i) {
    gids[i] = byte(4 * i) | (byte(4 * i + 1) << 8U) | (byte(4 * i + 2) << 16U) | (byte(4 * i + 3) << 24U);
  }
  return gids;
}

void count_unknown_format(std::string_view name, bool is_known, const TiledPlace& place,
                          std::vector<Omission>& omissions) {
  const std::string what = fmt::format("tile layer in the format {}", in_quotes(name));
  const std::string why = fmt::format(
      "{} cannot decompress it; choose CSV, or base64 uncompressed, in Tiled's map "
      "properties (Tile Layer Format)",
      is_known ? "this build of graze" : "graze");
  count_omission(omissions, {what, Loss::shape, why}, place);
}

}  // namespace

void check_count(std::uint64_t found, std::uint64_t count, const TiledPlace& place, std::vector<Omission>& omissions) {
  if (found > count) fail_at(place, fmt::format("there are {} tiles here, but width times height is {}", found, count));
  if (found < count) count_omission(omissions, tiled_omission::short_layer, place);
}

std::vector<std::uint32_t> tiled_gids_of_csv(std::string_view text, const TiledPlace& place) {
  std::vector<std::uint32_t> gids;
  gids.reserve(static_cast<std::size_t>(std::count(text.begin(), text.end(), ',')) + 1);
  const char* at = text.data();
  const char* const end = at + text.size();
  const auto skip_space = [&] {
    while (at != end && csv_space.find(*at) != std::string_view::npos) ++at;
  };
  for (skip_space(); at != end; skip_space()) {
    std::uint32_t gid = 0;
    const auto [behind, error] = std::from_chars(at, end, gid);
    if (error != std::errc()) {
      const std::string_view rest(at, std::min<std::size_t>(static_cast<std::size_t>(end - at), 20));
      fail_at(place, fmt::format("tile {} of the data is {}; it must be a whole number from 0 to 4294967295",
                                 gids.size() + 1, in_quotes(rest.substr(0, rest.find_first_of(", \t\r\n")))));
    }
    gids.push_back(gid);
    at = behind;
    skip_space();
    if (at == end) break;
    if (*at != ',') {
      fail_at(place, fmt::format("a comma is missing after tile {} of the data", gids.size()));
    }
    ++at;
  }
  return gids;
}

std::optional<std::vector<std::uint32_t>> tiled_gids(std::string_view text, const TiledDataFormat& format,
                                                     std::uint64_t count, const TiledPlace& place,
                                                     std::vector<Omission>& omissions) {
  if (format.encoding == "csv") {
    std::vector<std::uint32_t> gids = tiled_gids_of_csv(text, place);
    check_count(gids.size(), count, place, omissions);
    return gids;
  }
  const std::optional<Packing> packing = packing_named(format.compression);
  if (format.encoding != "base64" || !packing || !can_unpack(*packing)) {
    const bool is_encoded = format.encoding == "base64";
    count_unknown_format(is_encoded ? format.compression : format.encoding, is_encoded && packing.has_value(), place,
                         omissions);
    return std::nullopt;
  }
  const Unpacked packed = decoded_base64(text);
  if (packed.fault) fail_at(place, "the data " + packed.fault->fact);
  const Unpacked cells = unpacked(packed.bytes, *packing, static_cast<std::size_t>(4 * count));
  if (cells.fault) fail_at(place, "the data " + cells.fault->fact);
  return gids_of_bytes(cells.bytes);
}

}  // namespace graze::io
