// SPDX-License-Identifier: MIT
// In which direction a segment in a box in space is out of it the soonest: the separating-axis test of
// parting_axis.hpp in the box' own coordinates, where all but one of the directions are clearly worse. Include
// manifold.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>

namespace graze::detail {

/// Across a face, or across an edge of the box and the segment.
struct MinimumTranslation {
  bool is_known = false;  ///< If not, nothing else counts.
  bool is_face = false;
  bool is_level = false;    ///< Of a face: whether it is as far out of it all along, up to rounding.
  bool is_oblique = false;  ///< Of an edge: whether it is so by more than what is laid flat on a face.
  Dim axis = 0;             ///< Across the face, or along the edge.
  Vec<3, double> outward = Vec<3, double>(0.0);  ///< Along the box' axes, of any length.
};

/// A segment as a box sees it along its axes, and what is in doubt of how far out it is.
class MinimumTranslationSearch {
 public:
  MinimumTranslationSearch(const Vec<3, double>& start, const Vec<3, double>& way, const Vec<3, double>& half_extents,
                           double doubt)
      : start_(start), way_(way), half_(half_extents), doubt_(doubt) {}

  /// `noise` is what rounding makes of a coordinate.
  MinimumTranslation run(double noise) {
    for (Dim i = 0; i < 3; ++i) look_across_face(i);
    const bool is_level = std::fabs(way_[face_]) <= noise;
    for (Dim i = 0; i < 3; ++i) look_along_edge(i, is_level && i != face_, noise);
    const bool is_face = face_gap_ >= edge_gap_;
    MinimumTranslation result;
    const double best = is_face ? face_gap_ : edge_gap_;
    const double second = std::max(std::min(face_gap_, edge_gap_), is_face ? second_face_gap_ : second_edge_gap_);
    result.is_known = !is_in_doubt_ && best < -doubt_ && best - second > doubt_;
    result.is_face = is_face;
    result.is_level = is_level;
    result.axis = is_face ? face_ : edge_;
    result.outward = is_face ? face_outward() : edge_outward(result.is_oblique);
    return result;
  }

 private:
  static constexpr double nowhere = -std::numeric_limits<double>::infinity();

  void look_across_face(Dim i) {
    const double end = start_[i] + way_[i];
    const double ahead = std::min(start_[i], end) - half_[i];
    const double behind = -half_[i] - std::max(start_[i], end);
    const double gap = std::max(ahead, behind);
    second_face_gap_ = std::max(second_face_gap_, std::max(std::min(gap, face_gap_), std::min(ahead, behind)));
    if (!(gap > face_gap_)) return;
    face_gap_ = gap;
    face_ = i;
    is_far_ = ahead >= behind;
  }

  /// The normal of a face is across all its edges and a segment that is level over it.
  void look_along_edge(Dim i, bool is_of_face, double noise) {
    constexpr double least_sine_squared = 1e-8;  // of less the direction is lost to rounding
    const double x = way_[(i + 1) % 3];
    const double y = way_[(i + 2) % 3];
    const double squared = x * x + y * y;
    if (is_of_face || squared <= noise * noise) return;
    is_in_doubt_ = is_in_doubt_ || !(squared > least_sine_squared * dot(way_, way_));
    const double height = start_[(i + 1) % 3] * y - start_[(i + 2) % 3] * x;
    const double reach = half_[(i + 1) % 3] * std::fabs(y) + half_[(i + 2) % 3] * std::fabs(x);
    const double per_length = 1 / std::sqrt(squared);
    const double gap = (std::fabs(height) - reach) * per_length;
    second_edge_gap_ =
        std::max(second_edge_gap_, std::max(std::min(gap, edge_gap_), (-std::fabs(height) - reach) * per_length));
    if (!(gap > edge_gap_)) return;
    edge_gap_ = gap;
    edge_ = i;
    is_ahead_ = height > 0;
  }

  Vec<3, double> face_outward() const {
    Vec<3, double> result(0.0);
    result[face_] = is_far_ ? 1 : -1;
    return result;
  }

  Vec<3, double> edge_outward(bool& is_oblique) const {
    const double side = is_ahead_ ? 1 : -1;
    Vec<3, double> result(0.0);
    result[(edge_ + 1) % 3] = side * way_[(edge_ + 2) % 3];
    result[(edge_ + 2) % 3] = -side * way_[(edge_ + 1) % 3];
    constexpr double least_cosine = 16 * tolerance::aligned;
    const double x = std::fabs(result[(edge_ + 1) % 3]);
    const double y = std::fabs(result[(edge_ + 2) % 3]);
    is_oblique = std::min(x, y) > least_cosine * std::max(x, y);
    return result;
  }

  Vec<3, double> start_;
  Vec<3, double> way_;
  Vec<3, double> half_;
  double doubt_;
  double face_gap_ = nowhere;
  double second_face_gap_ = nowhere;
  double edge_gap_ = nowhere;
  double second_edge_gap_ = nowhere;
  Dim face_ = 0;
  Dim edge_ = 0;
  bool is_far_ = false;
  bool is_ahead_ = false;
  bool is_in_doubt_ = false;
};

}  // namespace graze::detail
