// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <graze/io/json/document.hpp>
#include <graze/io/text/in_quotes.hpp>
#include <graze/io/text/position.hpp>
#include <graze/io/text/utf8.hpp>
#include <graze/math/platform/bit_cast.hpp>

namespace graze::io {
namespace {

/// An iterator that shows how far the parser has read, which nlohmann's events do not report.
class CountingIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountingIterator(const char* at, const char** farthest) : at_(at), farthest_(farthest) {}
  reference operator*() const { return *at_; }
  CountingIterator& operator++() {
    *farthest_ = ++at_;
    return *this;
  }
  friend bool operator!=(const CountingIterator& a, const CountingIterator& b) { return a.at_ != b.at_; }

 private:
  const char* at_;
  const char** farthest_;
};

/// nlohmann's description of a syntax error without its prefix and its last token, whose position our message gives.
std::string reason_of(std::string message, const std::string& last_token) {
  if (const std::size_t dash = message.find(" - "); dash != std::string::npos) message.erase(0, dash + 3);
  const std::string last_read = "; last read: '" + last_token + "'";
  if (const std::size_t begin = message.find(last_read); begin != std::string::npos) {
    message.erase(begin, last_read.size());
  }
  return message;
}

/// True if the text begins with a spelling of NaN or infinity that other programs use.
bool begins_with_non_finite(std::string_view text) {
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  return text.starts_with("NaN") || text.starts_with("nan") || text.starts_with("Inf") || text.starts_with("inf");
}

}  // namespace

std::string_view kind_name(JsonKind kind) {
  switch (kind) {
    case JsonKind::null:
      return "null";
    case JsonKind::boolean:
      return "true or false";
    case JsonKind::whole:
    case JsonKind::number:
      return "a number";
    case JsonKind::text:
      return "a string";
    case JsonKind::array:
      return "an array";
    case JsonKind::object:
      return "an object";
  }
  return "";
}

/// Receives the events of nlohmann's parser, which does not recurse, and appends nodes.
class JsonDocument::Builder {
 public:
  Builder(JsonDocument& document, std::string_view packed_field)
      : document_(document),
        packed_field_(packed_field),
        text_begin_(document.text_.data()),
        seen_(text_begin_),
        last_end_(text_begin_) {}

  void parse() {
    const char* end = text_begin_ + document_.text_.size();
    nlohmann::json::sax_parse(CountingIterator(text_begin_, &seen_), CountingIterator(end, &seen_), this);
  }

  // Called by nlohmann's parser. All return true (continue) or throw.
  bool null() { return scalar(JsonKind::null, 0); }
  bool boolean(bool value) { return scalar(JsonKind::boolean, value ? 1 : 0); }
  bool number_integer(std::int64_t value) {
    // -0 differs from 0 in binary floating point, but nlohmann shows it only in the token's text.
    return real(value == 0 ? -0.0 : static_cast<double>(value));
  }
  bool number_unsigned(std::uint64_t value) {
    if (!is_packing_ || value > std::numeric_limits<std::uint32_t>::max()) return scalar(JsonKind::whole, value);
    document_.packed_.push_back(static_cast<std::uint32_t>(value));
    count_in_array();
    last_end_ = seen_;
    return true;
  }
  bool number_float(double value, const std::string&) { return real(value); }
  bool string(std::string& value) {
    count_in_array();
    return text(value);
  }
  bool key(std::string& value) {
    ++document_.nodes_[open_.back()].size;
    text(value);
    is_packed_field_ = !packed_field_.empty() && value == packed_field_;
    return true;
  }
  bool binary(nlohmann::json::binary_t&) { return false; }  // does not occur in text
  bool start_object(std::size_t) { return open(JsonKind::object); }
  bool start_array(std::size_t) {
    const bool packs = is_packed_field_;
    open(JsonKind::array);
    is_packing_ = packs;
    if (packs) document_.nodes_.back().payload = document_.packed_.size();
    return true;
  }
  bool end_object() {
    refuse_duplicate_keys();
    return close();
  }
  bool end_array() {
    is_packing_ = false;
    return close();
  }

  bool parse_error(std::size_t position, const std::string& last_token, const nlohmann::json::exception& exception) {
    constexpr int out_of_range = 406;
    const std::size_t token = token_offset();
    const std::string_view rest = document_.text_.substr(token);
    if (exception.id == out_of_range) {
      throw document_.error(token, in_quotes(rest.substr(0, rest.find_first_of(" \t\r\n,]}"))) +
                                       " is too large; the largest number is about 1.8e308");
    }
    if (begins_with_non_finite(rest)) {
      throw document_.error(token, "neither JSON nor a scene can hold NaN or infinity; give a finite number");
    }
    if (position > document_.text_.size()) {
      throw document_.error(position, "the JSON text ends here, before it is complete; is the file cut off?");
    }
    throw document_.error(position - 1, "this is not JSON: " + reason_of(exception.what(), last_token));
  }

 private:
  /// The position of the token that was just read: after the previous token, blanks, commas and colons.
  std::size_t token_offset() const {
    const auto last = static_cast<std::size_t>(last_end_ - text_begin_);
    return std::min(document_.text_.find_first_not_of(" \t\r\n,:", last), document_.text_.size());
  }

