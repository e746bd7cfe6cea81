// SPDX-License-Identifier: MIT
// Shapes of one number type as shapes of another.
#pragma once

#include <type_traits>
#include <utility>
#include <vector>

#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/converted.hpp>
#include <graze/shape/fields/visit.hpp>

namespace graze::io {

/// Shapes with every number of theirs changed by `change(number)`, which gives the number of the new type. The boxes of
/// a compound's parts are calculated anew. Throws std::invalid_argument when a polytope's point ceases to be finite.
template <class To, class Change>
class ShapeNumbers {
 public:
  explicit ShapeNumbers(Change change) : change_(std::move(change)) {}

  template <Dim N, class From>
  AnyShape<N, To> operator()(const AnyShape<N, From>& shape) const {
    return detail::visit([this](const auto& held) { return AnyShape<N, To>(this->of(held)); }, shape);
  }

  template <Dim N, class From>
  Vec<N, To> of(const Vec<N, From>& point) const {
    Vec<N, To> changed;
    detail::convert(point, changed, change_);
    return changed;
  }

 private:
  template <template <Dim, class> class S, Dim N, class From>
  S<N, To> of(const S<N, From>& shape) const {
    return detail::converted<To>(shape, change_);
  }
  template <Dim N, class From>
  Polytope<N, To> of(const Polytope<N, From>& polytope) const {
    std::vector<Vec<N, To>> points;
    for (const Vec<N, From>& vertex : polytope.vertices()) points.push_back(of(vertex));
    return convex_hull_in_order<N, To>(points);
  }
  template <Dim N, class From>
  Compound<N, To> of(const Compound<N, From>& compound) const {
    std::vector<AnyShape<N, To>> parts;
    for (const Part<N, From>& part : compound.parts) parts.push_back((*this)(part.shape));
    return compound_of<N, To>(std::move(parts));
  }

  Change change_;
};

/// A shape with its numbers rounded to another type: exactly the same shape where that type is the larger one.
template <class To, Dim N, class From>
AnyShape<N, To> with_numbers(const AnyShape<N, From>& shape) {
  if constexpr (std::is_same_v<To, From>) {
    return shape;
  } else {
    const auto round = [](From number) { return static_cast<To>(number); };
    return ShapeNumbers<To, decltype(round)>(round)(shape);
  }
}

}  // namespace graze::io
