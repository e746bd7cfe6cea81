// SPDX-License-Identifier: MIT
// The pictures that the programs of the cookbook draw of what they calculate.
#pragma once

#include <string>
#include <utility>

#include <graze/math/vec.hpp>
#include <graze/scene/scene.hpp>
#include <graze/shape/any_shape.hpp>

namespace cookbook {

/// Shapes with names, in double because pictures are drawn of scenes in double. Names are unique; an empty one is not
/// shown.
template <graze::Dim N>
class Picture {
 public:
  explicit Picture(std::string heading) : heading_(std::move(heading)) {}

  /// Adds a shape that is highlighted, with its partner, if it touches another one of the same group.
  void add(const graze::AnyShape<N>& shape, const std::string& name = "", graze::Layer group = 0);

  /// Adds a shape that is only drawn.
  void draw(const graze::AnyShape<N>& shape, const std::string& name = "");

  /// Draws the way from a point to an answer, both highlighted.
  void connect(const graze::Vec<N>& from, const graze::Vec<N>& to, const std::string& name = "");

  /// Writes the picture to the file that the first argument names, if there is one. Returns the program's exit status.
  int save(int argc, char** argv) const;

 private:
  std::string heading_;
  graze::Scene<N, double> scene_;
};

extern template class Picture<2>;
extern template class Picture<3>;

}  // namespace cookbook
