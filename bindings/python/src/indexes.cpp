// SPDX-License-Identifier: MIT
// Indexes of moving boxes: Bvh, Orthtree and Grid.
#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <mutex>
#include <shared_mutex>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <graze/broad/batch/answers.hpp>
#include <graze/broad/bvh.hpp>
#include <graze/broad/grid.hpp>
#include <graze/broad/orthtree.hpp>
#include <graze/broad/touching/pair_tasks.hpp>

#include "keys.hpp"
#include "module.hpp"

namespace graze::python {
namespace {

/// An index of any world. Readers share a lock; a call that changes it has it alone.
template <template <Dim, class> class Index>
struct HeldIndex {
  InAnyWorld<Index> any;
  std::uint32_t owner = 0;  ///< That of all keys.
  std::unique_ptr<std::shared_mutex> lock = std::make_unique<std::shared_mutex>();
};

}  // namespace

template <>
struct BoxedName<HeldIndex<Bvh>> {
  static constexpr auto name = py::detail::const_name("Bvh");
};
template <>
struct BoxedName<HeldIndex<Orthtree>> {
  static constexpr auto name = py::detail::const_name("Orthtree");
};
template <>
struct BoxedName<HeldIndex<Grid>> {
  static constexpr auto name = py::detail::const_name("Grid");
};

namespace {

/// The methods of one type of index.
template <template <Dim, class> class Index>
struct Methods {
  using Held = HeldIndex<Index>;

  /// use(index) of its world, under a lock for reading, without the GIL.
  template <class Use>
  static auto read(const Held& held, const Use& use) {
    return std::visit(
        [&](const auto& index) {
          return without_gil([&] {
            const std::shared_lock lock(*held.lock);
            return use(index);
          });
        },
        held.any);
  }

  template <class Use>
  static auto write(Held& held, const Use& use) {
    return std::visit(
        [&](auto& index) {
          return without_gil([&] {
            const std::scoped_lock lock(*held.lock);
            return use(index);
          });
        },
        held.any);
  }

  template <class Use>
  static auto in_world_of(const Held& held, const Use& use) {
    return std::visit([&]<Dim N, class T>(const Index<N, T>&) { return use(In<N, T>()); }, held.any);
  }

  static World world(const Held& held) {
    return in_world_of(held, []<Dim N, class T>(In<N, T>) { return In<N, T>::world; });
  }

  template <Dim N, class T>
  static Aabb<N, T> box_of(const py::object& value) {
    const std::array<std::size_t, 1> sizes = {2 * static_cast<std::size_t>(N)};
    const py::array numbers = numbers_of<T>({"index", "box"}, value, sizes);
    return *static_cast<const Aabb<N, T>*>(numbers.data());
  }

  static Rows boxes_of(const Held& held, const char* function, const py::object& boxes) {
    const World of_index = world(held);
    return rows_in({function, "boxes"}, boxes, 2 * static_cast<std::size_t>(of_index.dimension), of_index, "the index");
  }

  static std::uint64_t insert(Held& held, const py::object& value) {
    return in_world_of(held, [&]<Dim N, class T>(In<N, T>) {
      const Aabb<N, T> box = box_of<N, T>(value);
      const Key key = write(held, [&](auto& index) {
        if constexpr (std::is_same_v<std::remove_cvref_t<decltype(index)>, Index<N, T>>) {
          return index.insert(box);
        } else {
          return Key{};
        }
      });
      held.owner = key.owner;
      return packed(key);
    });
  }

  static void update(Held& held, const py::object& number, const py::object& value) {
    const Key key = unpacked<Key>(packed_of({"update", "key"}, number), held.owner);
    std::visit(
        [&]<Dim N, class T>(Index<N, T>& index) {
          const Aabb<N, T> box = box_of<N, T>(value);
          without_gil([&] {
            const std::scoped_lock lock(*held.lock);
            index.update(key, box);
          });
        },
        held.any);
  }

