// SPDX-License-Identifier: MIT
#include "html_report.hpp"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <ostream>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <graze/io/file/utf8_path.hpp>
#include <graze/io/file/whole_file.hpp>
#include <graze/io/input_error.hpp>
#include <graze/io/json_scene.hpp>
#include <graze/io/text/file_name.hpp>
#include <graze/io/text/in_quotes.hpp>
#include <graze/io/text/quoting.hpp>

#include "system.hpp"

namespace graze::cli {
namespace {

namespace fs = std::filesystem;

/// The template's element for the data; it is empty and is closed immediately.
constexpr std::string_view data_place = R"(<script type="application/json" id="graze-report">)";

constexpr const char* template_variable = "GRAZE_REPORT_TEMPLATE";

std::vector<fs::path> places_to_look() {
  if (const std::string named = environment(template_variable); !named.empty()) return {io::path_from_utf8(named)};
  const fs::path folder = program_path().parent_path();
  if (folder.empty()) return {};
  return {(folder / "../share/graze/report.html").lexically_normal(),
          (folder / "../../web/viewer/report.html").lexically_normal()};
}

/// Escapes JSON for use in an HTML page: "<" occurs only in strings, where its escape means the same, and without "<"
/// nothing can end the element or begin a comment.
void write_for_html(std::ostream& out, std::string_view json) {
  for (std::size_t from = 0; from < json.size();) {
    const std::size_t next = std::min(json.find('<', from), json.size());
    out << json.substr(from, next - from);
    if (next < json.size()) out << "\\u003c";
    from = next + 1;
  }
}

}  // namespace

std::string read_report_template() {
  const std::vector<fs::path> places = places_to_look();
  for (const fs::path& place : places) {
    std::error_code error;
    if (!fs::exists(place, error)) continue;
    if (fs::is_directory(place, error)) {
      throw io::InputError(fmt::format("{} is a folder; {} must name a file, the report.html that `./dev web` builds",
                                       io::in_quotes(io::utf8_from_path(place)), template_variable));
    }
    std::string page = io::read_whole_file(place, "the template");
    if (page.find(data_place) != std::string::npos) return page;
    throw io::InputError(
        fmt::format("{} is not a report template: it has no place for data; run `./dev web` to "
                    "build one",
                    io::in_quotes(io::utf8_from_path(place))));
  }
  std::string looked;
  for (const fs::path& place : places) {
    looked += fmt::format("{}{}", looked.empty() ? "" : " and ", io::in_quotes(io::utf8_from_path(place)));
  }
  throw io::InputError(
      fmt::format("there is no template for HTML reports{}{}; run `./dev web` to build it, or name one "
                  "in the environment variable {}",
                  looked.empty() ? "" : " at ", looked, template_variable));
}

HtmlReport::HtmlReport(std::string page, io::ReportHead head) : page_(std::move(page)) {
  head.source = io::file_name(head.source);
  for (io::Omission& omission : head.not_read) omission.where = io::file_name(omission.where);
  writer_ = io::begin_report(check_, io::ReportFormat::json, head);
}

void HtmlReport::finish(std::ostream& out, const io::SceneFile& file, const io::ReportSummary& summary) {
  writer_->finish(summary);
  std::ostringstream scene;
  io::write_json_scene(scene, file);
  const std::string_view page = page_;
  const std::size_t place = page.find(data_place) + data_place.size();
  out << page.substr(0, place);
  // The scene is stored as text in a string, because JavaScript's numbers could not represent all its fields.
  write_for_html(out, fmt::format("{{\"source\": {},\n\"scene\": {}", io::json_string(io::file_name(file.source)),
                                  io::json_string(scene.str())));
  write_for_html(out, ",\n\"check\": ");
  write_for_html(out, check_.str());
  out << "}\n" << page.substr(place);
}

}  // namespace graze::cli
