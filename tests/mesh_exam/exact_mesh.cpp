// SPDX-License-Identifier: MIT
#include "exact_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <random>
#include <span>
#include <vector>

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <boost/variant/get.hpp>

namespace graze::mesh_exam {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Number = Kernel::FT;
using Corner = Kernel::Point_3;
using Way = Kernel::Vector_3;
using Segment = Kernel::Segment_3;
using Triangle = Kernel::Triangle_3;
using Ray = Kernel::Ray_3;
using Triangles = std::vector<Triangle>;
using Tree =
    CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>>>;
using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::size_t>;

Corner corner_of(const Point& point) { return {point.x, point.y, point.z}; }
Way way_of(const Point& way) { return {way.x, way.y, way.z}; }

/// Of three collinear points, between the two that are farthest apart.
Segment longest_side(const Corner& a, const Corner& b, const Corner& c) {
  Segment longest(a, b);
  for (const Segment& side : {Segment(b, c), Segment(c, a)}) {
    if (side.squared_length() > longest.squared_length()) longest = side;
  }
  return longest;
}

}  // namespace

struct ExactMesh::Exact {
  std::vector<Corner> corners;
  std::vector<Face> faces;
  Triangles triangles;
  std::vector<std::size_t> face_of_triangle;
  std::vector<Segment> segments;
  std::vector<std::size_t> face_of_segment;
  std::vector<Box> boxes;
  std::unique_ptr<Tree> tree;

  Triangle triangle(std::size_t face) const {
    const auto& [a, b, c] = faces[face];
    return {corners[a], corners[b], corners[c]};
  }

  /// By test(triangle or segment).
  template <class Test>
  auto with_face(std::size_t face, const Test& test) const {
    const Triangle whole = triangle(face);
    if (!whole.is_degenerate()) return test(whole);
    return test(longest_side(whole[0], whole[1], whole[2]));
  }

  bool do_meet(std::size_t face, const Exact& other, std::size_t other_face) const {
    return with_face(face, [&](const auto& a) {
      return other.with_face(other_face, [&a](const auto& b) { return CGAL::do_intersect(a, b); });
    });
  }

  /// For faces with one common vertex: whether the side opposite to it meets the other face.
  bool do_cross_beside(std::size_t face, std::size_t other_face, std::uint32_t common) const {
    const auto opposite_side_meets = [&](std::size_t of, std::size_t with) {
      const auto place =
          static_cast<std::size_t>(std::find(faces[of].begin(), faces[of].end(), common) - faces[of].begin());
      return CGAL::do_intersect(Segment(corners[faces[of][(place + 1) % 3]], corners[faces[of][(place + 2) % 3]]),
                                triangle(with));
    };
    return opposite_side_meets(face, other_face) || opposite_side_meets(other_face, face);
  }

  std::vector<std::uint32_t> common_vertices(std::size_t face, std::size_t other_face) const {
    std::vector<std::uint32_t> common;
    for (const std::uint32_t vertex : faces[face]) {
      const Face& others = faces[other_face];
      if (std::find(others.begin(), others.end(), vertex) != others.end()) common.push_back(vertex);
    }
    return common;
  }
};

ExactMesh::ExactMesh(std::span<const Point> vertices, std::span<const Face> faces) : exact_(std::make_unique<Exact>()) {
  Exact& exact = *exact_;
  for (const Point& vertex : vertices) exact.corners.push_back(corner_of(vertex));
  exact.faces.assign(faces.begin(), faces.end());
  for (std::size_t face = 0; face < faces.size(); ++face) {
    const Triangle triangle = exact.triangle(face);
    if (triangle.is_degenerate()) {
      exact.segments.push_back(longest_side(triangle[0], triangle[1], triangle[2]));
      exact.face_of_segment.push_back(face);
    } else {
      exact.triangles.push_back(triangle);
      exact.face_of_triangle.push_back(face);
    }
    exact.boxes.emplace_back(triangle.bbox(), face);
  }
  exact.tree = std::make_unique<Tree>(exact.triangles.begin(), exact.triangles.end());
  if (!exact.triangles.empty()) exact.tree->accelerate_distance_queries();
}

ExactMesh::~ExactMesh() = default;

