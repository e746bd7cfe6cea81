// SPDX-License-Identifier: MIT
// The C++ side of `./dev bench python`: the calls that batches.py makes, on the same arrays. Each returns the seconds
// that it took and its answer.
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <graze/broad/bvh.hpp>
#include <graze/broad/closest_points.hpp>
#include <graze/broad/contacts.hpp>
#include <graze/broad/pairs.hpp>
#include <graze/broad/ray_casts.hpp>
#include <graze/broad/signed_distances.hpp>
#include <graze/broad/touching_pairs.hpp>
#include <graze/broad/winding_numbers.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/intersects.hpp>
#include <graze/scene/scene.hpp>
#include <graze/shape/polytope.hpp>

#include "arrays.hpp"

namespace graze::bench {
namespace {

namespace py = pybind11;
using python::array_of;
using Table = py::array_t<double, py::array::c_style>;
using PairTable = py::array_t<std::uint32_t, py::array::c_style>;
using Any = AnyShape<3, double>;
using Point = Vec<3, double>;

template <class Row, class Array>
std::span<const Row> rows(const Array& array) {
  return {reinterpret_cast<const Row*>(array.data()), static_cast<std::size_t>(array.shape(0))};
}

/// Seconds, and the answer of ask().
template <class Ask>
auto timed(const Ask& ask) {
  const py::gil_scoped_release released;
  const auto start = std::chrono::steady_clock::now();
  auto answer = ask();
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  return std::pair(taken.count(), std::move(answer));
}

/// Both as Python has them.
template <class Timed, class Convert>
py::tuple answered(Timed timed, const Convert& convert) {
  return py::make_tuple(timed.first, convert(std::move(timed.second)));
}

py::array pairs_of(std::vector<Pair> pairs) { return array_of(std::move(pairs)); }

py::tuple overlapping_pairs_of(const Table& boxes) {
  return answered(timed([&] { return overlapping_pairs(rows<Aabb<3, double>>(boxes)); }), pairs_of);
}

class Finder {
 public:
  py::tuple find(const Table& boxes) {
    const auto found = timed([&] { return finder_.find(rows<Aabb<3, double>>(boxes)); });
    return py::make_tuple(found.first, pairs_of({found.second.begin(), found.second.end()}));
  }

 private:
  PairFinder<3, double> finder_;
};

/// Oriented boxes or spheres.
class ShapeList {
 public:
  ShapeList(const Table& centers, const Table& half_extents, const Table& axes) {
    const auto middles = rows<Point>(centers);
    const auto halves = rows<Point>(half_extents);
    for (std::size_t i = 0; i < middles.size(); ++i) {
      const double* const matrix = axes.data() + 9 * i;
      Obb<3, double> box{middles[i], halves[i]};
      for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) box.axes[column][row] = matrix[3 * row + column];
      }
      shapes_.emplace_back(box);
    }
  }
  ShapeList(const Table& centers, const Table& radii) {
    const auto middles = rows<Point>(centers);
    for (std::size_t i = 0; i < middles.size(); ++i)
      shapes_.emplace_back(Sphere<3, double>{middles[i], radii.data()[i]});
  }

  const std::vector<Any>& shapes() const { return shapes_; }

  py::tuple boxes() const {
    return answered(timed([&] {
                      std::vector<Aabb<3, double>> boxes;
                      boxes.reserve(shapes_.size());
                      for (const Any& shape : shapes_) boxes.push_back(bounds(shape));
                      return boxes;
                    }),
                    [](auto boxes) { return array_of<double>(std::move(boxes), 6); });
  }

  py::tuple touching(const PairTable& pairs) const {
    return answered(timed([&] { return touching_pairs(shapes_, rows<Pair>(pairs)); }), pairs_of);
  }

  py::tuple relations_of(const PairTable& pairs) const {
    return answered(timed([&] { return relations<3, double>(shapes_, rows<Pair>(pairs)); }),
                    [](auto found) { return array_of<std::int32_t>(std::move(found), 0); });
  }

  /// The depths of all contacts.
  py::tuple contacts_of(const PairTable& pairs) const {
    return answered(timed([&] { return contacts(shapes_, rows<Pair>(pairs)); }), [](const auto& found) {
      std::vector<double> depths;
      for (const auto& each : found) {
        for (const auto& point : each.manifold.contacts()) depths.push_back(point.depth);
      }
      return array_of<double>(std::move(depths), 0);
    });
  }

  /// Single calls for each pair, and how many of them touch.
  py::tuple single_calls(const PairTable& pairs) const {
    return answered(timed([&] {
                      std::size_t count = 0;
                      for (const Pair& pair : rows<Pair>(pairs)) {
                        count += intersects(shapes_[pair.a], shapes_[pair.b]) ? 1 : 0;
                      }
                      return count;
                    }),
                    [](std::size_t count) { return py::int_(count); });
  }

 private:
  std::vector<Any> shapes_;
};

py::tuple hull_of(const Table& points) {
  return answered(timed([&] { return convex_hull<3, double>(rows<Point>(points)); }),
                  [](const auto& hull) { return py::int_(hull.vertices().size()); });
}

class Surface {
 public:
  Surface(const Table& vertices, const PairTable& faces)
      : mesh_(mesh_of<3, double>(rows<Point>(vertices), rows<std::array<std::uint32_t, 3>>(faces), MeshKind::solid)) {}

