// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <graze/shape/mesh.hpp>

#include "contestant.hpp"

namespace mesh_bench {

/// Tells whether two answers differ by more than rounding. Distances may differ by `error`. Any other answers, and the
/// t of a ray, may differ if they are answers to queries that differ by `error`: a ray moved aside by it, a shape grown
/// or shrunk by it, a mesh moved by it; points within it of the surface may be inside or not.
class Judge {
 public:
  explicit Judge(const Course& course);

  /// In units of length: 1e-5 times the reach of the surface.
  double error() const { return error_; }

  /// The queries on which the answers differ by more, or that have no answer.
  std::vector<std::size_t> differences(Work work, const Answers& expected, const Answers& found);

 private:
  using Mesh = graze::Mesh<3, double>;

  bool agree(Work work, std::size_t query, double expected, double found);
  bool agree_on_ray(Work work, const Ray& ray, double expected, double found);
  bool agree_on_place(const Pose& place);
  bool agree_on_pairs(const Pose& place, std::vector<graze::Pair> expected, std::vector<graze::Pair> found);
  const Mesh& mesh();

  const Course& course_;
  double error_;
  std::optional<Mesh> mesh_;  // made when it is needed
  std::optional<Mesh> moved_;
};

}  // namespace mesh_bench
