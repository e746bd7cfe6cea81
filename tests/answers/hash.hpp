// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <graze/math/platform/bit_cast.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/impact.hpp>
#include <graze/query/manifold.hpp>
#include <graze/query/proximity.hpp>
#include <graze/query/ray_hit.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::answers {

/// FNV-1a of 64-bit words. All NaN are equal: processors make them with different bits.
class Hash {
 public:
  std::uint64_t value() const { return value_; }

  void put(std::uint64_t word) { value_ = (value_ ^ word) * 0x100000001b3U; }
  void put(double number) { put(std::isnan(number) ? ~std::uint64_t{0} : bit_cast<std::uint64_t>(number)); }
  void put(float number) { put(static_cast<double>(number)); }

  template <Dim N, class T>
  void put(const Vec<N, T>& vector) {
    for (Dim i = 0; i < N; ++i) put(vector[i]);
  }

  template <Dim N, class T>
  void put(const Aabb<N, T>& box) {
    put<N, T>(box.min);
    put<N, T>(box.max);
  }

  template <Dim N, class T>
  void put(const Proximity<N, T>& found) {
    put(found.distance);
    put<N, T>(found.point_a);
    put<N, T>(found.point_b);
    put<N, T>(found.normal);
    put_state(found);
  }

  template <Dim N, class T>
  void put(const Contact<N, T>& found) {
    put<N, T>(found.point);
    put<N, T>(found.point_a);
    put<N, T>(found.point_b);
    put<N, T>(found.normal);
    put(found.depth);
    put_state(found);
  }

  template <Dim N, class T>
  void put(const Manifold<N, T>& found) {
    put(std::uint64_t{found.size});
    put<N, T>(found.normal);
    for (const ManifoldPoint<N, T>& point : found.contacts()) {
      put<N, T>(point.point);
      put<N, T>(point.point_a);
      put<N, T>(point.point_b);
      put(point.depth);
      for (const Feature& feature : {point.id.a, point.id.b}) {
        put(static_cast<std::uint64_t>(feature.kind));
        put(std::uint64_t{feature.index});
      }
      put(std::uint64_t{point.id.part_a});
      put(std::uint64_t{point.id.part_b});
    }
    put_state(found);
  }

  template <Dim N, class T>
  void put(const RayHit<N, T>& found) {
    put_moment<N, T>(found);
  }

  template <Dim N, class T>
  void put(const Impact<N, T>& found) {
    put_moment<N, T>(found);
  }

  template <class Found>
  void put_if_any(const std::optional<Found>& found) {
    put(std::uint64_t{found.has_value()});
    if (found) put(*found);
  }

 private:
  template <Dim N, class T, class Found>
  void put_moment(const Found& found) {
    put(found.t);
    put<N, T>(found.point);
    put<N, T>(found.normal);
    put_state(found);
  }

  template <class Found>
  void put_state(const Found& found) {
    put(static_cast<std::uint64_t>(found.status));
    put(found.error);
  }

  std::uint64_t value_ = 0xcbf29ce484222325U;
};

}  // namespace graze::answers
