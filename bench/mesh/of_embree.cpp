// SPDX-License-Identifier: MIT
// Embree in its robust mode, one thread, trees of medium quality (its default). Embree finds the triangles near a
// point; the adapter calculates the distances, in float, as Embree's tutorial does.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include <embree3/rtcore.h>

#include "closest_in_float.hpp"
#include "contestant.hpp"

namespace mesh_bench {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

/// One for the whole program, never freed.
RTCDevice device() {
  static const RTCDevice device = rtcNewDevice("threads=1");
  return device;
}

/// The trees that Embree builds. Those of low quality are built by Morton codes. Only dynamic scenes of low quality,
/// with geometry of a quality of its own, refit.
enum class Quality { medium, low, refit };

/// The triangles of a surface, in buffers that Embree shares.
class Scene {
 public:
  Scene(const std::vector<Point>& vertices, const std::vector<Face>& faces, Quality quality)
      : scene_(rtcNewScene(device())),
        geometry_(rtcNewGeometry(device(), RTC_GEOMETRY_TYPE_TRIANGLE)),
        vertices_(padded(vertices)) {
    rtcSetSceneFlags(
        scene_, quality == Quality::medium ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_DYNAMIC);
    if (quality != Quality::medium) rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_LOW);
    rtcSetGeometryBuildQuality(geometry_, quality == Quality::refit ? RTC_BUILD_QUALITY_REFIT
                                          : quality == Quality::low ? RTC_BUILD_QUALITY_LOW
                                                                    : RTC_BUILD_QUALITY_MEDIUM);
    rtcSetSharedGeometryBuffer(geometry_, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, vertices_.data(), 0,
                               sizeof(Point), vertices.size());
    rtcSetSharedGeometryBuffer(geometry_, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, faces.data(), 0, sizeof(Face),
                               faces.size());
    commit();
    rtcAttachGeometry(scene_, geometry_);
    rtcCommitScene(scene_);
    if (rtcGetDeviceError(device()) != RTC_ERROR_NONE) throw std::runtime_error("Embree reports an error");
  }
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;
  ~Scene() {
    rtcReleaseGeometry(geometry_);
    rtcReleaseScene(scene_);
  }

  RTCScene get() const { return scene_; }
  const Point& vertex(std::size_t index) const { return vertices_[index]; }

  void move(const std::vector<Point>& vertices) {
    std::copy(vertices.begin(), vertices.end(), vertices_.begin());
    rtcUpdateGeometryBuffer(geometry_, RTC_BUFFER_TYPE_VERTEX, 0);
    commit();
    rtcCommitScene(scene_);
  }

 private:
  /// Embree reads 16 bytes of the last vertex.
  static std::vector<Point> padded(const std::vector<Point>& vertices) {
    std::vector<Point> result;
    result.reserve(vertices.size() + 1);
    result = vertices;
    result.emplace_back(0.0F);
    return result;
  }

  void commit() { rtcCommitGeometry(geometry_); }

  RTCScene scene_;
  RTCGeometry geometry_;
  std::vector<Point> vertices_;
};

RTCRayHit query_of(const Ray& ray) {
  RTCRayHit query{};
  query.ray = {ray.origin.x,
               ray.origin.y,
               ray.origin.z,
               0,
               ray.direction.x,
               ray.direction.y,
               ray.direction.z,
               0,
               infinity,
               ~0U,
               0,
               0};
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  return query;
}

RTCIntersectContext context_of(RTCIntersectContextFlags flags) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = flags;
  return context;
}

class OfEmbree {
 public:
  explicit OfEmbree(const Course& course) : course_(course) {}

  void clear() {
    still_.reset();
    quick_.reset();
  }
  void build() { still_ = scene(course_.surface.vertices, Quality::medium); }
  void build_quickly() { quick_ = scene(course_.surface.vertices, Quality::low); }
  void build_if_needed() {
    if (!still_) build();
  }
  void build_moving_if_needed() {
    if (!moving_) moving_ = scene(course_.moved[0], Quality::refit);
  }

  void refit() { moving_->move(course_.moved[++frame_ % 2]); }
  void end_refit() {
    build_moving_if_needed();
    if (frame_ % 2 == 0) refit();
  }

  void moved_rays(Answers& answers) { cast(moving_->get(), answers); }
  void rays(Answers& answers) { cast(still_->get(), answers); }

  void rays_in_stream(Answers& answers) {
    constexpr std::size_t at_once = 1024;  // stay in the cache
    RTCIntersectContext context = context_of(RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT);
    std::vector<RTCRayHit> stream;
    stream.reserve(at_once);
    answers.numbers.resize(course_.rays.size());
    for (std::size_t first = 0; first < course_.rays.size(); first += at_once) {
      const std::size_t count = std::min(at_once, course_.rays.size() - first);
      stream.clear();
      for (std::size_t k = 0; k < count; ++k) stream.push_back(query_of(course_.rays[first + k]));
      rtcIntersect1M(still_->get(), &context, stream.data(), static_cast<unsigned>(count), sizeof(RTCRayHit));
      for (std::size_t k = 0; k < count; ++k) answers.numbers[first + k] = static_cast<double>(stream[k].ray.tfar);
    }
  }

