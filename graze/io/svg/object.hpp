// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

#include <graze/io/svg/pen.hpp>
#include <graze/io/svg/stage.hpp>
#include <graze/io/svg/style.hpp>
#include <graze/io/svg/subject.hpp>

namespace graze::io::svg {

/// What the pen has drawn of an object, as one element: a group with its title and, if it is in a pair, the class that
/// `class_of` returns; no group if neither is needed.
template <Dim N>
std::string object_element(const Subject<N>& subject, std::size_t position, const Detail& detail, Pen& pen);

/// The names of the objects, as SVG, as many as fit; empty if `detail` omits them.
template <Dim N>
std::string name_labels(const Subject<N>& subject, const Stage<N>& stage, const Detail& detail);

/// A mark where the objects of each pair meet, as SVG: at the average of their contact points. Empty for too many pairs
/// to tell apart.
template <Dim N>
std::string pair_marks(const Subject<N>& subject, const Stage<N>& stage);

}  // namespace graze::io::svg
