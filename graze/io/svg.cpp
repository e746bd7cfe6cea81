// SPDX-License-Identifier: MIT
#include <array>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include <graze/io/svg.hpp>
#include <graze/io/svg/flat.hpp>
#include <graze/io/svg/legend.hpp>
#include <graze/io/svg/object.hpp>
#include <graze/io/svg/solid.hpp>
#include <graze/io/svg/stage.hpp>
#include <graze/io/svg/style.hpp>
#include <graze/io/svg/subject.hpp>
#include <graze/io/svg/text.hpp>

namespace graze::io {
namespace {

constexpr std::array<std::string_view, 3> axis_names = {"x", "y", "z"};

template <Dim N>
svg::Summary summary_of(const SceneFile& file, const svg::Subject<N>& subject, const svg::Stage<N>& stage) {
  svg::Summary summary;
  summary.source = file.source;
  summary.dimension = N;
  for (const svg::Touches& touches : subject.touches) {
    if (touches.count == 0) ++summary.free;
    if (touches.count > 0) summary.objects.add(touches.closest);
  }
  for (const svg::DrawnPair& pair : subject.pairs) summary.pairs.add(pair.relation);
  summary.too_far = stage.too_far;
  return summary;
}

template <Dim N>
std::vector<svg::Axis> axes_of(const View<N>& view) {
  std::vector<svg::Axis> axes;
  axes.reserve(N);
  for (Dim i = 0; i < N; ++i) {
    axes.push_back({std::string(axis_names[static_cast<std::size_t>(i)]), seen(unit_axis<N>(i), view)});
  }
  return axes;
}

/// The page, and on it the card that shows the scene.
std::string page(const svg::Frame& frame) {
  const Vec<2, double> size = frame.card.max - frame.card.min;
  const std::string card = fmt::format(R"(x="{}" y="{}" width="{}" height="{}" rx="8")", svg::number(frame.card.min.x),
                                       svg::number(frame.card.min.y), svg::number(size.x), svg::number(size.y));
  return fmt::format(R"(<clipPath id="edge"><rect {0}/></clipPath>
<rect class="page" width="100%" height="100%"/>
<rect class="card" {0}/>
)",
                     card);
}

std::string opening(const svg::Frame& frame) {
  return fmt::format(R"(<?xml version="1.0" encoding="UTF-8"?>
<svg xmlns="http://www.w3.org/2000/svg" width="{0}" height="{1}" viewBox="0 0 {0} {1}">
)",
                     svg::number(svg::picture_width), svg::number(frame.height));
}

/// The text of an empty picture, so that nobody waits for more to appear, and the reason.
std::string empty_note(const svg::Frame& frame, std::span<const Omission> omissions) {
  const Vec<2, double> middle = frame.card.center();
  const std::string_view why =
      omissions.empty() ? "nothing to draw" : "nothing to draw: the content of the file was not read";
  return fmt::format("<text class=\"small\" x=\"{}\" y=\"{}\">{}</text>\n", svg::number(middle.x),
                     svg::number(middle.y), why);
}

template <Dim N>
std::string picture(const SceneFile& file, const Scene<N, double>& scene, std::span<const ObjectPair> reported) {
  const svg::Subject<N> subject = svg::subject_of<N>(scene, reported);
  const svg::Stage<N> stage = svg::stage_for<N>(subject, file.y_axis);
  const svg::Detail detail = svg::detail_for(scene.size());
  std::string text = opening(stage.frame);
  const std::string left_out = svg::omission(detail, scene.size());
  if (!left_out.empty()) text += fmt::format("<!-- {} -->\n", left_out);
  text += svg::style_sheet(detail, N) + page(stage.frame) + svg::header(summary_of<N>(file, subject, stage));
  text += "<g id=\"objects\" class=\"shapes\" clip-path=\"url(#edge)\">\n";
  if constexpr (N == 2) {
    text += svg::paint_flat(subject, stage, detail);
  } else {
    text += svg::paint_solid(subject, stage, detail);
  }
  text += "</g>\n<g id=\"pairs\" clip-path=\"url(#edge)\">\n" + svg::pair_marks<N>(subject, stage) + "</g>\n";
  text += "<g id=\"labels\">\n" + svg::name_labels<N>(subject, stage, detail) + "</g>\n";
  if (stage.drawn.empty()) text += empty_note(stage.frame, file.omissions);
  text += svg::omission_note(stage.frame, file.omissions);
  return text + svg::footer(stage.frame, axes_of(stage.view)) + "</svg>\n";
}

}  // namespace

void write_svg(std::ostream& out, const SceneFile& file, std::span<const ObjectPair> reported) {
  const std::string text =
      std::visit([&]<Dim N>(const Scene<N, double>& scene) { return picture<N>(file, scene, reported); }, file.scene);
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
}

}  // namespace graze::io
