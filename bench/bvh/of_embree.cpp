// SPDX-License-Identifier: MIT
#include <limits>

#include <embree3/rtcore.h>

#include <graze/broad/spatial_index.hpp>

#include "contestant.hpp"

namespace bench {
namespace {

/// Boxes as a user geometry of medium quality, for rays only; one thread. Embree's robust mode takes as long and misses
/// the same boxes.
class Tracer {
 public:
  Tracer() : device_(rtcNewDevice("threads=1")) {}
  Tracer(const Tracer&) = delete;
  Tracer& operator=(const Tracer&) = delete;
  ~Tracer() {
    if (scene_ != nullptr) rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }

  void build(std::span<const Box<3>> boxes) {
    boxes_.assign(boxes.begin(), boxes.end());
    if (scene_ != nullptr) rtcReleaseScene(scene_);
    scene_ = rtcNewScene(device_);
    const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(boxes.size()));
    rtcSetGeometryUserData(geometry, this);
    rtcSetGeometryBoundsFunction(geometry, give_bounds, nullptr);
    rtcSetGeometryIntersectFunction(geometry, intersect);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
  }
  double first_hit(const Ray<3>& ray) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit hit{};
    hit.ray.org_x = ray.origin.x;
    hit.ray.org_y = ray.origin.y;
    hit.ray.org_z = ray.origin.z;
    hit.ray.dir_x = ray.direction.x;
    hit.ray.dir_y = ray.direction.y;
    hit.ray.dir_z = ray.direction.z;
    hit.ray.tfar = std::numeric_limits<float>::infinity();
    hit.ray.mask = ~0U;
    hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene_, &context, &hit);
    return hit.ray.tfar;
  }

 private:
  static void give_bounds(const RTCBoundsFunctionArguments* arguments) {
    const Box<3>& box = static_cast<const Tracer*>(arguments->geometryUserPtr)->boxes_[arguments->primID];
    *arguments->bounds_o = {box.min.x, box.min.y, box.min.z, 0, box.max.x, box.max.y, box.max.z, 0};
  }
  static void intersect(const RTCIntersectFunctionNArguments* arguments) {
    if (arguments->valid[0] == 0) return;
    auto* hit = reinterpret_cast<RTCRayHit*>(arguments->rayhit);
    const Box<3>& box = static_cast<const Tracer*>(arguments->geometryUserPtr)->boxes_[arguments->primID];
    const Ray<3> ray{{hit->ray.org_x, hit->ray.org_y, hit->ray.org_z},
                     {hit->ray.dir_x, hit->ray.dir_y, hit->ray.dir_z}};
    const auto t = graze::detail::entry_of(ray, box);
    if (!t || !(*t < static_cast<double>(hit->ray.tfar))) return;
    hit->ray.tfar = static_cast<float>(*t);
    hit->hit.geomID = arguments->geomID;
    hit->hit.primID = arguments->primID;
  }

  RTCDevice device_;
  RTCScene scene_ = nullptr;
  std::vector<Box<3>> boxes_;
};

}  // namespace

template <Dim N>
void enter_embree(Entrants<N>& field) {
  if constexpr (N == 3) field.push_back(entrant<3, Tracer>("Embree"));
}

template void enter_embree(Entrants<2>&);
template void enter_embree(Entrants<3>&);

}  // namespace bench
