// SPDX-License-Identifier: MIT
// A scene and the result of its check as a single page that works from disk, without a network. The page is the viewer
// with everything inlined, which `./dev web` builds, plus the data. It contains the name of the scene's file but not
// its folder, so it can be passed on.
#pragma once

#include <functional>
#include <iosfwd>
#include <memory>
#include <sstream>
#include <string>

#include <graze/io/report/check.hpp>
#include <graze/io/scene_file.hpp>

namespace graze::cli {

/// The page without data: the file named by $GRAZE_REPORT_TEMPLATE, otherwise share/graze/report.html beside the folder
/// of the installed program, otherwise the one that `./dev web` builds, in the build folder beside that of the program.
/// Throws InputError, naming the places that were searched, if none exists or it has no place for data.
std::string read_report_template();

/// Collects the results of a check and writes the page.
class HtmlReport {
 public:
  /// `page` is a template from `read_report_template`.
  HtmlReport(std::string page, io::ReportHead head);

  void add(const io::ReportedPair& pair) { writer_->write(pair); }

  /// Writes the page, once, after the last pair. Names are escaped, whatever they contain. Throws OutputError for what
  /// JSON cannot represent: a name that is not UTF-8.
  void finish(std::ostream& out, const io::SceneFile& file, const io::ReportSummary& summary);

 private:
  std::string page_;
  std::ostringstream check_;
  std::unique_ptr<io::ReportWriter> writer_;
};

}  // namespace graze::cli
