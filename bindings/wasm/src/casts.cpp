// SPDX-License-Identifier: MIT
// The first contact of moving shapes. The output is t, point, normal, status and error, or empty without a contact.
#include <cstddef>
#include <optional>

#include <emscripten/bind.h>

#include <graze/math/motion.hpp>
#include <graze/query/cast_options.hpp>
#include <graze/query/impact.hpp>
#include <graze/query/shape_cast.hpp>
#include <graze/query/time_of_impact.hpp>

#include "arguments.hpp"
#include "bridge.hpp"
#include "results.hpp"

namespace graze::wasm {
namespace {

template <Dim N>
void put_impact(const std::optional<Impact<N, double>>& found) {
  if (found) put_hit<N>(*found);
}

/// The arguments are a, b and the motion.
void shape_cast_of(int dimension, std::size_t place, bool ignore_initial_touch, double target_distance) {
  in_dimension(dimension, [&](auto n) {
    Arguments in(place);
    const AnyShape<n, double> a = in.shape<n>();
    const AnyShape<n, double> b = in.shape<n>();
    const CastOptions options{.ignore_initial_touch = ignore_initial_touch, .target_distance = target_distance};
    put_impact<n>(shape_cast(a, in.vector<n>(), b, options));
  });
}

/// The arguments are a, b and the motion of each.
void time_of_impact_of(int dimension, std::size_t place) {
  in_dimension(dimension, [&](auto n) {
    Arguments in(place);
    const AnyShape<n, double> a = in.shape<n>();
    const AnyShape<n, double> b = in.shape<n>();
    const Motion<n, double> motion_a = in.motion<n>();
    put_impact<n>(time_of_impact(a, motion_a, b, in.motion<n>()));
  });
}

}  // namespace

EMSCRIPTEN_BINDINGS(graze_casts) {
  using namespace emscripten;  // NOLINT(google-build-using-namespace): as embind is written
  function("shapeCast", &Guarded<&shape_cast_of>::call);
  function("timeOfImpact", &Guarded<&time_of_impact_of>::call);
}

}  // namespace graze::wasm
