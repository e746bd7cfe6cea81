// SPDX-License-Identifier: MIT
// The contacts of many pairs as the arrays of graze.Contacts.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <graze/query/manifold.hpp>

#include "arrays.hpp"
#include "results.hpp"

namespace graze::python {

/// `PairRow` is a row of two numbers: what names the shapes of a pair.
template <Dim N, class T, class PairRow>
class ContactColumns {
 public:
  ContactColumns() : offsets_{0} {}

  void add(const PairRow& pair, const Manifold<N, T>& manifold) {
    pairs_.push_back(pair);
    normals_.push_back(manifold.normal);
    for (const ManifoldPoint<N, T>& point : manifold.contacts()) {
      points_.push_back(point.point);
      depths_.push_back(point.depth);
    }
    offsets_.push_back(static_cast<std::int64_t>(points_.size()));
  }

  /// With names of the type Number.
  template <class Number>
  py::object to_python() && {
    static ResultClass contacts_class("Contacts");
    constexpr auto columns = static_cast<std::size_t>(N);
    return contacts_class(array_of<Number>(std::move(pairs_), 2), array_of<T>(std::move(normals_), columns),
                          array_of<std::int64_t>(std::move(offsets_), 0), array_of<T>(std::move(points_), columns),
                          array_of<T>(std::move(depths_), 0));
  }

 private:
  std::vector<PairRow> pairs_;
  std::vector<Vec<N, T>> normals_;
  std::vector<std::int64_t> offsets_;
  std::vector<Vec<N, T>> points_;
  std::vector<T> depths_;
};

}  // namespace graze::python
