// SPDX-License-Identifier: MIT
// How answers.cpp and the other files beside it write numbers and shapes.
#pragma once

#include <cmath>
#include <ostream>
#include <string>

#include <fmt/format.h>

#include <graze/io/json/shape_writer.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/manifold.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze::test {

/// Numbers as JSON that parse to the same bits; numbers that JSON cannot represent as text.
class Numbers {
 public:
  void put(double number) {
    text_ += text_.empty() ? "" : ", ";
    if (std::isnan(number)) {
      text_ += "\"NaN\"";
    } else if (std::isinf(number)) {
      text_ += number > 0 ? "\"Infinity\"" : "\"-Infinity\"";
    } else {
      text_ += number == 0 && std::signbit(number) ? std::string("-0.0") : fmt::format("{}", number);
    }
  }

  template <Dim N, class T>
  void put(const Vec<N, T>& vector) {
    for (Dim i = 0; i < N; ++i) put(static_cast<double>(vector[i]));
  }

  template <Dim N, class T>
  void put(const Aabb<N, T>& box) {
    put<N>(box.min);
    put<N>(box.max);
  }

  std::string list() const { return '[' + text_ + ']'; }

 private:
  std::string text_;
};

/// t, point, normal and error of a RayHit or an Impact.
template <Dim N, class Hit>
void put_hit(const Hit& hit, Numbers& out) {
  out.put(hit.t);
  out.put<N>(hit.point);
  out.put<N>(hit.normal);
  out.put(hit.error);
}

template <Dim N, class T>
void put_manifold(const Manifold<N, T>& manifold, Numbers& out) {
  out.put<N>(manifold.normal);
  out.put(manifold.error);
  for (const ManifoldPoint<N, T>& point : manifold.contacts()) {
    out.put<N>(point.point);
    out.put<N>(point.point_a);
    out.put<N>(point.point_b);
    out.put(point.depth);
    for (const Feature& feature : {point.id.a, point.id.b}) {
      out.put(static_cast<double>(feature.kind));
      out.put(feature.index);
    }
    out.put(point.id.part_a);
    out.put(point.id.part_b);
  }
}

template <Dim N>
std::string text_of(const AnyShape<N, double>& shape) {
  std::string text = "{";
  io::append_json_shape<N>(text, shape);
  return text + '}';
}

/// A scene, and what its queries answer about shapes that touch its objects or move through it.
template <Dim N>
void write_scene(std::ostream& out);

/// A line for each two meshes: both, points, rays and a pose, and all answers about them.
template <Dim N>
void write_meshes(std::ostream& out);

}  // namespace graze::test