  /// Stores the elements of the current array as nodes, because one of them cannot be packed.
  void unpack() {
    is_packing_ = false;
    const Node array = document_.nodes_[open_.back()];
    for (std::size_t i = array.payload; i < document_.packed_.size(); ++i) {
      const auto index = static_cast<std::uint32_t>(document_.nodes_.size());
      document_.nodes_.push_back({JsonKind::whole, array.offset, index + 1, 0, document_.packed_[i]});
    }
    document_.packed_.resize(array.payload);
  }

  std::uint32_t append(JsonKind kind, std::uint32_t size, std::uint64_t payload) {
    if (is_packing_) unpack();
    is_packed_field_ = false;
    const auto index = static_cast<std::uint32_t>(document_.nodes_.size());
    document_.nodes_.push_back({kind, static_cast<std::uint32_t>(token_offset()), index + 1, size, payload});
    last_end_ = seen_;
    return index;
  }

  void count_in_array() {
    if (open_.empty()) return;
    Node& container = document_.nodes_[open_.back()];
    if (container.kind == JsonKind::array) ++container.size;
  }

  bool scalar(JsonKind kind, std::uint64_t payload) {
    count_in_array();
    append(kind, 0, payload);
    return true;
  }

  bool real(double value) { return scalar(JsonKind::number, bit_cast<std::uint64_t>(value)); }

  bool text(const std::string& value) {
    append(JsonKind::text, static_cast<std::uint32_t>(value.size()), document_.characters_.size());
    document_.characters_ += value;
    return true;
  }

  bool open(JsonKind kind) {
    count_in_array();
    if (open_.size() == max_depth) {
      throw document_.error(token_offset(),
                            fmt::format("nested deeper than {} levels, the most that is allowed", max_depth));
    }
    open_.push_back(append(kind, 0, 0));
    return true;
  }

  bool close() {
    document_.nodes_[open_.back()].end = static_cast<std::uint32_t>(document_.nodes_.size());
    open_.pop_back();
    last_end_ = seen_;
    return true;
  }

  void refuse_duplicate_keys() {
    keys_.clear();
    const auto end = static_cast<std::uint32_t>(document_.nodes_.size());
    for (std::uint32_t key = open_.back() + 1; key < end; key = document_.nodes_[key + 1].end) {
      keys_.emplace_back(document_.text_of(document_.nodes_[key]), document_.nodes_[key].offset);
    }
    std::sort(keys_.begin(), keys_.end());
    const auto same = [](const auto& a, const auto& b) { return a.first == b.first; };
    const auto twice = std::adjacent_find(keys_.begin(), keys_.end(), same);
    if (twice == keys_.end()) return;
    const TextPosition first = position_of(document_.text_, twice->second);
    throw document_.error((twice + 1)->second,
                          fmt::format("field {} appears twice in one object, first in line {}, column {}",
                                      in_quotes(twice->first), first.line + document_.first_line_ - 1, first.column));
  }

  JsonDocument& document_;
  std::string_view packed_field_;
  bool is_packed_field_ = false;  ///< The last token was the name of the packed field.
  bool is_packing_ = false;       ///< The current array is its value, with no other elements so far.
  const char* text_begin_;
  const char* seen_;      ///< How far the parser has read.
  const char* last_end_;  ///< How far it had read when the previous token ended.
  std::vector<std::uint32_t> open_;
  std::vector<std::pair<std::string_view, std::uint32_t>> keys_;
};

JsonDocument::JsonDocument(std::string_view text, std::string source, std::size_t first_line,
                           std::string_view packed_field)
    : text_(without_byte_order_mark(text)), source_(std::move(source)), first_line_(first_line) {
  if (text_.size() >= std::numeric_limits<std::uint32_t>::max()) {
    throw InputError(source_ + ": larger than 4 GiB, the most that one JSON file may have");
  }
  require_utf8(text_, source_, first_line_);
  Builder(*this, packed_field).parse();
}

InputError JsonDocument::error(std::size_t offset, std::string_view message) const {
  return error_at(text_, source_, offset, message, first_line_);
}

std::string_view JsonDocument::text_of(const Node& node) const {
  return std::string_view(characters_).substr(node.payload, node.size);
}

JsonKind JsonValue::kind() const { return document_->nodes_[index_].kind; }

std::size_t JsonValue::offset() const { return document_->nodes_[index_].offset; }

double JsonValue::number() const {
  const JsonDocument::Node& node = document_->nodes_[index_];
  return node.kind == JsonKind::whole ? static_cast<double>(node.payload) : bit_cast<double>(node.payload);
}

std::uint64_t JsonValue::whole() const { return document_->nodes_[index_].payload; }

bool JsonValue::boolean() const { return document_->nodes_[index_].payload != 0; }

std::string_view JsonValue::text() const { return document_->text_of(document_->nodes_[index_]); }

std::size_t JsonValue::size() const { return document_->nodes_[index_].size; }

JsonItems JsonValue::items() const { return JsonItems(*this); }

std::span<const std::uint32_t> JsonValue::packed() const {
  const JsonDocument::Node& node = document_->nodes_[index_];
  if (node.kind != JsonKind::array || node.end != index_ + 1) return {};
  return std::span(document_->packed_).subspan(node.payload, node.size);
}

JsonFieldRange JsonValue::fields() const { return JsonFieldRange(*this); }

std::optional<JsonValue> JsonValue::find(std::string_view name) const {
  for (const JsonField field : fields()) {
    if (field.name == name) return field.value;
  }
  return std::nullopt;
}

}  // namespace graze::io
