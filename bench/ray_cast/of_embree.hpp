// SPDX-License-Identifier: MIT
// Embree's rtcIntersect1 (float) on a scene of one sphere, one triangle, or the triangles of one hull, built before any
// ray is cast.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <type_traits>
#include <vector>

#include <embree3/rtcore.h>

#include <graze/shape/convex_mesh.hpp>

#include "../bench/ray_cast/cases.hpp"

namespace graze::ray_bench {

struct ReleaseScene {
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using EmbreeScene = std::unique_ptr<std::remove_pointer_t<RTCScene>, ReleaseScene>;

/// One for the whole program, never freed.
inline RTCDevice embree_device() {
  static const RTCDevice device = rtcNewDevice("threads=1");
  return device;
}

inline EmbreeScene embree_scene(RTCGeometry geometry) {
  rtcCommitGeometry(geometry);
  EmbreeScene scene(rtcNewScene(embree_device()));
  rtcAttachGeometry(scene.get(), geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene.get());
  return scene;
}

/// Corners of triangles, in threes.
inline EmbreeScene embree_triangles(const std::vector<Vec<3, float>>& corners) {
  const RTCGeometry geometry = rtcNewGeometry(embree_device(), RTC_GEOMETRY_TYPE_TRIANGLE);
  const auto buffer = [&](RTCBufferType type, RTCFormat format, std::size_t size, std::size_t count) {
    return rtcSetNewGeometryBuffer(geometry, type, 0, format, size, count);
  };
  auto* places =
      static_cast<float*>(buffer(RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, 3 * sizeof(float), corners.size()));
  auto* indices = static_cast<unsigned int*>(
      buffer(RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, 3 * sizeof(unsigned int), corners.size() / 3));
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (Dim k = 0; k < 3; ++k) places[3 * i + static_cast<std::size_t>(k)] = corners[i][k];
    indices[i] = static_cast<unsigned int>(i);
  }
  return embree_scene(geometry);
}

inline EmbreeScene embree_scene_of(const Triangle<3, float>& triangle) {
  return embree_triangles({triangle.a, triangle.b, triangle.c});
}
inline EmbreeScene embree_scene_of(const Sphere<3, float>& sphere) {
  const RTCGeometry geometry = rtcNewGeometry(embree_device(), RTC_GEOMETRY_TYPE_SPHERE_POINT);
  auto* numbers = static_cast<float*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, 4 * sizeof(float), 1));
  for (Dim k = 0; k < 3; ++k) numbers[k] = sphere.center[k];
  numbers[3] = sphere.radius;
  return embree_scene(geometry);
}
inline EmbreeScene embree_scene_of(const Polytope<3, float>& polytope) {
  const ConvexMesh<float> mesh = convex_mesh(polytope);
  std::vector<Vec<3, float>> corners;
  const auto corner = [&](std::uint32_t edge) { return mesh.vertices[mesh.half_edges[edge].origin]; };
  for (const std::uint32_t first : mesh.faces) {
    for (std::uint32_t edge = mesh.half_edges[first].next; mesh.half_edges[edge].next != first;
         edge = mesh.half_edges[edge].next) {
      corners.insert(corners.end(), {corner(first), corner(edge), corner(mesh.half_edges[edge].next)});
    }
  }
  return embree_triangles(corners);
}

class EmbreeRay {
 public:
  static constexpr const char* name = "Embree rtcIntersect1";
  static constexpr double tolerance = 1e-5;

  struct Hit {
    float t;
    Vec<3, float> normal;
  };

  template <class S>
  requires requires(const S& shape) { embree_scene_of(shape); }
  explicit EmbreeRay(const Case<S>& asked) : scene_(embree_scene_of(asked.shape)), ray_(asked.ray) {}

  std::optional<Hit> cast() const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit query{};
    query.ray = {ray_.origin.x,
                 ray_.origin.y,
                 ray_.origin.z,
                 0,
                 ray_.direction.x,
                 ray_.direction.y,
                 ray_.direction.z,
                 0,
                 t_max,
                 ~0U,
                 0,
                 0};
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene_.get(), &context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    return Hit{query.ray.tfar, {query.hit.Ng_x, query.hit.Ng_y, query.hit.Ng_z}};
  }

 private:
  EmbreeScene scene_;
  Ray<3, float> ray_;
};

}  // namespace graze::ray_bench