  /// Many boxes at once, or none if a key or a box is not valid.
  static void update_many(Held& held, const py::object& numbers, const py::object& values) {
    const PackedNumbers keys({"update_many", "keys"}, numbers);
    const Rows rows = boxes_of(held, "update_many", values);
    if (rows.count != keys.size()) {
      throw py::value_error(fmt::format("update_many: there are {} keys and {} boxes", keys.size(), rows.count));
    }
    std::visit(
        [&]<Dim N, class T>(Index<N, T>& index) {
          without_gil([&] {
            const std::scoped_lock lock(*held.lock);
            const auto boxes = rows.as<Aabb<N, T>>();
            for (std::size_t i = 0; i < keys.size(); ++i) {
              (void)index.box(unpacked<Key>(keys[i], held.owner));
              detail::require_box(boxes[i]);
            }
            for (std::size_t i = 0; i < keys.size(); ++i) index.update(unpacked<Key>(keys[i], held.owner), boxes[i]);
          });
        },
        held.any);
  }

  static void erase(Held& held, const py::object& number) {
    const Key key = unpacked<Key>(packed_of({"erase", "key"}, number), held.owner);
    write(held, [&](auto& index) { index.erase(key); });
  }

  static py::array assign(Held& held, const py::object& values) {
    const Rows rows = boxes_of(held, "assign", values);
    return std::visit(
        [&]<Dim N, class T>(Index<N, T>& index) {
          const std::vector<Key> keys = without_gil([&] {
            const std::scoped_lock lock(*held.lock);
            const auto boxes = rows.as<Aabb<N, T>>();
            if constexpr (requires { index.assign(boxes); }) {
              return index.assign(boxes);
            } else {
              for (const Aabb<N, T>& box : boxes) detail::require_box(box);
              index.clear();
              std::vector<Key> given;
              for (const Aabb<N, T>& box : boxes) given.push_back(index.insert(box));
              return given;
            }
          });
          if (!keys.empty()) held.owner = keys.front().owner;
          return array_of_names<Key>(keys);
        },
        held.any);
  }

  static bool contains(const Held& held, const py::object& number) {
    const std::optional<std::uint64_t> packed_key = packed_if_possible({"contains", "key"}, number);
    if (!packed_key) return false;
    const Key key = unpacked<Key>(*packed_key, held.owner);
    return read(held, [&](const auto& index) { return index.contains(key); });
  }

  static py::array box(const Held& held, const py::object& number) {
    const Key key = unpacked<Key>(packed_of({"box", "key"}, number), held.owner);
    return std::visit(
        [&]<Dim N, class T>(const Index<N, T>& index) {
          const Aabb<N, T> found = without_gil([&] {
            const std::shared_lock lock(*held.lock);
            return index.box(key);
          });
          return frozen_array<T>(&found.min[0], {static_cast<py::ssize_t>(2 * N)});
        },
        held.any);
  }

  static std::size_t size(const Held& held) {
    return read(held, [](const auto& index) { return index.size(); });
  }

  static py::array query(const Held& held, const HeldShape& region) {
    return std::visit(
        [&]<Dim N, class T>(const Index<N, T>& index) {
          const AnyShape<N, T>& shape = shape_in<N, T>("query: region is", region, "the index");
          std::vector<Key> keys = without_gil([&] {
            const std::shared_lock lock(*held.lock);
            std::vector<Key> found;
            index.query(shape, [&found](const Key& key) { found.push_back(key); });
            std::sort(found.begin(), found.end());
            return found;
          });
          return array_of_names<Key>(keys);
        },
        held.any);
  }

  /// For each box the keys of those that it meets, in parallel: rows and keys.
  static py::tuple query_many(const Held& held, const py::object& values, const py::object& threads) {
    const Rows rows = boxes_of(held, "query_many", values);
    const Threads used("query_many", threads);
    std::vector<std::int64_t> places;
    std::vector<std::uint64_t> keys;
    std::visit(
        [&]<Dim N, class T>(const Index<N, T>& index) {
          without_gil([&] {
            const std::shared_lock lock(*held.lock);
            const auto boxes = rows.as<Aabb<N, T>>();
            const auto found =
                detail::answers<std::vector<std::uint64_t>>(boxes.size(), {&used.executor()}, [&](std::size_t i) {
                  std::vector<std::uint64_t> met;
                  index.query(boxes[i], [&met](const Key& key) { met.push_back(packed(key)); });
                  std::sort(met.begin(), met.end());
                  return met;
                });
            for (std::size_t i = 0; i < found.size(); ++i) {
              places.insert(places.end(), found[i].size(), static_cast<std::int64_t>(i));
              keys.insert(keys.end(), found[i].begin(), found[i].end());
            }
          });
        },
        held.any);
    return py::make_tuple(array_of<std::int64_t>(std::move(places), 0), array_of<std::uint64_t>(std::move(keys), 0));
  }

