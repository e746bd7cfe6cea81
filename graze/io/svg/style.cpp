// SPDX-License-Identifier: MIT
#include <array>
#include <string_view>

#include <fmt/format.h>

#include <graze/io/svg/style.hpp>
#include <graze/io/svg/text.hpp>

namespace graze::io::svg {
namespace {

constexpr std::size_t most_with_wide_lines = 400;
constexpr std::size_t most_with_titles = 5000;
constexpr std::size_t most_with_patterns = 5000;
constexpr std::size_t most_with_faces = 10000;

/// The colours of one class of objects.
struct Colours {
  std::string_view name;
  std::string_view line;
  std::string_view fill;
  std::string_view dark;
  std::array<std::string_view, shades> shaded;
};

// Blue-grey, vermillion and a muted bluish green after Okabe and Ito, "Color Universal Design" (2008). Vermillion is
// distinguishable with every kind of colour vision, and by lightness alone; the green by its pattern or dashes.
constexpr Colours free_colours = {
    "free", "#3f5f7f", "#9db6cc", "#2a4560", {"#5d7791", "#7089a3", "#859db6", "#9bb2c8", "#b3c7d9", "#cddce8"}};
constexpr Colours touching_colours = {
    "touching", "#0f7568", "#a3d6c9", "#0a4d44", {"#3a8577", "#4c9889", "#64ac9d", "#82c0b2", "#a2d3c7", "#c6e6de"}};
constexpr Colours overlapping_colours = {
    "overlapping", "#d55e00", "#f3b183", "#8a3b00", {"#a84a00", "#c25500", "#d96a12", "#e5843a", "#efa064", "#f7bf94"}};
constexpr std::array<Colours, 2> pair_colours = {touching_colours, overlapping_colours};

constexpr std::string_view page_style = R"(text{font-family:system-ui,"Segoe UI","DejaVu Sans",sans-serif;fill:#2b2f36}
.page{fill:#f5f3ee}.card{fill:#fffefb;stroke:#dcd7cb}
.heading{font-size:18px;font-weight:600}.note{font-size:13px;fill:#6a6f78}.count{font-size:14px}
.label{font-size:12px;text-anchor:middle;paint-order:stroke;stroke:#fffefb;stroke-width:3px;stroke-linejoin:round}
.scale,.axis{fill:none;stroke:#4a505a;stroke-width:1.5}.small{font-size:12px;text-anchor:middle;fill:#4a505a}
)";

/// The tile of a pattern on a tinted background: slanted lines, or dots.
struct Pattern {
  std::string_view id;
  std::string_view line;
  double line_opacity;
  std::string_view ground;
  double ground_opacity;
  int spacing;
  int degrees;
  bool dotted = false;
};

std::string definition(const Pattern& pattern) {
  const std::string ink =
      pattern.dotted ? fmt::format("<circle cx=\"{0}\" cy=\"{0}\" r=\"1.25\" fill=\"{1}\" fill-opacity=\"{2}\"/>",
                                   number(pattern.spacing / 2.0), pattern.line, number(pattern.line_opacity))
                     : fmt::format("<path d=\"M0 0V{}\" stroke=\"{}\" stroke-opacity=\"{}\" stroke-width=\"2\"/>",
                                   pattern.spacing, pattern.line, number(pattern.line_opacity));
  return fmt::format(
      "<pattern id=\"{0}\" width=\"{1}\" height=\"{1}\" patternUnits=\"userSpaceOnUse\" "
      "patternTransform=\"rotate({2})\"><rect width=\"{1}\" height=\"{1}\" fill=\"{3}\" "
      "fill-opacity=\"{4}\"/>{5}</pattern>\n",
      pattern.id, pattern.spacing, pattern.degrees, pattern.ground, number(pattern.ground_opacity), ink);
}

/// A sphere lit from the upper left.
std::string sphere_gradient(const Colours& colours) {
  return fmt::format(
      "<radialGradient id=\"sphere-{}\" cx=\".36\" cy=\".28\" r=\".75\"><stop offset=\"0\" stop-color=\"{}\"/>"
      "<stop offset=\".55\" stop-color=\"{}\"/><stop offset=\"1\" stop-color=\"{}\"/></radialGradient>\n",
      colours.name, colours.shaded[5], colours.shaded[3], colours.shaded[0]);
}

/// Light above, shadow below: for bodies whose silhouette only is known.
std::string body_gradient(const Colours& colours) {
  return fmt::format(
      "<linearGradient id=\"body-{}\" x1=\".25\" y1=\"0\" x2=\".7\" y2=\"1\"><stop offset=\"0\" stop-color=\"{}\"/>"
      "<stop offset=\".5\" stop-color=\"{}\"/><stop offset=\"1\" stop-color=\"{}\"/></linearGradient>\n",
      colours.name, colours.shaded[5], colours.shaded[3], colours.shaded[1]);
}

/// Common styles of 2D and 3D. Line widths do not scale with the picture. Overlapping objects have the widest lines,
/// then touching, then all others; lines that only touch or are near are dashed.
std::string shared_style(const Detail& detail) {
  std::string css = fmt::format(
      ".shapes{{stroke:{0};stroke-width:{1};stroke-linejoin:round;stroke-linecap:round}}.shapes "
      "*{{vector-effect:non-scaling-stroke}}\n.line,.mark{{fill:none;stroke-width:{2}}}"
      ".near,.near .line{{stroke:{3};stroke-dasharray:1 5}}.touching .line{{stroke-dasharray:5 5}}"
      ".shapes .mark{{stroke-dasharray:none}}\n",
      free_colours.line, number(detail.stroke), number(detail.stroke * 1.7), touching_colours.line);
  for (const Colours& colours : pair_colours) {
    const bool overlapping = &colours == &pair_colours.back();
    css += fmt::format(".{0}{{stroke:{1};stroke-width:{2}}}.{0} .line,.{0} .mark{{stroke:{1};stroke-width:{3}}}\n",
                       colours.name, colours.line, number(detail.stroke * (overlapping ? 1.9 : 1.3)),
                       number(detail.stroke * (overlapping ? 2.6 : 2.1)));
  }
  return css +
         fmt::format(
             ".touch{{fill:#fffefb;stroke:{};stroke-width:2}}.overlap{{fill:{};stroke:#fffefb;stroke-width:1.2}}\n",
             touching_colours.line, overlapping_colours.dark);
}

std::string flat_style(const Detail& detail) {
  std::string css =
      fmt::format(".shapes{{fill:{};fill-opacity:.5}}.ground{{fill:url(#ground-free);fill-opacity:1;stroke:none}}\n",
                  free_colours.fill);
  for (const Colours& colours : pair_colours) {
    const std::string fill = detail.patterns ? fmt::format("url(#{});fill-opacity:1", colours.name)
                                             : fmt::format("{};fill-opacity:.65", colours.line);
    css += fmt::format(".{0}{{fill:{1}}}.{0} .ground{{fill:url(#ground-{0})}}", colours.name, fill);
  }
  return css + (detail.patterns ? ".touching{stroke-dasharray:6 5}\n" : "\n");
}

std::string flat_definitions(const Detail& detail) {
  const Colours& touching = touching_colours;
  const Colours& overlapping = overlapping_colours;
  std::string patterns = definition({"ground-free", free_colours.line, 0.3, free_colours.fill, 0.16, 12, -45}) +
                         definition({"ground-touching", touching.line, 0.55, touching.fill, 0.16, 9, 45, true}) +
                         definition({"ground-overlapping", overlapping.line, 0.4, overlapping.fill, 0.16, 12, -45});
  if (!detail.patterns) return patterns;
  return patterns + definition({"touching", touching.line, 0.6, touching.fill, 0.4, 7, 45, true}) +
         definition({"overlapping", overlapping.line, 0.55, overlapping.fill, 0.45, 7, 45});
}

std::string solid_style(const Detail& detail) {
  std::string css = fmt::format(
      ".shapes{{fill:url(#body-free)}}.sphere{{fill:url(#sphere-free)}}.sheet{{fill:#8fa9c3;fill-opacity:.14}}"
      ".grid{{fill:none;stroke-width:.8;stroke-opacity:.3}}\n");
  for (std::size_t i = 0; i < shades; ++i) css += fmt::format(".l{}{{fill:{}}}", i, free_colours.shaded[i]);
  for (const Colours& colours : pair_colours) {
    css += fmt::format(
        "\n.{0}{{fill:url(#body-{0});stroke:{1}}}.{0} .sphere{{fill:url(#sphere-{0})}}.{0} .sheet{{fill:{2};"
        "fill-opacity:.09;stroke:{2}}}.{0} .grid{{stroke:{2};stroke-width:.8}}",
        colours.name, colours.dark, colours.line);
    if (detail.patterns) css += fmt::format(".{0} .pattern{{fill:url(#{0})}}", colours.name);
    for (std::size_t i = 0; i < shades; ++i)
      css += fmt::format(".{} .l{}{{fill:{}}}", colours.name, i, colours.shaded[i]);
  }
  return css + "\n";
}

std::string solid_definitions(const Detail& detail) {
  std::string result;
  for (const Colours& colours : {free_colours, touching_colours, overlapping_colours}) {
    result += sphere_gradient(colours) + body_gradient(colours);
  }
  if (!detail.patterns) return result;
  return result + definition({"touching", touching_colours.dark, 0.5, touching_colours.fill, 0, 7, 45, true}) +
         definition({"overlapping", overlapping_colours.dark, 0.5, overlapping_colours.fill, 0, 7, 45});
}

}  // namespace

Detail detail_for(std::size_t objects) {
  Detail detail;
  if (objects > most_with_wide_lines) {
    detail.stroke = objects > most_with_titles ? 0.4 : 0.8;
    detail.mark_size = objects > most_with_titles ? 1.5 : 3;
  }
  detail.titles = objects <= most_with_titles;
  detail.labels = detail.titles;
  detail.patterns = objects <= most_with_patterns;
  detail.faces = objects <= most_with_faces;
  return detail;
}

std::string omission(const Detail& detail, std::size_t objects) {
  if (detail.titles) return "";
  return fmt::format("{} objects: names, titles and patterns are left out above {}, in 3D the faces of boxes above {}",
                     objects, most_with_titles, most_with_faces);
}

std::string style_sheet(const Detail& detail, Dim dimension) {
  const bool flat = dimension == 2;
  return fmt::format("<style>\n{}{}{}</style>\n<defs>\n{}</defs>\n", page_style, shared_style(detail),
                     flat ? flat_style(detail) : solid_style(detail),
                     flat ? flat_definitions(detail) : solid_definitions(detail));
}

}  // namespace graze::io::svg
