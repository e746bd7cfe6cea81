// SPDX-License-Identifier: MIT
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

template std::map<ObjectId, std::string> state_after(std::span<const LogEntry<2>>);
template std::map<ObjectId, std::string> state_after(std::span<const LogEntry<3>>);

}  // namespace graze::io
