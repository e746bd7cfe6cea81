// SPDX-License-Identifier: MIT
// The first contact of moving shapes. The output is t, point, normal, status and error, or empty without a contact.
#include <cstddef>
#include <optional>

#include <emscripten/bind.h>

#include <graze/math/motion.hpp>
#include <graze/query/impact.hpp>
#include <graze/query/shape_cast.hpp>
#include <graze/query/status.hpp>
#include <graze/query/time_of_impact.hpp>

#include "arguments.hpp"
#include "bridge.hpp"

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

/// The arguments are a, b and the motion.
void shape_cast_of(int dimension, std::size_t place) {
  in_dimension(dimension, [&](auto n) {
    Arguments in(place);
    const AnyShape<n, double> a = in.shape<n>();
    const AnyShape<n, double> b = in.shape<n>();
    put_impact<n>(shape_cast(a, in.vector<n>(), b));
  });
}

/// The translation, the rotation and the center.
template <Dim N>
Motion<N, double> motion_in(Arguments& in) {
  Motion<N, double> motion;
  motion.linear = in.vector<N>();
  if constexpr (N == 2) {
    motion.angular = in.number();
  } else {
    motion.angular = in.vector<N>();
  }
  motion.center = in.vector<N>();
  return motion;
}

/// The arguments are a, b and the motion of each.
void time_of_impact_of(int dimension, std::size_t place) {
  in_dimension(dimension, [&](auto n) {
    Arguments in(place);
    const AnyShape<n, double> a = in.shape<n>();
    const AnyShape<n, double> b = in.shape<n>();
    const Motion<n, double> motion_a = motion_in<n>(in);
    put_impact<n>(time_of_impact(a, motion_a, b, motion_in<n>(in)));
  });
}

}  // namespace

EMSCRIPTEN_BINDINGS(graze_casts) {
  using namespace emscripten;  // NOLINT(google-build-using-namespace): as embind is written
  function("shapeCast", &Guarded<&shape_cast_of>::call);
  function("timeOfImpact", &Guarded<&time_of_impact_of>::call);
}

}  // namespace graze::wasm
