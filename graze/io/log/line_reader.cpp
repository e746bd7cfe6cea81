// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include <graze/io/json/fields.hpp>
#include <graze/io/json/shape_reader.hpp>
#include <graze/io/log/line_reader.hpp>
#include <graze/io/text/in_quotes.hpp>
#include <graze/io/text/suggestion.hpp>
#include <graze/shape/frustum.hpp>

namespace graze::io {
namespace {

constexpr std::array<std::string_view, 3> event_words = {"began", "stayed", "ended"};

/// The name of the field for each bit of CallFields.
struct FieldNames {
  CallFields field;
  std::array<std::string_view, 5> names;
};
constexpr std::array<FieldNames, 17> field_names = {{
    {field_id, {"id"}},
    {field_ids, {"ids"}},
    {field_vacant_ids, {"vacant_ids"}},
    {field_shape, {"shape"}},
    {field_shapes, {"shapes"}},
    {field_corners, {"corners"}},
    {field_options, {"name", "layer", "mask", "user", "fixed"}},
    {field_name, {"name"}},
    {field_layers, {"layers"}},
    {field_count, {"count"}},
    {field_t_max, {"t_max"}},
    {field_margin, {"margin"}},
    {field_motion, {"motion"}},
    {field_rotation, {"angular", "center"}},
    {field_within, {"within"}},
    {field_except, {"except"}},
    {field_initial_touch, {"ignore_initial_touch"}},
}};

void allow_fields(const JsonFields& line, CallKind kind) {
  std::vector<std::string_view> allowed = {"call"};
  for (const auto& [field, names] : field_names) {
    if (has_field(kind, field)) allowed.insert(allowed.end(), names.begin(), names.end());
  }
  std::erase(allowed, std::string_view());
  line.allow_only(allowed);
}

std::uint64_t read_up_to(std::uint64_t most, JsonValue value, const JsonFieldName& name, const JsonPlace& place) {
  const std::uint64_t number = read_whole(value, name, place);
  if (number <= most) return number;
  throw place.error(value.offset(), fmt::format("\"{}\" has {}; at most {}", name.name, number, most));
}

/// [index, generation], null, or {"other_scene": [index, generation]}.
ObjectId read_id(JsonValue value, std::string_view name, const JsonPlace& place) {
  if (value.kind() == JsonKind::null) return {};
  if (value.kind() == JsonKind::object) {
    const JsonFields fields(value, place, "an id");
    constexpr std::array<std::string_view, 1> only = {"other_scene"};
    fields.allow_only(only);
    ObjectId id = read_id(fields.array("other_scene"), "other_scene", place);
    id.owner = other_scene;
    return id;
  }
  const JsonValue array = read_array(value, {name}, place);
  std::array<std::uint32_t, 2> numbers{};
  std::size_t count = 0;
  for (const JsonValue number : array.items()) {
    const auto read = read_up_to(std::numeric_limits<std::uint32_t>::max(), number, {name, count}, place);
    if (count < numbers.size()) numbers[count] = static_cast<std::uint32_t>(read);
    ++count;
  }
  if (count != 2) throw place.error(value.offset(), fmt::format("\"{}\" has {} numbers; an id has two", name, count));
  return {numbers[0], numbers[1], logged_scene};
}

std::vector<ObjectId> read_ids(const JsonFields& line, std::string_view name) {
  std::vector<ObjectId> ids;
  for (const JsonValue id : line.array(name).items()) ids.push_back(read_id(id, name, line.place()));
  return ids;
}

/// False if it is missing.
bool read_flag(const JsonFields& line, std::string_view name) {
  const auto flag = line.find(name);
  if (!flag) return false;
  if (flag->kind() != JsonKind::boolean) throw line.error(name, "must be true or false");
  return flag->boolean();
}

ObjectOptions read_options(const JsonFields& line) {
  const JsonPlace& place = line.place();
  ObjectOptions options;
  if (const auto name = line.find("name")) options.name = read_text(*name, {"name"}, place);
  if (const auto layer = line.find("layer")) {
    options.layer = static_cast<Layer>(read_up_to(std::numeric_limits<Layer>::max(), *layer, {"layer"}, place));
  }
  if (const auto mask = line.find("mask")) options.mask = read_whole(*mask, {"mask"}, place);
  if (const auto user = line.find("user")) options.user = read_whole(*user, {"user"}, place);
  if (read_flag(line, "fixed")) options.mobility = Mobility::fixed;
  return options;
}

CallKind read_kind(const JsonFields& line) {
  const std::string_view name = read_text(line.require("call"), {"call"}, line.place());
  std::array<std::string_view, call_kinds> known;
  for (std::size_t i = 0; i < call_kinds; ++i) {
    if (call_forms[i].name == name) return static_cast<CallKind>(i);
    known[i] = call_forms[i].name;
  }
  throw line.error("call", "is " + in_quotes(name) + ", which is not known" + did_you_mean(name, known));
}

template <Dim N>
void read_shapes(LoggedCall<N>& call, const JsonFields& line) {
  const JsonPlace& place = line.place();
  if (has_field(call.kind, field_shape)) call.shapes.push_back(read_json_shape<N>(line.require("shape"), place, {}));
  if (has_field(call.kind, field_shapes)) {
    for (const JsonValue shape : line.array("shapes").items()) {
      call.shapes.push_back(read_json_shape<N>(shape, {place.document, nullptr, "shape", call.shapes.size()}, {}));
    }
    if (call.shapes.size() != call.ids.size()) {
      throw line.error("shapes", fmt::format("are {}, but \"ids\" are {}", call.shapes.size(), call.ids.size()));
    }
  }
  if (has_field(call.kind, field_corners)) {
    for (const JsonValue corner : line.array("corners").items()) {
      call.corners.push_back(read_vector<N>(corner, {"corners", call.corners.size()}, place));
    }
    constexpr std::size_t wanted = Frustum<N, double>::corner_count;
    if (call.corners.size() != wanted) {
      throw line.error("corners", fmt::format("are {}; a frustum has {}", call.corners.size(), wanted));
    }
  }
}

template <Dim N>
void read_motion(LoggedCall<N>& call, const JsonFields& line) {
  if (has_field(call.kind, field_motion)) call.motion.linear = line.vector<N>("motion");
  if (!has_field(call.kind, field_rotation)) return;
  if constexpr (N == 2) {
    call.motion.angular = line.number("angular");
  } else {
    call.motion.angular = line.vector<3>("angular");
  }
  call.motion.center = line.vector<N>("center");
}

template <Dim N>
void require_types(const LoggedCall<N>& call, const JsonFields& line) {
  const bool is_ray = call.kind == CallKind::ray_cast || call.kind == CallKind::ray_cast_all;
  if (is_ray && !std::holds_alternative<Ray<N, double>>(call.shapes.front())) {
    throw line.error("shape", "must be a ray");
  }
  const bool is_of_two = call.kind == CallKind::except || call.kind == CallKind::accept;
  if (is_of_two && call.ids.size() != 2) {
    throw line.error("ids", fmt::format("are {}; \"{}\" has two", call.ids.size(), form_of(call.kind).name));
  }
  if (call.kind == CallKind::nearest && !std::holds_alternative<Vec<N, double>>(call.shapes.front())) {
    throw line.error("shape", "must be a point");
  }
}

/// A number, or the text that stands for a non-finite one.
double read_any_number(JsonValue value, const JsonPlace& place) {
  if (value.is_number()) return value.number();
  const std::string_view text = read_text(value, {"answer"}, place);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (text == "inf") return infinity;
  if (text == "-inf") return -infinity;
  if (text == "nan") return std::numeric_limits<double>::quiet_NaN();
  throw place.error(value.offset(), in_quotes(text) + " is not valid in an answer");
}

AnswerRow read_row(JsonValue value, const JsonPlace& place) {
  if (value.kind() != JsonKind::array) {
    if (value.kind() == JsonKind::null || value.kind() == JsonKind::object) {
      return {{}, {read_id(value, "answer", place)}, {}};
    }
    return {{}, {}, {read_any_number(value, place)}};
  }
  if (value.size() > 0 && (*value.items().begin()).kind() == JsonKind::whole) {
    return {{}, {read_id(value, "answer", place)}, {}};
  }
  AnswerRow row;
  for (const JsonValue part : value.items()) {
    if (part.kind() == JsonKind::array || part.kind() == JsonKind::null || part.kind() == JsonKind::object) {
      row.ids.push_back(read_id(part, "answer", place));
      continue;
    }
    const std::string_view text = part.kind() == JsonKind::text ? part.text() : std::string_view();
    const auto* const word = std::find(event_words.begin(), event_words.end(), text);
    if (word != event_words.end()) {
      row.word = *word;
    } else {
      row.numbers.push_back(read_any_number(part, place));
    }
  }
  // Converted back to text, [1e1, 1] would look like an id.
  if (row.word.empty() && row.ids.empty() && row.numbers.size() > 1) {
    throw place.error(value.offset(), "a list of numbers in an answer must begin with an id");
  }
  return row;
}

AnswerDigest read_digest(const JsonFields& line) {
  const std::string_view text = read_text(line.require("digest"), {"digest"}, line.place());
  AnswerDigest digest;
  digest.count = read_whole(line.require("count"), {"count"}, line.place());
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), digest.digest, 16);
  if (text.size() == 16 && error == std::errc() && end == text.data() + text.size()) return digest;
  throw line.error("digest", fmt::format("is {}; it must have 16 hexadecimal digits", in_quotes(text)));
}

