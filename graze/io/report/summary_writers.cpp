// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstddef>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <graze/io/report/summary.hpp>
#include <graze/io/text/printable.hpp>

namespace graze::io {
namespace {

using Json = nlohmann::ordered_json;

Json counts_as_json(const std::vector<Count>& counts) {
  Json result = Json::array();
  for (const Count& count : counts) result.push_back({{"name", count.name}, {"objects", count.objects}});
  return result;
}

Json sizes_as_json(const SizeSpread& sizes) {
  Json bins = Json::array();
  for (const SizeBin& bin : sizes.bins) {
    bins.push_back({{"from", bin.from}, {"to", bin.to}, {"objects", bin.objects}});
  }
  return {{"min", sizes.min}, {"median", sizes.median}, {"p90", sizes.p90}, {"max", sizes.max}, {"bins", bins}};
}

/// The counts of a report and their names, in JSON with underscores.
std::vector<std::pair<std::string_view, std::size_t>> counts_of(const MeshCount& mesh) {
  return {{"duplicate_vertices", mesh.duplicate_vertices},  {"unused_vertices", mesh.report.unused_vertices},
          {"open_edges", mesh.report.open_edges},           {"non_manifold_edges", mesh.report.non_manifold_edges},
          {"flipped_edges", mesh.report.flipped_edges},     {"degenerate_faces", mesh.report.degenerate_faces},
          {"duplicate_faces", mesh.report.duplicate_faces}, {"components", mesh.report.components}};
}

Json meshes_as_json(const std::vector<MeshCount>& meshes) {
  Json result = Json::array();
  for (const MeshCount& mesh : meshes) {
    Json entry = {{"name", mesh.name},
                  {"kind", mesh_kind_names[static_cast<std::size_t>(mesh.kind)]},
                  {"closed", mesh.report.is_closed},
                  {"vertices", mesh.vertices},
                  {"faces", mesh.faces}};
    for (const auto& [name, count] : counts_of(mesh)) entry[std::string(name)] = count;
    result.push_back(std::move(entry));
  }
  return result;
}

/// One aligned block of the table: its title, then a line per entry.
class Block {
 public:
  Block(std::string title, Colours colours) : title_(std::move(title)), colours_(colours) {}

  void add(std::string_view label, std::string text) { lines_.push_back({printable(label), std::move(text)}); }

  void write(std::ostream& out) const {
    if (lines_.empty()) return;
    std::size_t width = 0;
    for (const Line& line : lines_) width = std::max(width, display_columns(line.label));
    const bool coloured = colours_ == Colours::on;
    out << '\n' << (coloured ? "\x1b[1m" : "") << title_ << (coloured ? "\x1b[0m" : "") << '\n';
    for (const Line& line : lines_) {
      out << "  " << line.label << std::string(width + 2 - display_columns(line.label), ' ') << line.text << '\n';
    }
  }

 private:
  struct Line {
    std::string label;
    std::string text;
  };

