// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include <graze/io/json/shape_writer.hpp>
#include <graze/io/log/logged_answer.hpp>
#include <graze/io/log/logged_call.hpp>
#include <graze/io/output_error.hpp>
#include <graze/io/text/in_quotes.hpp>
#include <graze/io/text/quoting.hpp>
#include <graze/io/text/utf8.hpp>

namespace graze::io {
namespace {

/// Writes the fields of one call in order.
class CallWriter {
 public:
  explicit CallWriter(std::string_view name) : text_(fmt::format("{{\"call\": \"{}\"", name)) {}

  void field(std::string_view name, std::string_view value) {
    fmt::format_to(std::back_inserter(text_), ", \"{}\": {}", name, value);
  }

  void text_field(std::string_view name, const std::string& value) {
    if (find_invalid_utf8(value) != std::string_view::npos) {
      throw OutputError(fmt::format("the {} {} is not UTF-8 text, so a log cannot hold it", name, in_quotes(value)));
    }
    field(name, json_string(value));
  }

  template <class Values, class Write>
  void list(std::string_view name, const Values& values, const Write& write) {
    std::string list;
    for (const auto& value : values) list += (list.empty() ? "" : ", ") + write(value);
    field(name, '[' + list + ']');
  }

  void options(const ObjectOptions& options) {
    if (!options.name.empty()) text_field("name", options.name);
    if (options.layer != 0) field("layer", fmt::format("{}", options.layer));
    if (options.mask != all_layers) field("mask", fmt::format("{}", options.mask));
    if (options.user != 0) field("user", fmt::format("{}", options.user));
    if (options.mobility == Mobility::fixed) field("fixed", "true");
  }

  std::string finished() const { return text_ + '}'; }

 private:
  std::string text_;
};

template <Dim N>
std::string shape_text(const AnyShape<N, double>& shape) {
  std::string text = "{";
  append_json_shape<N>(text, shape);
  return text + '}';
}

template <Dim N>
std::string vector_text(const Vec<N, double>& vector) {
  std::string text = "[";
  for (Dim i = 0; i < N; ++i) text += (i > 0 ? ", " : "") + number_text(vector[i]);
  return text + ']';
}

std::string turn_text(double turn) { return number_text(turn); }
std::string turn_text(const Vec<3, double>& turn) { return vector_text<3>(turn); }

}  // namespace

template <Dim N>
std::string call_line(const LoggedCall<N>& call) {
  CallWriter writer(form_of(call.kind).name);
  if (!call.fault.empty()) {
    writer.field("fault", json_string(call.fault));
    return writer.finished();
  }
  const auto has = [&call](CallFields field) { return has_field(call.kind, field); };
  if (has(field_id)) writer.field("id", id_text(call.ids.front()));
  if (has(field_ids)) writer.list("ids", call.ids, id_text);
  if (has(field_vacant_ids)) writer.list("vacant_ids", call.vacant_ids, id_text);
  if (has(field_name)) writer.text_field("name", call.name);
  if (has(field_options)) writer.options(call.options);
  if (has(field_shape)) writer.field("shape", shape_text<N>(call.shapes.front()));
  if (has(field_shapes)) writer.list("shapes", call.shapes, shape_text<N>);
  if (has(field_corners)) writer.list("corners", call.corners, vector_text<N>);
  if (has(field_count)) writer.field("count", fmt::format("{}", call.count));
  if (has(field_t_max) && std::isfinite(call.t_max)) writer.field("t_max", number_text(call.t_max));
  if (has(field_margin)) writer.field("margin", number_text(call.margin));
  if (has(field_motion)) writer.field("motion", vector_text<N>(call.motion.linear));
  if (has(field_rotation)) {
    writer.field("angular", turn_text(call.motion.angular));
    writer.field("center", vector_text<N>(call.motion.center));
  }
  if (has(field_within)) writer.field("within", number_text(call.within));
  if (has(field_layers) && call.layers != all_layers) writer.field("layers", fmt::format("{}", call.layers));
  if (has(field_except) && !call.except.empty()) writer.list("except", call.except, id_text);
  if (has(field_initial_touch) && call.ignore_initial_touch) writer.field("ignore_initial_touch", "true");
  return writer.finished();
}

template std::string call_line(const LoggedCall<2>&);
template std::string call_line(const LoggedCall<3>&);

}  // namespace graze::io