  /// Keys and times, in order of the time.
  template <class Visit>
  static py::tuple timed(const Held& held, const Visit& visit) {
    std::vector<std::uint64_t> keys;
    std::vector<double> times;
    without_gil([&] {
      const std::shared_lock lock(*held.lock);
      visit([&](const Key& key, double t) {
        keys.push_back(packed(key));
        times.push_back(t);
      });
    });
    return py::make_tuple(array_of<std::uint64_t>(std::move(keys), 0), array_of<double>(std::move(times), 0));
  }

  static py::tuple ray_cast(const Held& held, const HeldShape& shape) {
    return std::visit(
        [&]<Dim N, class T>(const Index<N, T>& index) {
          const auto* const any = std::get_if<AnyShape<N, T>>(&shape.any);
          const auto* const ray = any == nullptr ? nullptr : std::get_if<Ray<N, T>>(any);
          if (ray == nullptr) {
            throw py::type_error(fmt::format("ray_cast: ray is {}; a Ray in {}D of {} is needed", described(shape), N,
                                             name_of_numbers(In<N, T>::world)));
          }
          return timed(held, [&](const auto& note) { index.ray_cast(*ray, note); });
        },
        held.any);
  }

  static py::tuple cast(const Held& held, const py::object& value, const py::object& motion) {
    return std::visit(
        [&]<Dim N, class T>(const Index<N, T>& index) {
          const Aabb<N, T> box = box_of<N, T>(value);
          const auto way = point_of<N, T>({"cast", "motion"}, motion);
          return timed(held, [&](const auto& note) { index.cast(box, way, note); });
        },
        held.any);
  }

  static py::tuple nearest(const Held& held, const py::object& point, std::size_t k) {
    std::vector<std::uint64_t> keys;
    std::vector<double> distances;
    std::visit(
        [&]<Dim N, class T>(const Index<N, T>& index) {
          const auto at = point_of<N, T>({"nearest", "point"}, point);
          without_gil([&] {
            const std::shared_lock lock(*held.lock);
            for (const Neighbour& found : index.nearest(at, k)) {
              keys.push_back(packed(found.key));
              distances.push_back(found.distance_squared);
            }
          });
        },
        held.any);
    return py::make_tuple(array_of<std::uint64_t>(std::move(keys), 0), array_of<double>(std::move(distances), 0));
  }

  /// For each point a row of keys and one of squared distances, in parallel.
  static py::tuple nearest_many(const Held& held, const py::object& values, std::size_t k, const py::object& threads) {
    const Argument argument{"nearest_many", "points"};
    const World of_index = world(held);
    const Rows rows = rows_in(argument, values, static_cast<std::size_t>(of_index.dimension), of_index, "the index");
    require_finite(argument, rows);
    const Threads used("nearest_many", threads);
    return std::visit(
        [&]<Dim N, class T>(const Index<N, T>& index) {
          constexpr std::size_t points_per_task = 256;
          auto found = without_gil([&] {
            const std::shared_lock lock(*held.lock);
            const std::size_t columns = std::min(k, index.size());
            NewRows<std::uint64_t> keys(rows.count * columns);
            NewRows<double> distances(rows.count * columns);
            const auto points = rows.as<Vec<N, T>>();
            detail::in_tasks(points.size(), points_per_task, used.executor(), [&](std::size_t first, std::size_t last) {
              std::size_t place = first * columns;
              for (std::size_t i = first; i < last; ++i) {
                for (const Neighbour& near : index.nearest(points[i], columns)) {
                  keys[place] = packed(near.key);
                  distances[place++] = near.distance_squared;
                }
              }
            });
            return std::tuple(std::move(keys), std::move(distances), columns);
          });
          const py::tuple shape = py::make_tuple(rows.count, std::get<2>(found));
          const auto shaped = [&shape](const py::array& array) { return array.attr("reshape")(shape); };
          return py::make_tuple(shaped(array_of<std::uint64_t>(std::move(std::get<0>(found)), 0)),
                                shaped(array_of<double>(std::move(std::get<1>(found)), 0)));
        },
        held.any);
  }

