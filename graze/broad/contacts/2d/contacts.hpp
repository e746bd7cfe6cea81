// SPDX-License-Identifier: MIT
// The manifolds of many pairs of 2D spheres, capsules and boxes: collected by kind for the kernels.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>
#include <variant>

#include <graze/broad/contacts/2d/contact_kernels_2d.hpp>
#include <graze/broad/touching_pairs.hpp>
#include <graze/query/manifold.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/capsule.hpp>
#include <graze/shape/fields/shape_order.hpp>
#include <graze/shape/obb.hpp>
#include <graze/shape/sphere.hpp>

namespace graze::detail {

/// Collects the touching pairs of these kinds of a task, at most `room`.
template <class T, std::size_t room>
class Pairs2d {
 public:
  /// False for other pairs.
  bool add(const ShapePair<2, T>& shapes, Manifold<2, T>* manifold, std::size_t place) {
    Named first = named(*shapes.a);
    Named second = named(*shapes.b);
    bool turned = second.rank < first.rank;
    if (turned) std::swap(first, second);
    const int kind = kinds[first.rank][second.rank];
    if (kind < 0) return false;
    if (first.rank == second.rank && !is_first(first, second)) {
      std::swap(first, second);
      turned = true;
    }
    List& list = lists_[static_cast<std::size_t>(kind)];
    list.pairs[list.count] = {first.numbers, second.numbers, turned, manifold};
    list.places[list.count++] = static_cast<std::uint16_t>(place);
    return true;
  }

  /// Calls contact_one(index) for the pairs that the kernels leave.
  template <class ContactOne>
  void contact(const ContactOne& contact_one) const {
    for (std::size_t kind = 0; kind < kinds_2d; ++kind) {
      const List& list = lists_[kind];
      if (list.count == 0) continue;
      std::array<std::uint32_t, room> left;
      const std::size_t left_count =
          contact_kernels_2d<T>()[kind](std::span(list.pairs).first(list.count), left.data());
      for (std::size_t i = 0; i < left_count; ++i) contact_one(list.places[left[i]]);
    }
  }

 private:
  /// The order of shapes in contacts, with other shapes last.
  enum Rank : std::uint8_t { sphere, obb, aabb, capsule, other, ranks };

  struct Named {
    Rank rank;
    const T* numbers;
  };

  static constexpr auto kinds = [] {
    std::array<std::array<int, ranks>, ranks> result{};
    for (auto& row : result) row.fill(-1);
    const auto set = [&result](Rank first, Rank second, Kind2d kind) {
      result[first][second] = static_cast<int>(kind);
    };
    set(sphere, sphere, Kind2d::sphere_sphere);
    set(sphere, obb, Kind2d::sphere_obb);
    set(sphere, aabb, Kind2d::sphere_aabb);
    set(sphere, capsule, Kind2d::sphere_capsule);
    set(obb, obb, Kind2d::obb_obb);
    set(obb, aabb, Kind2d::obb_aabb);
    set(obb, capsule, Kind2d::obb_capsule);
    set(aabb, aabb, Kind2d::aabb_aabb);
    set(aabb, capsule, Kind2d::aabb_capsule);
    set(capsule, capsule, Kind2d::capsule_capsule);
    return result;
  }();

  static Named named(const AnyShape<2, T>& shape) {
    if (const auto* held = std::get_if<Sphere<2, T>>(&shape)) return {sphere, numbers(*held)};
    if (const auto* held = std::get_if<Obb<2, T>>(&shape)) return {obb, numbers(*held)};
    if (const auto* held = std::get_if<Aabb<2, T>>(&shape)) return {aabb, numbers(*held)};
    if (const auto* held = std::get_if<Capsule<2, T>>(&shape)) return {capsule, numbers(*held)};
    return {other, nullptr};
  }

  /// The address of its numbers: the struct contains nothing else.
  template <class S>
  static const T* numbers(const S& shape) {
    static_assert(std::is_standard_layout_v<S> && sizeof(S) % sizeof(T) == 0);
    return reinterpret_cast<const T*>(&shape);
  }

  /// For two shapes of the same kind.
  static bool is_first(const Named& a, const Named& b) {
    const auto in_order = [&]<class S>(const S* first) {
      return is_in_order(*first, *reinterpret_cast<const S*>(b.numbers));
    };
    if (a.rank == obb) return in_order(reinterpret_cast<const Obb<2, T>*>(a.numbers));
    if (a.rank == aabb) return in_order(reinterpret_cast<const Aabb<2, T>*>(a.numbers));
    return a.rank != capsule || in_order(reinterpret_cast<const Capsule<2, T>*>(a.numbers));
  }

  struct List {
    std::array<PrimitivesToContact<2, T>, room> pairs;
    std::array<std::uint16_t, room> places;
    std::size_t count = 0;
  };

  std::array<List, kinds_2d> lists_;
};

}  // namespace graze::detail