std::optional<ExactHit> ExactMesh::first_hit(const Point& origin, const Point& direction) const {
  const Corner from = corner_of(origin);
  const Way way = way_of(direction);
  const Ray ray(from, way);
  const Number squared_way = way.squared_length();
  std::optional<Number> first;
  double sine = 0;
  const auto add = [&](const Corner& point, double sine_there) {
    const Number t = std::max(Number(0), Number((point - from) * way / squared_way));
    if (!first || t < *first) {
      first = t;
      sine = sine_there;
    } else if (t == *first) {
      sine = std::max(sine, sine_there);
    }
  };
  // CGAL 5.5 does not cut off what lies behind the origin of a ray in the plane of the triangle.
  const auto add_all = [&](const auto& common, double sine_there) {
    if (const Corner* point = boost::get<Corner>(&common)) add(*point, sine_there);
    if (const Segment* segment = boost::get<Segment>(&common)) {
      add(segment->source(), 0);
      add(segment->target(), 0);
    }
  };
  std::vector<Tree::Intersection_and_primitive_id<Ray>::Type> found;
  if (!exact_->triangles.empty()) exact_->tree->all_intersections(ray, std::back_inserter(found));
  for (const auto& [common, triangle] : found) {
    const Way normal = CGAL::normal((*triangle)[0], (*triangle)[1], (*triangle)[2]);
    const double cosine = std::fabs(CGAL::to_double(normal * way));
    add_all(common, cosine / std::sqrt(CGAL::to_double(normal.squared_length() * squared_way)));
  }
  for (const Segment& segment : exact_->segments) {
    if (const auto common = CGAL::intersection(ray, segment)) add_all(*common, 1);
  }
  if (!first) return std::nullopt;
  return ExactHit{CGAL::to_double(*first), sine};
}

double ExactMesh::distance_on_ray(const Point& origin, const Point& direction, double t, std::size_t face) const {
  const Corner point = corner_of(origin) + Number(t) * way_of(direction);
  return exact_->with_face(
      face, [&point](const auto& set) { return std::sqrt(CGAL::to_double(CGAL::squared_distance(point, set))); });
}

double ExactMesh::distance(const Point& point) const {
  const Corner from = corner_of(point);
  std::optional<Number> least;
  if (!exact_->triangles.empty()) least = exact_->tree->squared_distance(from);
  for (const Segment& segment : exact_->segments) {
    const Number squared = CGAL::squared_distance(from, segment);
    if (!least || squared < *least) least = squared;
  }
  return least ? std::sqrt(CGAL::to_double(*least)) : std::numeric_limits<double>::infinity();
}

std::optional<int> ExactMesh::winding_number(const Point& point) const {
  if (exact_->triangles.empty()) return 0;
  const Corner from = corner_of(point);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  std::vector<Tree::Primitive_id> met;
  for (;;) {
    const Way way(coordinate(random), coordinate(random), coordinate(random));
    met.clear();
    exact_->tree->all_intersected_primitives(Ray(from, way), std::back_inserter(met));
    int turns = 0;
    bool is_generic = true;
    const Corner ahead = from + way;
    for (const Tree::Primitive_id triangle : met) {
      const Corner a = (*triangle)[0];
      const Corner b = (*triangle)[1];
      const Corner c = (*triangle)[2];
      const auto side = CGAL::orientation(a, b, c, from);
      if (side == CGAL::COPLANAR && triangle->has_on(from)) return std::nullopt;
      const auto turn = CGAL::orientation(from, ahead, a, b);
      is_generic = is_generic && side != CGAL::COPLANAR && turn != CGAL::COPLANAR &&
                   turn == CGAL::orientation(from, ahead, b, c) && turn == CGAL::orientation(from, ahead, c, a);
      turns += side == CGAL::NEGATIVE ? 1 : -1;  // out of the mesh, or into it
    }
    if (is_generic) return turns;
  }
}

std::vector<Pair> ExactMesh::pairs_with(const ExactMesh& other) const {
  std::vector<Pair> pairs;
  std::vector<Box> boxes = exact_->boxes;
  std::vector<Box> others = other.exact_->boxes;
  CGAL::box_intersection_d(boxes.begin(), boxes.end(), others.begin(), others.end(), [&](const Box& a, const Box& b) {
    if (!exact_->do_meet(a.info(), *other.exact_, b.info())) return;
    pairs.push_back({static_cast<std::uint32_t>(a.info()), static_cast<std::uint32_t>(b.info())});
  });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

bool ExactMesh::decides(const Pair& pair) const {
  if (exact_->triangle(pair.a).is_degenerate() || exact_->triangle(pair.b).is_degenerate()) return false;
  return exact_->common_vertices(pair.a, pair.b).size() < 2;
}

std::vector<Pair> ExactMesh::own_pairs() const {
  std::vector<Pair> pairs;
  std::vector<Box> boxes = exact_->boxes;
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
    const Pair pair{static_cast<std::uint32_t>(std::min(a.info(), b.info())),
                    static_cast<std::uint32_t>(std::max(a.info(), b.info()))};
    if (!decides(pair)) return;
    const auto common = exact_->common_vertices(pair.a, pair.b);
    const bool do_cross = common.empty() ? exact_->do_meet(pair.a, *exact_, pair.b)
                                         : exact_->do_cross_beside(pair.a, pair.b, common.front());
    if (do_cross) pairs.push_back(pair);
  });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace graze::mesh_exam
