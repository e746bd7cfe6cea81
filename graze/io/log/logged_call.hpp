// SPDX-License-Identifier: MIT
// A call on a scene, as a query log holds it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <graze/math/motion.hpp>
#include <graze/math/vec.hpp>
#include <graze/scene/filter.hpp>
#include <graze/scene/object.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze::io {

/// The `owner` of ids that the logged scene returned. Logs do not contain the scenes' own numbers; the owner of a
/// default-constructed id is 0.
inline constexpr std::uint32_t logged_scene = 1;
/// The `owner` of ids that another scene returned.
inline constexpr std::uint32_t other_scene = 2;

/// The member functions of Scene and SceneView that a log can hold; `nearest_to` is `nearest` to a shape.
enum class CallKind : std::uint8_t {
  plan_ids,
  layer,
  add,
  move,
  move_many,
  remove,
  except,
  accept,
  update,
  find,
  candidates,
  pairs,
  contacts,
  overlapping,
  cull,
  cull_frustum,
  nearest,
  ray_cast,
  ray_cast_all,
  shape_cast,
  shape_cast_all,
  time_of_impact,
  contacts_with,
  nearest_to,
  closest_pairs,
};
/// The number of CallKinds.
inline constexpr std::size_t call_kinds = 25;

/// The arguments of a call, as bits of a set.
enum CallFields : std::uint32_t {
  field_id = 1U << 0U,
  field_ids = 1U << 1U,
  field_vacant_ids = 1U << 2U,
  field_shape = 1U << 3U,
  field_shapes = 1U << 4U,
  field_corners = 1U << 5U,
  field_options = 1U << 6U,
  field_name = 1U << 7U,
  field_layers = 1U << 8U,
  field_count = 1U << 9U,
  field_t_max = 1U << 10U,
  field_margin = 1U << 11U,
  field_motion = 1U << 12U,
  field_rotation = 1U << 13U,
  field_within = 1U << 14U,
  field_except = 1U << 15U,
  field_initial_touch = 1U << 16U,
};

/// How a kind of call is written.
struct CallForm {
  std::string_view name;  ///< The name in a log.
  std::uint32_t fields;   ///< A set of CallFields.
  bool is_change;         ///< Whether it changes objects or layers.
};

/// The forms of all calls, in the order of CallKind.
inline constexpr std::array<CallForm, call_kinds> call_forms = {{
    {"plan_ids", field_ids | field_vacant_ids, true},
    {"layer", field_name, true},
    {"add", field_shape | field_options, true},
    {"move", field_id | field_shape, true},
    {"move_many", field_ids | field_shapes, true},
    {"remove", field_id, true},
    {"except", field_ids, true},
    {"accept", field_ids, true},
    {"update", 0, false},
    {"find", field_name, false},
    {"candidates", field_margin, false},
    {"pairs", 0, false},
    {"contacts", 0, false},
    {"overlapping", field_shape | field_layers | field_except, false},
    {"cull", field_shape | field_layers | field_except, false},
    {"cull_frustum", field_corners | field_layers | field_except, false},
    {"nearest", field_shape | field_count | field_layers | field_except, false},
    {"ray_cast", field_shape | field_t_max | field_layers | field_except, false},
    {"ray_cast_all", field_shape | field_t_max | field_layers | field_except, false},
    {"shape_cast", field_shape | field_motion | field_layers | field_except | field_initial_touch, false},
    {"shape_cast_all", field_shape | field_motion | field_layers | field_except | field_initial_touch, false},
    {"time_of_impact", field_shape | field_motion | field_rotation | field_layers | field_except, false},
    {"contacts_with", field_shape | field_layers | field_except, false},
    {"nearest_to", field_shape | field_count | field_layers | field_except, false},
    {"closest_pairs", field_within, false},
}};

/// The form of a kind of call.
constexpr const CallForm& form_of(CallKind kind) { return call_forms[static_cast<std::size_t>(kind)]; }

/// Whether a kind of call has an argument.
constexpr bool has_field(CallKind kind, CallFields field) { return (form_of(kind).fields & field) != 0; }

/// A call with its arguments; `form_of(kind)` tells which members it uses. Numbers of a scene in float are widened to
/// double, exactly.
template <Dim N>
struct LoggedCall {
  CallKind kind = CallKind::update;              ///< The function that was called.
  std::vector<ObjectId> ids = {};                ///< One for `move` and `remove`, two for `except` and `accept`.
  std::vector<ObjectId> vacant_ids = {};         ///< The second argument of `plan_ids`.
  std::vector<AnyShape<N, double>> shapes = {};  ///< As many as ids for `move_many`, otherwise one: the shape of an
                                                 ///< object, the region, the point (`nearest`), the ray, or
                                                 ///< the shape that moves or is near.
  std::vector<Vec<N, double>> corners = {};      ///< The corners of a frustum.
  ObjectOptions options = {};                    ///< The options of an object.
  std::string name = {};                         ///< The name of a layer or object.
  LayerMask layers = all_layers;                 ///< The layers of a query.
  std::vector<ObjectId> except = {};             ///< The objects that a query leaves out.
  bool ignore_initial_touch = false;             ///< Of a query that casts a shape.
  std::uint64_t count = 0;                       ///< The number of objects for `nearest` and `nearest_to`.
  double t_max = std::numeric_limits<double>::infinity();  ///< The end of a ray.
  double margin = 0;                                       ///< The margin of `candidates`.
  Motion<N, double> motion = {};                           ///< The motion of a shape; for casts only `linear`.
  double within = 0;                                       ///< The distance for `closest_pairs`.
  std::string fault = {};  ///< If the arguments cannot be written, because they are not numbers or not a valid shape,
                           ///< what is wrong with them; then only `kind` is used. Scenes reject such calls.
};

/// The line of a call in a log, without the newline: {"call": "remove", "id": [3, 1]}. Throws OutputError for arguments
/// that a scene accepts but a log cannot contain: names that are not UTF-8, compounds nested deeper than 32.
template <Dim N>
std::string call_line(const LoggedCall<N>& call);

}  // namespace graze::io
