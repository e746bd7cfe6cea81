// SPDX-License-Identifier: MIT
// The bits of answers of C and of C++, in the same order.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <graze.h>

#include <graze/query/contact.hpp>
#include <graze/query/impact.hpp>
#include <graze/query/manifold.hpp>
#include <graze/query/mass_properties.hpp>
#include <graze/query/mesh_hit.hpp>
#include <graze/query/proximity.hpp>
#include <graze/query/ray_hit.hpp>
#include <graze/shape/aabb.hpp>

#include "in_c.hpp"

namespace graze::test {

/// Numbers as bits, so that those that are NaN and zeros with a sign count.
using Numbers = std::vector<std::uint64_t>;

template <class T>
std::uint64_t bits(T number) {
  return std::bit_cast<std::uint64_t>(static_cast<double>(number));
}

inline void put(Numbers& out, const graze_vec& v) {
  for (const double number : {v.x, v.y, v.z}) out.push_back(bits(number));
}

template <Dim N, class T>
void put(Numbers& out, const Vec<N, T>& v) {
  put(out, vec_of_c<N, T>(v));
}

inline Numbers numbers_of(const graze_vec& v) {
  Numbers out;
  put(out, v);
  return out;
}

inline Numbers numbers_of(const graze_proximity& p) {
  Numbers out{bits(p.distance), bits(p.error), bits(p.relation), bits(p.status)};
  for (const graze_vec& v : {p.point_a, p.point_b, p.normal}) put(out, v);
  return out;
}
template <Dim N, class T>
Numbers numbers_of(const Proximity<N, T>& p) {
  Numbers out{bits(p.distance), bits(p.error), bits(int(p.relation)), bits(int(p.status))};
  for (const Vec<N, T>& v : {p.point_a, p.point_b, p.normal}) put<N, T>(out, v);
  return out;
}

inline Numbers numbers_of(const graze_contact& c) {
  Numbers out{bits(c.depth), bits(c.error), bits(c.status)};
  for (const graze_vec& v : {c.point, c.normal, c.point_a, c.point_b}) put(out, v);
  return out;
}
template <Dim N, class T>
Numbers numbers_of(const Contact<N, T>& c) {
  Numbers out{bits(c.depth), bits(c.error), bits(int(c.status))};
  for (const Vec<N, T>& v : {c.point, c.normal, c.point_a, c.point_b}) put<N, T>(out, v);
  return out;
}

inline Numbers numbers_of(const graze_manifold& m) {
  Numbers out{m.count, bits(m.error), bits(m.status)};
  put(out, m.normal);
  for (std::size_t i = 0; i < m.count; ++i) {
    const graze_manifold_point& p = m.points[i];
    for (const graze_vec& v : {p.point, p.point_a, p.point_b}) put(out, v);
    for (const std::uint32_t number : {p.index_a, p.index_b, p.part_a, p.part_b}) out.push_back(number);
    for (const std::uint64_t number : {bits(p.depth), bits(p.feature_a), bits(p.feature_b)}) out.push_back(number);
  }
  return out;
}
template <Dim N, class T>
Numbers numbers_of(const Manifold<N, T>& m) {
  Numbers out{m.size, bits(m.error), bits(int(m.status))};
  put<N, T>(out, m.normal);
  for (const ManifoldPoint<N, T>& p : m.contacts()) {
    for (const Vec<N, T>& v : {p.point, p.point_a, p.point_b}) put<N, T>(out, v);
    for (const std::uint32_t number : {p.id.a.index, p.id.b.index, p.id.part_a, p.id.part_b}) out.push_back(number);
    for (const std::uint64_t number : {bits(p.depth), bits(int(p.id.a.kind)), bits(int(p.id.b.kind))}) {
      out.push_back(number);
    }
  }
  return out;
}

inline Numbers numbers_of(const graze_impact& i) {
  Numbers out{bits(i.t), bits(i.error), bits(i.status)};
  for (const graze_vec& v : {i.point, i.normal}) put(out, v);
  return out;
}
template <Dim N, class T>
Numbers numbers_of(const Impact<N, T>& i) {
  Numbers out{bits(i.t), bits(i.error), bits(int(i.status))};
  for (const Vec<N, T>& v : {i.point, i.normal}) put<N, T>(out, v);
  return out;
}

inline Numbers numbers_of(const graze_ray_hit& h) {
  Numbers out{bits(h.t), bits(h.error), bits(h.status), h.face};
  for (const graze_vec& v : {h.point, h.normal, h.barycentric}) put(out, v);
  return out;
}
template <Dim N, class T>
Numbers numbers_of(const MeshHit<N, T>& h) {
  Numbers out{bits(h.t), bits(h.error), bits(int(h.status)), h.face};
  for (const Vec<N, T>& v : {h.point, h.normal}) put<N, T>(out, v);
  put<3, T>(out, h.barycentric);
  return out;
}
template <Dim N, class T>
Numbers numbers_of(const RayHit<N, T>& h) {
  return numbers_of(MeshHit<N, T>{h});
}

inline Numbers numbers_of(const graze_box& b) {
  Numbers out;
  for (const graze_vec& v : {b.min, b.max}) put(out, v);
  return out;
}
template <Dim N, class T>
Numbers numbers_of(const Aabb<N, T>& b) {
  Numbers out;
  for (const Vec<N, T>& v : {b.min, b.max}) put<N, T>(out, v);
  return out;
}

inline Numbers numbers_of(const graze_mass& m) {
  Numbers out{bits(m.volume)};
  put(out, m.centroid);
  for (const graze_vec& column : m.inertia.columns) put(out, column);
  return out;
}
template <Dim N>
Numbers numbers_of(const MassProperties<N>& m) {
  Numbers out{bits(m.volume)};
  put<N, double>(out, m.centroid);
  if constexpr (N == 2) {
    for (const double number : {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, m.inertia}) out.push_back(bits(number));
  } else {
    for (Dim j = 0; j < 3; ++j) put<3, double>(out, m.inertia[j]);
  }
  return out;
}

}  // namespace graze::test
