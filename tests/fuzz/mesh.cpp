// SPDX-License-Identifier: MIT
// Meshes of any vertices and faces. mesh_of refuses coordinates that are not finite and indices of no vertex, and
// nothing else. A surface answers as the compound of its faces, bit for bit; moved and welded meshes answer as new
// ones; a solid contains its surface, and is whole numbers of times around a point if it is closed.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <ostream>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include <graze/broad/self_intersections.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/closest_point.hpp>
#include <graze/query/contains.hpp>
#include <graze/query/ray_cast.hpp>
#include <graze/query/relation.hpp>
#include <graze/query/winding_number.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/mesh.hpp>
#include <graze/shape/mesh_report.hpp>
#include <graze/shape/welded.hpp>

#include "catalogue.hpp"
#include "fuzz/input.hpp"
#include "fuzz/require.hpp"
#include "fuzz/shapes.hpp"
#include "parts_of.hpp"
#include "query/same_answers.hpp"

using namespace graze;
constexpr Dim N = GRAZE_FUZZ_DIMENSION;
using T = GRAZE_FUZZ_SCALAR;
using Any = AnyShape<N, T>;
using Point = Vec<N, T>;
using Face = std::array<std::uint32_t, 3>;

namespace {

/// Points to start with, and a row of more: enough faces for a tree of several nodes.
std::vector<Point> vertices_of(test::fuzz::Input& input) {
  std::vector<Point> vertices = test::fuzz::points<N, T>(input, 12);
  const Point way = input.vec<N, T>();
  for (std::size_t count = input.below(40); count > 0; --count) {
    vertices.push_back(vertices[count % vertices.size()] + way * static_cast<T>(input.below(5)));
  }
  return vertices;
}

/// Any, or also closed tetrahedra; sometimes one that has no meaning.
std::vector<Face> faces_of(test::fuzz::Input& input, std::size_t vertices) {
  std::vector<Face> faces(input.below(64));
  for (Face& face : faces) {
    for (std::uint32_t& vertex : face) vertex = static_cast<std::uint32_t>(input.below(vertices));
  }
  const auto corners = static_cast<std::uint32_t>(4 * input.below(vertices / 4 + 1));
  for (std::uint32_t a = 0; a < corners; a += 4) {
    for (const Face& face : {Face{0, 2, 1}, Face{0, 1, 3}, Face{1, 2, 3}, Face{2, 0, 3}}) {
      faces.push_back({a + face[0], a + face[1], a + face[2]});
    }
    if (input.byte() % 2 == 0) break;
  }
  const std::size_t spoilt = input.byte();
  if (spoilt < faces.size()) faces[spoilt][1] = static_cast<std::uint32_t>(vertices + input.byte());
  return faces;
}

/// What is asked of a mesh: a shape that it may touch, a point, and a ray if the way has a direction.
struct Question {
  Any other;
  Point point;
  Point way;
  bool is_judged = false;  ///< Whether queries guarantee results.
};

void require_same_answers(std::string_view law, const Any& a, const Any& b, const Question& asked) {
  const auto say = [&](std::ostream& out) {
    out << law << ": " << test::to_source<N, T>(a) << ", " << test::to_source<N, T>(asked.other) << ", "
        << test::initializer(asked.point) << ", " << test::initializer(asked.way);
  };
  const Point nearest = closest_point(a, asked.point);
  const bool is_same_ray = max_abs(asked.way) == T(0) || ray_cast(a, Ray<N, T>{asked.point, asked.way}) ==
                                                             ray_cast(b, Ray<N, T>{asked.point, asked.way});
  if (!asked.is_judged) return;
  test::fuzz::require(test::same_point<N, T>(nearest, closest_point(b, asked.point)), say);
  test::fuzz::require(contains(a, asked.point) == contains(b, asked.point), say);
  test::fuzz::require(relation(a, asked.other) == relation(b, asked.other), say);
  test::fuzz::require(is_same_ray, say);
}

/// Of a solid in 3D; in 2D it contains what a surface does.
[[maybe_unused]] void require_inside(const Mesh<N, T>& surface, const Mesh<N, T>& solid, const Question& asked) {
  const auto say = [&](std::ostream& out) {
    out << "winding number " << winding_number(solid, asked.point) << ": " << test::to_source(solid) << ", "
        << test::initializer(asked.point);
  };
  const double turns = winding_number(solid, asked.point);
  if (!asked.is_judged) return;
  const bool is_held = contains(Any(solid), asked.point);
  test::fuzz::require(is_held || !contains(Any(surface), asked.point), say);
  test::fuzz::require(is_held == (turns > 0.5 || contains(Any(surface), asked.point)), say);
  if (report(solid).is_closed) test::fuzz::require(turns == std::round(turns), say);
}

void check(test::fuzz::Input& input, const std::vector<Point>& vertices, const std::vector<Face>& faces) {
  const auto surface = mesh_of<N, T>(vertices, faces);
  const auto solid = mesh_of<N, T>(vertices, faces, MeshKind::solid);
  Question asked{test::fuzz::any_shape<N, T>(input, 0), input.vec<N, T>(), input.vec<N, T>()};
  if (!is_valid(asked.other) || !is_finite(asked.point) || !is_finite(asked.way)) return;
  std::vector<Point> others = vertices;
  for (Point& other : others) other += asked.way * static_cast<T>(input.below(3));
  const bool is_movable = std::all_of(others.begin(), others.end(), [](const Point& at) { return is_finite(at); });
  asked.is_judged = input.is_in_range() && !test::is_union<N, T>(asked.other);

  require_same_answers("the compound of its faces", surface, test::as_compound(surface), asked);
  require_same_answers("welded", surface, welded(surface), asked);
  if (is_movable) {
    require_same_answers("moved", moved(surface, others), mesh_of<N, T>(others, faces), asked);
    require_same_answers("a moved solid", moved(solid, others), mesh_of<N, T>(others, faces, MeshKind::solid), asked);
  }
  if constexpr (N == 3) require_inside(surface, solid, asked);
  for (const Pair& pair : self_intersections(surface)) {
    test::fuzz::require(pair.a < pair.b && pair.b < faces.size(), [&](std::ostream& out) {
      out << "faces " << pair.a << " and " << pair.b << " of " << faces.size();
    });
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  test::fuzz::Input input(data, size);
  const std::vector<Point> vertices = vertices_of(input);
  const std::vector<Face> faces = faces_of(input, vertices.size());
  const bool is_sound =
      std::all_of(vertices.begin(), vertices.end(), [](const Point& vertex) { return is_finite(vertex); }) &&
      std::all_of(faces.begin(), faces.end(),
                  [&](const Face& face) { return *std::max_element(face.begin(), face.end()) < vertices.size(); });
  bool is_accepted = true;
  try {
    (void)mesh_of<N, T>(vertices, faces);
  } catch (const std::invalid_argument&) {
    is_accepted = false;
  }
  test::fuzz::require(is_accepted == is_sound, [&](std::ostream& out) {
    out << vertices.size() << " vertices and " << faces.size() << " faces were "
        << (is_accepted ? "accepted" : "rejected");
  });
  if (is_sound) check(input, vertices, faces);
  return 0;
}
