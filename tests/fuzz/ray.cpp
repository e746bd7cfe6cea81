// SPDX-License-Identifier: MIT
// ray_cast(shape, ray) of any shape against the true entry, within the error that it reports. For a finite ray, the hit
// point is on the shape, within that error.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <ostream>

#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/ray.hpp>

#include "catalogue.hpp"
#include "exact.hpp"
#include "fuzz/require.hpp"
#include "fuzz/shapes.hpp"
#include "query/ray_casts.hpp"
#include "query/ray_judgement.hpp"

using namespace graze;
constexpr Dim N = GRAZE_FUZZ_DIMENSION;
using T = GRAZE_FUZZ_SCALAR;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  test::fuzz::Input input(data, size);
  const AnyShape<N, T> shape = test::fuzz::any_shape<N, T>(input);
  Ray<N, T> ray;
  test::fuzz::fill(input, ray);
  const T t_max = input.number<T>();
  if (!input.is_in_range() || !is_valid(shape) || !is_valid(ray) || !(t_max >= T(0))) return 0;
  const auto hit = test::hit_of<N, T>(shape, ray, std::numeric_limits<T>::infinity());
  const auto say = [&](std::ostream& out) {
    out << (hit ? "a hit at " : "no hit") << (hit ? hit->t : T(0)) << ": " << test::to_source<N, T>(shape) << ", "
        << test::to_source(ray);
  };
  if (const auto early = test::hit_of<N, T>(shape, ray, t_max); early && is_finite(early->point)) {
    const double height = test::exact_height<N, T>(shape, early->point);
    const double largest =
        std::max(static_cast<double>(max_abs(early->point)), static_cast<double>(max_abs(ray.origin)));
    const double bound = early->error + 4 * std::numeric_limits<T>::epsilon() * largest;
    test::fuzz::require(early->t <= t_max && height <= bound, [&](std::ostream& out) {
      out << "up to t = " << t_max << " a hit at " << early->t << ", whose point is off by " << height << ", error "
          << early->error << ": " << test::to_source<N, T>(shape) << ", " << test::to_source(ray);
    });
  }
  const test::ExactVerdict truth = test::exact_verdict<N, T>(shape, AnyShape<N, T>(ray));
  const double largest = std::max({truth.largest, static_cast<double>(max_abs(ray.origin)), truth.own_size});
  const test::RayErrors errors = test::ray_errors<N, T>(shape, ray, truth, largest, hit);
  test::fuzz::require(errors.judgement != test::Judgement::wrong, [&](std::ostream& out) {
    say(out);
    out << ", which are " << name_of(truth.relation) << " by " << truth.gap;
  });
  return 0;
}
