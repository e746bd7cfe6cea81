// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

#include <graze/io/svg/pen.hpp>
#include <graze/io/svg/stage.hpp>
#include <graze/io/svg/style.hpp>
#include <graze/io/svg/subject.hpp>

namespace graze::io::svg {

/// What the pen has drawn of an object, as one element: a group with its title and, when it is in a pair, the class
/// that `class_of` gives; bare where neither is called for.
template <Dim N>
std::string object_element(const Subject<N>& subject, std::size_t position, const Detail& detail, Pen& pen);

/// The names of the objects, as SVG, as many as fit; empty when `detail` leaves them out.
template <Dim N>
std::string name_labels(const Subject<N>& subject, const Stage<N>& stage, const Detail& detail);

/// A mark where the objects of each pair meet, as SVG: in the middle of their contact points. Empty for more pairs than
/// can be told apart.
template <Dim N>
std::string pair_marks(const Subject<N>& subject, const Stage<N>& stage);

}  // namespace graze::io::svg
