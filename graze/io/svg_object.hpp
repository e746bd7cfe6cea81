// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

#include <graze/io/svg_pen.hpp>
#include <graze/io/svg_stage.hpp>
#include <graze/io/svg_style.hpp>
#include <graze/io/svg_subject.hpp>

namespace graze::io::svg {

/// What the pen has drawn of an object, as one element: a group with its title and, when it touches something, the
/// class "touching"; bare where neither is called for.
template <Dim N>
std::string object_element(const Subject<N>& subject, std::size_t position, const Detail& detail, Pen& pen);

/// The names of the objects, as SVG, where they fit; empty when `detail` leaves them out.
template <Dim N>
std::string name_labels(const Subject<N>& subject, const Stage<N>& stage, const Detail& detail);

}  // namespace graze::io::svg
