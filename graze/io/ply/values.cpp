// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include <graze/io/mesh/bytes.hpp>
#include <graze/io/ply/values.hpp>

namespace graze::io {
namespace {

double value_of(PlyType type, const char* bytes, ByteOrder order) {
  switch (type) {
    case PlyType::int8:
      return number_at<std::int8_t>(bytes, order);
    case PlyType::uint8:
      return number_at<std::uint8_t>(bytes, order);
    case PlyType::int16:
      return number_at<std::int16_t>(bytes, order);
    case PlyType::uint16:
      return number_at<std::uint16_t>(bytes, order);
    case PlyType::int32:
      return number_at<std::int32_t>(bytes, order);
    case PlyType::uint32:
      return number_at<std::uint32_t>(bytes, order);
    case PlyType::float32:
      return number_at<float>(bytes, order);
    case PlyType::float64:
      return number_at<double>(bytes, order);
  }
  return 0;
}

}  // namespace

PlyValues::PlyValues(std::string_view bytes, const std::string& source, const PlyHeader& header)
    : bytes_(bytes),
      source_(source),
      encoding_(header.encoding),
      tokens_(bytes, source, MeshSyntax::plain, header.end),
      at_(header.end),
      offset_(header.end) {}

InputError PlyValues::error(std::size_t offset, std::string_view message) const {
  if (is_text()) return tokens_.error(offset, message);
  return InputError(fmt::format("{}: byte {}: {}", source_, offset, message));
}

double PlyValues::binary(PlyType type, std::string_view name) {
  offset_ = at_;
  const std::size_t size = ply_bytes(type);
  if (bytes_.size() - at_ < size) {
    throw error(at_, fmt::format("{} is missing; is the file cut off?", name));
  }
  at_ += size;
  const ByteOrder order = encoding_ == PlyEncoding::big_endian ? ByteOrder::big : ByteOrder::little;
  return value_of(type, bytes_.data() + offset_, order);
}

double PlyValues::number(PlyType type, std::string_view name) {
  if (is_text()) {
    const MeshToken token = tokens_.next();
    offset_ = token.offset;
    return tokens_.number(token, name);
  }
  const double value = binary(type, name);
  if (!std::isfinite(value)) throw error(offset_, fmt::format("{} is {}; it must be a finite number", name, value));
  return value;
}

std::int64_t PlyValues::whole(PlyType type, std::string_view name) {
  if (is_text()) {
    const MeshToken token = tokens_.next();
    offset_ = token.offset;
    return tokens_.whole(token, name);
  }
  const double value = binary(type, name);
  if (value == std::floor(value) && std::fabs(value) < 0x1p53) return static_cast<std::int64_t>(value);
  throw error(offset_, fmt::format("{} is {}; it must be a whole number", name, value));
}

std::size_t PlyValues::length(const PlyProperty& list) {
  const std::int64_t length = whole(*list.count_type, "the length of a list");
  const std::size_t least = is_text() ? 1 : ply_bytes(list.type);
  if (length < 0 || static_cast<std::uint64_t>(length) > bytes_left() / least) {
    throw error(offset_, fmt::format("a list has {} elements, but only {} bytes follow", length, bytes_left()));
  }
  return static_cast<std::size_t>(length);
}

void PlyValues::skip(const PlyProperty& property) {
  const std::size_t count = property.count_type ? length(property) : 1;
  if (!is_text()) {
    const std::size_t size = ply_bytes(property.type);
    if (bytes_left() / size < count) throw error(at_, "the file ends here; is it cut off?");
    at_ += count * size;
    return;
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (tokens_.next().text.empty()) throw error(tokens_.offset(), "the file ends here; is it cut off?");
  }
}

}  // namespace graze::io
