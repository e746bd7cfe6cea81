// SPDX-License-Identifier: MIT
// The pictures that the programs of the cookbook draw of their results.
#pragma once

#include <string>
#include <utility>

#include <graze/math/vec.hpp>
#include <graze/scene/scene.hpp>
#include <graze/shape/any_shape.hpp>

namespace cookbook {

/// Named shapes, in double because scenes for pictures are in double. Names must be unique; an empty name is not shown.
template <graze::Dim N>
class Picture {
 public:
  explicit Picture(std::string heading) : heading_(std::move(heading)) {}

  /// Adds a shape. If it touches another one added this way, both are highlighted.
  void add(const graze::AnyShape<N>& shape, const std::string& name = "", graze::Layer group = 0);

  /// Adds a shape that is only drawn.
  void draw(const graze::AnyShape<N>& shape, const std::string& name = "");

  /// Draws the line from a point to an answer, both highlighted.
  void connect(const graze::Vec<N>& from, const graze::Vec<N>& to, const std::string& name = "");

  /// Writes the picture to the file named by the first argument, if any. Returns the program's exit status.
  int save(int argc, char** argv) const;

 private:
  std::string heading_;
  graze::Scene<N, double> scene_;
};

extern template class Picture<2>;
extern template class Picture<3>;

}  // namespace cookbook
