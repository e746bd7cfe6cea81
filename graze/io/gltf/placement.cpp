// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <graze/io/gltf/placement.hpp>
#include <graze/math/rotation.hpp>
#include <graze/math/tolerance.hpp>

namespace graze::io {
namespace {

struct GltfQuaternion {
  double x, y, z, w;
};

/// The numbers of a field, which must be as many as `target` has; false if there is no such field.
template <std::size_t Count>
bool read_numbers(const JsonFields& node, std::string_view name, std::array<double, Count>& target) {
  if (!node.find(name)) return false;
  const JsonValue array = node.array(name);
  if (array.size() != Count) {
    throw node.error(name, fmt::format("has {} numbers; it must have {}", array.size(), Count));
  }
  std::size_t i = 0;
  for (const JsonValue number : array.items()) {
    target[i] = read_number(number, {name, i}, node.place());
    ++i;
  }
  return true;
}

/// In columns; the last row of an affine map is 0, 0, 0, 1.
GltfTransform of_matrix(const JsonFields& node, const std::array<double, 16>& matrix) {
  if (matrix[3] != 0 || matrix[7] != 0 || matrix[11] != 0 || matrix[15] != 1) {
    throw node.error("matrix", "is not affine: its last row must be 0, 0, 0, 1");
  }
  GltfTransform transform;
  for (std::size_t j = 0; j < 3; ++j) {
    for (std::size_t i = 0; i < 3; ++i) {
      transform.linear[static_cast<Dim>(j)][static_cast<Dim>(i)] = matrix[4 * j + i];
    }
    transform.offset[static_cast<Dim>(j)] = matrix[12 + j];
  }
  return transform;
}

/// The scale of a map that scales alike in all directions, rounded to float: nodes of the same scale differ by
/// rounding. None for other maps, and for those that mirror.
std::optional<double> uniform_scale(const Mat<3, double>& linear) {
  const double size = std::sqrt(dot(linear[0], linear[0]));
  const auto scale = static_cast<double>(static_cast<float>(size));
  if (!(scale > 0) || !std::isfinite(scale)) return std::nullopt;
  const Mat<3, double> rotation = linear / scale;
  if (!(orthonormal_error<3, double>(rotation) <= tolerance::orthonormal)) return std::nullopt;
  if (dot(cross(rotation[0], rotation[1]), rotation[2]) < 0) return std::nullopt;
  return scale;
}

}  // namespace

GltfTransform GltfTransform::after(const GltfTransform& inner) const {
  return {linear * inner.linear, linear * inner.offset + offset};
}

GltfTransform transform_of_node(const GltfItem& node) {
  const JsonFields fields = node.fields();
  std::array<double, 16> matrix{};
  if (read_numbers(fields, "matrix", matrix)) return of_matrix(fields, matrix);
  std::array<double, 3> translation{0, 0, 0};
  std::array<double, 4> rotation{0, 0, 0, 1};
  std::array<double, 3> scale{1, 1, 1};
  read_numbers(fields, "translation", translation);
  read_numbers(fields, "rotation", rotation);
  read_numbers(fields, "scale", scale);
  GltfTransform transform;
  try {
    transform.linear = rotation_from_quaternion(GltfQuaternion{rotation[0], rotation[1], rotation[2], rotation[3]});
  } catch (const std::invalid_argument&) {
    throw fields.error("rotation", "is zero; a quaternion has any other length");
  }
  for (std::size_t i = 0; i < 3; ++i) {
    transform.linear[static_cast<Dim>(i)] *= scale[i];
    transform.offset[static_cast<Dim>(i)] = translation[i];
  }
  return transform;
}

const Mesh<3, double>& GltfPlacement::copy(const Mesh<3, double>& mesh, const Mat<3, double>& linear) {
  Key key{&mesh, {}};
  for (std::size_t i = 0; i < 9; ++i) key.second[i] = linear[static_cast<Dim>(i / 3)][static_cast<Dim>(i % 3)];
  if (const auto known = copies_.find(key); known != copies_.end()) return known->second;
  copied_ += mesh.vertices().size() + mesh.faces().size();
  if (copied_ > most_copied_) {
    throw std::length_error(
        fmt::format("the scaled copies of meshes have more than {} vertices and faces", most_copied_));
  }
  std::vector<Vec<3, double>> vertices;
  vertices.reserve(mesh.vertices().size());
  for (const Vec<3, double>& vertex : mesh.vertices()) vertices.push_back(linear * vertex);
  std::vector<std::array<std::uint32_t, 3>> faces(mesh.faces().begin(), mesh.faces().end());
  if (dot(cross(linear[0], linear[1]), linear[2]) < 0) {
    for (std::array<std::uint32_t, 3>& face : faces) std::swap(face[1], face[2]);
  }
  return copies_.emplace(key, mesh_of<3, double>(vertices, faces)).first->second;
}

Mesh<3, double> GltfPlacement::placed(const Mesh<3, double>& mesh, const GltfTransform& transform) {
  for (Dim i = 0; i < 3; ++i) {
    if (!is_finite(transform.linear[i])) throw std::invalid_argument("the transform is not finite");
  }
  const std::optional<double> scale = uniform_scale(transform.linear);
  const Mesh<3, double>& source = !scale        ? copy(mesh, transform.linear)
                                  : *scale == 1 ? mesh
                                                : copy(mesh, Mat<3, double>(*scale));
  const Pose<3, double> pose{scale ? transform.linear / *scale : Mat<3, double>(1.0), transform.offset};
  if (pose.rotation == Mat<3, double>(1.0) && pose.position == Vec<3, double>(0.0)) return source;
  return transformed(source, pose);
}

}  // namespace graze::io
