// SPDX-License-Identifier: MIT
#include <cstddef>
#include <exception>
#include <map>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <graze/io/input_error.hpp>
#include <graze/io/log/scene_after.hpp>
#include <graze/io/log/side_by_side.hpp>

namespace graze::io {
namespace {

/// Applies the logged changes to a new scene.
template <Dim N>
class Successor {
 public:
  /// Applies an answered call that was not refused.
  void perform(const LogEntry<N>& entry) {
    const LoggedCall<N>& call = entry.call;
    switch (call.kind) {
      case CallKind::plan_ids:
        return scene_.plan_ids(call.ids, call.vacant_ids);
      case CallKind::layer:
        scene_.layer(call.name);
        return;
      case CallKind::add:
        return add(entry);
      case CallKind::move:
      case CallKind::move_many:
        return scene_.move(moves(call));
      case CallKind::remove:
        return scene_.remove(here(call.ids.front()));
      case CallKind::except:
        return scene_.except(here(call.ids[0]), here(call.ids[1]));
      case CallKind::accept:
        return scene_.accept(here(call.ids[0]), here(call.ids[1]));
      default:
        return;  // a query: changes nothing
    }
  }

  Scene<N, double> take() { return std::move(scene_); }

 private:
  void add(const LogEntry<N>& entry) {
    const ObjectId id = scene_.add(entry.call.shapes.front(), entry.call.options);
    if (const auto name = added_id(entry.call.kind, *entry.answer)) here_[*name] = id;
  }

  std::vector<ObjectMove<N, double>> moves(const LoggedCall<N>& call) const {
    std::vector<ObjectMove<N, double>> result;
    for (std::size_t i = 0; i < call.ids.size(); ++i) result.push_back({here(call.ids[i]), call.shapes[i]});
    return result;
  }

  /// The id of an object in this scene; an invalid id if the log is inconsistent.
  ObjectId here(const ObjectId& name) const {
    const auto found = here_.find(name);
    return found == here_.end() ? ObjectId{} : found->second;
  }

  Scene<N, double> scene_;
  std::map<ObjectId, ObjectId> here_;  // by the log's ids
};

}  // namespace

template <Dim N>
Scene<N, double> scene_after(const QueryLog<N>& log, const std::string& source) {
  Successor<N> successor;
  for (const LogEntry<N>& entry : log.entries) {
    if (!entry.answer || entry.answer->refusal || !entry.call.fault.empty()) continue;
    try {
      successor.perform(entry);
    } catch (const std::exception& error) {
      throw InputError(fmt::format(
          "{}: line {}: the log says that its scene accepted this \"{}\", but a scene refuses it ({}); the log "
          "must be as it was recorded",
          source, entry.line, form_of(entry.call.kind).name, error.what()));
    }
  }
  return successor.take();
}

template Scene<2, double> scene_after(const QueryLog<2>&, const std::string&);
template Scene<3, double> scene_after(const QueryLog<3>&, const std::string&);

}  // namespace graze::io
