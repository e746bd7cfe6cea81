// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdio>
#include <memory>
#include <optional>
#include <vector>

#include <libqhull_r/qhull_ra.h>

#include <graze/math/vec.hpp>

#include "exam/rival.hpp"

namespace graze::exam {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

/// A run of qhull.
class Run {
 public:
  /// `coordinates` are those of one point after another. qhull's error messages are suppressed.
  Run(std::vector<double>& coordinates, int dimension)
      : dimension_(static_cast<std::size_t>(dimension)), silence_(std::fopen("/dev/null", "w")) {
    qh_zero(&qh_, silence_.get());
    char command[] = "qhull";
    const auto count = static_cast<int>(coordinates.size() / dimension_);
    status_ = qh_new_qhull(&qh_, dimension, count, coordinates.data(), 0, command, silence_.get(), silence_.get());
  }
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;
  ~Run() {
    qh_freeqhull(&qh_, !qh_ALL);
    int blocks = 0;
    int bytes = 0;
    qh_memfreeshort(&qh_, &blocks, &bytes);
  }

  std::optional<std::vector<std::size_t>> corners() {
    if (status_ != 0) return std::nullopt;
    std::vector<std::size_t> places;
    for (vertexT* vertex = qh_.vertex_list; vertex != nullptr && vertex->next != nullptr; vertex = vertex->next)
      places.push_back(static_cast<std::size_t>(qh_pointid(&qh_, vertex->point)));
    return places;
  }

 private:
  std::size_t dimension_;
  std::unique_ptr<std::FILE, CloseFile> silence_;
  qhT qh_{};
  int status_ = 0;
};

template <Dim N>
std::optional<std::vector<std::size_t>> corners_of(const std::vector<Vec<N, double>>& points) {
  std::vector<double> coordinates;
  for (const Vec<N, double>& point : points) {
    for (Dim i = 0; i < N; ++i) coordinates.push_back(point[i]);
  }
  return Run(coordinates, static_cast<int>(N)).corners();
}

}  // namespace

std::optional<std::vector<std::size_t>> qhull_corners(const std::vector<Vec<2, double>>& points) {
  return corners_of<2>(points);
}

std::optional<std::vector<std::size_t>> qhull_corners(const std::vector<Vec<3, double>>& points) {
  return corners_of<3>(points);
}

}  // namespace graze::exam
