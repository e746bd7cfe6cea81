// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include <graze/math/rounding.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/relation.hpp>
#include <graze/query/shape_cast.hpp>
#include <graze/query/transformed.hpp>
#include <graze/scene/slide.hpp>
#include <graze/shape/fields/defect.hpp>
#include <graze/shape/fields/description.hpp>

namespace graze {
namespace {

constexpr int max_turns = 16;
constexpr int max_pushes = 8;

/// The sine of the largest angle at which a motion does not count as leading into a surface: a little more than that of
/// a cast, so that what stopped one cast does not stop the next.
template <class T>
constexpr double grazing = sizeof(T) == sizeof(float) ? 0x1p-20 : 0x1p-39;

template <Dim N>
Vec<N, double> unit_up(const SlideOptions& options) {
  const Vec<N, double> up(options.up);
  return up / std::sqrt(dot(up, up));
}

template <Dim N, class T>
class Slider {
 public:
  Slider(const SceneView<N, T>& scene, const AnyShape<N, T>& shape, const SlideOptions& options)
      : scene_(scene),
        shape_(shape),
        options_(options),
        up_(unit_up<N>(options)),
        half_width_(half_width(bounds(shape))) {}

  Slide<N, T> run(const Vec<N, T>& motion) {
    const double climbing = options_.step_height > 0 ? options_.step_height + half_width_ : 0;
    const double reach = std::sqrt(dot(wide(motion), wide(motion))) + climbing + 2 * options_.clearance;
    find_obstacles(reach);
    if (move_out()) find_obstacles(reach);
    stops_.push_back(place_);
    move(wide(motion));
    return {last_free_stop(), std::move(touches_)};
  }

 private:
  using Offset = Vec<N, double>;

  struct Obstacle {
    ObjectId id;
    const AnyShape<N, T>* shape;
  };

  /// Half of the largest extent; 0 for an unbounded shape.
  static double half_width(const Aabb<N, T>& box) {
    const double half = static_cast<double>(max_abs(box.max - box.min)) / 2;
    return std::isfinite(half) ? half : 0;
  }

  static Offset wide(const Vec<N, T>& v) { return Offset(v); }
  AnyShape<N, T> shape_at(const Vec<N, T>& place) const { return translated<N, T>(shape_, place); }

  /// What the shape can meet within a distance from its place.
  void find_obstacles(double reach) {
    Aabb<N, T> box = bounds(shape_at(place_));
    for (Dim axis = 0; axis < N; ++axis) {
      box.min[axis] = round_down<T>(static_cast<double>(box.min[axis]) - reach);
      box.max[axis] = round_up<T>(static_cast<double>(box.max[axis]) + reach);
    }
    obstacles_.clear();
    for (const ObjectId& id : scene_.overlapping(box, options_.query))
      obstacles_.push_back({id, &scene_.object(id).shape});
  }

  /// Moves out of what is nearer than half the clearance, and returns whether it has moved.
  bool move_out() {
    bool has_moved = false;
    for (int push = 0; push < max_pushes; ++push) {
      const AnyShape<N, T> shape = shape_at(place_);
      std::optional<Contact<N, T>> deepest;
      for (const Obstacle& obstacle : obstacles_) {
        const auto contact = graze::contact(shape, *obstacle.shape, {.margin = options_.clearance});
        if (contact && (!deepest || contact->depth > deepest->depth)) deepest = contact;
      }
      if (!deepest || static_cast<double>(deepest->depth) <= -options_.clearance / 2) break;
      const Offset out = wide(deepest->normal) * -(static_cast<double>(deepest->depth) + options_.clearance);
      const auto hit = first_hit(out);
      const Vec<N, T> before =
          std::exchange(place_, place_ + Vec<N, T>(hit ? out * static_cast<double>(hit->impact.t) : out));
      if (place_ == before) break;
      has_moved = true;
    }
    return has_moved;
  }

  /// Moves on in turns until the motion is over or nothing of it is left that leads into no surface.
  void move(Offset left) {
    for (int turn = 0; turn < max_turns; ++turn) {
      const Offset way = allowed(left);
      if (max_abs(Vec<N, T>(way)) == T(0)) return;
      const auto hit = first_hit(way);
      if (!hit) return advance(way);
      if (!is_ground(wide(hit->impact.normal)) && climb(left)) continue;
      const double t = static_cast<double>(hit->impact.t);
      if (t > 0) surfaces_.clear();
      advance(way * t);
      note(*hit, t);
      left *= 1 - t;
    }
  }

