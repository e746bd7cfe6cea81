// SPDX-License-Identifier: MIT
// A scene in a few figures: what `graze info` says.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include <graze/io/report/check.hpp>
#include <graze/io/scene_file.hpp>
#include <graze/math/vec.hpp>

namespace graze::io {

/// So many objects of a type or on a layer.
struct Count {
  std::string name;
  std::size_t objects = 0;
};

/// So many objects with a size from `from` up to, but not including, `to`. The bin of size zero has both zero.
struct SizeBin {
  double from = 0;
  double to = 0;
  std::size_t objects = 0;
};

/// How the sizes of the bounded objects spread. An object's size is the largest extent of its box, at most the largest
/// double. Median and p90 are sizes that occur: the least that at least 50 % or 90 % of the objects do not exceed.
struct SizeSpread {
  double min = 0;
  double median = 0;
  double p90 = 0;
  double max = 0;
  std::vector<SizeBin> bins;  ///< Ascending without gaps, edges are powers of two; at most twelve.
};

/// The box around all bounded objects.
struct Extent {
  std::vector<double> min;  ///< As many numbers as the scene has dimensions.
  std::vector<double> max;
};

struct SceneSummary {
  std::string source;
  std::string format;
  Dim dimension = 2;
  std::size_t objects = 0;
  std::vector<Count> types;   ///< Those that occur, in AnyShape's order.
  std::vector<Count> layers;  ///< By number: those that have a name or objects. One without a name is called "layer 3".
  std::optional<Extent> bounds;     ///< None when no object is bounded.
  std::size_t unbounded = 0;        ///< Rays, planes, half-spaces and compounds with one: without a size.
  std::size_t empty = 0;            ///< Compounds without parts: without a size too.
  std::optional<SizeSpread> sizes;  ///< None when no object is bounded.
  std::vector<Omission> omissions;
};

SceneSummary summarise(const SceneFile& file);

/// For people.
void write_summary_table(std::ostream& out, const SceneSummary& summary, Colours colours = Colours::off);

/// For programs: schema graze.info/1, documented in docs/cli.md.
void write_summary_json(std::ostream& out, const SceneSummary& summary);

}  // namespace graze::io
