// SPDX-License-Identifier: MIT
// Meshes that JavaScript holds, so that their triangles are copied into the module only once.
#pragma once

#include <cstdint>
#include <variant>

#include <graze/math/vec.hpp>
#include <graze/shape/mesh.hpp>

namespace graze::wasm {

using AnyMesh = std::variant<Mesh<2, double>, Mesh<3, double>>;

/// A mesh, and the number by which arguments name it while this exists.
class HeldMesh {
 public:
  explicit HeldMesh(AnyMesh mesh);
  ~HeldMesh();
  HeldMesh(const HeldMesh&) = delete;
  HeldMesh& operator=(const HeldMesh&) = delete;

  std::uint32_t number() const { return number_; }
  const AnyMesh& mesh() const { return mesh_; }

 private:
  AnyMesh mesh_;
  std::uint32_t number_;
};

/// The mesh with a number, which shares its triangles. Throws std::invalid_argument if it was deleted or has the other
/// dimension.
template <Dim N>
Mesh<N, double> held_mesh(std::uint32_t number);

}  // namespace graze::wasm
