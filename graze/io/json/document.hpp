// SPDX-License-Identifier: MIT
// JSON text, parsed, with the place of every value. Stricter than JSON parsers are by default: a key that appears twice
// is an error, and so is nesting beyond a limit.
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

/// `whole` is a number written as an integer from 0 to 2^64 - 1; any other is `number`.
enum class JsonKind : std::uint8_t { null, boolean, whole, number, text, array, object };

/// "a number", "an array", ...: for messages.
std::string_view kind_name(JsonKind kind);

class JsonDocument;
class JsonItems;
class JsonFieldRange;

/// One value of a document, as light as a pointer; valid while the document lives where it is.
class JsonValue {
 public:
  JsonKind kind() const;
  bool is_number() const { return kind() == JsonKind::whole || kind() == JsonKind::number; }

  /// Where its text begins in the document.
  std::size_t offset() const;

  /// The value of a `whole` or `number`, rounded to double.
  double number() const;
  /// The value of a `whole`.
  std::uint64_t whole() const;
  /// The value of a `boolean`.
  bool boolean() const;
  /// The value of a `text`.
  std::string_view text() const;

  /// The number of an array's elements or of an object's fields.
  std::size_t size() const;
  /// An array's elements, in order.
  JsonItems items() const;
  /// The elements of a packed array, none of any other: see JsonDocument.
  std::span<const std::uint32_t> packed() const;
  /// An object's fields, in order.
  JsonFieldRange fields() const;
  /// The value of an object's field, if there is one of that name.
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
  std::size_t offset;  ///< Where the name stands.
  JsonValue value;
};

/// A parsed text. Refers to the text given, which must outlive it.
class JsonDocument {
 public:
  /// How many arrays and objects may be open inside each other.
  static constexpr std::size_t max_depth = 128;

  /// Throws InputError with line and column. A byte order mark is allowed. `source` names the text in messages, and its
  /// first line has the number `first_line`: of newline-delimited JSON, each line is a document. An array in a field
  /// named `packed_field` that holds nothing but whole numbers below 2^32 is packed: it has a size, but no `items`.
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

  /// Values stand in the order of their text, a container before what it holds, a field's name (of kind `text`) before
  /// its value; so the first child is the next node, and `end` is where the next sibling stands.
  struct Node {
    JsonKind kind;
    std::uint32_t offset;
    std::uint32_t end;
    std::uint32_t size;     ///< Characters of a text, elements, fields.
    std::uint64_t payload;  ///< A whole number, the bits of a number, where a text or a packed array begins.
  };

  std::string_view text_of(const Node& node) const;

  std::string_view text_;
  std::string source_;
  std::vector<Node> nodes_;
  std::string characters_;             ///< All texts, unescaped, one behind the other.
  std::vector<std::uint32_t> packed_;  ///< The elements of packed arrays, one behind the other.
  std::size_t first_line_;
};

/// An array's elements, for a range-based for.
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

/// An object's fields, for a range-based for.
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
