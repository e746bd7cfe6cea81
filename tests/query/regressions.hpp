// SPDX-License-Identifier: MIT
// Cases worth keeping, as rows of a file: the query, the space, both shapes as their numbers in the order of their
// fields, and the true answer.
//
//   relation,3D float,sphere 0 0 0 1,segment 2 0 0 2 1 0,apart
//   point,2D double,triangle 0 0 1 0 0 1,point 0.5 0.25,-0.17677669529663687
//   distance,2D float,sphere 0 0 1,sphere 3 0 1,1
//   contact,2D float,sphere 0 0 1,sphere 1 0 1,-1
//   manifold,2D float,sphere 0 0 1,sphere 1 0 1,-1
//   ray_cast,2D float,sphere 0 0 1,ray 3 0 -1 0,2
//   shape_cast,2D float,sphere 0 0 1 by 3 0,sphere 3 0 1,overlapping
//   time_of_impact,2D float,sphere 0 0 1 by 3 0 0.5 0 0,sphere 3 0 1 by 0 0 0 0 0,touch
//   convex_hull,2D float,compound 4 point 0 0 point 1 0 point 0 1 point 0 0,compound 0,3
//
// A polytope begins with the number of its vertices, a compound with that of its parts, which follow. Numbers are the
// shortest decimals that read back as the same.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <istream>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <graze/math/vec.hpp>
#include <graze/shape/any_shape.hpp>

#include "catalogue.hpp"
#include "query/numbers_of.hpp"

