// SPDX-License-Identifier: MIT
// Questions to many at once.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <graze/broad/batch/answers.hpp>
#include <graze/broad/contacts.hpp>
#include <graze/broad/pairs.hpp>
#include <graze/broad/touching_pairs.hpp>
#include <graze/query/closest_point.hpp>
#include <graze/query/contains.hpp>
#include <graze/query/signed_distance.hpp>
#include <graze/query/winding_number.hpp>

#include "arrays.hpp"
#include "rays.hpp"
#include "results.hpp"
#include "shape_in.hpp"
#include "vectors.hpp"

namespace graze::c {
namespace {

// Pairs are passed on without a copy.
static_assert(sizeof(Pair) == sizeof(graze_pair) && offsetof(Pair, b) == offsetof(graze_pair, b));

/// The options of a call, and the executor behind them.
class PairOptionsIn {
 public:
  explicit PairOptionsIn(const graze_pair_options* options) : threads_(options != nullptr ? options->threads : 0) {
    options_.executor = &threads_.executor();
    if (options == nullptr) return;
    options_.margin = options->margin;
    options_.order = options->any_order ? PairOrder::any : PairOrder::sorted;
  }

  const PairOptions& operator*() const { return options_; }

 private:
  Threads threads_;
  PairOptions options_;
};

/// Candidates, whose indices the batches check.
std::span<const Pair> pairs_in(const graze_pair* candidates, std::size_t count) {
  require_array("candidates", candidates, count);
  return {reinterpret_cast<const Pair*>(candidates), count};
}

/// Throws Error, naming the row, if a number is not valid: for points, that it is finite.
template <Dim N, class T>
void require_rows(std::string_view role, std::span<const Vec<N, T>> points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (is_finite(points[i])) continue;
    throw Error(GRAZE_INVALID_ARGUMENT,
                std::string(role) + "[" + std::to_string(i) + "] has a coordinate that is not finite");
  }
}
template <Dim N, class T>
void require_rows(std::string_view role, std::span<const Ray<N, T>> rays) {
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const std::string_view fault = defect(rays[i]);
    if (!fault.empty()) require_valid(std::string(role) + "[" + std::to_string(i) + "]", fault);
  }
}

/// Writes ask(row) of every row.
template <class Row, class Answer, class Ask>
void ask_rows(std::string_view role, const graze_rows& rows, std::uint32_t threads, Answer* out, const Ask& ask) {
  require_array("out", out, rows.count);
  const RowsIn<Row> in(role, rows);
  require_rows(role, in.span());
  const Threads used(threads);
  // Bits of a vector of bool cannot be written by several threads.
  using Stored = std::conditional_t<std::is_same_v<Answer, bool>, std::uint8_t, Answer>;
  const auto answers = detail::answers<Stored>(in.span().size(), {&used.executor()},
                                               [&](std::size_t i) -> Stored { return ask(in.span()[i]); });
  std::transform(answers.begin(), answers.end(), out, [](const Stored& answer) { return Answer(answer); });
}

/// Writes ask(shape, point) of every point.
template <class Answer, class Ask>
void ask_points(const graze_shape* shape, const graze_rows& points, std::uint32_t threads, Answer* out,
                const Ask& ask) {
  require_world("shape", required("shape", shape).world, "points", points.world);
  on_shape("shape", shape, [&]<Dim N, class T>(const AnyShape<N, T>& in) {
    ask_rows<Vec<N, T>>("points", points, threads, out, [&](const Vec<N, T>& point) { return ask(in, point); });
  });
}

/// Calls ask(shapes, candidates, options).
template <class Ask>
graze_status ask_candidates(const graze_shape* shapes, std::size_t shape_count, const graze_pair* candidates,
                            std::size_t candidate_count, std::uint32_t threads, const Ask& ask) {
  require_array("shapes", shapes, shape_count);
  const std::span<const Pair> pairs = pairs_in(candidates, candidate_count);
  const Threads used(threads);
  return in_world(shape_count > 0 ? shapes[0].world : GRAZE_3D, [&]<Dim N, class T>(In<N, T>) {
    const std::vector<AnyShape<N, T>> all = shapes_in<N, T>("shapes", shapes, shape_count);
    return ask(std::span<const AnyShape<N, T>>(all), pairs, TouchOptions{&used.executor()});
  });
}

}  // namespace
}  // namespace graze::c

using namespace graze;
using namespace graze::c;

graze_status graze_overlapping_pairs(graze_rows boxes, const graze_pair_options* options, graze_pair* out,
                                     size_t capacity, size_t* count) {
  return guarded(__func__, [&] {
    const Buffer<graze_pair> buffer(out, capacity, count);
    const PairOptionsIn used(options);
    return in_world(boxes.world, [&]<Dim N, class T>(In<N, T>) {
      const RowsIn<Aabb<N, T>> in("boxes", boxes);
      return buffer.fill(overlapping_pairs<N, T>(in.span(), *used), in_c);
    });
  });
}

