// SPDX-License-Identifier: MIT
// Jolt, in float, for two oriented boxes: CollideShape with faces, which are clipped to a manifold of up to four
// points, as in its PhysicsSystem. Only compiled if CMake finds Jolt.
#pragma once

#include <memory>

#include "../bench/contact/answer.hpp"

namespace graze::contact_bench {

enum class JoltEdges { sharp, rounded };

template <JoltEdges Edges>
class JoltPair {
 public:
  static constexpr const char* name = Edges == JoltEdges::sharp ? "Jolt" : "Jolt, rounded";

  JoltPair(const Obb& a, const Obb& b);
  JoltPair(JoltPair&& other) noexcept;
  ~JoltPair();

  Answer find() const;

 private:
  struct Boxes;  // apart, because Jolt's headers set the instruction set of what includes them
  std::unique_ptr<const Boxes> boxes_;
};

}  // namespace graze::contact_bench
