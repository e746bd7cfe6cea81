// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include <graze/io/svg/labels.hpp>
#include <graze/io/svg/text.hpp>
#include <graze/io/text/printable.hpp>

namespace graze::io::svg {
namespace {

constexpr double font_size = 12;
constexpr double line_height = 15;
constexpr double gap = 4;
constexpr std::size_t most_tried = 1000;
/// Beyond this extent, a name beside a box could be taken for another object's, because other objects may overlap the
/// box.
constexpr double farthest_side = 60;

bool lies_within(const Aabb<2, double>& inner, const Aabb<2, double>& outer) {
  return inner.min.x >= outer.min.x && inner.min.y >= outer.min.y && inner.max.x <= outer.max.x &&
         inner.max.y <= outer.max.y;
}

double area(const Aabb<2, double>& box) { return (box.max.x - box.min.x) * (box.max.y - box.min.y); }

/// Candidate positions of a text of size 2 * half, the best first: in the middle of the box, elsewhere in it, above,
/// right, left, below.
std::vector<Aabb<2, double>> places(const Aabb<2, double>& box, const Vec<2, double>& half) {
  const Vec<2, double> center = box.center();
  std::vector<Vec<2, double>> middles;
  const Vec<2, double> play = box.half_extents() - half;
  if (play.x >= 0 && play.y >= 0) {
    middles.push_back(center);
    // Moved along one axis only: the content of the box is unlikely to reach into its corners.
    for (const auto& side :
         {Vec<2, double>(0, 0.6), Vec<2, double>(0, -0.6), Vec<2, double>(-0.6, 0), Vec<2, double>(0.6, 0)}) {
      middles.push_back(center + side * play);
    }
  }
  const Vec<2, double> away = box.half_extents() + half + Vec<2, double>(gap);
  for (const auto& side : {Vec<2, double>(0, -1), Vec<2, double>(1, 0), Vec<2, double>(-1, 0), Vec<2, double>(0, 1)}) {
    if (max_abs(side * box.half_extents()) <= farthest_side) middles.push_back(center + side * away);
  }
  std::vector<Aabb<2, double>> boxes;
  boxes.reserve(middles.size());
  for (const Vec<2, double>& middle : middles) boxes.push_back(Aabb<2, double>::from_center(middle, half));
  return boxes;
}

/// The position of label `which`, if there is one. A larger box around the position is background, not an obstacle. In
/// a crowded picture, the name of an object in a pair may cover smaller objects in the middle of its own box.
std::optional<Aabb<2, double>> place_for(std::size_t which, std::span<const Label> labels,
                                         std::span<const Aabb<2, double>> taken, const Aabb<2, double>& card) {
  const Label& label = labels[which];
  const auto is_open = [&](const Aabb<2, double>& place) {
    const auto meets = [&place](const Aabb<2, double>& other) { return boxes_overlap(place, other); };
    return lies_within(place, card) && std::none_of(taken.begin(), taken.end(), meets);
  };
  const auto is_free = [&](const Aabb<2, double>& place) {
    if (!is_open(place)) return false;
    for (std::size_t other = 0; other < labels.size(); ++other) {
      const Aabb<2, double>& box = labels[other].box;
      const bool is_ground = lies_within(place, box) && area(box) >= area(label.box);
      if (other != which && boxes_overlap(place, box) && !is_ground) return false;
    }
    return true;
  };
  const Vec<2, double> half(text_width(label.text, font_size) / 2, line_height / 2);
  for (const Aabb<2, double>& place : places(label.box, half)) {
    if (is_free(place)) return place;
  }
  const Aabb<2, double> middle = Aabb<2, double>::from_center(label.box.center(), half);
  if (label.in_pair && lies_within(middle, label.box) && is_open(middle)) return middle;
  return std::nullopt;
}

/// The order in which names are tried, the most important first.
std::vector<std::size_t> by_weight(std::span<const Label> labels) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (!labels[i].text.empty()) order.push_back(i);
  }
  std::stable_sort(order.begin(), order.end(), [&labels](std::size_t i, std::size_t j) {
    const Label& a = labels[i];
    const Label& b = labels[j];
    return a.in_pair != b.in_pair ? a.in_pair : area(a.box) > area(b.box);
  });
  if (order.size() > most_tried) order.resize(most_tried);
  return order;
}

}  // namespace

double text_width(const std::string& text, double size) {
  return 0.62 * size * static_cast<double>(display_columns(text));
}

std::string placed_labels(std::span<const Label> labels, const Aabb<2, double>& card) {
  std::string svg;
  std::vector<Aabb<2, double>> taken;
  for (const std::size_t i : by_weight(labels)) {
    const std::optional<Aabb<2, double>> place = place_for(i, labels, taken, card);
    if (!place) continue;
    taken.push_back(*place);
    const Vec<2, double> center = place->center();
    svg += fmt::format("<text class=\"label\" x=\"{}\" y=\"{}\">{}</text>\n", number(center.x), number(center.y + gap),
                       escaped(labels[i].text));
  }
  return svg;
}

}  // namespace graze::io::svg