  static py::tuple made(const Table& vertices, const PairTable& faces) {
    return answered(timed([&] {
                      return mesh_of<3, double>(rows<Point>(vertices), rows<std::array<std::uint32_t, 3>>(faces),
                                                MeshKind::solid);
                    }),
                    [](const auto& mesh) { return py::int_(mesh.faces().size()); });
  }

  py::tuple hits(const Table& rays) const {
    return answered(timed([&] { return ray_casts(mesh_, rows<Ray<3, double>>(rays)); }), [](const auto& found) {
      std::vector<std::int64_t> faces;
      for (const auto& hit : found)
        faces.push_back(hit && hit->face != no_face ? static_cast<std::int64_t>(hit->face) : -1);
      return array_of<std::int64_t>(std::move(faces), 0);
    });
  }

  py::tuple distances(const Table& points) const {
    return answered(timed([&] { return signed_distances(mesh_, rows<Point>(points)); }),
                    [](auto found) { return array_of<double>(std::move(found), 0); });
  }

  py::tuple nearest(const Table& points) const {
    return answered(timed([&] { return closest_points(mesh_, rows<Point>(points)); }),
                    [](auto found) { return array_of<double>(std::move(found), 3); });
  }

  py::tuple windings(const Table& points) const {
    return answered(timed([&] { return winding_numbers(mesh_, rows<Point>(points)); }),
                    [](auto found) { return array_of<double>(std::move(found), 0); });
  }

 private:
  Mesh<3, double> mesh_;
};

class Index {
 public:
  py::tuple assign(const Table& boxes) {
    auto found = timed([&] { return index_.assign(rows<Aabb<3, double>>(boxes)); });
    keys_ = std::move(found.second);
    return py::make_tuple(found.first, keys_.size());
  }

  py::tuple update(const Table& boxes) {
    const auto all = rows<Aabb<3, double>>(boxes);
    return answered(timed([&] {
                      for (std::size_t i = 0; i < keys_.size(); ++i) index_.update(keys_[i], all[i]);
                      return keys_.size();
                    }),
                    [](std::size_t count) { return py::int_(count); });
  }

 private:
  Bvh<3, double> index_;
  std::vector<Key> keys_;
};

/// A scene of boxes or of spheres, all of which move.
class World {
 public:
  py::tuple add(const ShapeList& list) {
    return answered(timed([&] {
                      for (const Any& shape : list.shapes()) ids_.push_back(scene_.add(shape));
                      return ids_.size();
                    }),
                    [](std::size_t count) { return py::int_(count); });
  }

  py::tuple move_to_boxes(const Table& boxes) {
    return moved([&] { scene_.move(std::span<const ObjectId>(ids_), rows<Aabb<3, double>>(boxes)); });
  }

  /// As a program does whose centers are in an array.
  py::tuple move_to_spheres(const Table& centers, const Table& radii) {
    const auto middles = rows<Point>(centers);
    return moved([&] {
      std::vector<Sphere<3, double>> spheres(middles.size());
      for (std::size_t i = 0; i < middles.size(); ++i) spheres[i] = {middles[i], radii.data()[i]};
      scene_.move(ids_, spheres);
    });
  }

  py::tuple pairs() const {
    return answered(timed([&] { return scene_.pairs(); }), [](const auto& found) { return py::int_(found.size()); });
  }

 private:
  /// Moves, and counts the pairs that began or ended.
  template <class Move>
  py::tuple moved(const Move& move) {
    return answered(timed([&] {
                      move();
                      const SceneEvents& events = scene_.update();
                      return events.began.size() + events.ended.size();
                    }),
                    [](std::size_t count) { return py::int_(count); });
  }

  Scene<3, double> scene_;
  std::vector<ObjectId> ids_;
};

}  // namespace

PYBIND11_MODULE(native, module) {
  module.def("overlapping_pairs", &overlapping_pairs_of);
  module.def("convex_hull", &hull_of);
  py::class_<Finder>(module, "Finder").def(py::init<>()).def("find", &Finder::find);
  py::class_<ShapeList>(module, "ShapeList")
      .def(py::init<const Table&, const Table&, const Table&>())
      .def(py::init<const Table&, const Table&>())
      .def("bounds", &ShapeList::boxes)
      .def("touching_pairs", &ShapeList::touching)
      .def("relations", &ShapeList::relations_of)
      .def("contacts", &ShapeList::contacts_of)
      .def("intersects", &ShapeList::single_calls);
  py::class_<Surface>(module, "Surface")
      .def(py::init<const Table&, const PairTable&>())
      .def_static("mesh_of", &Surface::made)
      .def("ray_casts", &Surface::hits)
      .def("signed_distances", &Surface::distances)
      .def("closest_points", &Surface::nearest)
      .def("winding_numbers", &Surface::windings);
  py::class_<Index>(module, "Index").def(py::init<>()).def("assign", &Index::assign).def("update_many", &Index::update);
  py::class_<World>(module, "World")
      .def(py::init<>())
      .def("add_many", &World::add)
      .def("move_to_boxes", &World::move_to_boxes)
      .def("move_to_spheres", &World::move_to_spheres)
      .def("pairs", &World::pairs);
}

}  // namespace graze::bench
