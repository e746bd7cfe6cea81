// SPDX-License-Identifier: MIT
// A mesh in exact numbers, judged by CGAL: faces without area are segments.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <graze/broad/pair.hpp>
#include <graze/math/vec.hpp>

namespace graze::mesh_exam {

using Point = Vec<3, double>;
using Face = std::array<std::uint32_t, 3>;

/// Where a ray first meets a mesh.
struct ExactHit {
  double t;
  double sine;  ///< Of the angle between the ray and the face, the greatest of the faces met there.
};

/// Answers without rounding errors, but for the last step to double.
class ExactMesh {
 public:
  ExactMesh(std::span<const Point> vertices, std::span<const Face> faces);
  ~ExactMesh();
  ExactMesh(const ExactMesh&) = delete;
  ExactMesh& operator=(const ExactMesh&) = delete;

  std::optional<ExactHit> first_hit(const Point& origin, const Point& direction) const;
  /// The distance from origin + t * direction to a face.
  double distance_on_ray(const Point& origin, const Point& direction, double t, std::size_t face) const;
  double distance(const Point& point) const;
  /// Counted along a random ray that meets no edge; nothing for points on a face. The mesh must be closed.
  std::optional<int> winding_number(const Point& point) const;
  /// The faces that share a point with those of another mesh, ascending.
  std::vector<Pair> pairs_with(const ExactMesh& other) const;
  /// The pairs of faces with area that have at most one vertex in common and share more than that, ascending.
  std::vector<Pair> own_pairs() const;
  /// Whether own_pairs() decides about two faces.
  bool decides(const Pair& pair) const;

 private:
  struct Exact;
  std::unique_ptr<Exact> exact_;
};

}  // namespace graze::mesh_exam
