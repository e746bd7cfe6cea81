// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include <graze/io/log/logged_answer.hpp>
#include <graze/io/log/logged_call.hpp>
#include <graze/io/text/quoting.hpp>
#include <graze/math/platform/bit_cast.hpp>

namespace graze::io {
namespace {

std::string row_text(const AnswerRow& row) {
  if (row.word.empty() && row.numbers.empty() && row.ids.size() == 1) return id_text(row.ids.front());
  if (row.word.empty() && row.ids.empty() && row.numbers.size() == 1) return number_text(row.numbers.front());
  std::string text;
  const auto append = [&text](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
  if (!row.word.empty()) append(fmt::format("\"{}\"", row.word));
  for (const ObjectId& id : row.ids) append(id_text(id));
  for (const double number : row.numbers) append(number_text(number));
  return '[' + text + ']';
}

/// NaN has many bit patterns, which a log does not distinguish.
bool same_number(double a, double b) {
  return bit_cast<std::uint64_t>(a) == bit_cast<std::uint64_t>(b) || (std::isnan(a) && std::isnan(b));
}

bool same_row(const AnswerRow& a, const AnswerRow& b) {
  return a.word == b.word && a.ids == b.ids &&
         std::equal(a.numbers.begin(), a.numbers.end(), b.numbers.begin(), b.numbers.end(), same_number);
}

template <Dim N, class T>
void append(std::vector<double>& numbers, const Vec<N, T>& vector) {
  for (Dim i = 0; i < N; ++i) numbers.push_back(static_cast<double>(vector[i]));
}

/// Of a RayHit or an Impact.
template <Dim N, class T, class Hit>
AnswerRow row_of_hit(const ObjectId& id, const Hit& hit) {
  AnswerRow row{{}, {id}, {static_cast<double>(hit.t)}};
  append<N, T>(row.numbers, hit.point);
  append<N, T>(row.numbers, hit.normal);
  return row;
}

template <Dim N, class T>
std::vector<double> numbers_of(const Manifold<N, T>& manifold) {
  std::vector<double> numbers;
  append<N, T>(numbers, manifold.normal);
  for (const ManifoldPoint<N, T>& contact : manifold.contacts()) {
    append<N, T>(numbers, contact.point_a);
    append<N, T>(numbers, contact.point_b);
    numbers.push_back(static_cast<double>(contact.depth));
  }
  return numbers;
}

void append_events(LoggedAnswer& answer, std::string_view word, const std::vector<ObjectPair>& pairs) {
  for (const auto& [a, b] : pairs) answer.rows.push_back({word, {a, b}, {}});
}

}  // namespace

std::string id_text(const ObjectId& id) {
  if (id == ObjectId{}) return "null";
  const std::string numbers = fmt::format("[{}, {}]", id.index, id.generation);
  return id.owner == other_scene ? fmt::format("{{\"other_scene\": {}}}", numbers) : numbers;
}

std::string number_text(double number) {
  if (std::isnan(number)) return "\"nan\"";
  if (std::isinf(number)) return number > 0 ? "\"inf\"" : "\"-inf\"";
  return number == 0 && std::signbit(number) ? "-0.0" : fmt::format("{}", number);
}

AnswerDigest digest_of(const std::vector<AnswerRow>& rows) {
  AnswerDigest result{rows.size(), 0xcbf29ce484222325U};
  for (const AnswerRow& row : rows) {
    for (const char letter : row_text(row) + '\n') {
      result.digest = (result.digest ^ static_cast<unsigned char>(letter)) * 0x100000001b3U;
    }
  }
  return result;
}

bool say_the_same(const LoggedAnswer& a, const LoggedAnswer& b) {
  if (a.refusal || b.refusal) return a.refusal.has_value() == b.refusal.has_value();
  if (a.digest || b.digest) {
    return (a.digest ? *a.digest : digest_of(a.rows)) == (b.digest ? *b.digest : digest_of(b.rows));
  }
  return std::equal(a.rows.begin(), a.rows.end(), b.rows.begin(), b.rows.end(), same_row);
}

std::string answer_line(const LoggedAnswer& answer) {
  if (answer.refusal) return fmt::format("{{\"refused\": {}}}", json_string(*answer.refusal));
  if (answer.digest || answer.rows.size() > most_rows) {
    const AnswerDigest digest = answer.digest ? *answer.digest : digest_of(answer.rows);
    return fmt::format("{{\"count\": {}, \"digest\": \"{:016x}\"}}", digest.count, digest.digest);
  }
  std::string text = "{\"answer\": [";
  for (const AnswerRow& row : answer.rows) text += (&row == answer.rows.data() ? "" : ", ") + row_text(row);
  return text + "]}";
}

LoggedAnswer logged(const std::vector<ObjectId>& ids) {
  LoggedAnswer answer;
  for (const ObjectId& id : ids) answer.rows.push_back({{}, {id}, {}});
  return answer;
}

LoggedAnswer logged(const std::vector<ObjectPair>& pairs) {
  LoggedAnswer answer;
  append_events(answer, {}, pairs);
  return answer;
}

LoggedAnswer logged(const SceneEvents& events) {
  LoggedAnswer answer;
  append_events(answer, "began", events.began);
  append_events(answer, "stayed", events.stayed);
  append_events(answer, "ended", events.ended);
  return answer;
}

template <class T>
LoggedAnswer logged(const std::vector<NearObject<T>>& neighbours) {
  LoggedAnswer answer;
  for (const auto& [id, distance] : neighbours) answer.rows.push_back({{}, {id}, {static_cast<double>(distance)}});
  return answer;
}

template <class T>
LoggedAnswer logged(const std::vector<NearPair<T>>& pairs) {
  LoggedAnswer answer;
  for (const auto& [pair, distance] : pairs) {
    answer.rows.push_back({{}, {pair.a, pair.b}, {static_cast<double>(distance)}});
  }
  return answer;
}

template <Dim N, class T>
LoggedAnswer logged(const std::vector<ObjectHit<N, T>>& hits) {
  LoggedAnswer answer;
  for (const auto& [id, hit] : hits) answer.rows.push_back(row_of_hit<N, T>(id, hit));
  return answer;
}

template <Dim N, class T>
LoggedAnswer logged(const std::vector<ObjectImpact<N, T>>& impacts) {
  LoggedAnswer answer;
  for (const auto& [id, impact] : impacts) answer.rows.push_back(row_of_hit<N, T>(id, impact));
  return answer;
}

template <Dim N, class T>
LoggedAnswer logged(const std::vector<ObjectContact<N, T>>& contacts) {
  LoggedAnswer answer;
  for (const auto& [pair, manifold] : contacts) {
    answer.rows.push_back({{}, {pair.a, pair.b}, numbers_of<N, T>(manifold)});
  }
  return answer;
}

template <Dim N, class T>
LoggedAnswer logged(const std::vector<ObjectTouch<N, T>>& touches) {
  LoggedAnswer answer;
  for (const auto& [id, manifold] : touches) answer.rows.push_back({{}, {id}, numbers_of<N, T>(manifold)});
  return answer;
}

template LoggedAnswer logged(const std::vector<NearObject<float>>&);
template LoggedAnswer logged(const std::vector<NearObject<double>>&);
template LoggedAnswer logged(const std::vector<NearPair<float>>&);
template LoggedAnswer logged(const std::vector<NearPair<double>>&);

#define GRAZE_INSTANTIATE(N, T)                                          \
  template LoggedAnswer logged(const std::vector<ObjectHit<N, T>>&);     \
  template LoggedAnswer logged(const std::vector<ObjectImpact<N, T>>&);  \
  template LoggedAnswer logged(const std::vector<ObjectContact<N, T>>&); \
  template LoggedAnswer logged(const std::vector<ObjectTouch<N, T>>&);
GRAZE_INSTANTIATE(2, float)
GRAZE_INSTANTIATE(3, float)
GRAZE_INSTANTIATE(2, double)
GRAZE_INSTANTIATE(3, double)
#undef GRAZE_INSTANTIATE

}  // namespace graze::io
