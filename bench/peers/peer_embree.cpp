// SPDX-License-Identifier: MIT
// Tried: trees of low and medium quality, scenes with the dynamic or the compact flag or neither. Medium takes twice as
// long.
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

#include <embree3/rtcore.h>
#include <tbb/task_arena.h>

#include "contestant.hpp"

namespace graze::race {
namespace {

/// How the tree is updated between frames.
enum class Upkeep { rebuild, refit };

struct Manner {
  std::size_t threads;
  Upkeep upkeep;
  ListMemory memory;
};

/// The boxes are one user geometry, of which Embree knows only the bounds. Its tree is rebuilt in every frame, or
/// refitted, which degrades it, and then collided with itself. Embree reports pairs of leaves, each in both orders; the
/// adapter tests the boxes. Embree's trees are 3D: 2D boxes are flat, at z = 0.
template <Dim N>
class Collider final : public Contestant<N, float> {
 public:
  Collider(std::span<const Aabb<N, float>> boxes, const Manner& manner)
      : memory_(manner.memory), arena_(static_cast<int>(manner.threads)), found_(manner.threads) {
    arena_.execute([&] { open(boxes.size(), manner.upkeep); });
  }

  ~Collider() override {
    rtcReleaseGeometry(geometry_);
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }
  Collider(const Collider&) = delete;
  Collider& operator=(const Collider&) = delete;

  std::span<const Pair> find(std::span<const Aabb<N, float>> boxes) override {
    boxes_ = boxes;
    for (Found& found : found_) clear(found.pairs, memory_);
    arena_.execute([this] {
      rtcCommitGeometry(geometry_);
      rtcCommitScene(scene_);
      rtcCollide(scene_, scene_, take, this);
    });
    if (rtcGetDeviceError(device_) != RTC_ERROR_NONE) throw std::runtime_error("Embree reports an error");
    for (std::size_t i = 1; i < found_.size(); ++i) {
      found_[0].pairs.insert(found_[0].pairs.end(), found_[i].pairs.begin(), found_[i].pairs.end());
    }
    return found_[0].pairs;
  }

 private:
  /// The result of one thread, aligned so that threads do not share a cache line.
  struct alignas(64) Found {
    std::vector<Pair> pairs;
    std::atomic_flag is_taken;
  };

  void open(std::size_t count, Upkeep upkeep) {
    const std::string configuration = "threads=" + std::to_string(std::max(1U, std::thread::hardware_concurrency()));
    device_ = rtcNewDevice(configuration.c_str());
    if (device_ == nullptr) throw std::runtime_error("Embree gives no device");
    scene_ = rtcNewScene(device_);
    rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_LOW);
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_DYNAMIC);
    geometry_ = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryBuildQuality(geometry_, upkeep == Upkeep::refit ? RTC_BUILD_QUALITY_REFIT : RTC_BUILD_QUALITY_LOW);
    rtcSetGeometryUserPrimitiveCount(geometry_, static_cast<unsigned>(count));
    rtcSetGeometryUserData(geometry_, this);
    rtcSetGeometryBoundsFunction(geometry_, give_bounds, nullptr);
    rtcAttachGeometry(scene_, geometry_);
  }

  static void give_bounds(const RTCBoundsFunctionArguments* arguments) {
    const auto& box = static_cast<const Collider*>(arguments->geometryUserPtr)->boxes_[arguments->primID];
    RTCBounds& bounds = *arguments->bounds_o;
    bounds.lower_x = box.min[0];
    bounds.lower_y = box.min[1];
    bounds.upper_x = box.max[0];
    bounds.upper_y = box.max[1];
    if constexpr (N == 3) {
      bounds.lower_z = box.min[2];
      bounds.upper_z = box.max[2];
    } else {
      bounds.lower_z = bounds.upper_z = 0;
    }
  }

  /// May be called by several threads at once: claims the first unused store for this call.
  static void take(void* collider, RTCCollision* collisions, unsigned count) {
    auto& self = *static_cast<Collider*>(collider);
    std::size_t i = 0;
    while (self.found_[i].is_taken.test_and_set(std::memory_order_acquire)) i = (i + 1) % self.found_.size();
    for (const RTCCollision& collision : std::span(collisions, count)) {
      const std::uint32_t a = collision.primID0;
      const std::uint32_t b = collision.primID1;
      if (a < b && boxes_overlap(self.boxes_[a], self.boxes_[b])) self.found_[i].pairs.push_back({a, b});
    }
    self.found_[i].is_taken.clear(std::memory_order_release);
  }

  ListMemory memory_;
  // Limits the threads. Embree's own limit would outlast its device and apply to all users of oneTBB in this program;
  // its device uses as many threads as the arena in which it is created.
  tbb::task_arena arena_;
  RTCDevice device_ = nullptr;
  RTCScene scene_ = nullptr;
  RTCGeometry geometry_ = nullptr;
  std::span<const Aabb<N, float>> boxes_;
  std::vector<Found> found_;
};

template <Dim N>
void enter_with(Entrants<N, float>& field, const Manner& manner) {
  Entrant<N, float> entrant;
  entrant.name = manner.upkeep == Upkeep::refit ? "Embree rtcCollide, refitted" : "Embree rtcCollide";
  entrant.settings = "Embree " RTC_VERSION_STRING ", user geometry, low quality, dynamic scene; ";
  entrant.settings += manner.upkeep == Upkeep::refit ? "the tree kept and refitted" : "the tree rebuilt";
  set_list_memory(entrant, manner.memory);
  if (manner.threads > 1) entrant.name += ", " + std::to_string(manner.threads) + " threads";
  entrant.threads = manner.threads;
  entrant.prepare = [manner](std::span<const Aabb<N, float>> boxes) {
    return std::make_unique<Collider<N>>(boxes, manner);
  };
  field.push_back(std::move(entrant));
}

template <Dim N>
void enter_all(Entrants<N, float>& field, std::size_t threads) {
  for (const ListMemory memory : list_memories) enter_with(field, {threads, Upkeep::rebuild, memory});
  enter_with(field, {threads, Upkeep::refit, ListMemory::kept});
}

}  // namespace

template <Dim N, class T>
void enter_embree(Entrants<N, T>& field, std::size_t threads) {
  if constexpr (std::is_same_v<T, float>) {
    enter_all(field, 1);
    if (threads > 1) enter_all(field, threads);
  }
}

template void enter_embree(Entrants<2, float>& field, std::size_t threads);
template void enter_embree(Entrants<2, double>& field, std::size_t threads);
template void enter_embree(Entrants<3, float>& field, std::size_t threads);
template void enter_embree(Entrants<3, double>& field, std::size_t threads);

}  // namespace graze::race
