// SPDX-License-Identifier: MIT
// What meshes answer: alone, many questions at a time, and against each other.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <ostream>
#include <random>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <graze/broad/closest_points.hpp>
#include <graze/broad/pair.hpp>
#include <graze/broad/ray_casts.hpp>
#include <graze/broad/self_intersections.hpp>
#include <graze/broad/signed_distances.hpp>
#include <graze/broad/touching_faces.hpp>
#include <graze/broad/winding_numbers.hpp>
#include <graze/math/pose.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/distance.hpp>
#include <graze/query/mesh_hit.hpp>
#include <graze/query/relation.hpp>
#include <graze/shape/mesh.hpp>
#include <graze/shape/mesh_report.hpp>
#include <graze/shape/welded.hpp>

#include "answers.hpp"

namespace graze::test {
namespace {

using Faces = std::vector<std::array<std::uint32_t, 3>>;

template <Dim N>
using Points = std::vector<Vec<N, double>>;

/// Coordinates from -2 to 2, every third of them on a grid, so that some things touch or are equal.
class Draw {
 public:
  explicit Draw(std::uint32_t seed) : bits_(seed) {}

  std::uint32_t below(std::uint32_t count) { return static_cast<std::uint32_t>(bits_() % count); }
  double coordinate() { return below(3) == 0 ? below(9) / 2.0 - 2 : below(4000001) / 1e6 - 2; }

  template <Dim N>
  Vec<N, double> point() {
    Vec<N, double> point;
    for (Dim i = 0; i < N; ++i) point[i] = coordinate();
    return point;
  }

  template <Dim N>
  Points<N> points(std::size_t count) {
    Points<N> points(count);
    for (Vec<N, double>& each : points) each = point<N>();
    return points;
  }