  void rays_in_packets(Answers& answers) {
    RTCIntersectContext context = context_of(RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT);
    answers.numbers.resize(course_.rays.size());
    for (std::size_t first = 0; first < course_.rays.size(); first += 16) {
      RTCRayHit16 packet{};
      alignas(64) std::array<int, 16> valid{};
      const std::size_t count = std::min<std::size_t>(16, course_.rays.size() - first);
      for (std::size_t k = 0; k < count; ++k) {
        const Ray& ray = course_.rays[first + k];
        valid[k] = -1;
        packet.ray.org_x[k] = ray.origin.x;
        packet.ray.org_y[k] = ray.origin.y;
        packet.ray.org_z[k] = ray.origin.z;
        packet.ray.dir_x[k] = ray.direction.x;
        packet.ray.dir_y[k] = ray.direction.y;
        packet.ray.dir_z[k] = ray.direction.z;
        packet.ray.tfar[k] = infinity;
        packet.ray.mask[k] = ~0U;
        packet.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
      }
      rtcIntersect16(valid.data(), still_->get(), &context, &packet);
      for (std::size_t k = 0; k < count; ++k) answers.numbers[first + k] = static_cast<double>(packet.ray.tfar[k]);
    }
  }

  void closest(Answers& answers) {
    answer_each(course_.points, answers, [this](const Point& point) {
      Nearest nearest{this, point};
      RTCPointQuery query{point.x, point.y, point.z, 0, infinity};
      RTCPointQueryContext context;
      rtcInitPointQueryContext(&context);
      rtcPointQuery(still_->get(), &query, &context, take, &nearest);
      return std::sqrt(nearest.distance_squared);
    });
  }

 private:
  struct Nearest {
    const OfEmbree* adapter;
    Point point;
    float distance_squared = infinity;
  };

  std::unique_ptr<Scene> scene(const std::vector<Point>& vertices, Quality quality) const {
    return std::make_unique<Scene>(vertices, course_.surface.faces, quality);
  }

  static bool take(RTCPointQueryFunctionArguments* arguments) {
    Nearest& nearest = *static_cast<Nearest*>(arguments->userPtr);
    const Face& face = nearest.adapter->course_.surface.faces[arguments->primID];
    const Scene& scene = *nearest.adapter->still_;
    const Point way =
        closest_in_float(nearest.point, scene.vertex(face[0]), scene.vertex(face[1]), scene.vertex(face[2])) -
        nearest.point;
    const float squared = dot(way, way);
    if (!(squared < nearest.distance_squared)) return false;
    nearest.distance_squared = squared;
    arguments->query->radius = std::sqrt(squared);
    return true;  // the radius has changed
  }

  void cast(RTCScene scene, Answers& answers) const {
    RTCIntersectContext context = context_of(RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT);
    answer_each(course_.rays, answers, [&](const Ray& ray) {
      RTCRayHit query = query_of(ray);
      rtcIntersect1(scene, &context, &query);
      return query.ray.tfar;
    });
  }

  const Course& course_;
  std::unique_ptr<Scene> still_;
  std::unique_ptr<Scene> quick_;  // never asked
  std::unique_ptr<Scene> moving_;
  std::size_t frame_ = 0;
};

}  // namespace

void enter_embree(const Course& course, Entries& field) {
  Enrolment<OfEmbree> embree("Embree", false, std::make_shared<OfEmbree>(course), field);
  embree.add(Work::build, &OfEmbree::clear, &OfEmbree::build_quickly, "low quality");
  embree.add(Work::build, &OfEmbree::clear, &OfEmbree::build, "medium quality");
  embree.add(Work::refit, &OfEmbree::build_moving_if_needed, &OfEmbree::refit, "refit");
  embree.add(Work::moved_rays, &OfEmbree::end_refit, &OfEmbree::moved_rays, "refit");
  embree.add(Work::rays, &OfEmbree::build_if_needed, &OfEmbree::rays, "rtcIntersect1");
  embree.add(Work::rays_batch, &OfEmbree::build_if_needed, &OfEmbree::rays, "rtcIntersect1");
  embree.add(Work::rays_batch, &OfEmbree::build_if_needed, &OfEmbree::rays_in_packets, "rtcIntersect16");
  embree.add(Work::rays_batch, &OfEmbree::build_if_needed, &OfEmbree::rays_in_stream, "rtcIntersect1M");
  embree.add(Work::closest, &OfEmbree::build_if_needed, &OfEmbree::closest, "rtcPointQuery");
  embree.add(Work::closest_batch, &OfEmbree::build_if_needed, &OfEmbree::closest, "rtcPointQuery");
}

}  // namespace mesh_bench
