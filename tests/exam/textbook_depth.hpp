// SPDX-License-Identifier: MIT
// Depth and normal as in textbooks and tutorials, in the shapes' own number type: for pairs of spheres and boxes. They
// are compared with graze, which does not use them. The normal is the direction in which the second shape must move to
// separate.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/obb.hpp>
#include <graze/shape/sphere.hpp>

#include "exam/textbook.hpp"

namespace graze::exam::textbook {

template <class T>
struct MinimumTranslation {
  T depth;
  Vec3<T> normal;
};

template <class T>
std::optional<MinimumTranslation<T>> minimum_translation(const Sphere<3, T>& a, const Sphere<3, T>& b) {
  const Vec3<T> off = b.center - a.center;
  const T distance = std::sqrt(dot(off, off));
  const T depth = a.radius + b.radius - distance;
  if (depth < 0) return std::nullopt;
  return MinimumTranslation<T>{depth, distance > 0 ? off / distance : Vec3<T>(T(1), T(0), T(0))};
}

/// From the nearest point of the box to the center, or from a center inside it through the nearest face.
template <class T>
std::optional<MinimumTranslation<T>> minimum_translation(const Sphere<3, T>& sphere, const Obb<3, T>& box) {
  const Vec3<T> to_center = sphere.center - box.center;
  Vec3<T> nearest = box.center;
  T least = std::numeric_limits<T>::infinity();
  Vec3<T> face = box.axes[0];
  for (Dim i = 0; i < 3; ++i) {
    const T along = dot(to_center, box.axes[i]);
    const T inside = box.half_extents[i] - std::fabs(along);
    if (inside < least) {
      least = inside;
      face = along < 0 ? -box.axes[i] : box.axes[i];
    }
    nearest += box.axes[i] * std::clamp(along, -box.half_extents[i], box.half_extents[i]);
  }
  if (least >= 0) return MinimumTranslation<T>{sphere.radius + least, -face};
  const Vec3<T> off = nearest - sphere.center;
  const T distance = std::sqrt(dot(off, off));
  if (distance > sphere.radius) return std::nullopt;
  return MinimumTranslation<T>{sphere.radius - distance, off / distance};
}

template <class T>
std::optional<MinimumTranslation<T>> minimum_translation(const Sphere<3, T>& sphere, const Aabb<3, T>& box) {
  return minimum_translation(sphere, oriented(box));
}

template <class T>
std::optional<MinimumTranslation<T>> minimum_translation(const Aabb<3, T>& a, const Aabb<3, T>& b) {
  MinimumTranslation<T> least{std::numeric_limits<T>::infinity(), Vec3<T>(T(0))};
  for (Dim i = 0; i < 3; ++i) {
    const T forward = a.max[i] - b.min[i];
    const T backward = b.max[i] - a.min[i];
    if (forward < 0 || backward < 0) return std::nullopt;
    if (std::min(forward, backward) >= least.depth) continue;
    least = {std::min(forward, backward), Vec3<T>(T(0))};
    least.normal[i] = forward <= backward ? T(1) : T(-1);
  }
  return least;
}

/// The least overlap along fifteen axes (Gottschalk, Lin, Manocha 1996); cross products of parallel edges are skipped.
template <class T>
std::optional<MinimumTranslation<T>> minimum_translation(const Obb<3, T>& a, const Obb<3, T>& b) {
  constexpr T usual = T(1e-6);
  MinimumTranslation<T> least{std::numeric_limits<T>::infinity(), Vec3<T>(T(0))};
  const Vec3<T> between = b.center - a.center;
  const auto is_parted_along = [&](const Vec3<T>& way) {
    const T squared = dot(way, way);
    if (squared < usual) return false;
    const Vec3<T> axis = way / std::sqrt(squared);
    T reach = 0;
    for (Dim i = 0; i < 3; ++i) {
      reach +=
          a.half_extents[i] * std::fabs(dot(a.axes[i], axis)) + b.half_extents[i] * std::fabs(dot(b.axes[i], axis));
    }
    const T along = dot(between, axis);
    const T overlap = reach - std::fabs(along);
    if (overlap < least.depth) least = {overlap, along < 0 ? -axis : axis};
    return overlap < 0;
  };
  for (Dim i = 0; i < 3; ++i) {
    if (is_parted_along(a.axes[i]) || is_parted_along(b.axes[i])) return std::nullopt;
  }
  for (Dim i = 0; i < 3; ++i) {
    for (Dim j = 0; j < 3; ++j) {
      if (is_parted_along(cross(a.axes[i], b.axes[j]))) return std::nullopt;
    }
  }
  return least;
}

template <class T>
std::optional<MinimumTranslation<T>> minimum_translation(const Aabb<3, T>& a, const Obb<3, T>& b) {
  return minimum_translation(oriented(a), b);
}

}  // namespace graze::exam::textbook
