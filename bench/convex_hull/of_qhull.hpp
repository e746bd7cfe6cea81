// SPDX-License-Identifier: MIT
// qhull's hulls, with its default options: facets and their corners.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstdlib>

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

#include <graze/shape/hull/lexicographic.hpp>

#include "../bench/convex_hull/point_clouds.hpp"

namespace graze::hull_bench {

template <Dim N>
class Qhull {
 public:
  /// qhull does not change the points.
  explicit Qhull(const Points<N>& points) : points_(points) {
    qh_zero(&qh_, stderr);
    char command[] = "qhull";
    auto* coordinates = const_cast<double*>(&points.data()->x);  // NOLINT(cppcoreguidelines-pro-type-const-cast)
    const auto count = static_cast<int>(points.size());
    if (qh_new_qhull(&qh_, N, count, coordinates, 0, command, nullptr, nullptr) != 0) {
      std::fprintf(stderr, "qhull failed\n");
      std::exit(1);
    }
  }
  Qhull(const Qhull&) = delete;
  Qhull& operator=(const Qhull&) = delete;
  ~Qhull() {
    qh_freeqhull(&qh_, !qh_ALL);
    int blocks = 0;
    int bytes = 0;
    qh_memfreeshort(&qh_, &blocks, &bytes);
  }

  /// In lexicographic order.
  Points<N> corners() {
    Points<N> result;
    for (const vertexT* vertex = qh_.vertex_list; vertex != nullptr && vertex->next != nullptr; vertex = vertex->next) {
      result.push_back(points_[static_cast<std::size_t>(qh_pointid(&qh_, vertex->point))]);
    }
    std::sort(result.begin(), result.end(), detail::lexicographically_less<N, double>);
    return result;
  }

  /// In 2D, the area.
  double volume() {
    qh_getarea(&qh_, qh_.facet_list);
    return qh_.totvol;
  }

  int count() const { return qh_.num_facets; }

 private:
  const Points<N>& points_;
  qhT qh_{};
};

}  // namespace graze::hull_bench
