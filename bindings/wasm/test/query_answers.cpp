// SPDX-License-Identifier: MIT
#include "query_answers.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include <graze/io/shape_numbers.hpp>
#include <graze/math/motion.hpp>
#include <graze/query/bounding.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/closest_boundary_point.hpp>
#include <graze/query/closest_point.hpp>
#include <graze/query/closest_points.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/contains.hpp>
#include <graze/query/distance.hpp>
#include <graze/query/manifold.hpp>
#include <graze/query/mass_properties.hpp>
#include <graze/query/ray_cast.hpp>
#include <graze/query/relation.hpp>
#include <graze/query/shape_cast.hpp>
#include <graze/query/signed_distance.hpp>
#include <graze/query/time_of_impact.hpp>

#include "answers.hpp"
#include "catalogue.hpp"
#include "query/regressions.hpp"

namespace graze::test {
namespace {

/// The arguments of one line.
template <Dim N, class T>
struct Case {
  AnyShape<N, T> a;
  AnyShape<N, T> b;
  Vec<N, T> point;
  Ray<N, T> ray;
  Motion<N, T> motion_a;
  Motion<N, T> motion_b;
};

/// The first shape moves along the ray's direction; then both move and rotate.
template <Dim N, class T>
Case<N, T> case_of(AnyShape<N, T> a, AnyShape<N, T> b, const Vec<N, T>& point, const Vec<N, T>& way) {
  Motion<N, T> first{way, {}, point};
  Motion<N, T> second{-way, {}, way};
  if constexpr (N == 2) {
    first.angular = 1;
    second.angular = way.x;
  } else {
    first.angular = {1, 0, -2};
    second.angular = way;
  }
  return {std::move(a), std::move(b), point, Ray<N, T>{point, way}, first, second};
}

template <Dim N, class T>
Case<N, T> draw_case(std::size_t first, std::size_t second) {
  const Source<N, T> from = draw_source<N, T>();
  return case_of<N, T>(draw_shape_at<N, T>(first, from), draw_shape_at<N, T>(second, from), *from.point,
                       *from.direction);
}

template <Dim N, class T>
void put_contact(const std::optional<Contact<N, T>>& found, Numbers& out) {
  if (!found) return;
  out.put<N>(found->point);
  out.put<N>(found->point_a);
  out.put<N>(found->point_b);
  out.put<N>(found->normal);
  out.put(found->depth);
  out.put(found->error);
}

template <Dim N, class T>
void answer_pair(const AnyShape<N, T>& a, const AnyShape<N, T>& b, Numbers& out) {
  out.put(static_cast<double>(relation(a, b)));
  out.put(distance(a, b));
  const Proximity<N, T> near = closest_points(a, b);
  out.put(near.distance);
  out.put<N>(near.point_a);
  out.put<N>(near.point_b);
  out.put<N>(near.normal);
  out.put(near.error);
  put_contact<N, T>(contact(a, b), out);
  put_manifold<N>(manifold(a, b), out);
}

template <Dim N, class T>
void answer_shape(const Case<N, T>& asked, Numbers& out) {
  for (const RaySide side : {RaySide::entry, RaySide::exit}) {
    const auto hit = ray_cast(asked.a, asked.ray, std::numeric_limits<T>::infinity(), RayOptions{side});
    if (hit) put_hit<N>(*hit, out);
  }
  out.put(contains(asked.a, asked.point) ? 1 : 0);
  out.put<N>(closest_point(asked.a, asked.point));
  out.put<N>(closest_boundary_point(asked.a, asked.point));
  out.put(signed_distance(asked.a, asked.point));
  out.put<N>(bounds(asked.a));
}

template <Dim N, class T>
void answer_casts(const Case<N, T>& asked, Numbers& out) {
  if (const auto found = shape_cast(asked.a, asked.ray.direction, asked.b)) put_hit<N>(*found, out);
  if (const auto found = time_of_impact(asked.a, asked.motion_a, asked.b, asked.motion_b)) put_hit<N>(*found, out);
}

/// With options: the first shape is cast, with each and with both, and contacts have a margin.
template <Dim N, class T>
void answer_options(const Case<N, T>& asked, Numbers& out) {
  for (const CastOptions options : {CastOptions{true, 0}, CastOptions{false, 0.25}, CastOptions{true, 0.25}}) {
    if (const auto found = shape_cast(asked.a, asked.ray.direction, asked.b, options)) put_hit<N>(*found, out);
  }
  const ContactOptions near{.margin = 2};
  put_contact<N, T>(contact(asked.a, asked.b, near), out);
  put_manifold<N>(manifold(asked.a, asked.b, near), out);
}

template <Dim N, class T>
void put_motion(const Motion<N, T>& motion, Numbers& out) {
  out.put<N>(motion.linear);
  if constexpr (N == 2) out.put(motion.angular);
  if constexpr (N == 3) out.put<N>(motion.angular);
  out.put<N>(motion.center);
}

/// The members of a line.
template <Dim N, class T>
std::string answers_about(const Case<N, T>& asked) {
  const auto text = [](const AnyShape<N, T>& shape) { return text_of<N>(io::with_numbers<double, N, T>(shape)); };
  Numbers answers;
  answer_pair<N, T>(asked.a, asked.b, answers);
  answer_shape<N, T>(asked, answers);
  Numbers casts;
  answer_casts<N, T>(asked, casts);
  Numbers options;
  answer_options<N, T>(asked, options);
  Numbers motions;
  put_motion<N, T>(asked.motion_a, motions);
  put_motion<N, T>(asked.motion_b, motions);
  return fmt::format(
      "\"a\": {}, \"b\": {}, \"point\": {}, \"ray\": {}, \"motions\": {}, \"answers\": {}, \"casts\": {}, "
      "\"options\": {}",
      text(asked.a), text(asked.b), text(asked.point), text(asked.ray), motions.list(), answers.list(), casts.list(),
      options.list());
}

// ---- Cases of a list

/// The numbers after the name and the count of a polytope, as points.
template <Dim N, class T>
std::vector<Vec<N, T>> points_in(const std::string& text) {
  std::istringstream words(text);
  std::string word;
  words >> word >> word;
  std::vector<Vec<N, T>> points;
  for (Vec<N, T> point; words >> word; points.push_back(point)) {
    for (Dim i = 0; i < N; ++i) {
      if (i > 0) words >> word;
      std::istringstream number(word);
      point[i] = read_number<T>(number);
    }
  }
  return points;
}

/// What is made of a polytope's points: the corners of their hull, and the spheres and boxes around them.
template <Dim N, class T>
std::string constructions(const std::vector<Vec<N, T>>& points) {
  Numbers given;
  for (const Vec<N, T>& point : points) given.put<N>(point);
  Numbers made;
  const Polytope<N, T> hull = convex_hull<N, T>(points);
  for (const Vec<N, T>& corner : hull.vertices()) made.put<N>(corner);
  for (const Sphere<N, T>& sphere : {bounding_sphere(points), bounding_sphere_fast(points)}) {
    made.put<N>(sphere.center);
    made.put(sphere.radius);
  }
  made.put<N>(bounding_box(points));
  const Obb<N, T> box = bounding_obb(points);
  made.put<N>(box.center);
  made.put<N>(box.half_extents);
  for (Dim i = 0; i < N; ++i) made.put<N>(box.axes[i]);
  return fmt::format(", \"points\": {}, \"constructions\": {}", given.list(), made.list());
}

template <Dim N, class T>
std::string mass(const AnyShape<N, T>& shape) {
  const MassProperties<N> found = mass_properties(shape);
  Numbers out;
  out.put(found.volume);
  out.put<N>(found.centroid);
  if constexpr (N == 2) out.put(found.inertia);
  if constexpr (N == 3) {
    for (Dim i = 0; i < N; ++i) out.put<N>(found.inertia[i]);
  }
  return fmt::format(", \"mass\": {}", out.list());
}

/// A shape, and the numbers of its motion if it has one.
template <Dim N, class T>
std::pair<AnyShape<N, T>, std::vector<T>> moving(const std::string& text) {
  const std::size_t by = text.find(" by ");
  std::vector<T> numbers;
  if (by != std::string::npos) {
    std::istringstream words(text.substr(by + 4));
    for (std::string word; words >> word;) {
      std::istringstream number(word);
      numbers.push_back(read_number<T>(number));
    }
  }
  return {shape_from<N, T>(text.substr(0, by)), numbers};
}

template <Dim N, class T>
Motion<N, T> motion_of(const std::vector<T>& numbers) {
  Motion<N, T> motion;
  std::size_t i = 0;
  for (Dim axis = 0; axis < N; ++axis) motion.linear[axis] = numbers.at(i++);
  if constexpr (N == 2) motion.angular = numbers.at(i++);
  if constexpr (N == 3) {
    for (Dim axis = 0; axis < N; ++axis) motion.angular[axis] = numbers.at(i++);
  }
  for (Dim axis = 0; axis < N; ++axis) motion.center[axis] = numbers.at(i++);
  return motion;
}

/// The point is the second shape, if that is one, and the ray likewise; else they are the same in all cases.
template <Dim N, class T>
void write_case(const std::vector<std::string>& cells, std::ostream& out) {
  const auto& [a, motion_a] = moving<N, T>(cells[2]);
  const auto& [b, motion_b] = moving<N, T>(cells[3] == "-" ? cells[2] : cells[3]);
  Vec<N, T> way(T(1));
  if (!motion_a.empty()) {
    for (Dim i = 0; i < N; ++i) way[i] = motion_a.at(static_cast<std::size_t>(i));
  }
  if (!is_valid(Ray<N, T>{Vec<N, T>(T(0)), way})) way = Vec<N, T>(T(1));  // a motion may have no length, a ray not
  const auto* const point = std::get_if<Vec<N, T>>(&b);
  Case<N, T> asked = case_of<N, T>(a, b, point != nullptr ? *point : Vec<N, T>(T(0.25)), way);
  if (const auto* const ray = std::get_if<Ray<N, T>>(&b)) asked.ray = *ray;
  if (cells[1] == "impact") {
    asked.motion_a = motion_of<N, T>(motion_a);
    asked.motion_b = motion_of<N, T>(motion_b);
  }
  std::string more;
  if (std::holds_alternative<Polytope<N, T>>(a)) {
    more += constructions<N, T>(points_in<N, T>(cells[2].substr(0, cells[2].find(" by "))));
  }
  if (cells[1] == "mass" || cells[1] == "hull") more += mass<N, T>(a);
  out << fmt::format("{{\"number\": \"{}\", {}{}}}\n", sizeof(T) == sizeof(float) ? "float32" : "float64",
                     answers_about<N, T>(asked), more);
}

}  // namespace

template <Dim N, class T>
void write_queries(std::ostream& out) {
  constexpr std::size_t types = std::variant_size_v<AnyShape<N, T>>;
  constexpr int rounds = 8;
  rc::Random random(20261121 + static_cast<std::uint64_t>(N));
  for (std::size_t k = 0; k < types * types * rounds; ++k) {
    const auto gen = rc::gen::exec([k] { return draw_case<N, T>(k % types, k / types % types); });
    out << fmt::format("{{{}}}\n", answers_about<N, T>(gen(random.split(), 50).value()));
  }
}

void write_cases(std::istream& cases, std::ostream& out) {
  for (std::string line; std::getline(cases, line);) {
    std::istringstream text(line);
    std::vector<std::string> cells;
    for (std::string cell; std::getline(text, cell, '\t');) cells.push_back(cell);
    if (cells.size() != 4) throw std::runtime_error("a case needs four cells: " + line);
    const std::string asked = cells[1];
    const bool in_float = asked.find("double") == std::string::npos;
    const bool in_double = asked.find("float") == std::string::npos;
    cells[1] = asked.substr(asked.rfind(' ') + 1);
    if (cells[0] == "2D" && in_double) write_case<2, double>(cells, out);
    if (cells[0] == "2D" && in_float) write_case<2, float>(cells, out);
    if (cells[0] == "3D" && in_double) write_case<3, double>(cells, out);
    if (cells[0] == "3D" && in_float) write_case<3, float>(cells, out);
  }
}

template void write_queries<2, float>(std::ostream&);
template void write_queries<3, float>(std::ostream&);
template void write_queries<2, double>(std::ostream&);
template void write_queries<3, double>(std::ostream&);

}  // namespace graze::test
