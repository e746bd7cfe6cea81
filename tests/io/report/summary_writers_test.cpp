// SPDX-License-Identifier: MIT
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <graze/io/report/summary.hpp>

namespace graze::io::summary_writers_test {
namespace {

SceneSummary yard() {
  SceneSummary summary;
  summary.source = "yard.json";
  summary.format = "graze.scene/1";
  summary.objects = 4;
  summary.types = {{"ray", 1}, {"sphere", 3}};
  summary.layers = {{"walls", 4}};
  summary.bounds = Extent{{-4, -1.5}, {4, 10}};
  summary.unbounded = 1;
  summary.sizes = SizeSpread{0, 3, 6, 6, {{0, 0, 1}, {2, 4, 2}}};
  summary.omissions = {{"tile layer", 3}};
  return summary;
}

std::string table(const SceneSummary& summary, Colours colours = Colours::off) {
  std::ostringstream out;
  write_summary_table(out, summary, colours);
  return out.str();
}

TEST(SummaryTable, says_everything_in_aligned_blocks) {
  EXPECT_EQ(table(yard()), R"(yard.json: graze.scene/1, 2D, 4 objects

types
  ray     1
  sphere  3

layers
  walls  4

bounds
  from       -4, -1.5
  to         4, 10
  unbounded  1

sizes (largest extent of each box)
  min     0
  median  3
  p90     6
  max     6
  zero    1 ####################
  2 to 4  2 ########################################

not read
  tile layer  3
)");
}

TEST(SummaryTable, leaves_out_blocks_that_would_be_empty) {
  SceneSummary summary;
  summary.source = "empty.csv";
  summary.format = "csv";
  summary.dimension = 3;
  EXPECT_EQ(table(summary), "empty.csv: csv, 3D, 0 objects\n");
}

TEST(SummaryTable, shows_names_without_what_a_terminal_would_obey) {
  SceneSummary summary = yard();
  summary.layers = {{"\x1b[2J", 4}};
  summary.omissions = {{"field \x1b]0;", 1}};
  EXPECT_EQ(table(summary).find('\x1b'), std::string::npos);
  EXPECT_NE(table(summary).find("\\x1b[2J"), std::string::npos);
}

TEST(SummaryTable, has_bold_titles_in_colour) {
  EXPECT_NE(table(yard(), Colours::on).find("\n\x1b[1mtypes\x1b[0m\n"), std::string::npos);
}

TEST(SummaryJson, says_everything) {
  std::ostringstream out;
  write_summary_json(out, yard());
  EXPECT_EQ(nlohmann::json::parse(out.str()), nlohmann::json::parse(R"({
    "schema": "graze.info/1", "scene": "yard.json", "format": "graze.scene/1", "dimension": 2, "objects": 4,
    "types": [{"name": "ray", "objects": 1}, {"name": "sphere", "objects": 3}],
    "layers": [{"name": "walls", "objects": 4}],
    "bounds": {"min": [-4.0, -1.5], "max": [4.0, 10.0]}, "unbounded": 1, "empty": 0,
    "sizes": {"min": 0.0, "median": 3.0, "p90": 6.0, "max": 6.0,
              "bins": [{"from": 0.0, "to": 0.0, "objects": 1}, {"from": 2.0, "to": 4.0, "objects": 2}]},
    "meshes": [],
    "not_read": [{"what": "tile layer", "count": 3, "loss": "none", "where": "", "why": ""}]
  })"));
}

/// A closed mesh, and one with faults.
SceneSummary with_meshes() {
  SceneSummary summary = yard();
  summary.meshes = {{"a", MeshKind::solid, 24, 12, 16, {.components = 1}},
                    {"b", MeshKind::surface, 3, 1, 0, {.open_edges = 3, .non_manifold_edges = 2, .is_closed = false}}};
  return summary;
}

TEST(SummaryTable, sums_up_the_meshes) {
  EXPECT_NE(table(with_meshes())
                .find("\nmeshes\n"
                      "  vertices            27\n"
                      "  faces               13\n"
                      "  closed              1 of 2\n"
                      "  solids              1 of 2\n"
                      "  duplicate vertices  16\n"
                      "  open edges          3\n"
                      "  non-manifold edges  2\n"
                      "  components          1\n"),
            std::string::npos)
      << table(with_meshes());
}

TEST(SummaryJson, lists_the_meshes) {
  std::ostringstream out;
  write_summary_json(out, with_meshes());
  EXPECT_EQ(nlohmann::json::parse(out.str())["meshes"][1], nlohmann::json::parse(R"({
    "name": "b", "kind": "surface", "closed": false, "vertices": 3, "faces": 1, "duplicate_vertices": 0,
    "unused_vertices": 0, "open_edges": 3, "non_manifold_edges": 2, "flipped_edges": 0, "degenerate_faces": 0,
    "duplicate_faces": 0, "components": 0})"));
}

TEST(SummaryJson, has_null_where_there_is_nothing_bounded) {
  SceneSummary summary = yard();
  summary.bounds.reset();
  summary.sizes.reset();
  std::ostringstream out;
  write_summary_json(out, summary);
  const auto document = nlohmann::json::parse(out.str());
  EXPECT_TRUE(document["bounds"].is_null());
  EXPECT_TRUE(document["sizes"].is_null());
}

}  // namespace
}  // namespace graze::io::summary_writers_test
