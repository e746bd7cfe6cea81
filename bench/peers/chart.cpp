// SPDX-License-Identifier: MIT
#include "chart.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "report.hpp"

namespace graze::race {
namespace {

constexpr double width = 960;
constexpr double height = 560;
constexpr double left = 76;
constexpr double right = 310;  // space for the names
constexpr double top = 74;
constexpr double bottom = 62;
constexpr double line_height = 17;

// Colours after Okabe and Ito, "Color Universal Design" (2008): vermillion for graze, the others for peers. The second
// colour is for dark pages.
struct Colour {
  std::string_view on_light;
  std::string_view on_dark;
};
constexpr Colour graze_colour = {"#c44e00", "#ff8a3d"};
constexpr std::array<Colour, 10> peer_colours = {{{"#0072b2", "#56a9e0"},
                                                  {"#009e73", "#2fc79a"},
                                                  {"#aa4499", "#dd8acb"},
                                                  {"#8a6d00", "#e6c229"},
                                                  {"#3a9bd0", "#9ad7f7"},
                                                  {"#555b66", "#b4bac4"},
                                                  {"#7a4b2a", "#cf9d78"},
                                                  {"#332288", "#a99cff"},
                                                  {"#5b9a00", "#a6dd4d"},
                                                  {"#117a8b", "#5fd3e3"}}};

struct Point {
  double x = 0;
  double y = 0;
};

struct Line {
  std::string name;
  Side side = Side::peer;
  std::size_t number = 0;  // among those of its side
  std::vector<Point> points;
  double label_y = 0;
};

/// Powers of ten below and above all values, and the mapping from values to pixels.
struct Axis {
  int low = 0;
  int high = 1;
  double from = 0;  // pixels of 10^low and 10^high
  double to = 1;

