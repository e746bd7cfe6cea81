// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include <graze/io/csv/header.hpp>
#include <graze/io/text/in_quotes.hpp>
#include <graze/io/text/suggestion.hpp>

namespace graze::io {
namespace {

constexpr std::string_view column_axes = "xyz";

/// The columns of a kind of shape: a prefix for each of its points, combined with the axis names, then the radius if it
/// has one.
struct Naming {
  CsvShape shape;
  std::array<std::string_view, 2> prefixes;
  std::size_t points;
  bool has_radius;

  std::vector<std::string> names(Dim dimension) const {
    std::vector<std::string> result;
    for (std::size_t point = 0; point < points; ++point) {
      for (Dim i = 0; i < dimension; ++i) {
        result.push_back(std::string(prefixes[point]) + column_axes[static_cast<std::size_t>(i)]);
      }
    }
    if (has_radius) result.emplace_back("radius");
    return result;
  }
};

constexpr std::array<Naming, 3> namings = {{{CsvShape::box, {"min_", "max_"}, 2, false},
                                            {CsvShape::capsule, {"a", "b"}, 2, true},
                                            {CsvShape::sphere, {"", ""}, 1, true}}};

constexpr std::string_view all_columns =
    "boxes need min_x, min_y, max_x, max_y; circles x, y, radius; capsules ax, ay, bx, by, radius; in 3D also those of "
    "z; id and layer are optional";

class HeaderReader {
 public:
  HeaderReader(const CsvText& text, const std::vector<CsvField>& fields) : text_(text), fields_(fields) {
    for (const CsvField& field : fields) names_.push_back(without_blanks(field.text));
    refuse_numbers();
    refuse_duplicates();
  }

  CsvColumns read() {
    CsvColumns columns;
    columns.count = names_.size();
    columns.id = find("id");
    columns.layer = find("layer");
    const Naming& naming = naming_of_columns();
    columns.shape = naming.shape;
    columns.dimension = has_z(naming) ? 3 : 2;
    columns.number_names = naming.names(columns.dimension);
    for (const std::string& name : columns.number_names) columns.numbers.push_back(require(name));
    if (!columns.id) refuse_misspelt_id();
    for (const std::string_view name : names_) {
      const bool used = std::find(used_.begin(), used_.end(), name) != used_.end();
      if (!used) columns.not_read.push_back({"column " + in_quotes(name), 1});
    }
    return columns;
  }

 private:
  /// Detects a table without a header; its ids may be words.
  void refuse_numbers() const {
    const auto is_number = [](std::string_view name) {
      double value = 0;
      const auto [end, error] = fast_float::from_chars(name.data(), name.data() + name.size(), value);
      return error == std::errc() && end == name.data() + name.size();
    };
    const auto numbers = static_cast<std::size_t>(std::count_if(names_.begin(), names_.end(), is_number));
    if (2 * numbers <= names_.size()) return;
    const auto first = std::find_if(names_.begin(), names_.end(), is_number);
    throw text_.error(fields_[static_cast<std::size_t>(first - names_.begin())],
                      fmt::format("the first line holds numbers such as {}; it must be a header that names the "
                                  "columns: {}",
                                  *first, all_columns));
  }

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
    used_.push_back(*found);
    return static_cast<std::size_t>(found - names_.begin());
  }

  bool has(std::string_view name) const { return std::find(names_.begin(), names_.end(), name) != names_.end(); }

  bool has_z(const Naming& naming) const {
    for (std::size_t point = 0; point < naming.points; ++point) {
      if (has(std::string(naming.prefixes[point]) + "z")) return true;
    }
    return false;
  }

  bool has_in_any_case(std::string_view name) const {
    return std::any_of(names_.begin(), names_.end(),
                       [name](std::string_view known) { return edit_distance(name, known, 0) == 0; });
  }

  /// The first kind of shape with a column here for one of its points, ignoring case; otherwise boxes.
  const Naming& naming_of_columns() const {
    for (const Naming& naming : namings) {
      for (const std::string& name : naming.names(3)) {
        if (name != "radius" && has_in_any_case(name)) return naming;
      }
    }
    return has("radius") ? namings.back() : namings.front();
  }

  std::size_t require(std::string_view name) {
    if (const auto index = find(name)) return *index;
    throw missing(name, nearest_name(name, unknown_names()));
  }

  InputError missing(std::string_view name, std::optional<std::string_view> nearest) const {
    const std::string remedy =
        nearest ? fmt::format("is it the one called {}?", in_quotes(*nearest)) : std::string(all_columns);
    return text_.error(fields_.front(), fmt::format("there is no column {}; {}", in_quotes(name), remedy));
  }

  /// Without an id column, objects are named by their number, but a column "ID" was probably meant as one.
  void refuse_misspelt_id() const {
    for (const std::string_view meant : {"id", "name"}) {
      for (const std::string_view name : names_) {
        if (edit_distance(meant, name, 0) == 0) throw missing("id", name);
      }
    }
  }

  /// The columns that may be misspelt, which excludes those with a known name.
  std::vector<std::string_view> unknown_names() const {
    std::vector<std::string> known{"id", "layer"};
    for (const Naming& naming : namings) {
      for (std::string& name : naming.names(3)) known.push_back(std::move(name));
    }
    std::vector<std::string_view> unknown;
    for (const std::string_view name : names_) {
      if (std::find(known.begin(), known.end(), name) == known.end()) unknown.push_back(name);
    }
    return unknown;
  }

  const CsvText& text_;
  const std::vector<CsvField>& fields_;
  std::vector<std::string_view> names_;
  std::vector<std::string_view> used_;
};

}  // namespace

CsvColumns read_csv_header(const CsvText& text, const std::vector<CsvField>& fields) {
  return HeaderReader(text, fields).read();
}

}  // namespace graze::io
