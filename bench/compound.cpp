// SPDX-License-Identifier: MIT
// Compares queries of compounds with and without their tree (3D, double): spheres and boxes that fill a tenth of a
// cube, asked by a thousand small spheres, and rays and motions from one random point to another. Before timing, both
// must give the same answers, bit for bit.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include <graze/math/motion.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/closest_point.hpp>
#include <graze/query/closest_points.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/contains.hpp>
#include <graze/query/intersects.hpp>
#include <graze/query/ray_cast.hpp>
#include <graze/query/shape_cast.hpp>
#include <graze/query/time_of_impact.hpp>
#include <graze/shape/any_shape.hpp>

#include "ratios.hpp"

namespace {

using Any = graze::AnyShape<3, double>;
using Compound = graze::Compound<3, double>;
using Part = graze::Part<3, double>;
using Point = graze::Vec<3, double>;

constexpr std::size_t question_count = 1024;
constexpr std::array<std::size_t, 7> part_counts = {10, 16, 32, 64, 100, 1'000, 10'000};

/// A small sphere, and where it goes.
struct Question {
  Any sphere;
  Point start;
  Point way;
};

/// The same parts with a tree and without.
struct Task {
  Any tree;
  Any loop;
  std::vector<Question> questions;
};

Task draw_task(std::size_t part_count) {
  std::mt19937_64 random(45);
  std::uniform_real_distribution<double> uniform(0, 100);
  const auto point = [&] {
    const double x = uniform(random);
    const double y = uniform(random);
    return Point(x, y, uniform(random));
  };
  const double radius = 30 / std::cbrt(static_cast<double>(part_count));
  std::vector<Part> parts;
  for (std::size_t i = 0; i < part_count; ++i) {
    const Point center = point();
    Any shape = graze::Sphere<3, double>{center, radius};
    if (i % 2 == 1) shape = graze::Aabb<3, double>::from_center(center, Point(0.7 * radius));
    const auto box = bounds(shape);
    parts.push_back({std::move(shape), box});
  }
  Task task{Compound{graze::detail::with_tree(parts)}, Compound{parts}, {}};
  while (task.questions.size() < question_count) {
    const Point start = point();
    task.questions.push_back({graze::Sphere<3, double>{start, radius / 2}, start, point() - start});
  }
  return task;
}

// ---- The queries

const auto ask_intersects = [](const Any& shape, const Question& asked) { return intersects(shape, asked.sphere); };
const auto ask_contains = [](const Any& shape, const Question& asked) { return contains(shape, asked.start); };
const auto ask_closest_point = [](const Any& shape, const Question& asked) {
  return closest_point(shape, asked.start);
};
const auto ask_closest_points = [](const Any& shape, const Question& asked) {
  return closest_points(shape, asked.sphere);
};
const auto ask_contact = [](const Any& shape, const Question& asked) { return contact(shape, asked.sphere); };
const auto ask_ray_cast = [](const Any& shape, const Question& asked) {
  return ray_cast(shape, graze::Ray<3, double>{asked.start, asked.way}, 1.0);
};
const auto ask_shape_cast = [](const Any& shape, const Question& asked) {
  return shape_cast(asked.sphere, asked.way, shape);
};
const auto ask_time_of_impact = [](const Any& shape, const Question& asked) {
  const graze::Motion<3, double> motion{asked.way, Point(0, 0, 1), asked.start};
  return time_of_impact(asked.sphere, motion, shape, graze::Motion<3, double>{});
};

template <class Ask>
void race(const std::string& name, const std::shared_ptr<const Task>& task, const Ask& ask) {
  for (const Question& asked : task->questions) {
    if (ask(task->tree, asked) == ask(task->loop, asked)) continue;
    std::fprintf(stderr, "%s: the tree and the loop disagree\n", name.c_str());
    std::exit(1);
  }
  const auto add = [&](const std::string& contestant, const Any& shape) {
    benchmark::RegisterBenchmark((name + "/" + contestant).c_str(), [task, &shape, ask](benchmark::State& state) {
      for (auto _ : state) {
        for (const Question& asked : task->questions) {
          auto answer = ask(shape, asked);
          benchmark::DoNotOptimize(answer);
        }
      }
      graze::bench::count_things(state, question_count);
    });
  };
  add("graze", task->tree);
  add("loop", task->loop);
}

}  // namespace

int main(int argc, char** argv) {
  for (const std::size_t part_count : part_counts) {
    const auto task = std::make_shared<const Task>(draw_task(part_count));
    const std::string of_parts = ", " + std::to_string(part_count);
    race("intersects" + of_parts, task, ask_intersects);
    race("contains" + of_parts, task, ask_contains);
    race("closest_point" + of_parts, task, ask_closest_point);
    race("closest_points" + of_parts, task, ask_closest_points);
    race("contact" + of_parts, task, ask_contact);
    race("ray_cast" + of_parts, task, ask_ray_cast);
    race("shape_cast" + of_parts, task, ask_shape_cast);
    race("time_of_impact" + of_parts, task, ask_time_of_impact);
  }
  return graze::bench::run_races(argc, argv);
}
