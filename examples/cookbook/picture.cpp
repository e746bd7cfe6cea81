// SPDX-License-Identifier: MIT
#include "picture.hpp"

#include <cstdio>
#include <fstream>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <graze/io/svg.hpp>
#include <graze/query/bounds.hpp>

namespace cookbook {
namespace {

using namespace graze;

/// The layer of the lines that `connect` draws.
constexpr Layer ways = 63;

/// The same shape in double: exact, as every float is a double.
template <Dim N>
struct InDouble {
  using Wide = AnyShape<N, double>;

  static Vec<N, double> of(const Vec<N>& v) { return wide<N, float>(v); }

  Wide operator()(const Vec<N>& point) const { return of(point); }
  Wide operator()(const Segment<N>& segment) const { return Segment<N, double>{of(segment.start), of(segment.end)}; }
  Wide operator()(const Ray<N>& ray) const { return Ray<N, double>{of(ray.origin), of(ray.direction)}; }
  Wide operator()(const Sphere<N>& sphere) const { return Sphere<N, double>{of(sphere.center), sphere.radius}; }
  Wide operator()(const Aabb<N>& box) const { return Aabb<N, double>{of(box.min), of(box.max)}; }
  Wide operator()(const Obb<N>& box) const {
    return Obb<N, double>{of(box.center), of(box.half_extents), wide_matrix<N, float>(box.axes)};
  }
  Wide operator()(const Plane<N>& plane) const { return Plane<N, double>{of(plane.normal), plane.offset}; }
  Wide operator()(const HalfSpace<N>& solid) const { return HalfSpace<N, double>{of(solid.normal), solid.offset}; }
  Wide operator()(const Triangle<N>& triangle) const {
    return Triangle<N, double>{of(triangle.a), of(triangle.b), of(triangle.c)};
  }
  Wide operator()(const Capsule<N>& capsule) const {
    return Capsule<N, double>{of(capsule.a), of(capsule.b), capsule.radius};
  }
  Wide operator()(const Polytope<N>& polytope) const {
    std::vector<Vec<N, double>> vertices;
    for (const Vec<N>& vertex : polytope.vertices()) vertices.push_back(of(vertex));
    return convex_hull<N, double>(vertices);
  }
  Wide operator()(const Compound<N>& compound) const {
    std::vector<Wide> shapes;
    for (const Part<N>& part : compound.parts) shapes.push_back(std::visit(*this, part.shape));
    return compound_of<N, double>(std::move(shapes));
  }
};

}  // namespace

template <Dim N>
void Picture<N>::add(const AnyShape<N>& shape, const std::string& name, Layer group) {
  scene_.add(std::visit(InDouble<N>(), shape), {.name = name, .layer = group, .mask = only_layer(group)});
}

template <Dim N>
void Picture<N>::draw(const AnyShape<N>& shape, const std::string& name) {
  scene_.add(std::visit(InDouble<N>(), shape), {.name = name, .mask = 0});
}

template <Dim N>
void Picture<N>::connect(const Vec<N>& from, const Vec<N>& to, const std::string& name) {
  add(Segment<N>{from, to}, "", ways);
  add(to, name, ways);
}

template <Dim N>
int Picture<N>::save(int argc, char** argv) const {
  if (argc < 2) return 0;
  io::SceneFile file;
  file.scene = scene_;
  file.source = heading_;
  std::ofstream out(argv[1], std::ios::binary);
  io::write_svg(out, file, scene_.pairs());
  if (out.flush()) return 0;
  std::fprintf(stderr, "cannot write %s\n", argv[1]);
  return 1;
}

template class Picture<2>;
template class Picture<3>;

}  // namespace cookbook
