// SPDX-License-Identifier: MIT
#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include <graze/io/svg_subject.hpp>
#include <graze/io/svg_text.hpp>

namespace graze::io::svg {
namespace {

constexpr std::size_t longest_name = 80;

std::size_t position_of(ObjectId id, std::span<const ObjectId> ids) {
  const auto found = std::lower_bound(ids.begin(), ids.end(), id);
  if (found == ids.end() || *found != id) {
    throw std::invalid_argument(
        fmt::format("write_svg: a touching pair names object {} (generation {}), which is not in the scene", id.index,
                    id.generation));
  }
  return static_cast<std::size_t>(found - ids.begin());
}

void note(Touches& touches, std::size_t other) {
  if (touches.count < Touches::named) touches.first[touches.count] = static_cast<std::uint32_t>(other);
  ++touches.count;
}

}  // namespace

std::vector<Touches> touches_by_object(std::span<const ObjectId> ids, std::span<const ObjectPair> pairs) {
  std::vector<Touches> touches(ids.size());
  for (const ObjectPair& pair : pairs) {
    const std::size_t a = position_of(pair.a, ids);
    const std::size_t b = position_of(pair.b, ids);
    note(touches[a], b);
    note(touches[b], a);
  }
  return touches;
}

template <Dim N>
Subject<N> subject_of(const Scene<N, double>& scene, std::span<const ObjectPair> touching) {
  Subject<N> subject;
  subject.ids = scene.ids();
  subject.touches = touches_by_object(subject.ids, touching);
  subject.objects.reserve(subject.ids.size());
  subject.names.reserve(subject.ids.size());
  for (const ObjectId id : subject.ids) {
    subject.objects.push_back(&scene.object(id));
    const std::string& name = scene.object(id).name;
    subject.names.push_back(name.empty() ? fmt::format("#{}", id.index) : shortened(name, longest_name));
  }
  return subject;
}

template <Dim N>
std::string title(const Subject<N>& subject, std::size_t position) {
  std::string text = fmt::format("{} ({})", subject.names[position], type_name(subject.objects[position]->shape));
  const Touches& touches = subject.touches[position];
  if (touches.count == 0) return text;
  const std::size_t named = std::min(touches.count, Touches::named);
  for (std::size_t i = 0; i < named; ++i) {
    const bool last = i + 1 == named && touches.count == named;
    text += i == 0 ? ", touches " : last ? " and " : ", ";
    text += subject.names[touches.first[i]];
  }
  if (touches.count > named) text += fmt::format(" and {} more", touches.count - named);
  return text;
}

template Subject<2> subject_of(const Scene<2, double>&, std::span<const ObjectPair>);
template Subject<3> subject_of(const Scene<3, double>&, std::span<const ObjectPair>);
template std::string title(const Subject<2>&, std::size_t);
template std::string title(const Subject<3>&, std::size_t);

}  // namespace graze::io::svg
