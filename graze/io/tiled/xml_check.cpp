// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include <graze/io/text/in_quotes.hpp>
#include <graze/io/text/position.hpp>
#include <graze/io/tiled/tile_elements.hpp>
#include <graze/io/tiled/xml_check.hpp>

namespace graze::io {
namespace {

constexpr std::string_view xml_space = " \t\r\n";

/// True for "#65" and "#x41" if the number is that of a character that XML allows.
bool is_character_reference(std::string_view name) {
  if (!name.starts_with('#')) return false;
  const bool hexadecimal = name.starts_with("#x");
  name.remove_prefix(hexadecimal ? 2 : 1);
  std::uint32_t code = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), code, hexadecimal ? 16 : 10);
  if (error != std::errc() || end != name.data() + name.size()) return false;
  if (code < 0x20) return code == 0x9 || code == 0xA || code == 0xD;
  return code <= 0xD7FF || (code >= 0xE000 && code <= 0xFFFD) || (code >= 0x10000 && code <= 0x10FFFF);
}

/// Scans a text once, tag by tag. Stops at an unterminated tag or quotation, which pugixml reports.
class XmlCheck {
 public:
  XmlCheck(std::string_view text, const std::string& source) : text_(text), source_(source) {}

  void run() {
    refuse_control_characters();
    while (at_ < text_.size()) {
      const std::size_t tag = std::min(text_.find('<', at_), text_.size());
      check_text(at_, tag);
      if (tag == text_.size()) return;
      // A fast path: <tile gid="7"/> occurs millions of times and has no faults.
      at_ = depth_ > 0 ? behind_tile_elements(text_, tag) : tag;
      if (at_ > tag) continue;
      const std::optional<std::size_t> end = pass_markup(tag);
      if (!end) return;
      at_ = *end;
    }
  }

 private:
  [[noreturn]] void fail(std::size_t offset, const std::string& fact) const {
    throw error_at(text_, source_, offset, fact);
  }

  void refuse_control_characters() const {
    const auto is_control = [](char byte) {
      return static_cast<unsigned char>(byte) < 0x20 && byte != '\t' && byte != '\r' && byte != '\n';
    };
    const auto* const found = std::find_if(text_.begin(), text_.end(), is_control);
    if (found == text_.end()) return;
    fail(static_cast<std::size_t>(found - text_.begin()),
         fmt::format("the character U+{:04X} is not allowed in XML; remove it", static_cast<unsigned char>(*found)));
  }

  /// Checks the text between two tags.
  void check_text(std::size_t begin, std::size_t end) const {
    if (depth_ > 0) return check_references(begin, end);
    const std::size_t first = text_.find_first_not_of(xml_space, begin);
    if (first >= end) return;
    const std::string_view found = text_.substr(first, std::min<std::size_t>(end - first, 20));
    fail(first, fmt::format("{} appears {} the root element, where XML allows no text; remove it",
                            in_quotes(found.substr(0, found.find_first_of("\r\n"))),
                            root_ == std::string_view::npos ? "before" : "after"));
  }

  void check_references(std::size_t begin, std::size_t end) const {
    static constexpr std::array<std::string_view, 5> predefined{"lt", "gt", "amp", "apos", "quot"};
    const std::string_view part = text_.substr(0, end);
    for (std::size_t i = part.find('&', begin); i != std::string_view::npos; i = part.find('&', i + 1)) {
      const std::size_t semicolon = part.find(';', i);
      const std::string_view name =
          semicolon == std::string_view::npos ? std::string_view() : part.substr(i + 1, semicolon - i - 1);
      if (std::find(predefined.begin(), predefined.end(), name) != predefined.end()) continue;
      if (is_character_reference(name)) continue;
      if (name.empty() || name.find_first_of(" \t\r\n<\"'=") != std::string_view::npos) {
        fail(i, "\"&\" begins a reference such as &lt; but this is not one; write &amp; for the character itself");
      }
      fail(i,
           fmt::format("the entity {} is not supported: graze reads &lt; &gt; &amp; &apos; &quot; and numbers such as "
                       "&#65; only; write its text instead",
                       in_quotes(fmt::format("&{};", name))));
    }
  }

