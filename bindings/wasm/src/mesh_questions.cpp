// SPDX-License-Identifier: MIT
// Questions to a mesh that JavaScript holds, many at a time: the input has points or rays, the output the answers in
// their order.
#include <cstddef>
#include <optional>
#include <span>
#include <stdexcept>
#include <variant>
#include <vector>

#include <emscripten/bind.h>
#include <fmt/format.h>

#include <graze/broad/closest_points.hpp>
#include <graze/broad/pair.hpp>
#include <graze/broad/ray_casts.hpp>
#include <graze/broad/self_intersections.hpp>
#include <graze/broad/signed_distances.hpp>
#include <graze/broad/touching_faces.hpp>
#include <graze/broad/winding_numbers.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/mesh_hit.hpp>
#include <graze/shape/mesh.hpp>
#include <graze/shape/ray.hpp>

#include "bridge.hpp"
#include "meshes.hpp"
#include "results.hpp"

namespace graze::wasm {
namespace {

/// The points of the input. Throws std::invalid_argument for one that is not finite.
template <Dim N>
std::vector<Vec<N, double>> input_points(std::size_t count) {
  const std::span<const double> numbers = input<double>(count * static_cast<std::size_t>(N));
  std::vector<Vec<N, double>> points(count);
  for (std::size_t i = 0; i < count; ++i) {
    points[i] = vector_at<N>(numbers, i);
    if (!is_finite(points[i])) throw std::invalid_argument(fmt::format("points: point {} is not finite", i));
  }
  return points;
}

/// The rays of the input: origin, then direction.
template <Dim N>
std::vector<Ray<N, double>> input_rays(std::size_t count) {
  const std::span<const double> numbers = input<double>(2 * count * static_cast<std::size_t>(N));
  std::vector<Ray<N, double>> rays(count);
  for (std::size_t i = 0; i < count; ++i) {
    rays[i] = {vector_at<N>(numbers, 2 * i), vector_at<N>(numbers, 2 * i + 1)};
    if (const auto flaw = defect(rays[i]); !flaw.empty()) {
      throw std::invalid_argument(fmt::format("rays: ray {} {}", i, flaw));
    }
  }
  return rays;
}

/// Calls ask(mesh, points of the input) and puts the numbers that it returns.
template <class Ask>
void put_numbers(HeldMesh& self, std::size_t count, const Ask& ask) {
  std::visit(
      [&]<Dim N>(const Mesh<N, double>& mesh) {
        const std::vector<double> numbers = ask(mesh, input_points<N>(count));
        answer().assign(numbers.begin(), numbers.end());
      },
      self.mesh());
}

void put_winding_numbers(HeldMesh& self, std::size_t count) {
  put_numbers(self, count, [](const auto& mesh, const auto& points) { return winding_numbers(mesh, points); });
}

void put_signed_distances(HeldMesh& self, std::size_t count) {
  put_numbers(self, count, [](const auto& mesh, const auto& points) { return signed_distances(mesh, points); });
}

void put_closest_points(HeldMesh& self, std::size_t count) {
  std::visit(
      [&]<Dim N>(const Mesh<N, double>& mesh) {
        for (const Vec<N, double>& point : closest_points(mesh, input_points<N>(count))) put<N>(point);
      },
      self.mesh());
}

/// For each ray 1 and what put_mesh_hit puts, or 0.
void put_ray_casts(HeldMesh& self, std::size_t count) {
  std::visit(
      [&]<Dim N>(const Mesh<N, double>& mesh) {
        for (const std::optional<MeshHit<N, double>>& hit : ray_casts(mesh, input_rays<N>(count))) {
          answer().push_back(hit ? 1 : 0);
          if (hit) put_mesh_hit<N>(*hit);
        }
      },
      self.mesh());
}

void put_pairs(const std::vector<Pair>& pairs) {
  for (const Pair& pair : pairs) {
    answer().push_back(pair.a);
    answer().push_back(pair.b);
  }
}

/// The face of the one mesh and of the other.
void put_touching_faces(HeldMesh& self, HeldMesh& other) {
  std::visit([&]<Dim N>(const Mesh<N, double>& mesh) { put_pairs(touching_faces(mesh, held_mesh<N>(other.number()))); },
             self.mesh());
}

void put_self_intersections(HeldMesh& self) {
  std::visit([](const auto& mesh) { put_pairs(self_intersections(mesh)); }, self.mesh());
}

}  // namespace

EMSCRIPTEN_BINDINGS(graze_mesh_questions) {
  using namespace emscripten;  // NOLINT(google-build-using-namespace): as embind is written
  function("meshWindingNumbers", &Guarded<&put_winding_numbers>::call);
  function("meshSignedDistances", &Guarded<&put_signed_distances>::call);
  function("meshClosestPoints", &Guarded<&put_closest_points>::call);
  function("meshRayCasts", &Guarded<&put_ray_casts>::call);
  function("meshTouchingFaces", &Guarded<&put_touching_faces>::call);
  function("meshSelfIntersections", &Guarded<&put_self_intersections>::call);
}

}  // namespace graze::wasm
