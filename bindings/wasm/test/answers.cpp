// SPDX-License-Identifier: MIT
// Writes what this machine's graze answers, for the tests of the module to compare with, into a folder:
//
//   queries.ndjson                  a line for each pair of shapes: both, a point, a ray, and all answers about them
//   queries_float.ndjson            the same in float
//   cases.ndjson                    the same for the cases that a file lists, if one is given; query_answers.hpp
//   touching_2d.json, _3d.json      shapes, candidate pairs of them, and those that touch
//   pairs_2d_float.boxes, .pairs    100,000 boxes as they lie in memory, and their pairs; likewise 3d and double
//   indexes.json                    what trees answer about boxes, and their cells
//   scenes_2d.json, _3d.json        a scene, shapes that move through it, and what its queries answer
//   meshes_2d.ndjson, _3d.ndjson    a line for each two meshes, and what they answer
#include "answers.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include <graze/broad/bvh.hpp>
#include <graze/broad/orthtree.hpp>
#include <graze/broad/pairs.hpp>
#include <graze/broad/scene_generators.hpp>
#include <graze/broad/touching_pairs.hpp>

#include "catalogue.hpp"
#include "query_answers.hpp"

namespace graze::test {
namespace {

template <class T>
void write_bytes(const std::filesystem::path& path, std::span<const T> values) {
  std::ofstream out(path, std::ios::binary);
  out.write(reinterpret_cast<const char*>(values.data()), static_cast<std::streamsize>(values.size_bytes()));
  if (!out) throw std::runtime_error(path.string() + " cannot be written");
}

template <Dim N, class T>
void write_pairs(const std::filesystem::path& folder) {
  const MovingBoxes<N, T> world(World::brownian, 100000, 7);
  const std::vector<Pair> pairs = overlapping_pairs(world.boxes());
  const std::string name = fmt::format("pairs_{}d_{}", N, std::is_same_v<T, float> ? "float" : "double");
  write_bytes(folder / (name + ".boxes"), world.boxes());
  write_bytes(folder / (name + ".pairs"), std::span<const Pair>(pairs));
}

/// Random shapes of every type; any two that are close in the list are a candidate.
template <Dim N>
void write_touching(std::ostream& out) {
  constexpr std::size_t types = std::variant_size_v<AnyShape<N, double>>;
  constexpr std::size_t count = 600;
  constexpr std::size_t partners = 40;
  rc::Random random(20261122 + static_cast<std::uint64_t>(N));
  std::vector<AnyShape<N, double>> shapes;
  std::string text;
  for (std::size_t i = 0; i < count; ++i) {
    const auto gen = rc::gen::exec([i] { return draw_shape_at<N, double>(i % types, draw_source<N, double>()); });
    shapes.push_back(gen(random.split(), 50).value());
    text += (i > 0 ? ", " : "") + text_of<N>(shapes.back());
  }
  std::vector<Pair> candidates;
  for (std::uint32_t a = 0; a < count; ++a) {
    for (std::uint32_t b = a + 1; b < std::min(count, a + partners); ++b) candidates.push_back({a, b});
  }
  const auto list = [](const std::vector<Pair>& pairs) {
    Numbers numbers;
    for (const Pair& pair : pairs) {
      numbers.put(pair.a);
      numbers.put(pair.b);
    }
    return numbers.list();
  };
  out << fmt::format("{{\"shapes\": [{}], \"candidates\": {}, \"touching\": {}}}\n", text, list(candidates),
                     list(touching_pairs<N, double>(shapes, candidates)));
}

/// The results of an index for the boxes of a world that moved once: the indexes of keys, in order of discovery.
template <class Index>
std::string answers_of(Index index) {
  using Box = typename Index::Box;
  constexpr Dim N = dimension_of<Box>;
  MovingBoxes<N, double> world(World::heavy, 2000, 7);
  Numbers boxes;
  std::vector<Key> keys;
  for (const Box& box : world.boxes()) {
    boxes.put<N>(box);
    keys.push_back(index.insert(box));
  }
  world.step();
  Numbers moved;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    moved.put<N>(world.boxes()[i]);
    index.update(keys[i], world.boxes()[i]);
  }
  const Box all = world.bounds();
  const Sphere<N, double> region{all.center(), max_abs(all.half_extents()) / 3};
  Numbers found;
  index.query(region, [&found](const Key& key) { found.put(key.index); });
  Numbers hits;
  index.ray_cast(Ray<N, double>{all.min, all.max - all.min}, [&hits](const Key& key, double t) {
    hits.put(key.index);
    hits.put(t);
  });
  Numbers near;
  for (const Neighbour& each : index.nearest(all.center(), 20)) {
    near.put(each.key.index);
    near.put(each.distance_squared);
  }
  Numbers cells;
  index.visit_cells([&cells](const auto& cell) {
    cells.put<N>(cell.box);
    for (const double number : {double(cell.depth), double(cell.count), double(cell.is_leaf)}) cells.put(number);
  });
  return fmt::format(
      "{{\"dimension\": {}, \"boxes\": {}, \"moved\": {}, \"region\": {}, \"ray\": {}, \"center\": {}, \"found\": {}, "
      "\"hits\": {}, \"near\": {}, \"cells\": {}}}",
      N, boxes.list(), moved.list(), text_of<N>(region), text_of<N>(Ray<N, double>{all.min, all.max - all.min}),
      text_of<N>(all.center()), found.list(), hits.list(), near.list(), cells.list());
}

void write_all(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  std::ofstream queries(folder / "queries.ndjson");
  write_queries<2, double>(queries);
  write_queries<3, double>(queries);
  std::ofstream float_queries(folder / "queries_float.ndjson");
  write_queries<2, float>(float_queries);
  write_queries<3, float>(float_queries);
  std::ofstream flat(folder / "touching_2d.json");
  write_touching<2>(flat);
  std::ofstream deep(folder / "touching_3d.json");
  write_touching<3>(deep);
  write_pairs<2, float>(folder);
  write_pairs<3, float>(folder);
  write_pairs<2, double>(folder);
  write_pairs<3, double>(folder);
  std::ofstream indexes(folder / "indexes.json");
  indexes << fmt::format("{{\"QuadTree\": {}, \"Octree\": {}, \"Bvh2\": {}, \"Bvh3\": {}}}\n",
                         answers_of(QuadTree<double>(OrthtreeOptions{.capacity = 4, .max_depth = 8})),
                         answers_of(Octree<double>(OrthtreeOptions{.capacity = 4, .max_depth = 8})),
                         answers_of(Bvh<2, double>()), answers_of(Bvh<3, double>(BvhOptions{.margin = 0.5})));
  std::ofstream flat_scene(folder / "scenes_2d.json");
  write_scene<2>(flat_scene);
  std::ofstream deep_scene(folder / "scenes_3d.json");
  write_scene<3>(deep_scene);
  std::ofstream flat_meshes(folder / "meshes_2d.ndjson");
  write_meshes<2>(flat_meshes);
  std::ofstream deep_meshes(folder / "meshes_3d.ndjson");
  write_meshes<3>(deep_meshes);
  if (!queries || !float_queries || !flat || !deep || !indexes || !flat_scene || !deep_scene || !flat_meshes ||
      !deep_meshes)
    throw std::runtime_error(folder.string() + ": writing failed");
}

}  // namespace
}  // namespace graze::test

int main(int count, char** arguments) {
  if (count != 2 && count != 3) {
    std::cerr << "usage: graze_answers FOLDER [CASES]\n";
    return 2;
  }
  try {
    graze::test::write_all(arguments[1]);
    if (count == 3) {
      std::ifstream cases(arguments[2]);
      std::ofstream out(std::filesystem::path(arguments[1]) / "cases.ndjson");
      graze::test::write_cases(cases, out);
      if (!cases.eof() || !out) throw std::runtime_error(std::string(arguments[2]) + " cannot be answered");
    }
  } catch (const std::exception& error) {
    std::cerr << "graze_answers: " << error.what() << '\n';
    return 1;
  }
}
