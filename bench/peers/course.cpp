// SPDX-License-Identifier: MIT
#include "course.hpp"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <variant>

#include <fmt/format.h>

#include <graze/io/scene_file.hpp>

namespace graze::race {
namespace {

constexpr std::size_t most_at_one_point = 3000;
constexpr double friendly_target = 10;
constexpr double hostile_target = 6;
constexpr double any_target = 2;

bool take_prefix(std::string_view& text, std::string_view prefix) {
  if (!text.starts_with(prefix)) return false;
  text.remove_prefix(prefix.size());
  return true;
}

std::string known_worlds() {
  std::string names;
  for (const World world : all_worlds()) names += (names.empty() ? "" : ", ") + std::string(name_of(world));
  return names;
}

template <Dim N>
std::vector<Aabb<N, double>> boxes_of(const Scene<N, double>& scene) {
  std::vector<Aabb<N, double>> boxes;
  boxes.reserve(scene.size());
  for (const ObjectId id : scene.ids()) boxes.push_back(scene.object(id).box);
  return boxes;
}

template <Dim N>
bool fit_float(const std::vector<Aabb<N, double>>& boxes) {
  const auto fits = [](const Vec<N, double>& v) { return Vec<N, double>(Vec<N, float>(v)) == v; };
  return std::all_of(boxes.begin(), boxes.end(), [&](const auto& box) { return fits(box.min) && fits(box.max); });
}

double target_of(World world) {
  switch (world) {
    case World::brownian:
    case World::cluster:
    case World::lattice:
      return friendly_target;
    case World::heavy:
    case World::line:
    case World::giants:
      return hostile_target;
    case World::plane:
    case World::point:
      break;
  }
  return any_target;
}

}  // namespace

Trajectory world_course(std::string_view text) {
  Trajectory course;
  std::string_view rest = text;
  if (take_prefix(rest, "2d:")) course.dimension = 2;
  if (take_prefix(rest, "double:")) course.is_double = true;
  course.world = world_named(rest);
  if (!course.world) {
    throw std::invalid_argument(
        fmt::format("there is no scene \"{}\"; scenes are {}, each also with 2d:, double: or 2d:double: before it",
                    text, known_worlds()));
  }
  course.name = rest;
  return course;
}

std::vector<Trajectory> file_courses(const std::string& path) {
  const auto courses = [&path](const auto& boxes, Dim dimension) {
    const Trajectory in_double{std::filesystem::path(path).filename().string(), std::nullopt, path, dimension, true};
    std::vector<Trajectory> found{in_double};
    if (fit_float(boxes)) {
      found.push_back(in_double);
      found.back().is_double = false;
    }
    return found;
  };
  const io::AnyScene scene = io::read_scene(path).scene;
  if (const auto* flat = std::get_if<Scene<2, double>>(&scene)) return courses(boxes_of(*flat), 2);
  return courses(boxes_of(std::get<Scene<3, double>>(scene)), 3);
}

std::string title_of(const Trajectory& course) {
  return fmt::format("{}, {}D {}", course.name, course.dimension, course.is_double ? "double" : "float");
}

double target_of(const Trajectory& course, std::size_t count) {
  if (!course.world) return hostile_target;
  return count >= 100'000 && count <= 1'000'000 ? target_of(*course.world) : any_target;
}

std::size_t most_boxes_on(const Trajectory& course) {
  return course.world == World::point ? most_at_one_point : std::numeric_limits<std::size_t>::max();
}

template <Dim N, class T>
Frames<N, T>::Frames(const Trajectory& course, std::size_t count, std::uint64_t seed) {
  if (course.world) {
    world_.emplace(*course.world, count, seed);
    return;
  }
  const io::AnyScene scene = io::read_scene(course.file).scene;
  for (const Aabb<N, double>& box : boxes_of(std::get<Scene<N, double>>(scene))) {
    still_.push_back({Vec<N, T>(box.min), Vec<N, T>(box.max)});
  }
}

template class Frames<2, float>;
template class Frames<2, double>;
template class Frames<3, float>;
template class Frames<3, double>;

}  // namespace graze::race
