// SPDX-License-Identifier: MIT
// Parsed JSON text with the position of every value. Stricter than most JSON parsers: duplicate keys and too deep
// nesting are errors.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <graze/io/input_error.hpp>

namespace graze::io {

/// `whole` is a number written as an integer from 0 to 2^64 - 1; any other number is `number`.
enum class JsonKind : std::uint8_t { null, boolean, whole, number, text, array, object };

/// "a number", "an array", ...: for messages.
std::string_view kind_name(JsonKind kind);

class JsonDocument;
class JsonItems;
class JsonFieldRange;

/// One value of a document, as cheap as a pointer. Valid as long as the document exists and is not moved.
class JsonValue {
 public:
  JsonKind kind() const;
  bool is_number() const { return kind() == JsonKind::whole || kind() == JsonKind::number; }

  /// The position of its text in the document.
  std::size_t offset() const;

  /// The value of a `whole` or `number`, rounded to double.
  double number() const;
  /// The value of a `whole`.
  std::uint64_t whole() const;
  /// The value of a `boolean`.
  bool boolean() const;
  /// The value of a `text`.
  std::string_view text() const;

  /// The number of elements of an array or fields of an object.
  std::size_t size() const;
  /// The elements of an array, in order.
  JsonItems items() const;
  /// The elements of a packed array, and none of any other; see JsonDocument.
  std::span<const std::uint32_t> packed() const;
  /// The fields of an object, in order.
  JsonFieldRange fields() const;
  /// The value of the field of that name, if there is one.
  std::optional<JsonValue> find(std::string_view name) const;

 private:
  friend class JsonDocument;
  friend class JsonItems;
  friend class JsonFieldRange;
  JsonValue(const JsonDocument& document, std::uint32_t index) : document_(&document), index_(index) {}

  const JsonDocument* document_;
  std::uint32_t index_;
};

/// A field of an object.
struct JsonField {
  std::string_view name;
  std::size_t offset;  ///< Position of the name.
  JsonValue value;
};

/// A parsed text. Refers to the given text, which must outlive this.
class JsonDocument {
 public:
  /// How deeply arrays and objects may be nested.
  static constexpr std::size_t max_depth = 128;

  /// Throws InputError with line and column. A byte order mark is allowed. `source` names the text in messages, and its
  /// first line has the number `first_line`, because each line of newline-delimited JSON is its own document. An array
  /// in a field named `packed_field` that contains only whole numbers below 2^32 is packed: it has a size, but no
  /// `items`.
  JsonDocument(std::string_view text, std::string source, std::size_t first_line = 1,
               std::string_view packed_field = {});
  JsonDocument(const JsonDocument&) = delete;
  JsonDocument& operator=(const JsonDocument&) = delete;
  JsonDocument(JsonDocument&&) = delete;
  JsonDocument& operator=(JsonDocument&&) = delete;
  ~JsonDocument() = default;

  JsonValue root() const { return {*this, 0}; }
  const std::string& source() const { return source_; }

  /// The error "source: line 3, column 7: message".
  InputError error(std::size_t offset, std::string_view message) const;

 private:
  friend class JsonValue;
  friend class JsonItems;
  friend class JsonFieldRange;
  class Builder;

  /// Values are in the order of their text: a container before its content, a field's name (of kind `text`) before its
  /// value. So the first child is the next node, and `end` is the position of the next sibling.
  struct Node {
    JsonKind kind;
    std::uint32_t offset;
    std::uint32_t end;
    std::uint32_t size;     ///< Number of characters, elements or fields.
    std::uint64_t payload;  ///< A whole number, the bits of a number, or the start of a text or packed array.
  };

  std::string_view text_of(const Node& node) const;

  std::string_view text_;
  std::string source_;
  std::vector<Node> nodes_;
  std::string characters_;             ///< All texts, unescaped and concatenated.
  std::vector<std::uint32_t> packed_;  ///< The elements of all packed arrays, concatenated.
  std::size_t first_line_;
};

/// Range of an array's elements.
class JsonItems {
 public:
  class Iterator {
   public:
    Iterator(const JsonDocument& document, std::uint32_t index) : document_(&document), index_(index) {}
    JsonValue operator*() const { return {*document_, index_}; }
    Iterator& operator++() {
      index_ = document_->nodes_[index_].end;
      return *this;
    }
    friend bool operator==(const Iterator&, const Iterator&) = default;

   private:
    const JsonDocument* document_;
    std::uint32_t index_;
  };

  explicit JsonItems(JsonValue array) : array_(array) {}
  Iterator begin() const { return {*array_.document_, array_.index_ + 1}; }
  Iterator end() const { return {*array_.document_, array_.document_->nodes_[array_.index_].end}; }

 private:
  JsonValue array_;
};

/// Range of an object's fields.
class JsonFieldRange {
 public:
  class Iterator {
   public:
    Iterator(const JsonDocument& document, std::uint32_t index) : document_(&document), index_(index) {}
    JsonField operator*() const {
      const JsonDocument::Node& name = document_->nodes_[index_];
      return {document_->text_of(name), name.offset, {*document_, index_ + 1}};
    }
    Iterator& operator++() {
      index_ = document_->nodes_[index_ + 1].end;
      return *this;
    }
    friend bool operator==(const Iterator&, const Iterator&) = default;

   private:
    const JsonDocument* document_;
    std::uint32_t index_;
  };

  explicit JsonFieldRange(JsonValue object) : object_(object) {}
  Iterator begin() const { return {*object_.document_, object_.index_ + 1}; }
  Iterator end() const { return {*object_.document_, object_.document_->nodes_[object_.index_].end}; }

 private:
  JsonValue object_;
};

}  // namespace graze::io