  /// Onto a step: up, ahead and down again, if there is ground. Takes its part from what is left of the motion.
  bool climb(Offset& left) {
    const Offset ahead = left - up_ * dot(left, up_);
    if (options_.step_height == 0 || max_abs(Vec<N, T>(ahead)) == T(0)) return false;
    const Vec<N, T> before = place_;
    place_ = place_after(up_ * options_.step_height);
    const Vec<N, T> raised = place_;
    const Offset down = wide(before) - wide(raised);
    const auto wall = first_hit(ahead);
    const double t = wall ? static_cast<double>(wall->impact.t) : 1;
    place_ += Vec<N, T>(ahead * t);
    const auto ground = first_hit(down);
    const auto is_ground_ahead = [&] {
      return is_ground_at(half_width_along(ahead), ahead, down) || is_ground_at(half_width_, ahead, down);
    };
    if (place_ == raised || !ground || !(is_ground(wide(ground->impact.normal)) || is_ground_ahead())) {
      place_ = before;
      return false;
    }
    surfaces_.clear();
    advance(down * static_cast<double>(ground->impact.t));
    note(*ground, t);
    left *= 1 - t;
    return true;
  }

  /// Half of the extent of the shape's box along a direction; 0 for an unbounded shape.
  double half_width_along(const Offset& direction) const {
    const Aabb<N, T> box = bounds(shape_);
    double half = 0;
    for (Dim axis = 0; axis < N; ++axis) {
      half += std::fabs(direction[axis]) * static_cast<double>(box.max[axis] - box.min[axis]) / 2;
    }
    half /= std::sqrt(dot(direction, direction));
    return std::isfinite(half) ? half : 0;
  }

  /// A round shape first meets a step's edge with its side, which is steep. It climbs if there is ground where its
  /// middle will be, this far ahead: at least half of its width, and more if it walks at an angle to the step.
  bool is_ground_at(double distance, const Offset& ahead, const Offset& down) {
    const Vec<N, T> before = place_;
    place_ = place_after(ahead * (distance / std::sqrt(dot(ahead, ahead))));
    const auto ground = first_hit(down);
    place_ = before;
    return ground && is_ground(wide(ground->impact.normal));
  }

  /// The place after a motion that ends at the first touch.
  Vec<N, T> place_after(const Offset& way) const {
    const auto hit = first_hit(way);
    return place_ + Vec<N, T>(hit ? way * static_cast<double>(hit->impact.t) : way);
  }

  void advance(const Offset& way) {
    place_ += Vec<N, T>(way);
    stops_.push_back(place_);
  }

  /// A touch after a share t of what was left of the time.
  void note(ObjectImpact<N, T> hit, double t) {
    time_ += (1 - time_) * t;
    hit.impact.t = static_cast<T>(time_);
    touches_.push_back(hit);
    const Offset normal = wide(hit.impact.normal);
    surfaces_.push_back(normal);
    const double rise = -dot(normal, up_);
    const Offset level = normal + up_ * rise;
    if (rise > 0 && !is_ground(normal)) surfaces_.push_back(level / std::sqrt(dot(level, level)));
  }

  /// Whether the shape can stand on a surface, by the normal that points into it.
  bool is_ground(const Offset& normal) const {
    return -dot(normal, up_) > std::max(std::cos(options_.max_slope), 2 * grazing<T>);
  }

  std::optional<ObjectImpact<N, T>> first_hit(const Offset& way) const {
    const AnyShape<N, T> shape = shape_at(place_);
    std::optional<ObjectImpact<N, T>> first;
    for (const Obstacle& obstacle : obstacles_) {  // in the order of their ids
      const auto impact = shape_cast(shape, Vec<N, T>(way), *obstacle.shape,
                                     {.ignore_initial_touch = true, .target_distance = options_.clearance});
      if (impact && (!first || impact->t < first->impact.t)) first = {obstacle.id, *impact};
    }
    return first;
  }

