// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include <graze/io/mesh/tokens.hpp>
#include <graze/io/ply/header.hpp>
#include <graze/io/text/in_quotes.hpp>
#include <graze/io/text/printable.hpp>
#include <graze/io/text/suggestion.hpp>

namespace graze::io {
namespace {

/// A type and its two names.
struct TypeName {
  PlyType type;
  std::string_view name;
  std::string_view other_name;
};

constexpr std::array<TypeName, 8> type_names = {{{PlyType::int8, "char", "int8"},
                                                 {PlyType::uint8, "uchar", "uint8"},
                                                 {PlyType::int16, "short", "int16"},
                                                 {PlyType::uint16, "ushort", "uint16"},
                                                 {PlyType::int32, "int", "int32"},
                                                 {PlyType::uint32, "uint", "uint32"},
                                                 {PlyType::float32, "float", "float32"},
                                                 {PlyType::float64, "double", "float64"}}};

constexpr std::array<std::pair<std::string_view, PlyEncoding>, 3> encodings = {
    {{"ascii", PlyEncoding::text},
     {"binary_little_endian", PlyEncoding::little_endian},
     {"binary_big_endian", PlyEncoding::big_endian}}};

class PlyHeaderReader {
 public:
  /// A file whose lines end with CR may continue with a byte that looks like the LF of a CRLF.
  PlyHeaderReader(std::string_view bytes, const std::string& source)
      : tokens_(bytes, source, MeshSyntax::plain),
        ends_with_cr_(bytes.size() > 4 && bytes[3] == '\r' && bytes[4] != '\n') {}

  PlyHeader read() {
    bool has_format = false;
    for (;;) {
      const bool goes_on = tokens_.next_line();
      const MeshToken word = tokens_.next_in_line();
      if (word.text == "end_header") break;
      if (!goes_on) throw tokens_.error(word.offset, "the header ends without \"end_header\"; is the file cut off?");
      if (word.text.empty() || word.text == "comment" || word.text == "obj_info") continue;
      read_line(word, has_format);
    }
    if (!has_format) throw tokens_.error(0, "the header has no line \"format\"");
    header_.end = end_of_line();
    return std::move(header_);
  }

 private:
  std::size_t end_of_line() {
    tokens_.rest_of_line();
    const std::size_t end = tokens_.offset();
    if (ends_with_cr_) return end + 1;
    tokens_.next_line();
    return tokens_.offset();
  }

  void read_line(const MeshToken& word, bool& has_format) {
    if (word.text == "format") {
      has_format = true;
      return read_format();
    }
    if (word.text == "element") return read_element(word.offset);
    if (word.text == "property") return read_property(word.offset);
    constexpr std::array<std::string_view, 6> known = {"format",  "comment",  "obj_info",
                                                       "element", "property", "end_header"};
    if (nearest_name(word.text, known)) {
      throw tokens_.error(word.offset, fmt::format("the header has an unknown line {}{}", in_quotes(word.text),
                                                   did_you_mean(word.text, known)));
    }
    header_.warnings.emplace_back(
        tokens_
            .error(word.offset,
                   fmt::format("the header has an unknown line {}, which was skipped", in_quotes(word.text)))
            .what());
  }

  void read_format() {
    const MeshToken word = tokens_.next_in_line();
    const auto* const found =
        std::find_if(encodings.begin(), encodings.end(), [&word](const auto& one) { return one.first == word.text; });
    if (found == encodings.end()) {
      throw tokens_.error(word.offset, fmt::format("the format is {}; it must be ascii, binary_little_endian or "
                                                   "binary_big_endian",
                                                   in_quotes(word.text)));
    }
    header_.encoding = found->second;
  }

  void read_element(std::size_t offset) {
    PlyElement element;
    const MeshToken name = tokens_.next_in_line();
    if (name.text.empty()) throw tokens_.error(name.offset, "an element needs a name and a number");
    element.name = printable(name.text);
    element.offset = offset;
    const MeshToken token = tokens_.next_in_line();
    const std::int64_t count = tokens_.whole(token, "the number of elements");
    if (count < 0) throw tokens_.error(token.offset, fmt::format("the number of elements is {}", count));
    element.count = static_cast<std::uint64_t>(count);
    header_.elements.push_back(std::move(element));
  }

  PlyType type_of(const MeshToken& word) const {
    const auto* const found = std::find_if(type_names.begin(), type_names.end(), [&word](const TypeName& one) {
      return one.name == word.text || one.other_name == word.text;
    });
    if (found != type_names.end()) return found->type;
    std::array<std::string_view, type_names.size()> known;
    for (std::size_t i = 0; i < known.size(); ++i) known[i] = type_names[i].name;
    throw tokens_.error(word.offset,
                        fmt::format("there is no type {}{}", in_quotes(word.text), did_you_mean(word.text, known)));
  }

  void read_property(std::size_t offset) {
    if (header_.elements.empty()) throw tokens_.error(offset, "a property stands before the first element");
    PlyProperty property;
    MeshToken word = tokens_.next_in_line();
    if (word.text == "list") {
      const MeshToken count = tokens_.next_in_line();
      property.count_type = type_of(count);
      if (*property.count_type >= PlyType::float32) {
        throw tokens_.error(count.offset, "the length of a list must be a whole number, such as uchar");
      }
      word = tokens_.next_in_line();
    }
    property.type = type_of(word);
    const MeshToken name = tokens_.next_in_line();
    if (name.text.empty()) throw tokens_.error(name.offset, "a property needs a type and a name");
    property.name = std::string(name.text);
    header_.elements.back().properties.push_back(std::move(property));
  }

  MeshTokens tokens_;
  PlyHeader header_;
  bool ends_with_cr_ = false;
};

}  // namespace

std::size_t ply_bytes(PlyType type) {
  constexpr std::array<std::size_t, 8> bytes = {1, 1, 2, 2, 4, 4, 4, 8};
  return bytes[static_cast<std::size_t>(type)];
}

std::optional<std::size_t> PlyElement::find(std::string_view property) const {
  for (std::size_t i = 0; i < properties.size(); ++i) {
    if (properties[i].name == property) return i;
  }
  return std::nullopt;
}

std::size_t PlyElement::least_bytes(bool is_text) const {
  std::size_t bytes = 0;
  for (const PlyProperty& property : properties) {
    bytes += is_text ? 2 : ply_bytes(property.count_type.value_or(property.type));
  }
  return bytes;
}

PlyHeader read_ply_header(std::string_view bytes, const std::string& source) {
  return PlyHeaderReader(bytes, source).read();
}

}  // namespace graze::io
