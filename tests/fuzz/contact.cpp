// SPDX-License-Identifier: MIT
// contact(a, b) and closest_points(a, b) of any two shapes against the exact gap or depth, within the error that they
// report.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <ostream>

#include <graze/math/vec.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/any_shape.hpp>

#include "catalogue.hpp"
#include "exact.hpp"
#include "fuzz/require.hpp"
#include "fuzz/shapes.hpp"
#include "query/contact_judgement.hpp"
#include "query/contacts.hpp"
#include "query/proximities.hpp"
#include "query/verdict_band.hpp"

using namespace graze;
constexpr Dim N = GRAZE_FUZZ_DIMENSION;
using T = GRAZE_FUZZ_SCALAR;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  test::fuzz::Input input(data, size);
  const test::fuzz::ShapePair<N, T> pair(input);
  if (!pair.is_judged) return 0;
  const auto touch = test::contact_of<N, T>(pair.a, pair.b);
  const auto near = test::closest_points_of<N, T>(pair.a, pair.b);
  const test::ExactVerdict truth = test::exact_verdict<N, T>(pair.a, pair.b);
  const auto case_and_truth = [&](std::ostream& out) {
    out << pair << ", which are " << name_of(truth.relation) << " by " << truth.gap;
  };
  const test::ContactErrors errors = test::contact_errors<N, T>(pair.a, pair.b, truth, touch);
  test::fuzz::require(errors.judgement != test::Judgement::wrong, [&](std::ostream& out) {
    if (touch) out << "a contact of depth " << touch->depth << ", error " << touch->error << ": ";
    if (!touch) out << "no contact: ";
    case_and_truth(out);
  });
  if (errors.judgement == test::Judgement::outside_range || !std::isfinite(truth.gap)) return 0;
  const double gap = std::max(0.0, truth.gap);
  const auto distance = static_cast<double>(near.distance);
  const double bound = near.error + std::numeric_limits<T>::epsilon() * distance + std::numeric_limits<T>::denorm_min();
  test::fuzz::require(std::fabs(distance - gap) <= bound, [&](std::ostream& out) {
    out << "a distance of " << near.distance << ", error " << near.error << ": ";
    case_and_truth(out);
  });
  return 0;
}