  bool leads_into_nothing(const Offset& way) const {
    const double limit = grazing<T> * std::sqrt(dot(way, way));
    return std::all_of(surfaces_.begin(), surfaces_.end(),
                       [&](const Offset& normal) { return dot(normal, way) <= limit; });
  }

  /// The motion nearest to `wanted` that leads into none of the surfaces: it is along none, one or, in 3D, two of them.
  Offset allowed(const Offset& wanted) const {
    if (leads_into_nothing(wanted)) return wanted;
    Offset best(0.0);
    double most = 0;
    const auto try_along = [&](const Offset& way) {
      const double along = dot(way, wanted);  // its length squared, since it is a projection
      if (along <= most || !leads_into_nothing(way)) return;
      best = way;
      most = along;
    };
    for (std::size_t i = 0; i < surfaces_.size(); ++i) {
      const Offset& normal = surfaces_[i];
      try_along(wanted - normal * dot(normal, wanted));
      if constexpr (N == 3) {
        for (std::size_t j = 0; j < i; ++j) {
          const Offset edge = cross(normal, surfaces_[j]);
          const double whole = dot(edge, edge);
          if (whole > 0) try_along(edge * (dot(edge, wanted) / whole));
        }
      }
    }
    return best;
  }

  /// The last stop without an overlap; one with what the shape overlapped at the start does not count.
  Vec<N, T> last_free_stop() const {
    const auto overlaps = [this](const Vec<N, T>& place, const Obstacle& obstacle) {
      return relation(shape_at(place), *obstacle.shape) == Relation::overlapping;
    };
    for (std::size_t stop = stops_.size(); stop-- > 1;) {
      if (std::none_of(obstacles_.begin(), obstacles_.end(), [&](const Obstacle& obstacle) {
            return overlaps(stops_[stop], obstacle) && !overlaps(Vec<N, T>(T(0)), obstacle);
          })) {
        return stops_[stop];
      }
    }
    return stops_.front();
  }

  const SceneView<N, T>& scene_;
  const AnyShape<N, T>& shape_;
  const SlideOptions& options_;
  Offset up_;
  double half_width_;  // of the shape's box
  std::vector<Obstacle> obstacles_;
  Vec<N, T> place_ = Vec<N, T>(T(0));  // how far the shape has moved
  std::vector<Vec<N, T>> stops_;       // the places after each part of the path, the start included
  std::vector<Offset> surfaces_;       // the normals of what is touched at the place
  double time_ = 0;
  std::vector<ObjectImpact<N, T>> touches_;
};

void require_of_slide(bool is_right, const char* what) {
  if (!is_right) throw std::invalid_argument(std::string("slide: ") + what);
}

bool is_length(double value) { return value >= 0 && std::isfinite(value); }

}  // namespace

template <Dim N, class T>
Slide<N, T> slide(const SceneView<N, T>& scene, const std::type_identity_t<AnyShape<N, T>>& shape,
                  const std::type_identity_t<Vec<N, T>>& motion, const SlideOptions& options) {
  const std::string_view fault = defect(shape);
  if (!fault.empty())
    require_of_slide(
        false, ("the shape, " + detail::with_article(type_name<N, T>(shape)) + ", " + std::string(fault)).c_str());
  require_of_slide(is_finite(motion), "the motion has a number that is not finite");
  require_of_slide(is_length(options.clearance), "the clearance is negative or not finite");
  require_of_slide(is_length(options.step_height), "the step height is negative or not finite");
  require_of_slide(options.max_slope >= 0 && options.max_slope <= std::numbers::pi / 2,
                   "the slope is not between 0 and a right angle");
  const Vec<N, double> up(options.up);
  require_of_slide(is_finite(up) && dot(up, up) > 0 && std::isfinite(dot(up, up)), "up is zero or not finite");
  return Slider<N, T>(scene, shape, options).run(motion);
}

#define GRAZE_INSTANTIATE(N, T) \
  template Slide<N, T> slide(const SceneView<N, T>&, const AnyShape<N, T>&, const Vec<N, T>&, const SlideOptions&);
GRAZE_INSTANTIATE(2, float)
GRAZE_INSTANTIATE(3, float)
GRAZE_INSTANTIATE(2, double)
GRAZE_INSTANTIATE(3, double)
#undef GRAZE_INSTANTIATE

}  // namespace graze
