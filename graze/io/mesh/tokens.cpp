// SPDX-License-Identifier: MIT
#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include <graze/io/mesh/tokens.hpp>
#include <graze/io/text/decimal.hpp>
#include <graze/io/text/in_quotes.hpp>
#include <graze/io/text/position.hpp>

namespace graze::io {
namespace {

bool is_blank(char character) {
  return character == ' ' || character == '\t' || character == '\v' || character == '\f';
}

bool is_line_end(char character) { return character == '\n' || character == '\r'; }

}  // namespace

std::size_t MeshTokens::line_end() const { return std::min(text_.find_first_of("\r\n", at_), text_.size()); }

std::size_t MeshTokens::continuation() const {
  if (syntax_ != MeshSyntax::obj || at_ + 1 >= text_.size() || text_[at_] != '\\' || !is_line_end(text_[at_ + 1])) {
    return 0;
  }
  return text_.substr(at_ + 1).starts_with("\r\n") ? 3 : 2;
}

void MeshTokens::skip_blanks() {
  for (;;) {
    while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
    if (continuation() == 0) break;
    at_ += continuation();
  }
  if (syntax_ != MeshSyntax::plain && at_ < text_.size() && text_[at_] == '#') at_ = line_end();
}

MeshToken MeshTokens::next_in_line() {
  skip_blanks();
  const std::size_t begin = at_;
  while (at_ < text_.size() && !is_blank(text_[at_]) && !is_line_end(text_[at_]) && continuation() == 0) ++at_;
  return {text_.substr(begin, at_ - begin), begin};
}

MeshToken MeshTokens::next() {
  MeshToken token = next_in_line();
  while (token.text.empty() && next_line()) token = next_in_line();
  return token;
}

bool MeshTokens::next_line() {
  if (syntax_ == MeshSyntax::obj) {  // word by word, because the line may be continued
    while (!next_in_line().text.empty()) continue;
  }
  at_ = line_end();
  if (at_ == text_.size()) return false;
  at_ += text_.substr(at_).starts_with("\r\n") ? 2 : 1;
  return at_ < text_.size();
}

std::string_view MeshTokens::rest_of_line() {
  while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
  const std::size_t begin = at_;
  at_ = line_end();
  std::string_view rest = text_.substr(begin, at_ - begin);
  while (!rest.empty() && is_blank(rest.back())) rest.remove_suffix(1);
  return rest;
}

InputError MeshTokens::error(std::size_t offset, std::string_view message) const {
  return error_at(text_, source_, offset, message);
}

double MeshTokens::number(const MeshToken& token, std::string_view name) const {
  if (token.text.empty()) throw error(token.offset, fmt::format("{} is missing; a number must follow here", name));
  const Decimal number = decimal_of(token.text);
  if (!number.fault.empty()) throw error(token.offset, fmt::format("{} {}", name, number.fault));
  return number.value;
}

std::int64_t MeshTokens::whole(const MeshToken& token, std::string_view name) const {
  if (token.text.empty())
    throw error(token.offset, fmt::format("{} is missing; a whole number must follow here", name));
  std::string_view digits = token.text;
  if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-') digits.remove_prefix(1);
  std::int64_t value = 0;
  const auto [end, status] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (status == std::errc() && end == digits.data() + digits.size()) return value;
  throw error(token.offset, fmt::format("{} is {}, which is not a whole number{}", name, in_quotes(token.text),
                                        status == std::errc::result_out_of_range ? " below 2^63" : ""));
}

}  // namespace graze::io