void require_object(JsonValue value, const JsonPlace& place) {
  if (value.kind() == JsonKind::object) return;
  throw place.error(value.offset(), fmt::format("a line of a log is a JSON object, not {}", kind_name(value.kind())));
}

}  // namespace

template <Dim N>
LoggedCall<N> read_call(const JsonDocument& document) {
  const JsonPlace place{document};
  require_object(document.root(), place);
  const JsonFields line(document.root(), place, "a call");
  LoggedCall<N> call;
  call.kind = read_kind(line);
  if (const auto fault = line.find("fault")) {
    constexpr std::array<std::string_view, 2> only = {"call", "fault"};
    line.allow_only(only);
    call.fault = read_text(*fault, {"fault"}, place);
    if (call.fault.empty()) throw line.error("fault", "is empty");
    return call;
  }
  allow_fields(line, call.kind);
  const auto has = [&call](CallFields field) { return has_field(call.kind, field); };
  if (has(field_id)) call.ids.push_back(read_id(line.require("id"), "id", place));
  if (has(field_ids)) call.ids = read_ids(line, "ids");
  if (has(field_vacant_ids)) call.vacant_ids = read_ids(line, "vacant_ids");
  if (has(field_name)) call.name = read_text(line.require("name"), {"name"}, place);
  if (has(field_options)) call.options = read_options(line);
  if (has(field_count)) call.count = read_whole(line.require("count"), {"count"}, place);
  if (has(field_margin)) call.margin = line.number("margin");
  if (has(field_within)) call.within = line.number("within");
  if (has(field_except) && line.find("except")) call.except = read_ids(line, "except");
  if (has(field_initial_touch)) call.ignore_initial_touch = read_flag(line, "ignore_initial_touch");
  read_motion(call, line);
  if (const auto t_max = line.find("t_max")) call.t_max = read_number(*t_max, {"t_max"}, place);
  if (const auto layers = line.find("layers")) call.layers = read_whole(*layers, {"layers"}, place);
  read_shapes(call, line);
  require_types(call, line);
  return call;
}

LoggedAnswer read_answer(const JsonDocument& document) {
  constexpr std::array<std::string_view, 4> known = {"answer", "refused", "count", "digest"};
  const JsonPlace place{document};
  require_object(document.root(), place);
  const JsonFields line(document.root(), place, "an answer");
  line.allow_only(known);
  LoggedAnswer answer;
  if (const auto refused = line.find("refused")) {
    answer.refusal = read_text(*refused, {"refused"}, place);
  } else if (line.find("digest")) {
    answer.digest = read_digest(line);
  } else {
    for (const JsonValue row : line.array("answer").items()) answer.rows.push_back(read_row(row, place));
  }
  return answer;
}

template LoggedCall<2> read_call(const JsonDocument&);
template LoggedCall<3> read_call(const JsonDocument&);

}  // namespace graze::io