  double place(double value) const { return from + (std::log10(value) - low) / (high - low) * (to - from); }
};

Axis axis_around(const std::vector<double>& values, double from, double to) {
  constexpr double slack = 1e-9;  // so that the logarithm of a power of ten may be rounded either way
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  Axis axis{static_cast<int>(std::floor(std::log10(*least) + slack)),
            static_cast<int>(std::ceil(std::log10(*most) - slack)), from, to};
  axis.high = std::max(axis.high, axis.low + 1);
  return axis;
}

struct Chart {
  Axis counts;
  Axis times;
  std::vector<Line> lines;
};

Chart plot(const CourseResult& result) {
  std::vector<double> counts;
  std::vector<double> times;
  for (const Heat& heat : result.heats) {
    for (const Timing& timing : heat.timings) {
      if (timing.threads != 1 || timing.frames == 0) continue;
      counts.push_back(static_cast<double>(heat.count));
      times.push_back(timing.median);
    }
  }
  Chart chart;
  if (counts.empty()) return chart;
  chart.counts = axis_around(counts, left, width - right);
  chart.times = axis_around(times, height - bottom, top);
  std::array<std::size_t, 2> numbers = {};
  for (const Timing& contestant : result.heats.front().timings) {
    if (contestant.threads != 1) continue;
    Line line{contestant.name, contestant.side, numbers[contestant.side == Side::graze ? 0 : 1]++, {}, 0};
    for (const Heat& heat : result.heats) {
      const Timing* timing = timing_of(heat, contestant.name);
      if (timing == nullptr) continue;
      line.points.push_back({chart.counts.place(static_cast<double>(heat.count)), chart.times.place(timing->median)});
    }
    if (!line.points.empty()) chart.lines.push_back(std::move(line));
  }
  return chart;
}

/// Spreads the names at the ends of the lines so that none overlaps another: downwards from the top, then upwards from
/// the bottom if that ran out of the picture.
void place_labels(std::vector<Line>& lines) {
  std::vector<Line*> ordered;
  ordered.reserve(lines.size());
  for (Line& line : lines) ordered.push_back(&line);
  std::sort(ordered.begin(), ordered.end(),
            [](const Line* a, const Line* b) { return a->points.back().y < b->points.back().y; });
  double free_from = top;
  for (Line* line : ordered) {
    line->label_y = std::max(line->points.back().y, free_from);
    free_from = line->label_y + line_height;
  }
  double free_to = height - bottom;
  std::reverse(ordered.begin(), ordered.end());
  for (Line* line : ordered) {
    line->label_y = std::min(line->label_y, free_to);
    free_to = line->label_y - line_height;
  }
}

/// A marker for each number, centered at the origin; graze's are filled.
std::string_view marker(std::size_t number) {
  constexpr std::array<std::string_view, peer_colours.size()> markers = {
      "M-4.5 0A4.5 4.5 0 1 0 4.5 0A4.5 4.5 0 1 0 -4.5 0Z",
      "M-4-4H4V4H-4Z",
      "M0-5.5L5.5 0L0 5.5L-5.5 0Z",
      "M0-5.2L5 3.8H-5Z",
      "M0 5.2L5-3.8H-5Z",
      "M-4.5-1.5H-1.5V-4.5H1.5V-1.5H4.5V1.5H1.5V4.5H-1.5V1.5H-4.5Z",
      "M-5 0L-2.5-4.5H2.5L5 0L2.5 4.5H-2.5Z",
      "M-3.2-5.3L0-2.1L3.2-5.3L5.3-3.2L2.1 0L5.3 3.2L3.2 5.3L0 2.1"
      "L-3.2 5.3L-5.3 3.2L-2.1 0L-5.3-3.2Z",
      "M-4.5-4.5H4.5L-4.5 4.5H4.5Z",
      "M5.2 0L-3.8 5V-5Z"};
  return markers[number % markers.size()];
}

std::string class_of(const Line& line) {
  return line.side == Side::graze ? "g" : fmt::format("p{}", line.number % peer_colours.size());
}

std::string colour_rules(bool dark) {
  const auto rule = [dark](const std::string& name, const Colour& colour) {
    return fmt::format(".{}{{color:{}}}", name, dark ? colour.on_dark : colour.on_light);
  };
  std::string css = rule("g", graze_colour);
  for (std::size_t i = 0; i < peer_colours.size(); ++i) css += rule(fmt::format("p{}", i), peer_colours[i]);
  return css;
}

std::string style() {
  return "<style>text{font-family:system-ui,\"Segoe UI\",\"DejaVu Sans\",sans-serif;font-size:13px;fill:#2b2f36}"
         ".heading{font-size:18px;font-weight:600}.note{fill:#5c626c}.card{fill:#fffefb;stroke:#dcd7cb}"
         ".grid{stroke:#dcd7cb;stroke-width:1;fill:none}.fine{stroke-opacity:.45}.frame{stroke:#8a8f98;fill:none}"
         ".line{fill:none;stroke:currentColor;stroke-width:1.8;stroke-linejoin:round}.graze .line{stroke-width:3}"
         ".dot{fill:#fffefb;stroke:currentColor;stroke-width:1.8}.graze .dot{fill:currentColor}"
         ".to-name{fill:none;stroke:currentColor;stroke-opacity:.45}.name{fill:currentColor}"
         ".graze .name{font-weight:600}\n" +
         colour_rules(false) +
         "\n@media (prefers-color-scheme:dark){text{fill:#e4e6ea}.note{fill:#a5abb5}.card{fill:#1c1f24;stroke:#3a3f47}"
         ".grid{stroke:#3a3f47}.dot{fill:#1c1f24}.name{fill:currentColor}.graze .dot{fill:currentColor}" +
         colour_rules(true) + "}</style>\n";
}

/// "1k", "10M", "0.01".
std::string power_text(int power, bool is_count) {
  if (!is_count)
    return power < 0 ? fmt::format("{:.{}f}", std::pow(10, power), -power)
                     : grouped(static_cast<std::size_t>(std::lround(std::pow(10, power))));
  if (power >= 6) return fmt::format("{:.0f}M", std::pow(10, power - 6));
  return power >= 3 ? fmt::format("{:.0f}k", std::pow(10, power - 3)) : fmt::format("{:.0f}", std::pow(10, power));
}

std::string grid(const Chart& chart) {
  std::string svg;
  const double end_x = width - right;
  const double end_y = height - bottom;
  for (int power = chart.counts.low; power <= chart.counts.high; ++power) {
    const double x = chart.counts.place(std::pow(10, power));
    svg += fmt::format(
        "<path class=\"grid\" d=\"M{0:.1f} {1}V{2}\"/><text class=\"note\" x=\"{0:.1f}\" y=\"{3}\" "
        "text-anchor=\"middle\">{4}</text>\n",
        x, top, end_y, end_y + 20, power_text(power, true));
  }
  for (int power = chart.times.low; power <= chart.times.high; ++power) {
    const double y = chart.times.place(std::pow(10, power));
    svg += fmt::format(
        "<path class=\"grid\" d=\"M{0} {1:.1f}H{2}\"/><text class=\"note\" x=\"{3}\" y=\"{4:.1f}\" "
        "text-anchor=\"end\">{5}</text>\n",
        left, y, end_x, left - 9, y + 4.5, power_text(power, false));
    for (int k = 2; k < 10 && power < chart.times.high; ++k) {
      svg += fmt::format("<path class=\"grid fine\" d=\"M{} {:.1f}H{}\"/>", left,
                         chart.times.place(k * std::pow(10, power)), end_x);
    }
  }
  return svg + fmt::format("<path class=\"frame\" d=\"M{} {}V{}H{}\"/>\n", left, top, end_y, end_x);
}

std::string drawn(const Line& line) {
  std::string path;
  std::string dots;
  for (const Point& point : line.points) {
    path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? 'M' : 'L', point.x, point.y);
    dots += fmt::format("<path class=\"dot\" transform=\"translate({:.1f} {:.1f})\" d=\"{}\"/>", point.x, point.y,
                        marker(line.number));
  }
  const Point& end = line.points.back();
  const double name_x = width - right + 34;
  return fmt::format(
      "<g class=\"{}{}\"><title>{}</title><path class=\"line\" d=\"{}\"/>"
      "<path class=\"to-name\" d=\"M{:.1f} {:.1f}L{} {:.1f}\"/>{}"
      "<path class=\"dot\" transform=\"translate({} {:.1f})\" d=\"{}\"/>"
      "<text class=\"name\" x=\"{}\" y=\"{:.1f}\">{}</text></g>\n",
      class_of(line), line.side == Side::graze ? " graze" : "", line.name, path, end.x, end.y, name_x - 16,
      line.label_y, dots, name_x - 10, line.label_y, marker(line.number), name_x, line.label_y + 4.5, line.name);
}

}  // namespace