  std::string title_;
  Colours colours_;
  std::vector<Line> lines_;
};

void add_counts(Block& block, const std::vector<Count>& counts) {
  std::size_t width = 0;
  for (const Count& count : counts) width = std::max(width, std::to_string(count.objects).size());
  for (const Count& count : counts) block.add(count.name, fmt::format("{:>{}}", count.objects, width));
}

std::string listed(const std::vector<double>& coordinates) {
  std::string text;
  for (const double coordinate : coordinates) text += fmt::format("{}{}", text.empty() ? "" : ", ", coordinate);
  return text;
}

void add_space(Block& block, const SceneSummary& summary) {
  if (summary.bounds) {
    block.add("from", listed(summary.bounds->min));
    block.add("to", listed(summary.bounds->max));
  }
  if (summary.unbounded != 0) block.add("unbounded", fmt::format("{}", summary.unbounded));
  if (summary.empty != 0) block.add("empty", fmt::format("{}", summary.empty));
}

/// The statistics, then a bar for each bin. The longest has 40 characters; a bin that is not empty has at least one.
void add_sizes(Block& block, const SizeSpread& sizes) {
  block.add("min", fmt::format("{}", sizes.min));
  block.add("median", fmt::format("{}", sizes.median));
  block.add("p90", fmt::format("{}", sizes.p90));
  block.add("max", fmt::format("{}", sizes.max));
  std::size_t most = 1;
  for (const SizeBin& bin : sizes.bins) most = std::max(most, bin.objects);
  const std::size_t digits = std::to_string(most).size();
  for (const SizeBin& bin : sizes.bins) {
    const auto length = (bin.objects * std::size_t{40} + most - 1) / most;
    const std::string label = bin.to == 0 ? "zero" : fmt::format("{:.6g} to {:.6g}", bin.from, bin.to);
    const std::string bar(length, '#');
    block.add(label, fmt::format("{:>{}}{}{}", bin.objects, digits, bar.empty() ? "" : " ", bar));
  }
}

/// The sums over all meshes; of faults only those that occur.
void add_meshes(Block& block, const std::vector<MeshCount>& meshes) {
  if (meshes.empty()) return;
  std::vector<std::pair<std::string_view, std::size_t>> sums = counts_of({});
  std::array<std::size_t, 4> totals{};  // vertices, faces, closed meshes, solids
  for (const MeshCount& mesh : meshes) {
    totals[0] += mesh.vertices;
    totals[1] += mesh.faces;
    totals[2] += mesh.report.is_closed ? 1 : 0;
    totals[3] += mesh.kind == MeshKind::solid ? 1 : 0;
    const auto counts = counts_of(mesh);
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i].second += counts[i].second;
  }
  block.add("vertices", fmt::format("{}", totals[0]));
  block.add("faces", fmt::format("{}", totals[1]));
  block.add("closed", fmt::format("{} of {}", totals[2], meshes.size()));
  if (totals[3] != 0) block.add("solids", fmt::format("{} of {}", totals[3], meshes.size()));
  for (const auto& [name, sum] : sums) {
    std::string label(name);
    std::replace(label.begin(), label.end(), '_', ' ');
    if (label.starts_with("non ")) label[3] = '-';
    if (sum != 0) block.add(label, fmt::format("{}", sum));
  }
}

}  // namespace

void write_summary_json(std::ostream& out, const SceneSummary& summary) {
  Json bounds = nullptr;
  if (summary.bounds) bounds = {{"min", summary.bounds->min}, {"max", summary.bounds->max}};
  const Json document = {{"schema", "graze.info/1"},
                         {"scene", summary.source},
                         {"format", summary.format},
                         {"dimension", summary.dimension},
                         {"objects", summary.objects},
                         {"types", counts_as_json(summary.types)},
                         {"layers", counts_as_json(summary.layers)},
                         {"bounds", bounds},
                         {"unbounded", summary.unbounded},
                         {"empty", summary.empty},
                         {"sizes", summary.sizes ? sizes_as_json(*summary.sizes) : Json(nullptr)},
                         {"meshes", meshes_as_json(summary.meshes)},
                         {"not_read", Json::parse(omissions_json(summary.omissions))}};
  out << document.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
}

void write_summary_table(std::ostream& out, const SceneSummary& summary, Colours colours) {
  out << fmt::format("{}: {}, {}D, {} object{}\n", printable(summary.source), printable(summary.format),
                     summary.dimension, summary.objects, summary.objects == 1 ? "" : "s");
  Block types("types", colours);
  add_counts(types, summary.types);
  Block layers("layers", colours);
  add_counts(layers, summary.layers);
  Block space("bounds", colours);
  add_space(space, summary);
  Block sizes("sizes (largest extent of each box)", colours);
  if (summary.sizes) add_sizes(sizes, *summary.sizes);
  Block meshes("meshes", colours);
  add_meshes(meshes, summary.meshes);
  Block not_read("not read", colours);
  for (const Omission& omission : summary.omissions) not_read.add(omission.what, fmt::format("{}", omission.count));
  for (const Block* block : {&types, &layers, &space, &sizes, &meshes, &not_read}) block->write(out);
}

}  // namespace graze::io
