// SPDX-License-Identifier: MIT
#include <cmath>
#include <optional>
#include <variant>

#include "exam/rival.hpp"
#include "exam/textbook.hpp"
#include "exam/textbook_depth.hpp"
#include "exam/textbook_ray.hpp"

namespace graze::exam {
namespace {

template <class T>
std::optional<bool> answer(const Solid3<T>& a, const Solid3<T>& b) {
  return std::visit(
      [](const auto& held_a, const auto& held_b) -> std::optional<bool> {
        if constexpr (requires { textbook::meet(held_a, held_b); }) {
          return textbook::meet(held_a, held_b);
        } else {
          return std::nullopt;
        }
      },
      a, b);
}

template <class T>
std::optional<Proximity> parting(const Solid3<T>& a, const Solid3<T>& b) {
  return std::visit(
      [](const auto& held_a, const auto& held_b) -> std::optional<Proximity> {
        if constexpr (requires { textbook::minimum_translation(held_a, held_b); }) {
          const auto found = textbook::minimum_translation(held_a, held_b);
          if (!found) return Proximity{};
          return Proximity{true, static_cast<double>(found->depth), Vec<3, double>(found->normal)};
        } else {
          return std::nullopt;
        }
      },
      a, b);
}

template <class T>
std::optional<RayVerdict> verdict(const Solid3<T>& shape, const Ray<3, T>& ray) {
  const Vec<3, T> way = ray.direction / std::sqrt(dot(ray.direction, ray.direction));
  return std::visit(
      [&ray, &way](const auto& held) -> std::optional<RayVerdict> {
        if constexpr (requires { textbook::entry(held, ray.origin, way); }) {
          const std::optional<T> distance = textbook::entry(held, ray.origin, way);
          return RayVerdict{distance.has_value(), static_cast<double>(distance.value_or(T(0)))};
        } else {
          return std::nullopt;
        }
      },
      shape);
}

}  // namespace

std::optional<bool> textbook_answer(const Solid3<float>& a, const Solid3<float>& b) { return answer<float>(a, b); }
std::optional<bool> textbook_answer(const Solid3<double>& a, const Solid3<double>& b) { return answer<double>(a, b); }

std::optional<Proximity> textbook_parting(const Solid3<float>& a, const Solid3<float>& b) {
  return parting<float>(a, b);
}
std::optional<Proximity> textbook_parting(const Solid3<double>& a, const Solid3<double>& b) {
  return parting<double>(a, b);
}

std::optional<RayVerdict> textbook_sight(const Solid3<float>& shape, const Ray<3, float>& ray, double) {
  return verdict<float>(shape, ray);
}
std::optional<RayVerdict> textbook_sight(const Solid3<double>& shape, const Ray<3, double>& ray, double) {
  return verdict<double>(shape, ray);
}

}  // namespace graze::exam
