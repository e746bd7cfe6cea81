// SPDX-License-Identifier: MIT
// Bvh beside Octree, Bullet's dynamic tree, Boost's R-tree and Embree, on the bounding boxes of cubes that drift in
// space: build, move all, move one in a hundred, and 100,000 questions: what is around, what does a ray enter first,
// what is nearest. Who does not offer something is left out of it. Answers are compared before anything is timed.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/BroadphaseCollision/btOverlappingPairCache.h>
#include <benchmark/benchmark.h>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>
#include <embree3/rtcore.h>

#include <graze/broad/bvh.hpp>
#include <graze/broad/grid.hpp>
#include <graze/broad/orthtree.hpp>

#include "bvh_course.hpp"

namespace {

using bench::Box;
using bench::Course;
using bench::Point;
using bench::questions;
using bench::Ray;

using Keep = std::function<void(std::size_t)>;

// ---- The contestants

/// Any index of graze.
template <class Index>
class Graze {
 public:
  explicit Graze(Index index = Index()) : empty_(index), index_(index) {}

  void build(const std::vector<Box>& boxes) {
    index_ = empty_;
    keys_.clear();
    keys_.reserve(boxes.size());
    for (const Box& box : boxes) keys_.push_back(index_.insert(box));
  }
  void build_at_once(const std::vector<Box>& boxes) { keys_ = index_.assign(boxes, graze::serial_executor()); }
  void move(std::size_t k, const Box& box) { index_.update(keys_[k], box); }
  template <class Visit>
  void query(const Box& region, const Visit& visit) const {
    index_.query(region, [&visit](graze::Key key) { visit(std::size_t{key.index}); });
  }
  double first_hit(const Ray& ray) const {
    double first = std::numeric_limits<double>::infinity();
    index_.ray_cast(ray, [&first](graze::Key, double t) {
      first = t;
      return false;
    });
    return first;
  }
  double nearest(const Point& point, std::size_t k) const { return index_.nearest(point, k).back().distance_squared; }

 private:
  Index empty_;
  Index index_;
  std::vector<graze::Key> keys_;
};

struct Bvh : Graze<graze::Bvh<3>> {
  static constexpr const char* name = "graze Bvh";
};

struct BvhWithMargin : Graze<graze::Bvh<3>> {
  static constexpr const char* name = "graze Bvh, margin 0.2";
  BvhWithMargin() : Graze(graze::Bvh<3>({.margin = 0.2})) {}
};

struct BvhAtOnce : Graze<graze::Bvh<3>> {
  static constexpr const char* name = "graze Bvh, built at once";
  void build(const std::vector<Box>& boxes) { build_at_once(boxes); }
};

struct Octree : Graze<graze::Octree<>> {
  static constexpr const char* name = "graze Octree";
};

struct Grid : Graze<graze::Grid<3>> {
  static constexpr const char* name = "graze Grid";
};

/// With its own margin, which it needs to be quick, and for one ray at a time: it does not stop at the first box.
class Bullet {
 public:
  static constexpr const char* name = "Bullet btDbvtBroadphase";

  void build(const std::vector<Box>& boxes) {
    gDbvtMargin = 0.2F;
    broadphase_.emplace(&no_pairs_);
    broadphase_->m_deferedcollide = true;
    boxes_ = boxes;
    proxies_.clear();
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      proxies_.push_back(
          broadphase_->createProxy(corner(boxes[k].min), corner(boxes[k].max), 0, &boxes_[k], 1, 1, nullptr));
    }
  }
  void move(std::size_t k, const Box& box) {
    boxes_[k] = box;
    broadphase_->setAabb(proxies_[k], corner(box.min), corner(box.max), nullptr);
  }
  template <class Visit>
  void query(const Box& region, const Visit& visit) {
    struct Callback final : btBroadphaseAabbCallback {
      bool process(const btBroadphaseProxy* proxy) override {
        const auto* box = static_cast<const Box*>(proxy->m_clientObject);
        if (boxes_overlap(*asked, *box)) (*take)(static_cast<std::size_t>(box - first));
        return true;
      }
      const Box* first = nullptr;
      const Box* asked = nullptr;
      const Visit* take = nullptr;
    } callback;
    callback.first = boxes_.data();
    callback.asked = &region;
    callback.take = &visit;
    broadphase_->aabbTest(corner(region.min), corner(region.max), callback);
  }
  double first_hit(const Ray& ray) {
    struct Callback final : btBroadphaseRayCallback {
      bool process(const btBroadphaseProxy* proxy) override {
        const auto t = graze::detail::entry_of(*ray, *static_cast<const Box*>(proxy->m_clientObject));
        if (t) first = std::min(first, *t);
        return true;
      }
      const Ray* ray = nullptr;
      double first = std::numeric_limits<double>::infinity();
    } callback;
    callback.ray = &ray;
    callback.m_lambda_max = 1e4F;
    for (int i = 0; i < 3; ++i) {
      const float along = ray.direction[i];
      callback.m_rayDirectionInverse[i] = along == 0 ? BT_LARGE_FLOAT : 1 / along;
      callback.m_signs[i] = static_cast<unsigned>(callback.m_rayDirectionInverse[i] < 0);
    }
    broadphase_->rayTest(corner(ray.origin), corner(ray.origin + ray.direction * 1e4F), callback);
    return callback.first;
  }

