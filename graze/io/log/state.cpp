// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>

#include <graze/io/log/side_by_side.hpp>
#include <graze/io/log/state.hpp>

namespace graze::io {
namespace {

/// An object as the `add` call that would create it.
template <Dim N>
std::string text_of(const ObjectOptions& options, const AnyShape<N, double>& shape) {
  LoggedCall<N> call{.kind = CallKind::add, .shapes = {shape}, .options = options};
  return call_line(call);
}

/// The pair that a call excepts or accepts.
template <Dim N>
ObjectPair pair_of(const LoggedCall<N>& call) {
  const auto [a, b] = std::minmax(call.ids[0], call.ids[1]);
  return {a, b};
}

}  // namespace

template <Dim N>
std::map<ObjectId, std::string> state_after(std::span<const LogEntry<N>> entries) {
  std::map<ObjectId, ObjectOptions> options;
  std::map<ObjectId, std::string> state;
  for (const LogEntry<N>& entry : entries) {
    const LoggedCall<N>& call = entry.call;
    if (!entry.answer || entry.answer->refusal) continue;
    if (const auto id = added_id(call.kind, *entry.answer)) {
      options[*id] = call.options;
      state[*id] = text_of<N>(call.options, call.shapes.front());
    } else if (call.kind == CallKind::remove) {
      state.erase(call.ids.front());
    } else if (call.kind == CallKind::move || call.kind == CallKind::move_many) {
      for (std::size_t i = 0; i < call.ids.size(); ++i) {
        state[call.ids[i]] = text_of<N>(options[call.ids[i]], call.shapes[i]);
      }
    }
  }
  return state;
}

template <Dim N>
std::set<ObjectPair> excepted_after(std::span<const LogEntry<N>> entries) {
  std::set<ObjectPair> excepted;
  for (const LogEntry<N>& entry : entries) {
    const LoggedCall<N>& call = entry.call;
    if (!entry.answer || entry.answer->refusal) continue;
    if (call.kind == CallKind::remove) {
      const ObjectId gone = call.ids.front();
      std::erase_if(excepted, [gone](const ObjectPair& pair) { return pair.a == gone || pair.b == gone; });
    } else if (call.kind == CallKind::except) {
      excepted.insert(pair_of(call));
    } else if (call.kind == CallKind::accept) {
      excepted.erase(pair_of(call));
    }
  }
  return excepted;
}

template std::set<ObjectPair> excepted_after(std::span<const LogEntry<2>>);
template std::set<ObjectPair> excepted_after(std::span<const LogEntry<3>>);
template std::map<ObjectId, std::string> state_after(std::span<const LogEntry<2>>);
template std::map<ObjectId, std::string> state_after(std::span<const LogEntry<3>>);

}  // namespace graze::io
