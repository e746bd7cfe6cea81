// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include <graze/io/input_error.hpp>
#include <graze/io/json/document.hpp>
#include <graze/io/json/fields.hpp>
#include <graze/io/log/line_reader.hpp>
#include <graze/io/log/query_log.hpp>
#include <graze/io/shape_numbers.hpp>
#include <graze/io/text/in_quotes.hpp>
#include <graze/io/text/utf8.hpp>

namespace graze::io {
namespace {

/// Iterates over the non-empty lines of a text.
class Lines {
 public:
  explicit Lines(std::string_view text) : rest_(text) {}

  /// Moves to the next line; false after the last one.
  bool next() {
    do {
      if (rest_.empty()) return false;
      const std::size_t end = rest_.find('\n');
      line_ = rest_.substr(0, end);
      rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
      ++number_;
    } while (line_.find_first_not_of(" \t\r") == std::string_view::npos);
    return true;
  }

  std::string_view line() const { return line_; }
  std::size_t number() const { return number_; }

 private:
  std::string_view rest_;
  std::string_view line_;
  std::size_t number_ = 0;
};

struct LogHead {
  Dim dimension = 2;
  NumberType numbers = NumberType::double_precision;
};

void require_log_schema(const JsonFields& head) {
  const auto value = head.find("schema");
  if (!value) {
    throw head.place().error(head.offset(), fmt::format("there is no \"schema\"; a graze log begins with {}",
                                                        log_head(2, NumberType::double_precision)));
  }
  const std::string_view schema = read_text(*value, {"schema"}, head.place());
  if (schema == query_log_schema) return;
  const bool is_log = schema.starts_with(query_log_schema.substr(0, query_log_schema.find('/') + 1));
  throw head.error("schema",
                   fmt::format("is {}{}; this version reads \"{}\"", in_quotes(schema),
                               is_log ? ", another version" : ", which is not a query log", query_log_schema));
}

LogHead read_head(const JsonDocument& document) {
  constexpr std::array<std::string_view, 3> known = {"schema", "dimension", "numbers"};
  const JsonPlace place{document};
  if (document.root().kind() != JsonKind::object) {
    throw place.error(document.root().offset(), "a log begins with a JSON object");
  }
  const JsonFields head(document.root(), place, "the header of a log");
  require_log_schema(head);
  head.allow_only(known);
  const double dimension = head.number("dimension");
  if (dimension != 2 && dimension != 3) {
    throw head.error("dimension", fmt::format("is {}; it must be 2 or 3", dimension));
  }
  const std::string_view numbers = read_text(head.require("numbers"), {"numbers"}, place);
  for (const NumberType each : {NumberType::single_precision, NumberType::double_precision}) {
    if (name_of(each) == numbers) return {dimension == 2 ? 2 : 3, each};
  }
  throw head.error("numbers", fmt::format("is {}; it must be \"float\" or \"double\"", in_quotes(numbers)));
}

/// Whether all numbers of the shape are within the range of float.
template <Dim N>
bool fits_float(const AnyShape<N, double>& shape) {
  bool fits = true;
  const auto look = [&fits](double number) {
    fits = fits && std::fabs(number) <= static_cast<double>(std::numeric_limits<float>::max());
    return number;
  };
  const ShapeNumbers<double, decltype(look)> numbers(look);
  numbers(shape);
  return fits;
}

/// Reads the lines after the header.
template <Dim N>
class LogReader {
 public:
  LogReader(Lines& lines, const std::string& source, NumberType numbers) : lines_(lines), source_(source) {
    log_.numbers = numbers;
  }

  QueryLog<N> read() {
    while (lines_.next()) {
      const JsonDocument document(lines_.line(), source_, lines_.number());
      const JsonValue root = document.root();
      const bool is_answer = root.kind() == JsonKind::object && !root.find("call");
      is_answer ? take_answer(document) : take_call(document);
    }
    if (is_open_) require_known_ids(log_.entries.back());
    return std::move(log_);
  }

 private:
  InputError error(std::size_t line, const std::string& message) const {
    return InputError(fmt::format("{}: line {}: {}", source_, line, message));
  }

  void take_call(const JsonDocument& document) {
    LoggedCall<N> call = read_call<N>(document);
    if (is_open_) {
      throw error(lines_.number(), fmt::format("the call in line {} has no answer; only the last call may lack one",
                                               log_.entries.back().line));
    }
    for (const AnyShape<N, double>& shape : call.shapes) {
      if (log_.numbers == NumberType::single_precision && !fits_float<N>(shape)) {
        throw error(lines_.number(), "a shape has a number that float cannot hold, at most 3.4e38");
      }
    }
    log_.entries.push_back({std::move(call), std::nullopt, lines_.number()});
    is_open_ = true;
  }

  void take_answer(const JsonDocument& document) {
    LoggedAnswer answer = read_answer(document);
    if (!is_open_) throw error(lines_.number(), "this answer has no call; each answer must follow its call");
    is_open_ = false;
    LogEntry<N>& entry = log_.entries.back();
    if (!answer.refusal) {
      require_known_ids(entry);
      if (entry.call.kind == CallKind::add) note_new_id(answer);
    }
    entry.answer = std::move(answer);
  }

  void require_known_ids(const LogEntry<N>& entry) const {
    if (entry.call.kind == CallKind::plan_ids) return;
    for (const ObjectId& id : entry.call.ids) {
      if (given_.contains(id)) continue;
      throw error(entry.line, fmt::format("no earlier line returned the id {}, so this call cannot have been "
                                          "answered",
                                          id_text(id)));
    }
  }

  void note_new_id(const LoggedAnswer& answer) {
    const bool is_id = answer.rows.size() == 1 && answer.rows.front().ids.size() == 1;
    if (!is_id) throw error(lines_.number(), "the answer to \"add\" must be one id: {\"answer\": [[0, 1]]}");
    given_.insert(answer.rows.front().ids.front());
  }

  Lines& lines_;
  const std::string& source_;
  QueryLog<N> log_;
  std::set<ObjectId> given_;
  bool is_open_ = false;  // the last call has no answer yet
};

/// Whether a text whose first line is not a complete JSON object begins like a scene.
bool is_scene_of_many_lines(std::string_view text, std::string_view first_line) {
  constexpr std::string_view sign = "\"graze.scene/";
  constexpr std::size_t enough = 200;
  const bool is_scene = text.substr(0, enough).find(sign) != std::string_view::npos;
  return is_scene && first_line.find(sign) == std::string_view::npos;
}

}  // namespace

AnyQueryLog parse_query_log(std::string_view text, const std::string& source) {
  require_utf8(text, source);
  Lines lines(without_byte_order_mark(text));
  if (!lines.next()) throw InputError(source + ": this is empty; a log has at least a header");
  if (is_scene_of_many_lines(text, lines.line())) {
    throw InputError(source + ": this is a scene, not a query log; graze simulate --log records one");
  }
  const LogHead head = read_head(JsonDocument(lines.line(), source, lines.number()));
  if (head.dimension == 2) return LogReader<2>(lines, source, head.numbers).read();
  return LogReader<3>(lines, source, head.numbers).read();
}

}  // namespace graze::io