 private:
  static btVector3 corner(const Point& p) { return {p.x, p.y, p.z}; }

  std::vector<Box> boxes_;
  btNullPairCache no_pairs_;
  std::optional<btDbvtBroadphase> broadphase_;
  std::vector<btBroadphaseProxy*> proxies_;
};

/// Packed when it is built at once. It has no rays in space.
class Boost {
 public:
  static constexpr const char* name = "Boost rtree";

  void build(const std::vector<Box>& boxes) {
    boxes_ = boxes;
    std::vector<Entry> entries;
    for (std::size_t k = 0; k < boxes.size(); ++k) entries.push_back(entry(k));
    tree_ = Tree(entries);
  }
  void move(std::size_t k, const Box& box) {
    tree_.remove(entry(k));
    boxes_[k] = box;
    tree_.insert(entry(k));
  }
  template <class Visit>
  void query(const Box& region, const Visit& visit) const {
    const auto take = [&visit](const Entry& entry) { visit(std::size_t{entry.second}); };
    tree_.query(boost::geometry::index::intersects(BoostBox(corner(region.min), corner(region.max))),
                boost::make_function_output_iterator(take));
  }
  double nearest(const Point& point, std::size_t k) const {
    double farthest = 0;
    const auto take = [&](const Entry& entry) {
      farthest = std::max(farthest, distance_squared(point, boxes_[entry.second]));
    };
    tree_.query(boost::geometry::index::nearest(corner(point), static_cast<unsigned>(k)),
                boost::make_function_output_iterator(take));
    return farthest;
  }

 private:
  using Corner = boost::geometry::model::point<float, 3, boost::geometry::cs::cartesian>;
  using BoostBox = boost::geometry::model::box<Corner>;
  using Entry = std::pair<BoostBox, std::uint32_t>;
  using Tree = boost::geometry::index::rtree<Entry, boost::geometry::index::linear<8>>;

  static Corner corner(const Point& p) { return {p.x, p.y, p.z}; }
  Entry entry(std::size_t k) const {
    return {{corner(boxes_[k].min), corner(boxes_[k].max)}, static_cast<std::uint32_t>(k)};
  }

  std::vector<Box> boxes_;
  Tree tree_;
};

/// Boxes as a geometry of the user's own, of the quality that its makers call medium, for rays only.
class Embree {
 public:
  static constexpr const char* name = "Embree";

  Embree() : device_(rtcNewDevice("threads=1")) {}
  Embree(const Embree&) = delete;
  Embree& operator=(const Embree&) = delete;
  ~Embree() {
    if (scene_ != nullptr) rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }

  void build(const std::vector<Box>& boxes) {
    boxes_ = boxes;
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
  double first_hit(const Ray& ray) const {
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
    const Box& box = static_cast<const Embree*>(arguments->geometryUserPtr)->boxes_[arguments->primID];
    *arguments->bounds_o = {box.min.x, box.min.y, box.min.z, 0, box.max.x, box.max.y, box.max.z, 0};
  }
  static void intersect(const RTCIntersectFunctionNArguments* arguments) {
    if (arguments->valid[0] == 0) return;
    auto* hit = reinterpret_cast<RTCRayHit*>(arguments->rayhit);
    const Box& box = static_cast<const Embree*>(arguments->geometryUserPtr)->boxes_[arguments->primID];
    const Ray ray{{hit->ray.org_x, hit->ray.org_y, hit->ray.org_z}, {hit->ray.dir_x, hit->ray.dir_y, hit->ray.dir_z}};
    const auto t = graze::detail::entry_of(ray, box);
    if (!t || !(*t < static_cast<double>(hit->ray.tfar))) return;
    hit->ray.tfar = static_cast<float>(*t);
    hit->hit.geomID = arguments->geomID;
    hit->hit.primID = arguments->primID;
  }

  RTCDevice device_;
  RTCScene scene_ = nullptr;
  std::vector<Box> boxes_;
};

// ---- What is compared

/// The answers to some of the questions after a move: numbers, of which those of regions are exact.
template <class Contestant>
struct Answers {
  std::vector<std::size_t> regions;
  std::vector<double> rays;
  std::vector<double> nearest;

  explicit Answers(const Course& course) {
    Contestant contestant;
    contestant.build(course.first);
    if constexpr (requires { contestant.move(0, Box{}); }) {
      for (std::size_t k = 0; k < course.second.size(); ++k) contestant.move(k, course.second[k]);
    } else {
      contestant.build(course.second);
    }
    for (std::size_t k = 0; k < questions; k += 10) ask(contestant, course, k);
  }

