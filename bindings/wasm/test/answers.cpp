// SPDX-License-Identifier: MIT
// Writes what this machine's graze answers, for the tests of the module to compare with, into a folder:
//
//   queries.ndjson                  a line for each pair of shapes: both, a point, a ray, and all answers about them
//   touching_2d.json, _3d.json      shapes, candidate pairs of them, and those that touch
//   pairs_2d_float.boxes, .pairs    100,000 boxes as they lie in memory, and their pairs; likewise 3d and double
//   indexes.json                    what trees answer about boxes, and their cells
//   scenes_2d.json, _3d.json        a scene, shapes that move through it, and what its queries answer
#include "answers.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <optional>
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
#include <graze/math/motion.hpp>
#include <graze/query/closest_boundary_point.hpp>
#include <graze/query/closest_point.hpp>
#include <graze/query/closest_points.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/contains.hpp>
#include <graze/query/distance.hpp>
#include <graze/query/manifold.hpp>
#include <graze/query/ray_cast.hpp>
#include <graze/query/relation.hpp>
#include <graze/query/shape_cast.hpp>
#include <graze/query/signed_distance.hpp>
#include <graze/query/time_of_impact.hpp>

#include "catalogue.hpp"

namespace graze::test {
namespace {

/// The arguments of one line.
template <Dim N>
struct Case {
  AnyShape<N, double> a;
  AnyShape<N, double> b;
  Vec<N, double> point;
  Ray<N, double> ray;
};

template <Dim N>
Case<N> draw_case(std::size_t first, std::size_t second) {
  const Source<N, double> from = draw_source<N, double>();
  return {draw_shape_at<N, double>(first, from), draw_shape_at<N, double>(second, from), *from.point,
          Ray<N, double>{*from.point, *from.direction}};
}

template <Dim N>
void put_contact(const std::optional<Contact<N, double>>& found, Numbers& out) {
  if (!found) return;
  out.put<N>(found->point);
  out.put<N>(found->point_a);
  out.put<N>(found->point_b);
  out.put<N>(found->normal);
  out.put(found->depth);
  out.put(found->error);
}

template <Dim N>
void answer_pair(const AnyShape<N, double>& a, const AnyShape<N, double>& b, Numbers& out) {
  out.put(static_cast<double>(relation(a, b)));
  out.put(distance(a, b));
  const Proximity<N, double> near = closest_points(a, b);
  out.put(near.distance);
  out.put<N>(near.point_a);
  out.put<N>(near.point_b);
  out.put<N>(near.normal);
  out.put(near.error);
  put_contact<N>(contact(a, b), out);
  put_manifold<N>(manifold(a, b), out);
}

template <Dim N>
void answer_shape(const Case<N>& asked, Numbers& out) {
  for (const RaySide side : {RaySide::entry, RaySide::exit}) {
    const auto hit = ray_cast(asked.a, asked.ray, std::numeric_limits<double>::infinity(), RayOptions{side});
    if (hit) put_hit<N>(*hit, out);
  }
  out.put(contains(asked.a, asked.point) ? 1 : 0);
  out.put<N>(closest_point(asked.a, asked.point));
  out.put<N>(closest_boundary_point(asked.a, asked.point));
  out.put(signed_distance(asked.a, asked.point));
  out.put<N>(bounds(asked.a));
}

/// The first shape moves along the ray's direction; then both move and rotate.
template <Dim N>
void answer_casts(const Case<N>& asked, Numbers& out) {
  const Vec<N, double>& way = asked.ray.direction;
  if (const auto found = shape_cast(asked.a, way, asked.b)) put_hit<N>(*found, out);
  Motion<N, double> first{way, {}, asked.point};
  Motion<N, double> second{-way, {}, way};
  if constexpr (N == 2) {
    first.angular = 1;
    second.angular = way.x;
  } else {
    first.angular = {1, 0, -2};
    second.angular = way;
  }
  if (const auto found = time_of_impact(asked.a, first, asked.b, second)) put_hit<N>(*found, out);
}

/// With options: the first shape is cast, with each and with both, and contacts have a margin.
template <Dim N>
void answer_options(const Case<N>& asked, Numbers& out) {
  for (const CastOptions options : {CastOptions{true, 0}, CastOptions{false, 0.25}, CastOptions{true, 0.25}}) {
    if (const auto found = shape_cast(asked.a, asked.ray.direction, asked.b, options)) put_hit<N>(*found, out);
  }
  const ContactOptions near{.margin = 2};
  put_contact<N>(contact(asked.a, asked.b, near), out);
  put_manifold<N>(manifold(asked.a, asked.b, near), out);
}

/// Every two types of shapes, several times.
template <Dim N>
void write_queries(std::ostream& out) {
  constexpr std::size_t types = std::variant_size_v<AnyShape<N, double>>;
  constexpr int rounds = 8;
  rc::Random random(20261121 + static_cast<std::uint64_t>(N));
  for (std::size_t k = 0; k < types * types * rounds; ++k) {
    const auto gen = rc::gen::exec([k] { return draw_case<N>(k % types, k / types % types); });
    const Case<N> asked = gen(random.split(), 50).value();
    Numbers answers;
    answer_pair<N>(asked.a, asked.b, answers);
    answer_shape<N>(asked, answers);
    Numbers casts;
    answer_casts<N>(asked, casts);
    Numbers options;
    answer_options<N>(asked, options);
    out << fmt::format(
        "{{\"a\": {}, \"b\": {}, \"point\": {}, \"ray\": {}, \"answers\": {}, \"casts\": {}, \"options\": {}}}\n",
        text_of<N>(asked.a), text_of<N>(asked.b), text_of<N>(asked.point), text_of<N>(asked.ray), answers.list(),
        casts.list(), options.list());
  }
}

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
    const auto gen = rc::gen::exec([i] { return draw_case<N>(i % types, 0); });
    shapes.push_back(gen(random.split(), 50).value().a);
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
  write_queries<2>(queries);
  write_queries<3>(queries);
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
  if (!queries || !flat || !deep || !indexes || !flat_scene || !deep_scene)
    throw std::runtime_error(folder.string() + ": writing failed");
}

}  // namespace
}  // namespace graze::test

int main(int count, char** arguments) {
  if (count != 2) {
    std::cerr << "usage: graze_answers FOLDER\n";
    return 2;
  }
  try {
    graze::test::write_all(arguments[1]);
  } catch (const std::exception& error) {
    std::cerr << "graze_answers: " << error.what() << '\n';
    return 1;
  }
}
