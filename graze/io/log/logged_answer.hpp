// SPDX-License-Identifier: MIT
// What a scene answered to a call, as a query log holds it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <graze/math/vec.hpp>
#include <graze/scene/events.hpp>
#include <graze/scene/object.hpp>
#include <graze/scene/scene_view.hpp>

namespace graze::io {

/// One entry of a result: an object, a pair, a hit.
struct AnswerRow {
  std::string_view word = {};        ///< "began", "stayed" or "ended" for the events of an update.
  std::vector<ObjectId> ids = {};    ///< At most two.
  std::vector<double> numbers = {};  ///< For neighbours the distance; for a hit t, point and normal; for contacts the
                                     ///< normal, then for each point its place on a, its place on b and its depth.
};

/// Replaces a result that is too long for a log.
struct AnswerDigest {
  std::size_t count = 0;     ///< The number of rows.
  std::uint64_t digest = 0;  ///< The hash of the rows; see `digest_of`.

  friend bool operator==(const AnswerDigest&, const AnswerDigest&) = default;
};

/// The result of a call: a list of rows, empty if the call returns nothing; or an exception.
struct LoggedAnswer {
  std::vector<AnswerRow> rows = {};                   ///< What the call returned.
  std::optional<AnswerDigest> digest = std::nullopt;  ///< Instead of rows, if there are more than `most_rows`.
  std::optional<std::string> refusal = std::nullopt;  ///< The message of the exception, instead of both.
};

/// Results with more rows than this are written as a digest.
inline constexpr std::size_t most_rows = 64;

/// The 64-bit FNV-1a hash of the text of all rows (Fowler, Noll and Vo 1991).
AnswerDigest digest_of(const std::vector<AnswerRow>& rows);

/// Whether two results are equal, numbers bit for bit; rows equal a digest if they have it. Two exceptions are equal
/// whatever their messages, which may change between versions.
bool say_the_same(const LoggedAnswer& a, const LoggedAnswer& b);

/// The line of a result in a log, without the newline: {"answer": [[3, 1]]}, {"count": 99, "digest": "..."} or
/// {"refused": "..."}.
std::string answer_line(const LoggedAnswer& answer);

/// The text of an id: [index, generation]; null for a default-constructed one, {"other_scene": [...]} for one of
/// another scene.
std::string id_text(const ObjectId& id);

/// The shortest text that is read as the same double, including the sign of zero. Numbers that are not finite become
/// the JSON strings "inf", "-inf" or "nan".
std::string number_text(double number);

// ---- The results of a scene, with ids unchanged

/// The result of `add`.
inline LoggedAnswer logged(const ObjectId& id) { return {{{{}, {id}, {}}}}; }
/// The result of `find`.
inline LoggedAnswer logged(const std::optional<ObjectId>& id) { return id ? logged(*id) : LoggedAnswer{}; }
/// The result of `layer`.
inline LoggedAnswer logged(Layer layer) { return {{{{}, {}, {static_cast<double>(layer)}}}}; }
/// The result of `overlapping` and `cull`.
LoggedAnswer logged(const std::vector<ObjectId>& ids);
/// The result of `candidates` and `pairs`.
LoggedAnswer logged(const std::vector<ObjectPair>& pairs);
/// The result of `update`.
LoggedAnswer logged(const SceneEvents& events);
/// The result of `nearest`.
template <class T>
LoggedAnswer logged(const std::vector<NearObject<T>>& neighbours);
/// The result of `closest_pairs`.
template <class T>
LoggedAnswer logged(const std::vector<NearPair<T>>& pairs);
/// The result of `shape_cast_all`.
template <Dim N, class T>
LoggedAnswer logged(const std::vector<ObjectImpact<N, T>>& impacts);
/// The result of `contacts_with`.
template <Dim N, class T>
LoggedAnswer logged(const std::vector<ObjectTouch<N, T>>& touches);
/// The result of `ray_cast_all`.
template <Dim N, class T>
LoggedAnswer logged(const std::vector<ObjectHit<N, T>>& hits);
/// The result of `contacts`.
template <Dim N, class T>
LoggedAnswer logged(const std::vector<ObjectContact<N, T>>& contacts);

/// The result of `ray_cast`.
template <Dim N, class T>
LoggedAnswer logged(const std::optional<ObjectHit<N, T>>& hit) {
  return logged(hit ? std::vector<ObjectHit<N, T>>{*hit} : std::vector<ObjectHit<N, T>>{});
}

/// The result of `shape_cast` and `time_of_impact`.
template <Dim N, class T>
LoggedAnswer logged(const std::optional<ObjectImpact<N, T>>& impact) {
  return logged(impact ? std::vector<ObjectImpact<N, T>>{*impact} : std::vector<ObjectImpact<N, T>>{});
}

}  // namespace graze::io
