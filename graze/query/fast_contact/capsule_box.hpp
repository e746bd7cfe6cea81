// SPDX-License-Identifier: MIT
// Fast contacts of capsules and 3D boxes, by capsule_box-inl.hpp. Include manifold.hpp.
#pragma once

#include <cstddef>
#include <limits>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/contact/boxes.hpp>
#include <graze/query/fast_contact/fast_result.hpp>
#include <graze/query/fast_contact/one_pair.hpp>
#include <graze/query/fast_contact/oriented_box.hpp>
#include <graze/query/patch/manifold_points.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/capsule.hpp>
#include <graze/shape/obb.hpp>

namespace graze::detail::one_pair {
// Each header after those that it needs.
// clang-format off
#include <graze/query/fast_contact/minimum_translation-inl.hpp>
#include <graze/query/fast_contact/axis_over_face-inl.hpp>
#include <graze/query/fast_contact/capsule_box-inl.hpp>
// clang-format on
}  // namespace graze::detail::one_pair

namespace graze::detail {

/// On a face a capsule may have two points, which not every caller needs.
struct CapsuleResult : FastContact<3> {
  one_pair::CapsuleContact contact;
  bool turns;

  std::size_t put_points(SurfacePair<3>* points) const {
    if (!contact.is_over) return FastContact<3>::put_points(points);
    one_pair::CapsulePoint ends[2];
    if (!one_pair::AxisOverFace(contact.over).put_points(ends)) return 0;
    for (std::size_t i = 0; i < 2; ++i) {
      const auto& [on_box, on_capsule, depth, of_box, of_capsule] = ends[i];
      points[i] = {turns ? on_capsule : on_box, turns ? on_box : on_capsule, depth,
                   one_pair::feature_of(turns ? of_capsule : of_box),
                   one_pair::feature_of(turns ? of_box : of_capsule)};
    }
    return 2;
  }

  /// Sets the result, if the two certainly meet.
  [[gnu::always_inline]] void set_found() {
    is_known = contact.is_apart || contact.meets;
    meets = contact.meets;
    is_single = contact.is_single;
    found.error = contact.error;
    if (!meets) return;
    if (contact.is_over) contact.point = contact.over.lowest_point();
    const auto& [on_box, on_capsule, depth, of_box, of_capsule] = contact.point;
    set(contact.normal, depth, on_box, on_capsule, turns);
    set_features(one_pair::feature_of(of_box), one_pair::feature_of(of_capsule), turns);
  }
};

inline void look_at_capsule(const one_pair::CapsuleAndBox& pair, CapsuleResult& look) {
  one_pair::CapsuleOnBox(pair, look.contact).run();
  look.set_found();
}

template <class T, class Box>
CapsuleResult look_at_capsule(const Box& box, const Capsule<3, T>& capsule, bool turns) {
  const Vec<3, double> origin = wide<3, T>(capsule.a);
  const Obb<3, double> seen = oriented_box_from(origin, box);
  one_pair::CapsuleAndBox pair{origin,
                               wide<3, T>(capsule.b) - origin,
                               static_cast<double>(capsule.radius),
                               seen.center,
                               seen.half_extents,
                               {seen.axes[0], seen.axes[1], seen.axes[2]},
                               0};
  pair.find_size();
  CapsuleResult look;
  look.turns = turns;
  look_at_capsule(pair, look);
  return look;
}

template <class T>
CapsuleResult find_fast_contact(const Aabb<3, T>& box, const Capsule<3, T>& capsule, bool turns) {
  return look_at_capsule(box, capsule, turns);
}
template <class T>
CapsuleResult find_fast_contact(const Obb<3, T>& box, const Capsule<3, T>& capsule, bool turns) {
  return look_at_capsule(box, capsule, turns);
}

}  // namespace graze::detail