  void ask(Contestant& contestant, const Course& course, std::size_t k) {
    if constexpr (requires { contestant.query(Box{}, Keep{}); }) {
      const auto first = static_cast<std::ptrdiff_t>(regions.size());
      contestant.query(course.regions[k], [this](std::size_t id) { regions.push_back(id); });
      std::sort(regions.begin() + first, regions.end());
      regions.push_back(k);
    }
    if constexpr (requires { contestant.first_hit(Ray{}); }) rays.push_back(contestant.first_hit(course.rays[k]));
    if constexpr (requires { contestant.nearest(Point{}, 1); }) {
      nearest.push_back(contestant.nearest(course.points[k], 1));
      nearest.push_back(contestant.nearest(course.points[k], 8));
    }
  }
};

bool same(const std::vector<double>& a, const std::vector<double>& b) {
  if (b.empty()) return true;
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](double x, double y) {
    return x == y || std::fabs(x - y) <= 1e-6 * (1 + std::fabs(x));  // Embree's t is a float
  });
}

template <class Contestant>
void require_the_same(const Course& course, const Answers<Bvh>& expected) {
  const Answers<Contestant> found(course);
  if ((found.regions.empty() || found.regions == expected.regions) && same(expected.rays, found.rays) &&
      same(expected.nearest, found.nearest)) {
    return;
  }
  std::fprintf(stderr, "bvh: %s gives other answers\n", Contestant::name);
  std::exit(1);
}

// ---- What is timed

template <class Run>
void add_one(const std::string& name, Run run) {
  benchmark::RegisterBenchmark(name.c_str(), run)->Unit(benchmark::kMillisecond)->MinTime(0.2);
}

template <class Contestant>
void add_moves(std::size_t count, const std::string& name) {
  const auto add_share = [&](const char* work, std::size_t step) {
    add_one(work + name, [count, step](benchmark::State& state) {
      const Course course(count);
      Contestant contestant;
      contestant.build(course.first);
      std::size_t frame = 0;
      for (auto _ : state) {
        const std::vector<Box>& boxes = course.at(++frame / step);
        for (std::size_t k = frame % step; k < count; k += step) contestant.move(k, boxes[k]);
      }
    });
  };
  add_share("move_all", 1);
  add_share("move_one_percent", 100);
}

/// 100,000 questions after everything has moved, or has been built where it cannot move.
template <class Contestant, class Ask>
void add_questions(std::size_t count, const std::string& name, const Ask& ask) {
  add_one(name, [count, ask](benchmark::State& state) {
    const Course course(count);
    Contestant contestant;
    contestant.build(course.first);
    double found = 0;
    for (auto _ : state) {
      for (std::size_t k = 0; k < questions; ++k) found += ask(contestant, course, k);
    }
    benchmark::DoNotOptimize(found);
    state.counters["found"] = found / static_cast<double>(questions) / static_cast<double>(state.iterations());
  });
}

template <class Contestant>
void add(std::size_t count) {
  const std::string name = std::string("/") + Contestant::name + "/" + std::to_string(count);
  add_one("build" + name, [count](benchmark::State& state) {
    const Course course(count);
    Contestant contestant;
    for (auto _ : state) contestant.build(course.first);
  });
  if constexpr (requires(Contestant c) { c.move(0, Box{}); }) add_moves<Contestant>(count, name);
  if constexpr (requires(Contestant c) { c.query(Box{}, Keep{}); }) {
    add_questions<Contestant>(count, "regions" + name, [](auto& contestant, const Course& course, std::size_t k) {
      double hits = 0;
      contestant.query(course.regions[k], [&hits](std::size_t) { ++hits; });
      return hits;
    });
  }
  if constexpr (requires(Contestant c) { c.first_hit(Ray{}); }) {
    add_questions<Contestant>(count, "rays" + name, [](auto& contestant, const Course& course, std::size_t k) {
      return contestant.first_hit(course.rays[k]) < 1e6 ? 1.0 : 0.0;
    });
  }
  if constexpr (requires(Contestant c) { c.nearest(Point{}, 1); }) {
    for (const std::size_t wanted : {std::size_t{1}, std::size_t{8}}) {
      add_questions<Contestant>(count, "nearest_" + std::to_string(wanted) + name,
                                [wanted](auto& contestant, const Course& course, std::size_t k) {
                                  return contestant.nearest(course.points[k], wanted);
                                });
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  {
    const Course course(10'000);
    const Answers<Bvh> expected(course);
    require_the_same<BvhWithMargin>(course, expected);
    require_the_same<BvhAtOnce>(course, expected);
    require_the_same<Octree>(course, expected);
    require_the_same<Grid>(course, expected);
    require_the_same<Bullet>(course, expected);
    require_the_same<Boost>(course, expected);
    require_the_same<Embree>(course, expected);
  }
  for (const std::size_t count : {std::size_t{10'000}, std::size_t{100'000}}) {
    add<Bvh>(count);
    add<BvhWithMargin>(count);
    add<BvhAtOnce>(count);
    add<Octree>(count);
    add<Grid>(count);
    add<Bullet>(count);
    add<Boost>(count);
    add<Embree>(count);
  }
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
}
