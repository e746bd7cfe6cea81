// SPDX-License-Identifier: MIT
#include <array>
#include <string_view>

#include <fmt/format.h>

#include <graze/io/svg_style.hpp>
#include <graze/io/svg_text.hpp>

namespace graze::io::svg {
namespace {

constexpr std::size_t most_with_labels = 40;
constexpr std::size_t most_with_wide_lines = 400;
constexpr std::size_t most_with_titles = 5000;
constexpr std::size_t most_with_patterns = 5000;
constexpr std::size_t most_with_faces = 10000;

// Blue-grey against the vermillion of Okabe and Ito, "Color Universal Design" (2008): told apart with every kind of
// colour vision, and by lightness alone.
constexpr std::string_view free_line = "#3f5f7f";
constexpr std::string_view free_fill = "#9db6cc";
constexpr std::string_view touching_line = "#d55e00";
constexpr std::string_view touching_fill = "#f3b183";
constexpr std::string_view touching_dark = "#8a3b00";

constexpr std::array<std::string_view, shades> free_shades = {"#5d7791", "#7089a3", "#859db6",
                                                              "#9bb2c8", "#b3c7d9", "#cddce8"};
constexpr std::array<std::string_view, shades> touching_shades = {"#a84a00", "#c25500", "#d96a12",
                                                                  "#e5843a", "#efa064", "#f7bf94"};

constexpr std::string_view page_style = R"(text{font-family:system-ui,"Segoe UI","DejaVu Sans",sans-serif;fill:#2b2f36}
.page{fill:#f5f3ee}.card{fill:#fffefb;stroke:#dcd7cb}
.heading{font-size:18px;font-weight:600}.note{font-size:13px;fill:#6a6f78}.count{font-size:14px}
.label{font-size:12px;text-anchor:middle;paint-order:stroke;stroke:#fffefb;stroke-width:3px;stroke-linejoin:round}
.scale,.axis{fill:none;stroke:#4a505a;stroke-width:1.5}.small{font-size:12px;text-anchor:middle;fill:#4a505a}
)";

/// Slanted lines on a tinted ground, as a tile that repeats.
struct Hatching {
  std::string_view id;
  std::string_view line;
  double line_opacity;
  std::string_view ground;
  double ground_opacity;
  int spacing;
  int degrees;
};

std::string pattern(const Hatching& hatching) {
  return fmt::format(
      "<pattern id=\"{0}\" width=\"{1}\" height=\"{1}\" patternUnits=\"userSpaceOnUse\" "
      "patternTransform=\"rotate({2})\">"
      "<rect width=\"{1}\" height=\"{1}\" fill=\"{3}\" fill-opacity=\"{4}\"/>"
      "<path d=\"M0 0V{1}\" stroke=\"{5}\" stroke-opacity=\"{6}\" stroke-width=\"2\"/></pattern>\n",
      hatching.id, hatching.spacing, hatching.degrees, hatching.ground, number(hatching.ground_opacity), hatching.line,
      number(hatching.line_opacity));
}

/// A ball lit from the upper left.
std::string ball_gradient(std::string_view id, const std::array<std::string_view, shades>& colours) {
  return fmt::format(
      "<radialGradient id=\"{}\" cx=\".36\" cy=\".28\" r=\".75\"><stop offset=\"0\" stop-color=\"{}\"/>"
      "<stop offset=\".55\" stop-color=\"{}\"/><stop offset=\"1\" stop-color=\"{}\"/></radialGradient>\n",
      id, colours[5], colours[3], colours[0]);
}

/// Light above, shade below: a body of which only the silhouette is known.
std::string body_gradient(std::string_view id, const std::array<std::string_view, shades>& colours) {
  return fmt::format(
      "<linearGradient id=\"{}\" x1=\".25\" y1=\"0\" x2=\".7\" y2=\"1\"><stop offset=\"0\" stop-color=\"{}\"/>"
      "<stop offset=\".5\" stop-color=\"{}\"/><stop offset=\"1\" stop-color=\"{}\"/></linearGradient>\n",
      id, colours[5], colours[3], colours[1]);
}

/// What 2D and 3D have in common. Lines keep their width when the picture is enlarged.
std::string shared_style(const Detail& detail) {
  return fmt::format(
      ".shapes{{stroke:{0};stroke-width:{1};stroke-linejoin:round;stroke-linecap:round}}.shapes "
      "*{{vector-effect:non-scaling-stroke}}\n"
      ".line,.mark{{fill:none;stroke-width:{2}}}.touching{{stroke:{3};stroke-width:{2}}}"
      ".touching .line,.touching .mark{{stroke-width:{4}}}\n",
      free_line, number(detail.stroke), number(detail.stroke * 1.7), touching_line, number(detail.stroke * 2.6));
}

std::string flat_style(const Detail& detail) {
  const std::string_view touching = detail.patterns ? "url(#hatch);fill-opacity:1" : "#d55e00;fill-opacity:.65";
  return fmt::format(
      ".shapes{{fill:{};fill-opacity:.5}}.touching{{fill:{}}}\n"
      ".ground{{fill:url(#ground);fill-opacity:1;stroke:none}}.touching .ground{{fill:url(#ground-touching)}}\n",
      free_fill, touching);
}

std::string flat_definitions() {
  return pattern({"hatch", touching_line, 0.55, touching_fill, 0.45, 7, 45}) +
         pattern({"ground", free_line, 0.3, free_fill, 0.16, 12, -45}) +
         pattern({"ground-touching", touching_line, 0.4, touching_fill, 0.16, 12, -45});
}

std::string solid_style() {
  std::string css = fmt::format(
      ".shapes{{fill:url(#body)}}.touching{{fill:url(#body-touching);stroke:{}}}.ball{{fill:url(#ball)}}"
      ".touching .ball{{fill:url(#ball-touching)}}\n.touching .line,.touching .mark{{stroke:{}}}\n"
      ".hatch{{fill:url(#hatch)}}.sheet{{fill:#8fa9c3;fill-opacity:.14}}.grid{{fill:none;stroke-width:.8;stroke-"
      "opacity:.3}}\n"
      ".touching .sheet{{fill:#d55e00;fill-opacity:.09;stroke:{}}}.touching .grid{{stroke:{};stroke-width:.8}}\n",
      touching_dark, touching_line, touching_line, touching_line);
  for (std::size_t i = 0; i < shades; ++i) {
    css += fmt::format(".l{0}{{fill:{1}}}.touching .l{0}{{fill:{2}}}", i, free_shades[i], touching_shades[i]);
  }
  return css + "\n";
}

std::string solid_definitions() {
  return pattern({"hatch", touching_dark, 0.5, touching_fill, 0, 7, 45}) + ball_gradient("ball", free_shades) +
         ball_gradient("ball-touching", touching_shades) + body_gradient("body", free_shades) +
         body_gradient("body-touching", touching_shades);
}

}  // namespace

Detail detail_for(std::size_t objects) {
  Detail detail;
  if (objects > most_with_wide_lines) {
    detail.stroke = objects > most_with_titles ? 0.4 : 0.8;
    detail.mark_size = objects > most_with_titles ? 1.5 : 3;
  }
  detail.labels = objects <= most_with_labels;
  detail.titles = objects <= most_with_titles;
  detail.patterns = objects <= most_with_patterns;
  detail.faces = objects <= most_with_faces;
  return detail;
}

std::string omission(const Detail& detail, std::size_t objects) {
  if (detail.titles) return "";
  return fmt::format("{} objects: titles and hatching are left out above {}, in 3D the faces of boxes above {}",
                     objects, most_with_titles, most_with_faces);
}

std::string style_sheet(const Detail& detail, Dim dimension) {
  const bool flat = dimension == 2;
  return fmt::format("<style>\n{}{}{}</style>\n<defs>\n{}</defs>\n", page_style, shared_style(detail),
                     flat ? flat_style(detail) : solid_style(), flat ? flat_definitions() : solid_definitions());
}

}  // namespace graze::io::svg
