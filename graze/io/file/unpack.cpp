// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#if GRAZE_COMPRESSION
#define ZLIB_CONST  // makes zlib declare its input const
#include <zlib.h>
#include <zstd.h>
#endif

#include <graze/io/file/unpack.hpp>

namespace graze::io {
namespace {

constexpr std::uint8_t no_digit = 0xFF;

/// The value of each base64 character, `no_digit` for all others.
constexpr std::array<std::uint8_t, 256> base64_digits() {
  std::array<std::uint8_t, 256> digits{};
  for (auto& digit : digits) digit = no_digit;
  constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::size_t i = 0; i < alphabet.size(); ++i) {
    digits[static_cast<unsigned char>(alphabet[i])] = static_cast<std::uint8_t>(i);
  }
  return digits;
}

Unpacked refused(std::string fact) { return {"", UnpackFault{std::move(fact)}}; }

#if GRAZE_COMPRESSION
/// Data is unpacked in blocks of this size, so that a short input that claims to be long costs no more memory than
/// this.
constexpr std::size_t unpack_step = std::size_t{1} << 18U;

/// Makes room for the next bytes, at most one more than `size`; that one reveals excess data.
std::size_t make_room(std::string& bytes, std::size_t size) {
  const std::size_t room = std::min(unpack_step, size - bytes.size() + 1);
  bytes.resize(bytes.size() + room);
  return room;
}

Unpacked checked(std::string bytes, bool is_complete, std::size_t size) {
  if (bytes.size() > size) return refused(fmt::format("unpacks to more than the {} bytes that its cells need", size));
  if (!is_complete) return refused("ends before it is complete; is the file cut off?");
  if (bytes.size() < size) {
    return refused(fmt::format("unpacks to {} bytes, but its cells need {}", bytes.size(), size));
  }
  return {std::move(bytes)};
}

Unpacked inflated(std::string_view packed, int window_bits, std::size_t size) {
  z_stream stream{};
  if (inflateInit2(&stream, window_bits) != Z_OK) return refused("cannot be unpacked: zlib is out of memory");
  const std::unique_ptr<z_stream, int (*)(z_stream*)> closing(&stream, inflateEnd);
  std::string bytes;
  int status = Z_OK;
  std::size_t given = 0;
  while (status == Z_OK && bytes.size() <= size) {
    if (stream.avail_in == 0 && given < packed.size()) {
      const std::size_t piece = std::min<std::size_t>(packed.size() - given, 1U << 30U);
      stream.next_in = reinterpret_cast<const Bytef*>(packed.data() + given);
      stream.avail_in = static_cast<uInt>(piece);
      given += piece;
    }
    const std::size_t before = bytes.size();
    const std::size_t room = make_room(bytes, size);
    stream.next_out = reinterpret_cast<Bytef*>(bytes.data() + before);
    stream.avail_out = static_cast<uInt>(room);
    status = inflate(&stream, Z_NO_FLUSH);
    bytes.resize(before + room - stream.avail_out);
  }
  if (status == Z_DATA_ERROR || status == Z_NEED_DICT) {
    return refused(fmt::format("is broken: {}", stream.msg != nullptr ? stream.msg : "it needs a preset dictionary"));
  }
  return checked(std::move(bytes), status == Z_STREAM_END, size);
}

Unpacked unpacked_zstd(std::string_view packed, std::size_t size) {
  const std::unique_ptr<ZSTD_DStream, std::size_t (*)(ZSTD_DStream*)> stream(ZSTD_createDStream(), ZSTD_freeDStream);
  if (!stream) return refused("cannot be unpacked: Zstandard is out of memory");
  ZSTD_inBuffer input{packed.data(), packed.size(), 0};
  std::string bytes;
  std::size_t status = 1;  // 0 at the end of a frame
  bool has_progress = true;
  while (status != 0 && has_progress && bytes.size() <= size) {
    const std::size_t before = bytes.size();
    const std::size_t input_before = input.pos;
    const std::size_t room = make_room(bytes, size);
    ZSTD_outBuffer output{bytes.data() + before, room, 0};
    status = ZSTD_decompressStream(stream.get(), &output, &input);
    bytes.resize(before + output.pos);
    if (ZSTD_isError(status) != 0U) return refused(fmt::format("is broken: {}", ZSTD_getErrorName(status)));
    has_progress = output.pos > 0 || input.pos > input_before;
  }
  return checked(std::move(bytes), status == 0, size);
}
#endif

}  // namespace

Unpacked decoded_base64(std::string_view text) {
  static constexpr std::array<std::uint8_t, 256> digits = base64_digits();
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3);
  std::uint32_t group = 0;
  int bits = 0;
  std::size_t i = 0;
  for (; i < text.size() && text[i] != '='; ++i) {
    const std::uint8_t digit = digits[static_cast<unsigned char>(text[i])];
    if (digit == no_digit) {
      if (std::string_view(" \t\r\n").find(text[i]) != std::string_view::npos) continue;
      return refused(fmt::format("is not base64: character {} is not one of A-Z, a-z, 0-9, + and /", i + 1));
    }
    group = (group << 6U) | digit;
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes.push_back(static_cast<char>((group >> static_cast<unsigned>(bits)) & 0xFFU));
  }
  if (text.find_first_not_of("= \t\r\n", i) != std::string_view::npos) {
    return refused("is not base64: it continues after \"=\"");
  }
  if (bits == 6) return refused("is not base64: it ends in the middle of a byte; is the file cut off?");
  return {std::move(bytes)};
}

bool can_unpack(Packing packing) { return packing == Packing::none || GRAZE_COMPRESSION != 0; }

Unpacked unpacked(std::string_view packed, Packing packing, std::size_t size) {
#if GRAZE_COMPRESSION
  if (packing == Packing::zlib) return inflated(packed, MAX_WBITS, size);
  constexpr int with_gzip_header = 16;  // zlib.h: added to the window size
  if (packing == Packing::gzip) return inflated(packed, MAX_WBITS + with_gzip_header, size);
  if (packing == Packing::zstd) return unpacked_zstd(packed, size);
#endif
  if (packing != Packing::none) return refused("cannot be unpacked by this build");
  if (packed.size() != size) {
    return refused(fmt::format("has {} bytes, but its cells need {}", packed.size(), size));
  }
  return {std::string(packed)};
}

}  // namespace graze::io
