// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include <graze/io/csv_boxes.hpp>
#include <graze/io/csv_records.hpp>
#include <graze/io/in_quotes.hpp>
#include <graze/io/suggestion.hpp>
#include <graze/io/text_position.hpp>
#include <graze/io/utf8.hpp>

namespace graze::io {
namespace {

constexpr std::array<std::string_view, 3> min_names = {"min_x", "min_y", "min_z"};
constexpr std::array<std::string_view, 3> max_names = {"max_x", "max_y", "max_z"};

struct CsvText {
  std::string_view text;
  std::string_view source;

  InputError error(const CsvField& field, std::string_view message) const {
    return error_at(text, source, field.offset, message);
  }
};

std::string_view without_blanks(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

/// Which column holds what.
struct Columns {
  std::size_t count = 0;
  std::size_t id = 0;
  std::array<std::size_t, 3> min{};
  std::array<std::size_t, 3> max{};
  std::optional<std::size_t> layer;
  Dim dimension = 2;
  std::vector<Omission> not_read;
};

/// Reads the header line.
class HeaderReader {
 public:
  HeaderReader(const CsvText& text, const std::vector<CsvField>& fields) : text_(text), fields_(fields) {
    for (const CsvField& field : fields) names_.push_back(without_blanks(field.text));
    refuse_duplicates();
  }

  Columns read() {
    Columns columns;
    columns.count = names_.size();
    columns.id = require("id");
    columns.dimension = find("min_z") || find("max_z") ? 3 : 2;
    for (std::size_t i = 0; i < static_cast<std::size_t>(columns.dimension); ++i) {
      columns.min[i] = require(min_names[i]);
      columns.max[i] = require(max_names[i]);
    }
    columns.layer = find("layer");
    for (const std::string_view name : names_) {
      const bool used = std::find(used_.begin(), used_.end(), name) != used_.end();
      if (!used) columns.not_read.push_back({"column " + in_quotes(name), 1});
    }
    return columns;
  }

 private:
  void refuse_duplicates() const {
    std::vector<std::size_t> order(names_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [this](std::size_t a, std::size_t b) { return names_[a] < names_[b]; });
    const auto twice = std::adjacent_find(order.begin(), order.end(),
                                          [this](std::size_t a, std::size_t b) { return names_[a] == names_[b]; });
    if (twice == order.end()) return;
    const std::size_t second = *(twice + 1);
    throw text_.error(fields_[second], fmt::format("column {} appears twice, as number {} and {}",
                                                   in_quotes(names_[second]), *twice + 1, second + 1));
  }

  std::optional<std::size_t> find(std::string_view name) {
    const auto found = std::find(names_.begin(), names_.end(), name);
    if (found == names_.end()) return std::nullopt;
    used_.push_back(name);
    return static_cast<std::size_t>(found - names_.begin());
  }

  std::size_t require(std::string_view name) {
    if (const auto index = find(name)) return *index;
    std::string message = fmt::format("there is no column {}; ", in_quotes(name));
    if (const auto nearest = nearest_name(name, unknown_names())) {
      message += fmt::format("is it the one called {}?", in_quotes(*nearest));
    } else {
      message += "boxes need id, min_x, min_y, max_x, max_y, in 3D also min_z, max_z";
    }
    throw text_.error(fields_.front(), message);
  }

  /// The columns that could be misspelt: not those whose names mean something already.
  std::vector<std::string_view> unknown_names() const {
    std::vector<std::string_view> unknown;
    for (const std::string_view name : names_) {
      const auto is_in = [name](std::span<const std::string_view> list) {
        return std::find(list.begin(), list.end(), name) != list.end();
      };
      if (!is_in(min_names) && !is_in(max_names) && name != "id" && name != "layer") unknown.push_back(name);
    }
    return unknown;
  }

  const CsvText& text_;
  const std::vector<CsvField>& fields_;
  std::vector<std::string_view> names_;
  std::vector<std::string_view> used_;
};

double read_number(const CsvText& text, const CsvField& field, std::string_view column) {
  const std::string_view digits = without_blanks(field.text);
  double value = 0;
  const auto [end, status] = fast_float::from_chars(digits.data(), digits.data() + digits.size(), value);
  const bool is_complete = end == digits.data() + digits.size() && !digits.empty();
  if (is_complete && status == std::errc() && std::isfinite(value)) return value;
  const bool is_infinite =
      is_complete && std::isinf(value) && digits.find_first_of("0123456789") != std::string_view::npos;
  if (is_infinite) {
    throw text.error(field, fmt::format("{} is {}, beyond the largest number there is, about 1.8e308", column,
                                        in_quotes(field.text)));
  }
  if (is_complete && !std::isfinite(value)) {
    throw text.error(field, fmt::format("{} is {}; it must be a finite number", column, in_quotes(field.text)));
  }
  throw text.error(field, fmt::format("{} is {}, which is not a number", column, in_quotes(field.text)));
}

/// Reads the lines behind the header into a scene.
template <Dim N>
class BoxReader {
 public:
  BoxReader(const CsvText& text, const Columns& columns) : text_(text), columns_(columns) {}

  Scene<N, double> read(CsvRecords& records) {
    while (records.next()) add(records.fields());
    return std::move(scene_);
  }

 private:
  void add(const std::vector<CsvField>& fields) {
    if (fields.size() != columns_.count) {
      throw text_.error(fields.front(), fmt::format("this line has {} field{}, the header has {}", fields.size(),
                                                    fields.size() == 1 ? "" : "s", columns_.count));
    }
    const CsvField& id = fields[columns_.id];
    if (id.text.empty()) throw text_.error(id, "the id is empty; each box needs its own");
    ObjectOptions options;
    options.name = id.text;
    if (columns_.layer) options.layer = layer_number(fields[*columns_.layer]);
    const Aabb<N, double> box = read_box(fields);
    try {
      scene_.add(box, std::move(options));
    } catch (const std::invalid_argument& refusal) {
      throw refused(id, refusal);
    }
    id_offsets_.push_back(id.offset);
  }

  Aabb<N, double> read_box(const std::vector<CsvField>& fields) const {
    Aabb<N, double> box;
    for (Dim i = 0; i < N; ++i) {
      const auto axis = static_cast<std::size_t>(i);
      const CsvField& min = fields[columns_.min[axis]];
      const CsvField& max = fields[columns_.max[axis]];
      box.min[i] = read_number(text_, min, min_names[axis]);
      box.max[i] = read_number(text_, max, max_names[axis]);
      if (box.min[i] <= box.max[i]) continue;
      throw text_.error(
          min, fmt::format("{} is above {}: {} > {}", min_names[axis], max_names[axis], box.min[i], box.max[i]));
    }
    return box;
  }

  Layer layer_number(const CsvField& field) {
    const std::string_view name = field.text.empty() ? std::string_view("default") : field.text;
    try {
      return scene_.layer(name);
    } catch (const std::length_error&) {
      throw text_.error(
          field, fmt::format("the layer {} is one too many; a scene has at most {}", in_quotes(name), max_layers));
    }
  }

  /// The scene's refusal in this file's words. Only the first of two equal ids can be in the scene, at the index of its
  /// line.
  InputError refused(const CsvField& id, const std::invalid_argument& refusal) const {
    const auto other = scene_.find(id.text);
    if (!other) return text_.error(id, refusal.what());
    const TextPosition first = position_of(text_.text, id_offsets_[other->index]);
    return text_.error(id, fmt::format("the id {} is taken by the box in line {}; ids must be unique",
                                       in_quotes(id.text), first.line));
  }

  const CsvText& text_;
  const Columns& columns_;
  Scene<N, double> scene_;
  std::vector<std::size_t> id_offsets_;
};

}  // namespace

SceneFile parse_csv_boxes(std::string_view text, const std::string& source) {
  const CsvText csv{without_byte_order_mark(text), source};
  require_utf8(csv.text, source);
  CsvRecords records(csv.text, csv.source);
  if (!records.next()) throw InputError(source + ": empty; CSV begins with a line like id,min_x,min_y,max_x,max_y");
  const Columns columns = HeaderReader(csv, records.fields()).read();
  const auto boxes = [&]() -> AnyScene {
    if (columns.dimension == 2) return BoxReader<2>(csv, columns).read(records);
    return BoxReader<3>(csv, columns).read(records);
  };
  return {boxes(), source, "csv", YAxis::up, columns.not_read};
}

}  // namespace graze::io
