// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <graze/io/svg/pen.hpp>
#include <graze/io/svg/text.hpp>

namespace graze::io::svg {
namespace {

constexpr double least_size = 0.1;
constexpr double arrow_head_length = 11;
constexpr double arrow_head_half_width = 4.5;

std::string class_attribute(std::string_view style) {
  return style.empty() ? std::string() : fmt::format(" class=\"{}\"", style);
}

std::string text_of(const Vec<2, double>& point) { return number(point.x) + " " + number(point.y); }

/// "M1 2L3 4": a path through points of the picture.
std::string polyline(std::span<const Vec<2, double>> points) {
  std::string data;
  for (const Vec<2, double>& point : points) data += (data.empty() ? "M" : "L") + text_of(point);
  return data;
}

/// An edge of a polygon (counter-clockwise as seen), moved outward.
Segment<2, double> moved_outward(const Vec<2, double>& from, const Vec<2, double>& to, double distance) {
  const Vec<2, double> edge = to - from;
  const double length = std::sqrt(dot(edge, edge));
  if (!(length > 0)) return {from, to};  // two corners that coincide in the picture
  const Vec<2, double> outward = Vec<2, double>(-edge.y, edge.x) * (distance / length);
  return {from + outward, to + outward};
}

/// The outline of all points within `radius` of a polygon: its edges moved outward, joined by arcs. Two corners give a
/// capsule.
std::string rounded_polygon(std::span<const Vec<2, double>> corners, double radius) {
  const std::string arc = fmt::format("A{0} {0} 0 0 0 ", number(radius));
  std::string data;
  std::string beginning;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Segment<2, double> edge = moved_outward(corners[i], corners[(i + 1) % corners.size()], radius);
    if (i == 0) beginning = text_of(edge.start);
    data += (i == 0 ? "M" : arc) + text_of(edge.start) + "L" + text_of(edge.end);
  }
  return data + arc + beginning + "Z";
}

}  // namespace

void Pen::path(std::string_view data, std::string_view style) {
  svg_ += fmt::format("<path{} d=\"{}\"/>", class_attribute(style), data);
  ++elements_;
}

void Pen::disc(const Vec<2, double>& center, double radius, std::string_view style) {
  svg_ += fmt::format("<circle{} cx=\"{}\" cy=\"{}\" r=\"{}\"/>", class_attribute(style), number(center.x),
                      number(center.y), number(std::max(radius, least_size / 2)));
  ++elements_;
}

void Pen::mark(const Vec<2, double>& point) {
  const Vec<2, double> center = to_picture(frame_, point);
  const double arm = mark_size_;
  path(fmt::format("M{} {}h{}M{} {}v{}", number(center.x - arm), number(center.y), number(2 * arm), number(center.x),
                   number(center.y - arm), number(2 * arm)),
       "mark");
}

void Pen::outline(const Outline& outline, std::string_view style) {
  if (outline.core.empty()) return;
  const double radius = outline.radius * frame_.scale;
  std::vector<Vec<2, double>> corners;
  corners.reserve(outline.core.size());
  for (const Vec<2, double>& corner : outline.core) corners.push_back(to_picture(frame_, corner));
  if (corners.size() == 1 && outline.radius == 0) return mark(outline.core[0]);
  Aabb<2, double> core_box{corners[0], corners[0]};
  for (const Vec<2, double>& corner : corners) core_box.grow(corner);
  if (max_abs(core_box.max - core_box.min) < least_size) return disc(core_box.center(), radius, style);
  if (radius >= least_size / 2) return path(rounded_polygon(corners, radius), style);
  if (corners.size() == 2) return path(polyline(corners), "line");
  path(polyline(corners) + "Z", style);
}

void Pen::area(std::span<const std::vector<Vec<2, double>>> ways, std::string_view style) {
  std::string data;
  Aabb<2, double> box = Aabb<2, double>::nothing();
  std::vector<Vec<2, double>> corners;
  for (const std::vector<Vec<2, double>>& way : ways) {
    corners.clear();
    for (const Vec<2, double>& corner : way) {
      corners.push_back(to_picture(frame_, corner));
      box.grow(corners.back());
    }
    if (!corners.empty()) data += polyline(corners) + "Z";
  }
  if (data.empty()) return;
  if (max_abs(box.max - box.min) < least_size) return disc(box.center(), 0, style);
  path(data, style);
}

void Pen::line(const Vec<2, double>& from, const Vec<2, double>& to, std::string_view style) {
  lines(std::vector{from, to}, style);
}

void Pen::lines(std::span<const Vec<2, double>> ends, std::string_view style) {
  std::string data;
  for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
    data += "M" + text_of(to_picture(frame_, ends[i])) + "L" + text_of(to_picture(frame_, ends[i + 1]));
  }
  if (!data.empty()) path(data, style);
}

void Pen::arrow(const Vec<2, double>& from, const Vec<2, double>& to) {
  const Vec<2, double> start = to_picture(frame_, from);
  const Vec<2, double> tip = to_picture(frame_, to);
  const Vec<2, double> shaft = tip - start;
  const double length = std::sqrt(dot(shaft, shaft));
  if (!(length > least_size)) return mark(from);
  const Vec<2, double> along = shaft / length;
  const Vec<2, double> back = tip - along * std::min(arrow_head_length, length);
  const Vec<2, double> aside = perpendicular(along) * arrow_head_half_width;
  const auto inside = [this](const Vec<2, double>& point) {
    return Vec<2, double>(std::clamp(point.x, frame_.card.min.x, frame_.card.max.x),
                          std::clamp(point.y, frame_.card.min.y, frame_.card.max.y));
  };
  path(polyline(std::vector{start, tip}) + polyline(std::vector{inside(back + aside), tip, inside(back - aside)}),
       "line");
}

void Pen::rectangle(const Aabb<2, double>& box, std::string_view style) {
  const Vec<2, double> a = to_picture(frame_, box.min);
  const Vec<2, double> b = to_picture(frame_, box.max);
  const double left = std::min(a.x, b.x);
  const double top = std::min(a.y, b.y);
  const double width = std::max(std::fabs(b.x - a.x), least_size);
  const double height = std::max(std::fabs(b.y - a.y), least_size);
  svg_ += fmt::format("<rect{} x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>", class_attribute(style), number(left),
                      number(top), number(width), number(height));
  ++elements_;
}

std::string Pen::take() {
  elements_ = 0;
  return std::exchange(svg_, {});
}

}  // namespace graze::io::svg
