// SPDX-License-Identifier: MIT
// Statistics of a scene: the output of `graze info`.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include <graze/io/report/check.hpp>
#include <graze/io/scene_file.hpp>
#include <graze/math/platform/export.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/mesh.hpp>
#include <graze/shape/mesh_report.hpp>

namespace graze::io {

/// The number of objects of a type or on a layer.
struct Count {
  std::string name;
  std::size_t objects = 0;
};

/// The number of objects with a size from `from` up to, but not including, `to`. Both are zero for the bin of size
/// zero.
struct SizeBin {
  double from = 0;
  double to = 0;
  std::size_t objects = 0;
};

/// The distribution of the sizes of bounded objects. An object's size is the largest extent of its box, at most the
/// largest double. Median and p90 are sizes of objects: the smallest that at least 50 % or 90 % of the objects do not
/// exceed.
struct SizeSpread {
  double min = 0;
  double median = 0;
  double p90 = 0;
  double max = 0;
  std::vector<SizeBin> bins;  ///< Ascending without gaps; the edges are powers of two. At most twelve.
};

/// The box around all bounded objects.
struct Extent {
  std::vector<double> min;  ///< As many numbers as the scene has dimensions.
  std::vector<double> max;
};

/// A mesh of a scene. Edges and faces are counted in the mesh's own coordinates, after vertices with equal coordinates
/// have been joined: files repeat vertices where normals or colours change.
struct MeshCount {
  std::string name;  ///< Of the object.
  MeshKind kind = MeshKind::surface;
  std::size_t vertices = 0;            ///< As in the file.
  std::size_t faces = 0;               ///< Triangles.
  std::size_t duplicate_vertices = 0;  ///< Those with the coordinates of another one.
  MeshReport report;                   ///< `unused_vertices` is that of the mesh as in the file.
};

struct SceneSummary {
  std::string source;
  std::string format;
  Dim dimension = 2;
  std::size_t objects = 0;
  std::vector<Count> types;      ///< The types that occur, in AnyShape's order.
  std::vector<Count> layers;     ///< By number: layers that have a name or objects. An unnamed one is called "layer 3".
  std::optional<Extent> bounds;  ///< None when no object is bounded.
  std::size_t unbounded = 0;     ///< Rays, planes, half-spaces and compounds that contain one: they have no size.
  std::size_t empty = 0;         ///< Compounds without parts, which have no size either.
  std::optional<SizeSpread> sizes;  ///< None when no object is bounded.
  std::vector<MeshCount> meshes;    ///< Objects that are meshes; those inside compounds are not listed.
  std::vector<Omission> omissions;
};

GRAZE_EXPORT SceneSummary summarise(const SceneFile& file);

/// For people.
GRAZE_EXPORT void write_summary_table(std::ostream& out, const SceneSummary& summary, Colours colours = Colours::off);

/// For programs: schema graze.info/1, documented in docs/cli.md.
GRAZE_EXPORT void write_summary_json(std::ostream& out, const SceneSummary& summary);

}  // namespace graze::io
