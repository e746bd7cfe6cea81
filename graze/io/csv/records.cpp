// SPDX-License-Identifier: MIT
#include <algorithm>

#include <fmt/format.h>

#include <graze/io/csv/records.hpp>
#include <graze/io/text/position.hpp>

namespace graze::io {
namespace {

std::size_t line_break_length(std::string_view text, std::size_t at) {
  if (text.substr(at).starts_with("\r\n")) return 2;
  return at < text.size() && text[at] == '\n' ? 1 : 0;
}

}  // namespace

char csv_separator(std::string_view text) {
  bool is_quoted = false;
  for (const char character : text.substr(std::min(text.find_first_not_of(" \t\r\n"), text.size()))) {
    if (character == '"') is_quoted = !is_quoted;
    if (is_quoted) continue;
    if (character == ',' || character == ';' || character == '\t') return character;
    if (character == '\n' || character == '\r') break;
  }
  return ',';
}

std::string_view without_blanks(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

void CsvRecords::skip_blank_lines() {
  while (at_ < text_.size()) {
    const std::size_t blank = std::min(text_.find_first_not_of(" \t", at_), text_.size());
    const std::size_t length = line_break_length(text_, blank);
    if (length == 0 && blank < text_.size()) return;
    at_ = blank + length;
  }
}

bool CsvRecords::next() {
  fields_.clear();
  unescaped_.clear();
  skip_blank_lines();
  if (at_ == text_.size()) return false;
  while (true) {
    if (at_ < text_.size() && text_[at_] == '"') {
      read_quoted_field();
    } else {
      read_field();
    }
    if (at_ < text_.size() && text_[at_] == separator_) {
      ++at_;
      continue;
    }
    at_ += line_break_length(text_, at_);
    return true;
  }
}

void CsvRecords::read_field() {
  const std::size_t begin = at_;
  while (at_ < text_.size() && text_[at_] != separator_ && text_[at_] != '\n') {
    if (text_[at_] == '"') {
      throw error_at(text_, source_, at_,
                     "a quote inside a field; put the whole field in quotes and write each quote in it twice");
    }
    ++at_;
  }
  const bool ends_line = at_ == text_.size() || text_[at_] == '\n';
  if (ends_line && at_ > begin && text_[at_ - 1] == '\r') {
    fields_.push_back({text_.substr(begin, at_ - 1 - begin), begin});
  } else {
    fields_.push_back({text_.substr(begin, at_ - begin), begin});
  }
}

void CsvRecords::read_quoted_field() {
  const std::size_t begin = at_;
  std::string* unescaped = nullptr;
  std::size_t run = begin + 1;  // start of the characters not yet copied to `unescaped`
  while (true) {
    const std::size_t quote = text_.find('"', run);
    if (quote == std::string_view::npos) throw error_at(text_, source_, begin, "this quote is never closed");
    at_ = quote + 1;
    const bool is_doubled = at_ < text_.size() && text_[at_] == '"';
    if (!is_doubled && unescaped == nullptr) {
      fields_.push_back({text_.substr(run, quote - run), begin});
      break;
    }
    if (unescaped == nullptr) unescaped = &unescaped_.emplace_back();
    unescaped->append(text_.substr(run, quote - run + (is_doubled ? 1 : 0)));
    run = at_ + 1;
    if (is_doubled) continue;
    fields_.push_back({*unescaped, begin});
    break;
  }
  if (at_ < text_.size() && text_[at_] != separator_ && line_break_length(text_, at_) == 0) {
    throw error_at(text_, source_, at_,
                   fmt::format("text after a closing quote; only a {} or the end of the line may follow",
                               separator_ == ','   ? "comma"
                               : separator_ == ';' ? "semicolon"
                                                   : "tab"));
  }
}

}  // namespace graze::io