 private:
  std::mt19937 bits_;
};

/// Faces anywhere: open, crossing each other, some flat or equal.
template <Dim N>
Mesh<N, double> soup(Draw& draw, MeshKind kind) {
  const Points<N> vertices = draw.points<N>(40);
  Faces faces(70);
  for (auto& face : faces) {
    for (std::uint32_t& vertex : face) vertex = draw.below(40);
  }
  return mesh_of<N, double>(vertices, faces, kind);
}

/// A closed surface of rings of corners at distances from 0.7 to 1 from an axis; in 2D a fan.
template <Dim N>
Mesh<N, double> ball(Draw& draw, MeshKind kind) {
  constexpr std::uint32_t around = 12;
  constexpr std::uint32_t rings = N == 2 ? 1 : 7;
  Points<N> vertices;
  Faces faces;
  for (std::uint32_t ring = 0; ring < rings; ++ring) {
    for (std::uint32_t i = 0; i < around; ++i) {
      const double angle = 2 * std::numbers::pi * i / around;
      const double reach = 0.7 + draw.below(1000) / 3333.0;
      Vec<N, double> corner(0.0);
      corner[0] = reach * std::cos(angle);
      corner[1] = reach * std::sin(angle);
      if constexpr (N == 3) corner[2] = (ring + 1.0) / (rings + 1) * 2 - 1;
      vertices.push_back(corner);
    }
  }
  const auto top = static_cast<std::uint32_t>(vertices.size());
  vertices.emplace_back(0.0);
  vertices.emplace_back(0.0);
  vertices[top][N - 1] = N == 2 ? 0 : 1;
  vertices[top + 1][N - 1] = N == 2 ? 0 : -1;
  for (std::uint32_t i = 0; i < around; ++i) {
    const std::uint32_t next = (i + 1) % around;
    const std::uint32_t last = (rings - 1) * around;
    faces.push_back({top, last + i, last + next});
    if (N == 3) faces.push_back({top + 1, next, i});
    for (std::uint32_t ring = 0; ring + 1 < rings; ++ring) {
      const std::uint32_t low = ring * around;
      const std::uint32_t high = low + around;
      faces.push_back({low + i, low + next, high + i});
      faces.push_back({low + next, high + next, high + i});
    }
  }
  return mesh_of<N, double>(vertices, faces, kind);
}

std::string pair_list(const std::vector<Pair>& pairs) {
  Numbers out;
  for (const Pair& pair : pairs) {
    out.put(pair.a);
    out.put(pair.b);
  }
  return out.list();
}

std::string number_list(const std::vector<double>& numbers) {
  Numbers out;
  for (const double number : numbers) out.put(number);
  return out.list();
}

template <Dim N>
std::string point_list(std::span<const Vec<N, double>> points) {
  Numbers out;
  for (const Vec<N, double>& point : points) out.put<N>(point);
  return out.list();
}

template <Dim N>
std::string ray_list(const std::vector<Ray<N, double>>& rays) {
  Numbers out;
  for (const Ray<N, double>& ray : rays) {
    out.put<N>(ray.origin);
    out.put<N>(ray.direction);
  }
  return out.list();
}

/// For each ray t, and for a hit its point, normal, error, face (-1 for none) and barycentric coordinates.
template <Dim N>
std::string hit_list(const std::vector<std::optional<MeshHit<N, double>>>& hits) {
  Numbers out;
  for (const auto& hit : hits) {
    if (!hit) {
      out.put(std::numeric_limits<double>::infinity());
      continue;
    }
    put_hit<N>(*hit, out);
    out.put(hit->face == no_face ? -1 : static_cast<double>(hit->face));
    out.put<3>(hit->barycentric);
  }
  return out.list();
}

std::string report_list(const MeshReport& found) {
  Numbers out;
  for (const std::size_t count :
       {found.open_edges, found.non_manifold_edges, found.flipped_edges, found.degenerate_faces, found.duplicate_faces,
        found.unused_vertices, found.components, std::size_t{found.is_closed ? 1U : 0U}}) {
    out.put(static_cast<double>(count));
  }
  return out.list();
}

/// The numbers of a pose: a position, then an angle or a quaternion.
template <Dim N>
std::vector<double> draw_pose(Draw& draw) {
  std::vector<double> numbers(N == 2 ? 3 : 7);
  for (double& number : numbers) number = draw.coordinate() + 0.0625;
  return numbers;
}

template <Dim N>
Pose<N, double> pose_of(const std::vector<double>& numbers) {
  if constexpr (N == 2) {
    return Pose<2, double>::from_angle({numbers[0], numbers[1]}, numbers[2]);
  } else {
    const Vec<4, double> quaternion(numbers[3], numbers[4], numbers[5], numbers[6]);
    return Pose<3, double>::from_quaternion({numbers[0], numbers[1], numbers[2]}, quaternion);
  }
}

template <Dim N>
std::vector<Ray<N, double>> draw_rays(Draw& draw) {
  std::vector<Ray<N, double>> rays;
  while (rays.size() < 60) {
    const Ray<N, double> ray{draw.point<N>(), draw.point<N>()};
    if (defect(ray).empty()) rays.push_back(ray);
  }
  return rays;
}

/// Two meshes, the second of which is placed by a pose, and all answers about them.
template <Dim N>
std::string answers_about(const Mesh<N, double>& mesh, const Mesh<N, double>& unplaced, Draw& draw) {
  const Points<N> points = draw.points<N>(60);
  const std::vector<Ray<N, double>> rays = draw_rays<N>(draw);
  const std::vector<double> pose = draw_pose<N>(draw);
  const Mesh<N, double> other = transformed(unplaced, pose_of<N>(pose));
  const Points<N> places = draw.points<N>(mesh.vertices().size());
  const Mesh<N, double> changed = moved(mesh, places);
  const Mesh<N, double> whole = welded(changed);
  Numbers pair;
  pair.put(static_cast<double>(relation(mesh, other)));
  pair.put(distance(mesh, other));
  if (const auto found = contact(mesh, other)) {
    pair.put<N>(found->point);
    pair.put<N>(found->normal);
    pair.put(found->depth);
  }
  const std::vector<std::string> fields = {
      fmt::format("\"mesh\": {}", text_of<N>(mesh)),
      fmt::format("\"other\": {}", text_of<N>(unplaced)),
      fmt::format("\"points\": {}", point_list<N>(points)),
      fmt::format("\"rays\": {}", ray_list<N>(rays)),
      fmt::format("\"pose\": {}", number_list(pose)),
      fmt::format("\"places\": {}", point_list<N>(places)),
      fmt::format("\"report\": {}", report_list(report(mesh))),
      fmt::format("\"windings\": {}", number_list(winding_numbers(mesh, points))),
      fmt::format("\"distances\": {}", number_list(signed_distances(mesh, points))),
      fmt::format("\"closest\": {}", point_list<N>(closest_points(mesh, points))),
      fmt::format("\"hits\": {}", hit_list<N>(ray_casts(mesh, rays))),
      fmt::format("\"crossings\": {}", pair_list(self_intersections(mesh))),
      fmt::format("\"touching\": {}", pair_list(touching_faces(mesh, other))),
      fmt::format("\"pair\": {}", pair.list()),
      fmt::format("\"placed\": {}", point_list<N>(other.vertices())),
      fmt::format("\"changedClosest\": {}", point_list<N>(closest_points(changed, points))),
      fmt::format("\"welded\": {}", text_of<N>(whole)),
  };
  return fmt::format("{{{}}}", fmt::join(fields, ", "));
}

}  // namespace

template <Dim N>
void write_meshes(std::ostream& out) {
  Draw draw(20261129);
  for (int round = 0; round < 24; ++round) {
    const MeshKind kind = round % 2 == 0 ? MeshKind::surface : MeshKind::solid;
    const Mesh<N, double> mesh = round % 3 == 0 ? soup<N>(draw, kind) : ball<N>(draw, kind);
    const Mesh<N, double> other = round % 4 == 0 ? soup<N>(draw, kind) : ball<N>(draw, kind);
    out << answers_about<N>(mesh, other, draw) << '\n';
  }
}

template void write_meshes<2>(std::ostream&);
template void write_meshes<3>(std::ostream&);

}  // namespace graze::test
