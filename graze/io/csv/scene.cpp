// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <graze/io/csv/header.hpp>
#include <graze/io/csv/records.hpp>
#include <graze/io/csv/scene.hpp>
#include <graze/io/text/decimal.hpp>
#include <graze/io/text/in_quotes.hpp>
#include <graze/io/text/utf8.hpp>

namespace graze::io {
namespace {

double read_number(const CsvText& text, const CsvField& field, std::string_view column) {
  const Decimal number = decimal_of(without_blanks(field.text));
  if (!number.fault.empty()) throw text.error(field, fmt::format("{} {}", column, number.fault));
  return number.value;
}

std::string_view name_of(CsvShape shape, Dim dimension) {
  if (shape == CsvShape::box) return "box";
  if (shape == CsvShape::capsule) return "capsule";
  return dimension == 2 ? "circle" : "sphere";
}

/// Reads the lines after the header into a scene.
template <Dim N>
class ShapeReader {
 public:
  ShapeReader(const CsvText& text, const CsvColumns& columns)
      : text_(text), columns_(columns), numbers_(columns.numbers.size()) {}

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
    const CsvField& place = fields[columns_.id.value_or(0)];
    if (columns_.id && place.text.empty()) {
      throw text_.error(place, fmt::format("the id is empty; each {} needs its own", name_of(columns_.shape, N)));
    }
    ObjectOptions options;
    options.name = columns_.id ? std::string(place.text) : fmt::format("#{}", id_offsets_.size());
    if (columns_.layer) options.layer = layer_number(fields[*columns_.layer]);
    for (std::size_t i = 0; i < numbers_.size(); ++i) {
      numbers_[i] = read_number(text_, fields[columns_.numbers[i]], columns_.number_names[i]);
    }
    require_sound(fields);
    try {
      scene_.add(shape(), std::move(options));
    } catch (const std::invalid_argument& refusal) {
      throw refused(place, refusal);
    }
    id_offsets_.push_back(place.offset);
  }

  /// Refuses a box whose min is above its max, and a negative radius.
  void require_sound(const std::vector<CsvField>& fields) const {
    constexpr auto dimension = static_cast<std::size_t>(N);
    const std::vector<std::string>& names = columns_.number_names;
    const auto field = [&](std::size_t i) -> const CsvField& { return fields[columns_.numbers[i]]; };
    for (std::size_t i = 0; columns_.shape == CsvShape::box && i < dimension; ++i) {
      const double min = numbers_[i];
      const double max = numbers_[dimension + i];
      if (min <= max) continue;
      throw text_.error(field(i), fmt::format("{} is above {}: {} > {}", names[i], names[dimension + i], min, max));
    }
    if (columns_.shape == CsvShape::box || numbers_.back() >= 0) return;
    throw text_.error(field(numbers_.size() - 1),
                      fmt::format("the radius is {}; it must be 0 or more", numbers_.back()));
  }

  Vec<N, double> point(std::size_t number) const {
    Vec<N, double> result;
    for (Dim i = 0; i < N; ++i)
      result[i] = numbers_[number * static_cast<std::size_t>(N) + static_cast<std::size_t>(i)];
    return result;
  }

  AnyShape<N, double> shape() const {
    if (columns_.shape == CsvShape::box) return Aabb<N, double>{point(0), point(1)};
    if (columns_.shape == CsvShape::capsule) return Capsule<N, double>{point(0), point(1), numbers_.back()};
    return Sphere<N, double>{point(0), numbers_.back()};
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

  /// Translates the scene's error into the terms of this file. Of two equal ids only the first can be in the scene, at
  /// the index of its line.
  InputError refused(const CsvField& id, const std::invalid_argument& refusal) const {
    const auto other = scene_.find(id.text);
    if (!other) return text_.error(id, refusal.what());
    const TextPosition first = position_of(text_.text, id_offsets_[other->index]);
    return text_.error(id, fmt::format("the id {} is taken by the {} in line {}; ids must be unique",
                                       in_quotes(id.text), name_of(columns_.shape, N), first.line));
  }

  const CsvText& text_;
  const CsvColumns& columns_;
  std::vector<double> numbers_;  // of the current line
  Scene<N, double> scene_;
  std::vector<std::size_t> id_offsets_;
};

/// Text whose lines all end with CR, as old programs write them, with LF instead; offsets do not change.
std::string with_line_feeds(std::string_view text) {
  std::string result(text);
  if (text.find('\n') == std::string_view::npos) std::replace(result.begin(), result.end(), '\r', '\n');
  return result;
}

/// Warns if the last line may be cut off: a truncated number is still a number.
std::vector<std::string> warnings_about_end(const CsvText& csv) {
  if (csv.text.empty() || csv.text.back() == '\n' || csv.text.back() == '\r') return {};
  return {
      fmt::format("{}: line {}, the last one, has no line break; if the file was cut off, its last field is incomplete",
                  csv.source, position_of(csv.text, csv.text.size()).line)};
}

}  // namespace

SceneFile parse_csv_scene(std::string_view text, const std::string& source) {
  require_utf8(text, source);
  const std::string lines = with_line_feeds(without_byte_order_mark(text));
  const CsvText csv{lines, source};
  CsvRecords records(csv.text, csv.source, csv_separator(csv.text));
  if (!records.next()) throw InputError(source + ": empty; CSV begins with a line like id,min_x,min_y,max_x,max_y");
  const CsvColumns columns = read_csv_header(csv, records.fields());
  const auto shapes = [&]() -> AnyScene {
    if (columns.dimension == 2) return ShapeReader<2>(csv, columns).read(records);
    return ShapeReader<3>(csv, columns).read(records);
  };
  SceneFile file{shapes(), source, "csv", YAxis::up, columns.not_read};
  file.warnings = warnings_about_end(csv);
  return file;
}

}  // namespace graze::io
