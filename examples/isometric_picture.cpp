// SPDX-License-Identifier: MIT
// Draws 3D shapes as SVG in parallel projection: each is the convex hull of a few points, grown by a radius.
#include <cstdio>
#include <string>
#include <vector>

#include <graze/graze.hpp>

/// A polygon with round corners, as a line of SVG, in which y points down.
std::string svg_of(const graze::Outline& outline, const char* color) {
  std::string points;
  for (const auto& corner : outline.core) points += std::to_string(corner.x) + "," + std::to_string(-corner.y) + " ";
  const std::string paint = "\" fill=\"" + std::string(color) + "\" stroke=\"" + color + "\" stroke-linejoin=\"round";
  return "<polygon points=\"" + points + paint + "\" stroke-width=\"" + std::to_string(2 * outline.radius) + "\"/>\n";
}

int main() {
  const graze::View<3> view = graze::isometric_view();
  const graze::Aabb<3, double> frame{{-4, -4, -4}, {4, 4, 4}};  // unbounded shapes are clipped to it

  const graze::HalfSpace<3> ground{{0, 0, 1}, 0};
  const graze::Ray<3> ray{{-9, 0, 1}, {1, 0, 0}};
  std::printf("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-8 -8 16 16\">\n");
  std::printf("%s", svg_of(graze::outline(graze::boundary(ground), view, frame), "lightgray").c_str());
  std::printf("%s", svg_of(graze::outline(graze::Capsule<3>{{0, 0, 1}, {0, 0, 3}, 1}, view), "orange").c_str());

  // Further points: a shadow, and where the ray crosses the frame.
  const std::vector<graze::Vec<3, double>> shadow = {{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {0, 1, 0}};
  std::printf("%s", svg_of(graze::outline_of_hull(graze::span_of(shadow), view), "gray").c_str());
  const auto piece = graze::cut(ray, frame);
  if (!piece) return 1;
  std::printf("%s",
              svg_of(graze::outline_of_hull<3>(std::vector{piece->start, piece->end}, view, 0.05), "red").c_str());

  const graze::Vec<2, double> label = graze::seen({3, 0, 0}, view);
  std::printf("<text x=\"%g\" y=\"%g\" font-size=\"1\">shadow</text>\n</svg>\n", label.x, -label.y);

  // Shapes nearer to the viewer are drawn later.
  const graze::Vec<3, double> eye = graze::to_viewer(view);
  const bool is_in_front = dot(eye, piece->end) > dot(eye, piece->start);
  const std::size_t corners = graze::cut(graze::boundary(ground), frame).size();
  return piece->start.x == -4 && piece->end.x == 4 && corners == 4 && is_in_front ? 0 : 1;
}
