// SPDX-License-Identifier: MIT
#include "meshes.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

#include <emscripten/bind.h>
#include <fmt/format.h>

#include <graze/shape/mesh.hpp>
#include <graze/shape/mesh/open_edges.hpp>
#include <graze/shape/mesh_report.hpp>
#include <graze/shape/welded.hpp>

#include "bridge.hpp"
#include "poses.hpp"

namespace graze::wasm {
namespace {

/// By number; their meshes share triangles with them.
std::unordered_map<std::uint32_t, AnyMesh> held_meshes;
std::uint32_t next_number = 0;

/// A mesh in a new handle.
template <Dim N>
HeldMesh* held(Mesh<N, double> mesh) {
  return std::make_unique<HeldMesh>(std::move(mesh)).release();  // embind owns it
}

/// Vertex or point `i` of the input, for each of them.
template <Dim N>
std::vector<Vec<N, double>> vectors_of(std::span<const double> numbers) {
  std::vector<Vec<N, double>> vectors(numbers.size() / static_cast<std::size_t>(N));
  for (std::size_t i = 0; i < vectors.size(); ++i) vectors[i] = vector_at<N>(numbers, i);
  return vectors;
}

std::vector<std::array<std::uint32_t, 3>> faces_of(std::span<const double> numbers) {
  constexpr double too_large = 4294967296;  // 2^32
  std::vector<std::array<std::uint32_t, 3>> faces(numbers.size() / 3);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const double number = numbers[i];
    if (!(number >= 0 && number < too_large && number == std::floor(number))) {
      throw std::invalid_argument(
          fmt::format("faces: face {} has {}, which is not the index of a vertex", i / 3, number));
    }
    faces[i / 3][i % 3] = static_cast<std::uint32_t>(number);
  }
  return faces;
}

/// The input has the coordinates of vertices, then three indices for each face.
HeldMesh* make_mesh(int dimension, std::size_t vertices, std::size_t faces, bool is_solid) {
  return in_dimension(dimension, [&](auto n) {
    const std::size_t coordinates = vertices * static_cast<std::size_t>(n());
    const std::span<const double> numbers = input<double>(coordinates + 3 * faces);
    const MeshKind kind = is_solid ? MeshKind::solid : MeshKind::surface;
    return held<n>(
        mesh_of<n, double>(vectors_of<n>(numbers.first(coordinates)), faces_of(numbers.subspan(coordinates)), kind));
  });
}

double number_of(HeldMesh& self) { return self.number(); }

int dimension_of_mesh(HeldMesh& self) {
  return std::visit([]<Dim N>(const Mesh<N, double>&) { return static_cast<int>(N); }, self.mesh());
}

bool is_solid(HeldMesh& self) {
  return std::visit([](const auto& mesh) { return mesh.kind() == MeshKind::solid; }, self.mesh());
}

double count_of_vertices(HeldMesh& self) {
  return std::visit([](const auto& mesh) { return static_cast<double>(mesh.vertices().size()); }, self.mesh());
}

double count_of_faces(HeldMesh& self) {
  return std::visit([](const auto& mesh) { return static_cast<double>(mesh.faces().size()); }, self.mesh());
}

void put_vertices(HeldMesh& self) {
  std::visit(
      []<Dim N>(const Mesh<N, double>& mesh) {
        for (const auto& vertex : mesh.vertices()) put<N>(vertex);
      },
      self.mesh());
}

void put_faces(HeldMesh& self) {
  std::visit(
      [](const auto& mesh) {
        for (const auto& face : mesh.faces()) answer().insert(answer().end(), face.begin(), face.end());
      },
      self.mesh());
}

/// In the order of js/meshes.js.
void report_of(HeldMesh& self) {
  const MeshReport found = std::visit([](const auto& mesh) { return report(mesh); }, self.mesh());
  for (const std::size_t count :
       {found.open_edges, found.non_manifold_edges, found.flipped_edges, found.degenerate_faces, found.duplicate_faces,
        found.unused_vertices, found.components}) {
    answer().push_back(static_cast<double>(count));
  }
  answer().push_back(found.is_closed ? 1 : 0);
}

/// In the order of js/meshes.js.
enum class EdgeFault { open, non_manifold, flipped };

/// The two vertices of each edge that `report` counts as open, non-manifold or flipped.
void put_edges(HeldMesh& self, int fault) {
  const auto uses = std::visit([](const auto& mesh) { return detail::sorted_edge_uses(mesh.faces()); }, self.mesh());
  detail::for_each_edge(uses, [fault](std::span<const detail::EdgeUse> edge) {
    const bool is_one_way = edge.size() == 2 && edge[0].way == edge[1].way;
    const bool is_wanted = fault == static_cast<int>(EdgeFault::open)           ? edge.size() == 1
                           : fault == static_cast<int>(EdgeFault::non_manifold) ? edge.size() > 2
                                                                                : is_one_way;
    if (is_wanted) answer().insert(answer().end(), {double(edge[0].from), double(edge[0].to)});
  });
}

HeldMesh* welded_copy(HeldMesh& self) {
  return std::visit([]<Dim N>(const Mesh<N, double>& mesh) { return held<N>(welded(mesh)); }, self.mesh());
}

/// The input has as many vertices, anywhere.
HeldMesh* moved_copy(HeldMesh& self, std::size_t vertices) {
  return std::visit(
      [&]<Dim N>(const Mesh<N, double>& mesh) {
        return held<N>(moved(mesh, vectors_of<N>(input<double>(vertices * static_cast<std::size_t>(N)))));
      },
      self.mesh());
}

/// The input has one pose.
HeldMesh* posed_copy(HeldMesh& self) {
  return std::visit(
      []<Dim N>(const Mesh<N, double>& mesh) {
        return held<N>(transformed(mesh, pose_at<N>(input<double>(numbers_in_pose<N>), 0)));
      },
      self.mesh());
}

}  // namespace