namespace graze::test {

/// One row, still text.
struct Regression {
  std::string query;  ///< "relation", "point" and so on, as in the rows above.
  std::string space;  ///< "3D float".
  std::string a;
  std::string b;
  /// The relation's name, the signed distance, the distance, the gap, where the ray enters, the relation of b and the
  /// region swept by a, whether moving shapes touch, or the number of corners.
  std::string expected;
};

/// "3D float".
template <Dim N, class T>
std::string space_text() {
  return std::to_string(N) + (std::is_same_v<T, float> ? "D float" : "D double");
}

/// The shortest decimals that read back as the same number.
template <class T>
std::string number_text(T x) {
  std::string text = literal(x);
  if (text.back() == 'F') text.pop_back();
  return text;
}

template <Dim N, class T>
std::string shape_text(AnyShape<N, T> shape) {
  std::string text(shape_type_names[shape.index()]);
  const auto append = [&text](T& x) { text += " " + number_text(x); };
  if (const auto* polytope = std::get_if<Polytope<N, T>>(&shape)) {
    text += " " + std::to_string(polytope->vertices().size());
    for (Vec<N, T> vertex : polytope->vertices()) {
      for (Dim i = 0; i < N; ++i) append(vertex[i]);
    }
  } else if (const auto* compound = std::get_if<Compound<N, T>>(&shape)) {
    text += " " + std::to_string(compound->parts.size());
    for (const Part<N, T>& part : compound->parts) text += " " + shape_text<N, T>(part.shape);
  } else if (const auto* mesh = std::get_if<Mesh<N, T>>(&shape)) {
    text += " " + std::to_string(mesh->vertices().size());
    for (Vec<N, T> vertex : mesh->vertices()) {
      for (Dim i = 0; i < N; ++i) append(vertex[i]);
    }
    text += " " + std::to_string(mesh->faces().size());
    for (const auto& face : mesh->faces()) {
      for (const std::uint32_t vertex : face) text += " " + std::to_string(vertex);
    }
  } else {
    for_each_number<N, T>(shape, append);
  }
  return text;
}

/// The number that a whole word is. libc++ 14 has no std::from_chars for float and double.
template <class Number>
std::optional<Number> number_in(const std::string& word) {
  char* end = nullptr;
  Number x{};
  if constexpr (std::is_same_v<Number, float>) {
    x = std::strtof(word.c_str(), &end);
  } else if constexpr (std::is_same_v<Number, double>) {
    x = std::strtod(word.c_str(), &end);
  } else {
    x = static_cast<Number>(std::strtoull(word.c_str(), &end, 10));
  }
  if (word.empty() || end != word.c_str() + word.size()) return std::nullopt;
  return x;
}

template <class Number>
Number read_number(std::istream& words) {
  std::string word;
  words >> word;
  const std::optional<Number> number = number_in<Number>(word);
  if (!number) throw std::runtime_error("regressions: \"" + word + "\" is not a number");
  return *number;
}

/// The default value of the type with this name.
template <Dim N, class T>
AnyShape<N, T> shape_named(std::string_view name) {
  AnyShape<N, T> shape;
  std::size_t index = 0;
  for_each_shape_type<N, T>([&]<class S>(std::type_identity<S>) {
    if (shape_type_names[index++] == name) shape = S{};
  });
  if (shape_type_names[shape.index()] != name) {
    throw std::runtime_error("regressions: no shape is named \"" + std::string(name) + "\"");
  }
  return shape;
}

template <Dim N, class T>
AnyShape<N, T> read_shape(std::istream& words) {
  std::string name;
  words >> name;
  AnyShape<N, T> shape = shape_named<N, T>(name);
  const auto read = [&words](T& x) { x = read_number<T>(words); };
  if (std::holds_alternative<Polytope<N, T>>(shape)) {
    std::vector<Vec<N, T>> vertices(read_number<std::size_t>(words));
    for (Vec<N, T>& vertex : vertices) {
      for (Dim i = 0; i < N; ++i) read(vertex[i]);
    }
    shape = convex_hull<N, T>(vertices);
  } else if (std::holds_alternative<Compound<N, T>>(shape)) {
    std::vector<AnyShape<N, T>> parts(read_number<std::size_t>(words));
    for (AnyShape<N, T>& part : parts) part = read_shape<N, T>(words);
    shape = compound_of<N, T>(std::move(parts));
  } else if (std::holds_alternative<Mesh<N, T>>(shape)) {
    std::vector<Vec<N, T>> vertices(read_number<std::size_t>(words));
    for (Vec<N, T>& vertex : vertices) {
      for (Dim i = 0; i < N; ++i) read(vertex[i]);
    }
    std::vector<std::array<std::uint32_t, 3>> faces(read_number<std::size_t>(words));
    for (auto& face : faces) {
      for (std::uint32_t& vertex : face) vertex = read_number<std::uint32_t>(words);
    }
    shape = mesh_of<N, T>(vertices, faces);
  } else {
    for_each_number<N, T>(shape, read);
  }
  return shape;
}

template <Dim N, class T>
AnyShape<N, T> shape_from(const std::string& text) {
  std::istringstream words(text);
  return read_shape<N, T>(words);
}

template <Dim N, class T>
std::string regression_row(std::string_view query, const AnyShape<N, T>& a, const AnyShape<N, T>& b,
                           std::string_view expected) {
  return std::string(query) + "," + space_text<N, T>() + "," + shape_text<N, T>(a) + "," + shape_text<N, T>(b) + "," +
         std::string(expected);
}

/// A row of `convex_hull`: the points as the parts of a compound, and how many of them are corners. The second shape is
/// a compound without parts.
template <Dim N, class T>
std::string hull_row(const std::vector<Vec<N, T>>& points, std::size_t corners) {
  const std::vector<AnyShape<N, T>> parts(points.begin(), points.end());
  return regression_row<N, T>("convex_hull", compound_of<N, T>(parts), Compound<N, T>{}, std::to_string(corners));
}

/// The rows of a file; none if it does not exist. Lines beginning with # are comments.
inline std::vector<Regression> read_regressions(const std::string& path) {
  std::vector<Regression> rows;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line.front() == '#') continue;
    std::istringstream cells(line);
    Regression row;
    for (std::string* cell : {&row.query, &row.space, &row.a, &row.b, &row.expected}) {
      if (!std::getline(cells, *cell, ',')) throw std::runtime_error("regressions: five cells are needed: " + line);
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace graze::test
