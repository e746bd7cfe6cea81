// SPDX-License-Identifier: MIT
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include <graze/broad/contacts.hpp>
#include <graze/io/svg/labels.hpp>
#include <graze/io/svg/legend.hpp>
#include <graze/io/svg/object.hpp>
#include <graze/io/svg/text.hpp>

namespace graze::io::svg {
namespace {

/// More marks would hide what they mark.
constexpr std::size_t most_marked_pairs = 150;

}  // namespace

template <Dim N>
std::string object_element(const Subject<N>& subject, std::size_t position, const Detail& detail, Pen& pen) {
  const std::string_view style = class_of(subject.touches[position]);
  const bool bare = style.empty() && !detail.titles && pen.elements() == 1;
  const std::string pieces = pen.take();
  if (bare) return pieces + "\n";
  const std::string heading =
      detail.titles ? fmt::format("<title>{}</title>", escaped(title(subject, position))) : std::string();
  return fmt::format("<g{}>{}{}</g>\n", style.empty() ? "" : fmt::format(" class=\"{}\"", style), heading, pieces);
}

template <Dim N>
std::string name_labels(const Subject<N>& subject, const Stage<N>& stage, const Detail& detail) {
  if (!detail.labels) return "";
  std::vector<Label> labels;
  for (const std::size_t position : stage.drawn) {
    const Object<N, double>& object = *subject.objects[position];
    const Aabb<2, double> box = picture_box(stage, object.shape);
    if (!(box.min.x <= box.max.x)) continue;
    labels.push_back({object.name.empty() ? "" : subject.names[position], box, subject.touches[position].count > 0});
  }
  return placed_labels(labels, stage.frame.card);
}

template <Dim N>
std::string pair_marks(const Subject<N>& subject, const Stage<N>& stage) {
  if (subject.pairs.size() > most_marked_pairs) return "";
  std::vector<Manifold<N, double>> manifolds(subject.pairs.size());
  std::vector<graze::detail::ShapesToContact<N, double>> meeting;
  for (std::size_t i = 0; i < subject.pairs.size(); ++i) {
    const DrawnPair& pair = subject.pairs[i];
    if (pair.relation == Relation::apart) continue;
    meeting.push_back({{&subject.objects[pair.a]->shape, &subject.objects[pair.b]->shape}, &manifolds[i]});
  }
  graze::detail::contacts_of<N, double>(meeting);
  std::string svg;
  for (std::size_t i = 0; i < subject.pairs.size(); ++i) {
    Vec<N, double> sum(0.0);
    for (const ManifoldPoint<N, double>& contact : manifolds[i].contacts()) sum += contact.point;
    if (manifolds[i].size == 0 || !is_finite(sum)) continue;
    const Vec<2, double> place =
        to_picture(stage.frame, seen(Vec<N, double>(sum / static_cast<double>(manifolds[i].size)), stage.view));
    svg += pair_mark(subject.pairs[i].relation, place) + "\n";
  }
  return svg;
}

template std::string object_element(const Subject<2>&, std::size_t, const Detail&, Pen&);
template std::string object_element(const Subject<3>&, std::size_t, const Detail&, Pen&);
template std::string name_labels(const Subject<2>&, const Stage<2>&, const Detail&);
template std::string name_labels(const Subject<3>&, const Stage<3>&, const Detail&);
template std::string pair_marks(const Subject<2>&, const Stage<2>&);
template std::string pair_marks(const Subject<3>&, const Stage<3>&);

}  // namespace graze::io::svg
