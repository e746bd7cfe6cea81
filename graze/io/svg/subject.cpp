// SPDX-License-Identifier: MIT
#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include <graze/broad/touching_pairs.hpp>
#include <graze/io/svg/subject.hpp>
#include <graze/io/svg/text.hpp>

namespace graze::io::svg {
namespace {

constexpr std::size_t longest_name = 80;

std::uint32_t position_of(ObjectId id, std::span<const ObjectId> ids) {
  const auto found = std::lower_bound(ids.begin(), ids.end(), id);
  if (found == ids.end() || *found != id) {
    throw std::invalid_argument(
        fmt::format("write_svg: a touching pair names object {} (generation {}), which is not in the scene", id.index,
                    id.generation));
  }
  return static_cast<std::uint32_t>(found - ids.begin());
}

void note(Touches& touches, std::uint32_t other, Relation relation) {
  if (touches.count < Touches::named) touches.first[touches.count] = other;
  ++touches.count;
  touches.closest = std::max(touches.closest, relation);
}

template <Dim N>
std::vector<DrawnPair> seen_pairs(const Subject<N>& subject, std::span<const ObjectPair> reported) {
  std::vector<DrawnPair> pairs;
  std::vector<graze::detail::ShapePair<N, double>> shapes;
  pairs.reserve(reported.size());
  shapes.reserve(reported.size());
  for (const ObjectPair& pair : reported) {
    pairs.push_back({position_of(pair.a, subject.ids), position_of(pair.b, subject.ids), Relation::apart});
    shapes.push_back({&subject.objects[pairs.back().a]->shape, &subject.objects[pairs.back().b]->shape});
  }
  std::vector<Relation> relations(pairs.size());
  graze::detail::relations_of<N, double>(shapes, relations.data());
  for (std::size_t i = 0; i < pairs.size(); ++i) pairs[i].relation = relations[i];
  return pairs;
}

}  // namespace

std::vector<Touches> touches_by_object(std::size_t objects, std::span<const DrawnPair> pairs) {
  std::vector<Touches> touches(objects);
  for (const DrawnPair& pair : pairs) {
    note(touches[pair.a], pair.b, pair.relation);
    note(touches[pair.b], pair.a, pair.relation);
  }
  return touches;
}

std::string_view class_of(const Touches& touches) {
  if (touches.count == 0) return "";
  return touches.closest == Relation::apart ? "near" : name_of(touches.closest);
}

template <Dim N>
Subject<N> subject_of(const Scene<N, double>& scene, std::span<const ObjectPair> reported) {
  Subject<N> subject;
  subject.ids = scene.ids();
  subject.objects.reserve(subject.ids.size());
  subject.names.reserve(subject.ids.size());
  for (const ObjectId id : subject.ids) {
    subject.objects.push_back(&scene.object(id));
    const std::string& name = scene.object(id).name;
    subject.names.push_back(name.empty() ? fmt::format("#{}", id.index) : shortened(name, longest_name));
  }
  subject.pairs = seen_pairs(subject, reported);
  subject.touches = touches_by_object(subject.ids.size(), subject.pairs);
  return subject;
}

template <Dim N>
std::string title(const Subject<N>& subject, std::size_t position) {
  std::string text = fmt::format("{} ({})", subject.names[position], type_name(subject.objects[position]->shape));
  const Touches& touches = subject.touches[position];
  if (touches.count == 0) return text;
  const std::string_view verb = touches.closest == Relation::apart ? ", is near " : ", touches ";
  const std::size_t named = std::min(touches.count, Touches::named);
  for (std::size_t i = 0; i < named; ++i) {
    const bool last = i + 1 == named && touches.count == named;
    text += i == 0 ? verb : last ? " and " : ", ";
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