std::string chart_of(const CourseResult& result) {
  Chart chart = plot(result);
  const bool has_line =
      std::any_of(chart.lines.begin(), chart.lines.end(), [](const Line& line) { return line.points.size() > 1; });
  if (!has_line) return "";
  place_labels(chart.lines);
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" role=\"img\">\n"
      "<title>All overlapping pairs of {2}: milliseconds per frame over the number of boxes</title>\n{3}"
      "<rect class=\"card\" x=\".5\" y=\".5\" width=\"{4}\" height=\"{5}\" rx=\"8\"/>\n"
      "<text class=\"heading\" x=\"{6}\" y=\"34\">All overlapping pairs: {2}, one thread</text>\n"
      "<text class=\"note\" x=\"{6}\" y=\"56\">milliseconds per frame, median; lower is better</text>\n",
      width, height, title_of(result.course), style(), width - 1, height - 1, left);
  svg += grid(chart);
  svg += fmt::format("<text class=\"note\" x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">boxes</text>\n",
                     (left + width - right) / 2, height - 20);
  // Peers first, so that graze's lines are on top.
  for (const Side side : {Side::peer, Side::graze}) {
    for (const Line& line : chart.lines) {
      if (line.side == side) svg += drawn(line);
    }
  }
  return svg + "</svg>\n";
}

}  // namespace graze::race
