// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include <graze/io/svg_labels.hpp>
#include <graze/io/svg_legend.hpp>
#include <graze/io/svg_text.hpp>

namespace graze::io::svg {
namespace {

constexpr double count_font_size = 14;
constexpr double swatch_width = 30;
constexpr double text_gap = 8;
constexpr double item_gap = 26;
constexpr double longest_bar = 200;
constexpr double axis_length = 24;

/// One entry of the legend, at the left of the picture; whoever uses it moves it to its place.
struct Item {
  std::string sample;
  std::string text;
  std::string id;
};

std::string sample(bool touching, Dim dimension) {
  const std::string_view hatched =
      touching && dimension == 3 ? R"(<rect class="hatch" y="-8" width="30" height="16" rx="3"/>)" : "";
  return fmt::format(R"(<g class="shapes"><g{}><rect{} y="-8" width="30" height="16" rx="3"/>{}</g></g>)",
                     touching ? " class=\"touching\"" : "", dimension == 3 ? " class=\"l4\"" : "", hatched);
}

/// Two discs that touch.
std::string pair_sample(Dim dimension) {
  const std::string_view style = dimension == 3 ? " class=\"ball\"" : "";
  return fmt::format(
      R"(<g class="shapes"><g class="touching"><circle{0} cx="8" r="7"/><circle{0} cx="22" r="7"/></g></g>)", style);
}

std::string last_part(const std::string& path) {
  const std::size_t slash = path.find_last_of("/\\");
  return slash == std::string::npos || slash + 1 == path.size() ? path : path.substr(slash + 1);
}

double width_of(const Item& item) { return swatch_width + text_gap + text_width(item.text, count_font_size); }

/// The entries side by side, beginning at `left`.
std::string row(std::span<const Item> items, double left) {
  std::string svg;
  for (const Item& item : items) {
    svg += fmt::format("<g transform=\"translate({} 36)\">{}", number(left), item.sample);
    svg += fmt::format("<text id=\"{}\" class=\"count\" x=\"{}\" y=\"5\">{}</text></g>\n", item.id,
                       number(swatch_width + text_gap), item.text);
    left += width_of(item) + item_gap;
  }
  return svg;
}

std::string scale_bar(const Frame& frame, double unit_length) {
  const double pixels_per_unit = frame.scale * unit_length;  // both positive
  const double units = round_length(longest_bar / pixels_per_unit);
  const double right = picture_width - side_margin;
  const double left = right - units * pixels_per_unit;
  const double y = frame.card.max.y + 40;
  return fmt::format(
      R"(<g id="scale"><path class="scale" d="M{0} {2}v8M{0} {3}H{1}M{1} {2}v8"/><text class="small" x="{4}" y="{5}">{6} {7}</text></g>)"
      "\n",
      number(left), number(right), number(y - 4), number(y), number((left + right) / 2), number(y - 9),
      length_text(units), units == 1 ? "unit" : "units");
}

std::string axis_glyph(const Frame& frame, std::span<const Axis> axes) {
  Aabb<2, double> reach{Vec<2, double>(0.0), Vec<2, double>(0.0)};
  for (const Axis& axis : axes) reach.grow(Vec<2, double>(axis.step.x, -axis.step.y) * axis_length);
  const Vec<2, double> origin(side_margin + 14 - reach.min.x, frame.card.max.y + 34 - reach.center().y);
  std::string svg = "<g id=\"axes\">";
  for (const Axis& axis : axes) {
    const Vec<2, double> direction(axis.step.x, -axis.step.y);
    const Vec<2, double> tip = origin + direction * axis_length;
    const double size = std::sqrt(dot(direction, direction));
    const Vec<2, double> along = size > 0 ? direction / size : Vec<2, double>(0.0);
    const Vec<2, double> back = tip - along * 6.0;
    const Vec<2, double> aside = perpendicular(along) * 3.0;
    const Vec<2, double> text = tip + along * 9.0;
    svg += fmt::format(
        R"(<path class="axis" d="M{} {}L{} {}M{} {}L{} {}L{} {}"/><text class="small" x="{}" y="{}">{}</text>)",
        number(origin.x), number(origin.y), number(tip.x), number(tip.y), number((back + aside).x),
        number((back + aside).y), number(tip.x), number(tip.y), number((back - aside).x), number((back - aside).y),
        number(text.x), number(text.y + 4), axis.name);
  }
  return svg + "</g>\n";
}

}  // namespace

std::string header(const Summary& summary) {
  const std::array<Item, 3> items = {
      Item{sample(false, summary.dimension), fmt::format("{} free", summary.free), "count-free"},
      Item{sample(true, summary.dimension), fmt::format("{} touching", summary.touching), "count-touching"},
      Item{pair_sample(summary.dimension), counted(summary.pairs, "pair"), "count-pairs"}};
  double left = picture_width - side_margin + item_gap;
  for (const Item& item : items) left -= width_of(item) + item_gap;
  constexpr double heading_size = 18;
  const auto fitting = static_cast<std::size_t>((left - item_gap - side_margin) / text_width("n", heading_size));
  std::string note = fmt::format("{} in {}D", counted(summary.free + summary.touching, "object"), summary.dimension);
  if (summary.too_far > 0) note += fmt::format(", {} too far away to be drawn", summary.too_far);
  return fmt::format(
      "<text class=\"heading\" x=\"{0}\" y=\"32\">{1}</text>\n<text id=\"note\" class=\"note\" x=\"{0}\" "
      "y=\"53\">{2}</text>\n"
      "<g id=\"legend\">\n{3}</g>\n",
      number(side_margin), escaped(shortened(last_part(summary.source), std::max<std::size_t>(fitting, 1))), note,
      row(items, left));
}

std::string footer(const Frame& frame, std::span<const Axis> axes) {
  const Vec<2, double>& step = axes.front().step;
  return axis_glyph(frame, axes) + scale_bar(frame, std::sqrt(dot(step, step)));
}

}  // namespace graze::io::svg
