// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <graze/io/svg/stage.hpp>
#include <graze/query/bounds.hpp>

namespace graze::io::svg {
namespace {

/// The size of the box that cuts off planes and rays in 3D, relative to its content, and its smallest side, relative to
/// its largest.
constexpr double stage_growth = 1.15;
constexpr double flattest_stage = 0.1;

/// The point of a plane that is nearest to another point.
template <Dim N>
Vec<N, double> foot(const Plane<N, double>& plane, const Vec<N, double>& point) {
  const Plane<N, double> unit = unit_plane(plane);
  return point + unit.normal * (unit.offset - dot(unit.normal, point));
}

/// The points of a part that must be in the picture: all of a bounded part, the origin of a ray, and for a plane the
/// foot of the perpendicular from `center`.
template <Dim N>
struct Essence {
  Vec<N, double> center;

  Aabb<N, double> operator()(const Ray<N, double>& ray) const { return bounds(ray.origin); }
  Aabb<N, double> operator()(const Plane<N, double>& plane) const { return bounds(foot(plane, center)); }
  Aabb<N, double> operator()(const HalfSpace<N, double>& solid) const { return bounds(foot(boundary(solid), center)); }
  Aabb<N, double> operator()(const auto& bounded) const { return bounds(bounded); }
};

template <class S>
inline constexpr bool passes_through = false;
template <Dim N>
inline constexpr bool passes_through<Plane<N, double>> = true;
template <Dim N>
inline constexpr bool passes_through<HalfSpace<N, double>> = true;

/// Also false for coordinates that overflowed to infinity or NaN.
template <Dim N>
bool is_near(const Aabb<N, double>& box) {
  for (Dim i = 0; i < N; ++i) {
    if (!(box.min[i] >= -farthest_drawn && box.max[i] <= farthest_drawn)) return false;
  }
  return true;
}

template <Dim N>
bool can_be_drawn(const AnyShape<N, double>& shape) {
  bool near = true;
  for_each_part<N>(shape, [&near](const auto& part) { near = near && is_near(Essence<N>{Vec<N, double>(0.0)}(part)); });
  return near;
}

/// The box around everything that must be visible. Planes come last, because only their part next to everything else is
/// needed.
template <Dim N>
Aabb<N, double> contents(const Subject<N>& subject, const std::vector<std::size_t>& drawn) {
  Aabb<N, double> box = Aabb<N, double>::nothing();
  for (const std::size_t position : drawn) {
    for_each_part<N>(subject.objects[position]->shape, [&box]<class S>(const S& part) {
      if constexpr (!passes_through<S>) box.grow(Essence<N>{}(part));
    });
  }
  const Essence<N> essence{box.min.x <= box.max.x ? box.center() : Vec<N, double>(0.0)};
  for (const std::size_t position : drawn) {
    for_each_part<N>(subject.objects[position]->shape, [&box, &essence]<class S>(const S& part) {
      if constexpr (passes_through<S>) box.grow(essence(part));
    });
  }
  return box.min.x <= box.max.x ? box : Aabb<N, double>{Vec<N, double>(0.0), Vec<N, double>(0.0)};
}

/// The 3D box that planes and rays fill: somewhat larger than the content, never flat.
Aabb<3, double> grown(const Aabb<3, double>& contents) {
  Vec<3, double> half = contents.half_extents();
  const double size = std::max({half.x, half.y, half.z});
  const double largest = size > 0 ? size : 1.0;
  for (Dim i = 0; i < 3; ++i) half[i] = std::max(half[i] * stage_growth, largest * flattest_stage);
  return Aabb<3, double>::from_center(contents.center(), half);
}

Aabb<2, double> local_box(const Stage<3>& stage, const Subject<3>& subject) {
  Aabb<2, double> box = Aabb<2, double>::nothing();
  for (const std::size_t position : stage.drawn) {
    for_each_part<3>(subject.objects[position]->shape,
                     [&](const auto& part) { box.grow(box_around(outline_on(stage, part))); });
  }
  return box.min.x <= box.max.x ? box : Aabb<2, double>{Vec<2, double>(0.0), Vec<2, double>(0.0)};
}

void set_up(Stage<2>& stage, const Subject<2>& subject, YAxis y_axis) {
  if (y_axis == YAxis::down) stage.view.up = -stage.view.up;
  const Aabb<2, double> all = contents(subject, stage.drawn);
  stage.frame = frame_around(Aabb<2, double>::from_corners(seen(all.min, stage.view), seen(all.max, stage.view)));
  const Aabb<2, double> card = visible(stage.frame);
  const View<2>& view = stage.view;
  stage.box = Aabb<2, double>::from_corners(view.right * card.min.x + view.up * card.min.y,
                                            view.right * card.max.x + view.up * card.max.y);
}

void set_up(Stage<3>& stage, const Subject<3>& subject, YAxis) {
  stage.view = isometric_view();
  stage.box = grown(contents(subject, stage.drawn));
  stage.frame = frame_around(local_box(stage, subject));
}

}  // namespace

template <Dim N>
Stage<N> stage_for(const Subject<N>& subject, YAxis y_axis) {
  Stage<N> stage;
  for (std::size_t position = 0; position < subject.objects.size(); ++position) {
    if (can_be_drawn(subject.objects[position]->shape)) stage.drawn.push_back(position);
  }
  stage.too_far = subject.objects.size() - stage.drawn.size();
  set_up(stage, subject, y_axis);
  return stage;
}

template <Dim N>
Aabb<2, double> picture_box(const Stage<N>& stage, const AnyShape<N, double>& shape) {
  Aabb<2, double> box = Aabb<2, double>::nothing();
  for_each_part<N>(shape, [&](const auto& part) {
    const Outline seen_part = outline_on(stage, part);
    if (!seen_part.core.empty()) box.grow(picture_box(stage.frame, seen_part));
  });
  return box;
}

template Stage<2> stage_for(const Subject<2>&, YAxis);
template Stage<3> stage_for(const Subject<3>&, YAxis);
template Aabb<2, double> picture_box(const Stage<2>&, const AnyShape<2, double>&);
template Aabb<2, double> picture_box(const Stage<3>&, const AnyShape<3, double>&);

}  // namespace graze::io::svg
