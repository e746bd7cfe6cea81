// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include <graze/io/svg/labels.hpp>
#include <graze/io/svg/legend.hpp>
#include <graze/io/svg/text.hpp>
#include <graze/io/text/file_name.hpp>

namespace graze::io::svg {
namespace {

constexpr double count_font_size = 14;
constexpr double note_font_size = 13;
constexpr double swatch_width = 30;
constexpr double text_gap = 8;
constexpr double item_gap = 26;
constexpr double longest_bar = 200;
constexpr double axis_length = 24;

/// One entry of the legend, drawn at the left edge; the caller moves it into place.
struct Item {
  std::string sample;
  std::string text;
  std::string id;
};

/// A rectangle in the style of a class of objects.
std::string sample(std::string_view style, Dim dimension) {
  constexpr std::string_view frame = R"(y="-8" width="30" height="16" rx="3")";
  std::string drawn = fmt::format("<rect{} {}/>", dimension == 3 ? R"( class="l4")" : "", frame);
  if (dimension == 3 && !style.empty()) drawn += fmt::format(R"(<rect class="pattern" {}/>)", frame);
  const std::string group = style.empty() ? "" : fmt::format(R"( class="{}")", style);
  return fmt::format(R"(<g class="shapes"><g{}>{}</g></g>)", group, drawn);
}

/// Adds an entry for a kind of object or pair that occurs.
void add_item(std::vector<Item>& items, std::size_t count, const Item& item) {
  if (count > 0) items.push_back(item);
}

std::vector<Item> items_of(const Summary& summary) {
  const auto& [near, touching, overlapping] = summary.objects;
  const Dim dimension = summary.dimension;
  const std::string touch = pair_mark(Relation::touching, {swatch_width / 2, 0});
  const std::string overlap = pair_mark(Relation::overlapping, {swatch_width / 2, 0});
  std::vector<Item> items = {{sample("", dimension), fmt::format("{} free", summary.free), "count-free"}};
  add_item(items, near, {sample("near", dimension), fmt::format("{} near", near), "count-near"});
  items.push_back({sample("touching", dimension), fmt::format("{} touching", touching), "count-touching"});
  items.push_back({sample("overlapping", dimension), fmt::format("{} overlapping", overlapping), "count-overlapping"});
  add_item(items, summary.pairs.touching,
           {touch, counted(summary.pairs.touching, "touch", "touches"), "count-touching-pairs"});
  add_item(items, summary.pairs.overlapping,
           {overlap, counted(summary.pairs.overlapping, "overlap"), "count-overlapping-pairs"});
  return items;
}

double width_of(const Item& item) { return swatch_width + text_gap + text_width(item.text, count_font_size); }

/// The entries side by side, starting at `left`.
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

void Counts::add(Relation relation) {
  ++(relation == Relation::apart ? near : relation == Relation::touching ? touching : overlapping);
}

std::string pair_mark(Relation relation, const Vec<2, double>& place) {
  if (relation == Relation::touching) {
    return fmt::format(R"(<circle class="touch" cx="{}" cy="{}" r="4"/>)", number(place.x), number(place.y));
  }
  return fmt::format(R"(<path class="overlap" d="M{} {}l5.5 5.5L{} {}l-5.5 -5.5Z"/>)", number(place.x),
                     number(place.y - 5.5), number(place.x), number(place.y + 5.5));
}

std::string omission_note(const Frame& frame, std::span<const Omission> omissions) {
  if (omissions.empty()) return "";
  std::vector<Omission> ordered(omissions.begin(), omissions.end());
  std::stable_sort(ordered.begin(), ordered.end(),
                   [](const Omission& a, const Omission& b) { return a.loss > b.loss; });
  std::string text = "not read:";
  for (const Omission& omission : ordered) {
    text += fmt::format("{} {} x {}", &omission == &ordered.front() ? "" : ",", omission.count, omission.what);
  }
  constexpr double left = 150;
  constexpr double room = picture_width - side_margin - longest_bar - 2 * item_gap - left;
  const auto fitting = static_cast<std::size_t>(room / text_width("n", note_font_size));
  return fmt::format("<text id=\"omissions\" class=\"note\" x=\"{}\" y=\"{}\"><title>{}</title>{}</text>\n",
                     number(left), number(frame.card.max.y + 44), escaped(text), escaped(shortened(text, fitting)));
}

std::string header(const Summary& summary) {
  const std::vector<Item> items = items_of(summary);
  double left = picture_width - side_margin + item_gap;
  for (const Item& item : items) left -= width_of(item) + item_gap;
  constexpr double heading_size = 18;
  const auto fitting = static_cast<std::size_t>((left - item_gap - side_margin) / text_width("n", heading_size));
  std::string note = fmt::format("{} in {}D, {}", counted(summary.free + summary.objects.all(), "object"),
                                 summary.dimension, counted(summary.pairs.all(), "pair"));
  if (summary.too_far > 0) note += fmt::format(", {} too far away to be drawn", summary.too_far);
  return fmt::format(
      "<text class=\"heading\" x=\"{0}\" y=\"32\">{1}</text>\n<text id=\"note\" class=\"note\" x=\"{0}\" "
      "y=\"53\">{2}</text>\n"
      "<g id=\"legend\">\n{3}</g>\n",
      number(side_margin), escaped(shortened(file_name(summary.source), std::max<std::size_t>(fitting, 1))), note,
      row(items, left));
}

std::string footer(const Frame& frame, std::span<const Axis> axes) {
  const Vec<2, double>& step = axes.front().step;
  return axis_glyph(frame, axes) + scale_bar(frame, std::sqrt(dot(step, step)));
}

}  // namespace graze::io::svg
