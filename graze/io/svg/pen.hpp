// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <graze/io/svg/frame.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/outline.hpp>

namespace graze::io::svg {

/// Writes SVG elements for geometry in view coordinates. Each call writes one element, with the class `style` unless
/// that is empty; an empty outline writes none.
class Pen {
 public:
  /// `mark_size` is the arm length of the cross that represents a point, in pixels.
  Pen(const Frame& frame, double mark_size) : frame_(frame), mark_size_(mark_size) {}

  /// A disc, polygon, rounded polygon, line or cross, according to the outline. Anything smaller than a tenth of a
  /// pixel becomes a dot of that size, so that nothing disappears.
  void outline(const Outline& outline, std::string_view style = {});

  /// An area bounded by closed paths, as one element; holes have the opposite orientation.
  void area(std::span<const std::vector<Vec<2, double>>> ways, std::string_view style = {});

  /// A cross of fixed size.
  void mark(const Vec<2, double>& point);

  void line(const Vec<2, double>& from, const Vec<2, double>& to, std::string_view style = "line");

  /// Many lines as one element: points 2i and 2i + 1 are the ends of line i. Writes nothing for no lines.
  void lines(std::span<const Vec<2, double>> ends, std::string_view style);

  /// A line with an arrowhead at `to`.
  void arrow(const Vec<2, double>& from, const Vec<2, double>& to);

  /// A rectangle along the edges of the picture.
  void rectangle(const Aabb<2, double>& box, std::string_view style = {});

  /// The number of elements written since `take`.
  std::size_t elements() const { return elements_; }

  /// Returns the elements written so far and clears the pen.
  std::string take();

 private:
  void disc(const Vec<2, double>& center, double radius, std::string_view style);
  void path(std::string_view data, std::string_view style);

  Frame frame_;
  double mark_size_;
  std::string svg_;
  std::size_t elements_ = 0;
};

}  // namespace graze::io::svg
