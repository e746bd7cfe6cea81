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

/// One of the things that an answer lists: an object, a pair, a hit.
struct AnswerRow {
  std::string_view word = {};        ///< "began", "stayed" or "ended" for the events of an update.
  std::vector<ObjectId> ids = {};    ///< At most two.
  std::vector<double> numbers = {};  ///< Of a neighbour, its distance; of a hit, t, point and normal; of contacts, the
                                     ///< normal, and of each point those on a and b, and the depth.
};

/// What stands for an answer that is too long for a log.
struct AnswerDigest {
  std::size_t count = 0;  ///< Of rows.
  std::uint64_t digest = 0;

  friend bool operator==(const AnswerDigest&, const AnswerDigest&) = default;
};

/// What a call gave: a list of rows, which is empty for a call that only does something; or a refusal.
struct LoggedAnswer {
  std::vector<AnswerRow> rows = {};
  std::optional<AnswerDigest> digest = std::nullopt;  ///< Instead of rows.
  std::optional<std::string> refusal = std::nullopt;  ///< The message of the exception, instead of both.
};

/// Answers with more rows are written as a digest.
inline constexpr std::size_t most_rows = 64;

/// FNV-1a of the text of all rows (Fowler, Noll and Vo 1991), 64 bits.
AnswerDigest digest_of(const std::vector<AnswerRow>& rows);

/// Whether two answers say the same, numbers bit for bit; a digest stands for all rows that have it. Two refusals are
/// the same whatever their messages, which are for people and may change.
bool say_the_same(const LoggedAnswer& a, const LoggedAnswer& b);

/// The answer's line in a log, without an end of line: {"answer": [[3, 1]]}, {"count": 99, "digest": "..."} or
/// {"refused": "..."}.
std::string answer_line(const LoggedAnswer& answer);

/// An id as it is written: [index, generation]; null for one made by default, {"other_scene": [...]} for a foreign one.
std::string id_text(const ObjectId& id);

/// The shortest text that reads back as the same double, the sign of zero included. JSON has no words for what is not
/// finite: it becomes "inf", "-inf" or "nan", with the quotes.
std::string number_text(double number);

// ---- The answers of a scene. Ids are taken over as they are.

inline LoggedAnswer logged(const ObjectId& id) { return {{{{}, {id}, {}}}}; }
inline LoggedAnswer logged(const std::optional<ObjectId>& id) { return id ? logged(*id) : LoggedAnswer{}; }
inline LoggedAnswer logged(Layer layer) { return {{{{}, {}, {static_cast<double>(layer)}}}}; }
LoggedAnswer logged(const std::vector<ObjectId>& ids);
LoggedAnswer logged(const std::vector<ObjectPair>& pairs);
LoggedAnswer logged(const SceneEvents& events);
template <class T>
LoggedAnswer logged(const std::vector<NearObject<T>>& neighbours);
template <Dim N, class T>
LoggedAnswer logged(const std::vector<ObjectHit<N, T>>& hits);
template <Dim N, class T>
LoggedAnswer logged(const std::vector<ObjectContact<N, T>>& contacts);

template <Dim N, class T>
LoggedAnswer logged(const std::optional<ObjectHit<N, T>>& hit) {
  return logged(hit ? std::vector<ObjectHit<N, T>>{*hit} : std::vector<ObjectHit<N, T>>{});
}

}  // namespace graze::io
