// SPDX-License-Identifier: MIT
#include "picture.hpp"

#include <cstdio>
#include <fstream>
#include <string>

#include <graze/io/shape_numbers.hpp>
#include <graze/io/svg.hpp>

namespace cookbook {
namespace {

using namespace graze;

/// The layer of the lines that `connect` draws.
constexpr Layer ways = 63;

}  // namespace

template <Dim N>
void Picture<N>::add(const AnyShape<N>& shape, const std::string& name, Layer group) {
  scene_.add(io::with_numbers<double>(shape), {.name = name, .layer = group, .mask = only_layer(group)});
}

template <Dim N>
void Picture<N>::draw(const AnyShape<N>& shape, const std::string& name) {
  scene_.add(io::with_numbers<double>(shape), {.name = name, .mask = 0});
}

template <Dim N>
void Picture<N>::connect(const Vec<N>& from, const Vec<N>& to, const std::string& name) {
  add(Segment<N>{from, to}, "", ways);
  add(to, name, ways);
}

template <Dim N>
int Picture<N>::save(int argc, char** argv) const {
  if (argc < 2) return 0;
  io::SceneFile file;
  file.scene = scene_;
  file.source = heading_;
  std::ofstream out(argv[1], std::ios::binary);
  io::write_svg(out, file, scene_.pairs());
  if (out.flush()) return 0;
  std::fprintf(stderr, "cannot write %s\n", argv[1]);
  return 1;
}

template class Picture<2>;
template class Picture<3>;

}  // namespace cookbook