graze_status graze_overlapping_pairs_between(graze_rows boxes_a, graze_rows boxes_b, const graze_pair_options* options,
                                             graze_pair* out, size_t capacity, size_t* count) {
  return guarded(__func__, [&] {
    const Buffer<graze_pair> buffer(out, capacity, count);
    const PairOptionsIn used(options);
    require_world("boxes_a", boxes_a.world, "boxes_b", boxes_b.world);
    return in_world(boxes_a.world, [&]<Dim N, class T>(In<N, T>) {
      const RowsIn<Aabb<N, T>> in_a("boxes_a", boxes_a);
      const RowsIn<Aabb<N, T>> in_b("boxes_b", boxes_b);
      return buffer.fill(overlapping_pairs<N, T>(in_a.span(), in_b.span(), *used), in_c);
    });
  });
}

graze_status graze_visit_overlapping_pairs(graze_rows boxes, const graze_pair_options* options,
                                           graze_pair_visitor visit, void* context) {
  return guarded(__func__, [&] {
    if (visit == nullptr) refuse_null("visit");
    const PairOptionsIn used(options);
    in_world(boxes.world, [&]<Dim N, class T>(In<N, T>) {
      const RowsIn<Aabb<N, T>> in("boxes", boxes);
      const auto pass_on = [&](std::span<const Pair> pairs) {
        return visit(reinterpret_cast<const graze_pair*>(pairs.data()), pairs.size(), context);
      };
      visit_overlapping_pairs<N, T>(in.span(), pass_on, *used);
    });
  });
}

graze_status graze_touching_pairs(const graze_shape* shapes, size_t shape_count, const graze_pair* candidates,
                                  size_t candidate_count, uint32_t threads, graze_pair* out, size_t capacity,
                                  size_t* count) {
  return guarded(__func__, [&] {
    const Buffer<graze_pair> buffer(out, capacity, count);
    return ask_candidates(shapes, shape_count, candidates, candidate_count, threads,
                          [&]<Dim N, class T>(std::span<const AnyShape<N, T>> all, const auto& pairs, auto options) {
                            return buffer.fill(touching_pairs<N, T>(all, pairs, options), in_c);
                          });
  });
}

graze_status graze_contacts(const graze_shape* shapes, size_t shape_count, const graze_pair* candidates,
                            size_t candidate_count, uint32_t threads, graze_pair_contact* out, size_t capacity,
                            size_t* count) {
  return guarded(__func__, [&] {
    const Buffer<graze_pair_contact> buffer(out, capacity, count);
    return ask_candidates(shapes, shape_count, candidates, candidate_count, threads,
                          [&]<Dim N, class T>(std::span<const AnyShape<N, T>> all, const auto& pairs, auto options) {
                            return buffer.fill(contacts<N, T>(all, pairs, options), [](const auto& found) {
                              return graze_pair_contact{c_result(found.pair), c_result(found.manifold)};
                            });
                          });
  });
}

graze_status graze_ray_casts(const graze_shape* shape, graze_rows rays, const graze_ray_options* options,
                             uint32_t threads, graze_ray_hit* out) {
  return guarded(__func__, [&] {
    require_world("shape", required("shape", shape).world, "rays", rays.world);
    on_shape("shape", shape, [&]<Dim N, class T>(const AnyShape<N, T>& in) {
      const T t_max = limit_in<T>(options);
      const RayOptions side = ray_options_in(options);
      ask_rows<Ray<N, T>>("rays", rays, threads, out,
                          [&](const Ray<N, T>& ray) { return hit_of(in, ray, t_max, side).value_or(graze_ray_hit{}); });
    });
  });
}

graze_status graze_contains_points(const graze_shape* shape, graze_rows points, uint32_t threads, bool* out) {
  return guarded(__func__, [&] {
    ask_points(shape, points, threads, out, [](const auto& in, const auto& point) { return contains(in, point); });
  });
}

graze_status graze_closest_points_to(const graze_shape* shape, graze_rows points, uint32_t threads, graze_vec* out) {
  return guarded(__func__, [&] {
    ask_points(shape, points, threads, out, []<Dim N, class T>(const AnyShape<N, T>& in, const Vec<N, T>& point) {
      return vec_out<N, T>(closest_point(in, point));
    });
  });
}

graze_status graze_signed_distances(const graze_shape* shape, graze_rows points, uint32_t threads, double* out) {
  return guarded(__func__, [&] {
    ask_points(shape, points, threads, out,
               [](const auto& in, const auto& point) -> double { return signed_distance(in, point); });
  });
}

graze_status graze_winding_numbers(const graze_shape* mesh, graze_rows points, uint32_t threads, double* out) {
  return guarded(__func__, [&] {
    if (required("mesh", mesh).kind != GRAZE_MESH) refuse_kind("mesh", mesh->kind, "a mesh");
    ask_points(mesh, points, threads, out, []<Dim N, class T>(const AnyShape<N, T>& in, const Vec<N, T>& point) {
      return winding_number(*std::get_if<Mesh<N, T>>(&in), point);
    });
  });
}
