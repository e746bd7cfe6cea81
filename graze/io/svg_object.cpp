// SPDX-License-Identifier: MIT
#include <vector>

#include <fmt/format.h>

#include <graze/io/svg_labels.hpp>
#include <graze/io/svg_object.hpp>
#include <graze/io/svg_text.hpp>

namespace graze::io::svg {

template <Dim N>
std::string object_element(const Subject<N>& subject, std::size_t position, const Detail& detail, Pen& pen) {
  const bool touching = subject.touches[position].count > 0;
  const bool bare = !touching && !detail.titles && pen.elements() == 1;
  const std::string pieces = pen.take();
  if (bare) return pieces + "\n";
  const std::string heading =
      detail.titles ? fmt::format("<title>{}</title>", escaped(title(subject, position))) : std::string();
  return fmt::format("<g{}>{}{}</g>\n", touching ? " class=\"touching\"" : "", heading, pieces);
}

template <Dim N>
std::string name_labels(const Subject<N>& subject, const Stage<N>& stage, const Detail& detail) {
  if (!detail.labels) return "";
  std::vector<Label> labels;
  for (const std::size_t position : stage.drawn) {
    const Object<N, double>& object = *subject.objects[position];
    const Aabb<2, double> box = picture_box(stage, object.shape);
    if (!object.name.empty() && box.min.x <= box.max.x) labels.push_back({subject.names[position], box});
  }
  return placed_labels(labels, stage.frame.card);
}

template std::string object_element(const Subject<2>&, std::size_t, const Detail&, Pen&);
template std::string object_element(const Subject<3>&, std::size_t, const Detail&, Pen&);
template std::string name_labels(const Subject<2>&, const Stage<2>&, const Detail&);
template std::string name_labels(const Subject<3>&, const Stage<3>&, const Detail&);

}  // namespace graze::io::svg