  static py::array pairs(const Held& held) {
    std::vector<std::array<std::uint64_t, 2>> found;
    read(held, [&found](const auto& index) {
      index.pairs([&found](const Key& a, const Key& b) { found.push_back({packed(a), packed(b)}); });
    });
    return array_of<std::uint64_t>(std::move(found), 2);
  }

  template <class Make>
  static void add(py::module_& module, const char* name, const char* doc, const Make& make) {
    TypeMaker maker = TypeMaker::of<Held>(module, name, doc);
    maker.constructor(make, py::arg("dimension") = 3, py::arg("dtype") = py::none());
    maker.method("insert", &insert, py::arg("box"), "Adds a box, (2 * N,): minima, then maxima. Returns its key.");
    maker.method("assign", &assign, py::arg("boxes"),
                 "Replaces all boxes by these, (n, 2 * N). Returns their keys, (n,).");
    maker.method("update", &update, py::arg("key"), py::arg("box"), "Replaces a box.");
    maker.method("update_many", &update_many, py::arg("keys"), py::arg("boxes"),
                 "Replaces many boxes, or none if a key or a box is not valid.");
    maker.method("erase", &erase, py::arg("key"), "Removes a box; its key is never valid again.");
    maker.method(
        "clear", [](Held& held) { write(held, [](auto& index) { index.clear(); }); }, "Removes all boxes.");
    maker.method("__len__", &size);
    maker.method("__contains__", &contains, py::arg("key"));
    maker.method("box", &box, py::arg("key"), "The box of a key.");
    maker.method("query", &query, py::arg("region"), "The keys of all boxes that meet a shape, ascending.");
    maker.method("query_many", &query_many, py::arg("boxes"), py::kw_only(), py::arg("threads") = py::none(),
                 "For many boxes (n, 2 * N) the boxes that they meet: rows and keys, ascending.");
    maker.method("ray_cast", &ray_cast, py::arg("ray"), "The boxes that a Ray enters: keys and t, by t.");
    maker.method("cast", &cast, py::arg("box"), py::arg("motion"),
                 "The boxes that a moving box touches: keys and t from 0 to 1, by t.");
    maker.method("nearest", &nearest, py::arg("point"), py::arg("k") = 1,
                 "The k boxes nearest to a point (N,): keys and squared distances, by distance.");
    maker.method(
        "nearest_many", &nearest_many, py::arg("points"), py::arg("k") = 1, py::kw_only(),
        py::arg("threads") = py::none(),
        "For each of many points (n, N) the k boxes nearest to it, or all if there are fewer: keys and squared "
        "distances, (n, k) each.");
    maker.method("pairs", &pairs, "All pairs of boxes that share a point: (n, 2) keys, ascending.");
    maker.property(
        "dimension", [](const Held& held) { return world(held).dimension; }, "2 or 3");
    maker.property(
        "dtype", [](const Held& held) { return py::dtype(std::string(name_of_numbers(world(held)))); },
        "float32 or float64");
    maker.finish();
  }
};

template <template <Dim, class> class Index>
py::object new_index(const py::object& dimension, const py::object& dtype) {
  return in_world(world_of_words("index", dimension, dtype),
                  []<Dim N, class T>(In<N, T>) { return boxed(HeldIndex<Index>{Index<N, T>()}); });
}

}  // namespace

void add_indexes(py::module_& module) {
  Methods<Bvh>::add(module, "graze.Bvh",
                    "Bvh(dimension=3, dtype=numpy.float64)\n--\n\nAn index of moving boxes: the fastest to query.",
                    &new_index<Bvh>);
  Methods<Orthtree>::add(
      module, "graze.Orthtree",
      "Orthtree(dimension=3, dtype=numpy.float64)\n--\n\nAn index of moving boxes: a quadtree in 2D, an "
      "octree in 3D.",
      &new_index<Orthtree>);
  Methods<Grid>::add(
      module, "graze.Grid",
      "Grid(dimension=3, dtype=numpy.float64)\n--\n\nAn index of moving boxes: equal cells, found by hashing.",
      &new_index<Grid>);
}

}  // namespace graze::python