  /// The end of the tag, comment, ... that begins at `begin`; none if it is unterminated.
  std::optional<std::size_t> pass_markup(std::size_t begin) {
    const std::string_view rest = text_.substr(begin);
    if (rest.starts_with("<!--")) return behind("-->", begin + 4);
    if (rest.starts_with("<?")) return pass_instruction(begin);
    if (rest.starts_with("<![CDATA[")) {
      if (depth_ == 0) fail(begin, "there is a CDATA section outside the root element; remove it");
      return behind("]]>", begin + 9);
    }
    if (rest.starts_with("<!")) return behind_declaration(begin);
    if (!rest.starts_with("</")) return pass_start_tag(begin);
    if (depth_ > 0) --depth_;
    return behind(">", begin);
  }

  std::optional<std::size_t> behind(std::string_view mark, std::size_t from) const {
    const std::size_t found = text_.find(mark, from);
    if (found == std::string_view::npos) return std::nullopt;
    return found + mark.size();
  }

  std::optional<std::size_t> pass_instruction(std::size_t begin) const {
    const std::string_view target = text_.substr(begin + 2, text_.find_first_of(" \t\r\n?", begin + 2) - begin - 2);
    if (target == "xml" && begin != text_.find_first_not_of(xml_space)) {
      fail(begin, "an XML declaration is only allowed at the beginning of a file; remove it");
    }
    return behind("?>", begin + 2);
  }

  /// The position after a document type, which may contain declarations in brackets.
  std::optional<std::size_t> behind_declaration(std::size_t begin) const {
    int open = 0;
    for (std::size_t i = begin; i < text_.size(); ++i) {
      if (text_[i] == '[') ++open;
      if (text_[i] == ']') --open;
      if (text_[i] == '>' && open <= 0) return i + 1;
    }
    return std::nullopt;
  }

  std::optional<std::size_t> pass_start_tag(std::size_t begin) {
    std::size_t i = std::min(text_.find_first_of(" \t\r\n/>", begin + 1), text_.size());
    if (depth_ == 0 && root_ != std::string_view::npos) {
      fail(begin, fmt::format("element {} is a second root; the first begins in line {}, and a file has only one",
                              in_quotes(text_.substr(begin + 1, i - begin - 1)), position_of(text_, root_).line));
    }
    if (depth_ == 0) root_ = begin;
    attributes_.clear();
    while (true) {
      const std::size_t next = std::min(text_.find_first_not_of(xml_space, i), text_.size());
      if (next == text_.size()) return std::nullopt;
      if (text_[next] == '>') {
        ++depth_;
        return next + 1;
      }
      if (text_[next] == '/') return text_.substr(next).starts_with("/>") ? std::optional(next + 2) : std::nullopt;
      if (next == i) fail(i, "there is no blank between two attributes; insert one");
      const std::optional<std::size_t> end = pass_attribute(next);
      if (!end) return std::nullopt;
      i = *end;
    }
  }

  std::optional<std::size_t> pass_attribute(std::size_t begin) {
    const std::size_t equals = text_.find_first_of("=<>", begin);
    if (equals == std::string_view::npos || text_[equals] != '=') return std::nullopt;
    const std::size_t name_end = std::min(text_.find_first_of(" \t\r\n=", begin), equals);
    const std::string_view name = text_.substr(begin, name_end - begin);
    const std::size_t quote = text_.find_first_not_of(xml_space, equals + 1);
    if (quote == std::string_view::npos || (text_[quote] != '"' && text_[quote] != '\'')) return std::nullopt;
    const std::size_t end = text_.find(text_[quote], quote + 1);
    if (end == std::string_view::npos) return std::nullopt;
    if (std::find(attributes_.begin(), attributes_.end(), name) != attributes_.end()) {
      fail(begin, fmt::format("the attribute {} is given twice; remove one", in_quotes(name)));
    }
    attributes_.push_back(name);
    const std::size_t tag = text_.substr(0, end).find('<', quote);
    if (tag != std::string_view::npos) fail(tag, "an attribute's value contains \"<\"; write &lt; instead");
    check_references(quote + 1, end);
    return end + 1;
  }

  std::string_view text_;
  const std::string& source_;
  std::size_t at_ = 0;
  std::size_t depth_ = 0;
  std::size_t root_ = std::string_view::npos;  ///< Position of the root element, once it has been found.
  std::vector<std::string_view> attributes_;   ///< Of the current tag.
};

}  // namespace

void require_well_formed_xml(std::string_view text, const std::string& source) { XmlCheck(text, source).run(); }

}  // namespace graze::io
