// SPDX-License-Identifier: MIT
// When shapes that move first touch. Motions are numbers in the input; the answer is t, point, normal, status and
// error, or nothing if they do not touch.
#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include <emscripten/bind.h>

#include <graze/math/motion.hpp>
#include <graze/query/impact.hpp>
#include <graze/query/shape_cast.hpp>
#include <graze/query/status.hpp>
#include <graze/query/time_of_impact.hpp>

#include "bridge.hpp"
#include "shape_text.hpp"

namespace graze::wasm {
namespace {

template <Dim N>
void put_impact(const std::optional<Impact<N, double>>& found) {
  if (!found) return;
  answer().push_back(found->t);
  put<N>(found->point);
  put<N>(found->normal);
  answer().push_back(found->status == Status::converged ? 0 : 1);
  answer().push_back(found->error);
}

/// The input holds the motion: N numbers.
void shape_cast_of(int dimension, std::string a, std::string b) {
  in_dimension(dimension, [&](auto n) {
    const Vec<n, double> motion = vector_at<n>(input<double>(static_cast<std::size_t>(n())), 0);
    put_impact<n>(shape_cast(shape_of<n>(a, "a"), motion, shape_of<n>(b, "b")));
  });
}

template <Dim N>
constexpr std::size_t numbers_in_motion = N == 2 ? 5 : 9;

/// From the way of the center, the turn, and the center.
template <Dim N>
Motion<N, double> motion_in(std::span<const double> numbers) {
  Motion<N, double> motion;
  motion.linear = vector_at<N>(numbers, 0);
  if constexpr (N == 2) {
    motion.angular = numbers[2];
    motion.center = {numbers[3], numbers[4]};
  } else {
    motion.angular = vector_at<N>(numbers, 1);
    motion.center = vector_at<N>(numbers, 2);
  }
  return motion;
}

/// The input holds the motions of a and of b.
void time_of_impact_of(int dimension, std::string a, std::string b) {
  in_dimension(dimension, [&](auto n) {
    constexpr std::size_t width = numbers_in_motion<n>;
    const std::span<const double> numbers = input<double>(2 * width);
    put_impact<n>(time_of_impact(shape_of<n>(a, "a"), motion_in<n>(numbers.first(width)), shape_of<n>(b, "b"),
                                 motion_in<n>(numbers.subspan(width))));
  });
}

}  // namespace

EMSCRIPTEN_BINDINGS(graze_casts) {
  using namespace emscripten;  // NOLINT(google-build-using-namespace): as embind is written
  function("shapeCast", &Guarded<&shape_cast_of>::call);
  function("timeOfImpact", &Guarded<&time_of_impact_of>::call);
}

}  // namespace graze::wasm