HeldMesh::HeldMesh(AnyMesh mesh) : mesh_(std::move(mesh)), number_(next_number) {
  // Numbers may run around after four billion meshes; those in use are skipped.
  while (held_meshes.contains(number_)) ++number_;
  held_meshes.emplace(number_, mesh_);
  next_number = number_ + 1;
}

HeldMesh::~HeldMesh() { held_meshes.erase(number_); }

template <Dim N>
Mesh<N, double> held_mesh(std::uint32_t number) {
  const auto found = held_meshes.find(number);
  if (found == held_meshes.end()) throw std::invalid_argument("this mesh was deleted");
  const auto* const mesh = std::get_if<Mesh<N, double>>(&found->second);
  if (mesh == nullptr) throw std::invalid_argument(fmt::format("the mesh does not have dimension {}", N));
  return *mesh;
}

template Mesh<2, double> held_mesh<2>(std::uint32_t);
template Mesh<3, double> held_mesh<3>(std::uint32_t);

EMSCRIPTEN_BINDINGS(graze_meshes) {
  using namespace emscripten;  // NOLINT(google-build-using-namespace): as embind is written
  class_<HeldMesh>("Mesh")
      .class_function("make", &Guarded<&make_mesh>::call, allow_raw_pointers())
      .function("number", &Guarded<&number_of>::call)
      .function("dimension", &Guarded<&dimension_of_mesh>::call)
      .function("isSolid", &Guarded<&is_solid>::call)
      .function("vertexCount", &Guarded<&count_of_vertices>::call)
      .function("faceCount", &Guarded<&count_of_faces>::call)
      .function("vertices", &Guarded<&put_vertices>::call)
      .function("faces", &Guarded<&put_faces>::call)
      .function("report", &Guarded<&report_of>::call)
      .function("edges", &Guarded<&put_edges>::call)
      .function("welded", &Guarded<&welded_copy>::call, allow_raw_pointers())
      .function("moved", &Guarded<&moved_copy>::call, allow_raw_pointers())
      .function("posed", &Guarded<&posed_copy>::call, allow_raw_pointers());
}

}  // namespace graze::wasm
