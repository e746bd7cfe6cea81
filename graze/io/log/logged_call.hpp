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

#include <graze/math/vec.hpp>
#include <graze/scene/filter.hpp>
#include <graze/scene/object.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze::io {

/// What `owner` says in the ids of a log, where no scene's own number has a meaning. It is zero in an id that was made
/// by default.
inline constexpr std::uint32_t logged_scene = 1;  ///< The id is one of the scene that the log is about.
inline constexpr std::uint32_t other_scene = 2;   ///< Another scene gave it.

/// The member functions of Scene and SceneView that a log can hold.
enum class CallKind : std::uint8_t {
  plan_ids,
  layer,
  add,
  move,
  move_many,
  remove,
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
};
inline constexpr std::size_t call_kinds = 17;

/// What a call can be given: bits of a set.
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
};

/// How a kind of call is written.
struct CallForm {
  std::string_view name;
  std::uint32_t fields;  ///< A set of CallFields.
  bool is_change;        ///< Whether it changes what objects and layers there are.
};

/// In the order of CallKind.
inline constexpr std::array<CallForm, call_kinds> call_forms = {{
    {"plan_ids", field_ids | field_vacant_ids, true},
    {"layer", field_name, true},
    {"add", field_shape | field_options, true},
    {"move", field_id | field_shape, true},
    {"move_many", field_ids | field_shapes, true},
    {"remove", field_id, true},
    {"update", 0, false},
    {"find", field_name, false},
    {"candidates", field_margin, false},
    {"pairs", 0, false},
    {"contacts", 0, false},
    {"overlapping", field_shape | field_layers, false},
    {"cull", field_shape | field_layers, false},
    {"cull_frustum", field_corners | field_layers, false},
    {"nearest", field_shape | field_count | field_layers, false},
    {"ray_cast", field_shape | field_t_max | field_layers, false},
    {"ray_cast_all", field_shape | field_t_max | field_layers, false},
}};

constexpr const CallForm& form_of(CallKind kind) { return call_forms[static_cast<std::size_t>(kind)]; }

constexpr bool has_field(CallKind kind, CallFields field) { return (form_of(kind).fields & field) != 0; }

/// A call with what it was given; `form_of(kind)` says which of these have a meaning. Numbers of a scene in float are
/// widened, which loses nothing.
template <Dim N>
struct LoggedCall {
  CallKind kind = CallKind::update;
  std::vector<ObjectId> ids = {};  ///< One for `move` and `remove`.
  std::vector<ObjectId> vacant_ids = {};
  std::vector<AnyShape<N, double>> shapes = {};  ///< As many as ids for `move_many`; one for all others: of an object,
                                                 ///< the region, the point (`nearest`), the ray.
  std::vector<Vec<N, double>> corners = {};      ///< Of a frustum.
  ObjectOptions options = {};
  std::string name = {};
  LayerMask layers = all_layers;
  std::uint64_t count = 0;
  double t_max = std::numeric_limits<double>::infinity();
  double margin = 0;
  std::string fault = {};  ///< What is wrong with arguments that no log can hold, since they are no numbers or make no
                           ///< valid shape; none of the others has a meaning then. Scenes refuse such calls.
};

/// The call's line in a log, without an end of line: {"call": "remove", "id": [3, 1]}. Throws OutputError for what no
/// log can hold although scenes take it: names that are not UTF-8, compounds nested deeper than 32.
template <Dim N>
std::string call_line(const LoggedCall<N>& call);

}  // namespace graze::io
