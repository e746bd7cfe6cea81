// SPDX-License-Identifier: MIT
// A scene and what a check of it found, as one page that opens in a browser, from disk and without a network. The page
// is the viewer with everything inlined, which `./dev web` builds; here its data are filled in. It names the scene's
// file, not the folders it lies in: the page may be mailed.
#pragma once

#include <functional>
#include <iosfwd>
#include <memory>
#include <sstream>
#include <string>

#include <graze/io/report/check.hpp>
#include <graze/io/scene_file.hpp>

namespace graze::cli {

/// The page without data: the file that $GRAZE_REPORT_TEMPLATE names, else share/graze/report.html beside the folder of
/// the installed program, else what `./dev web` has put into the build folder beside that of the program. Throws
/// InputError that says where was looked, when there is none, and when what is there has no place for data.
std::string read_report_template();

/// Gathers what the check finds and writes the page.
class HtmlReport {
 public:
  /// `page` is a template as `read_report_template` gives it.
  HtmlReport(std::string page, io::ReportHead head);

  void add(const io::ReportedPair& pair) { writer_->write(pair); }

  /// Writes the page, once, after the last pair. Whatever names hold, the browser takes it for data. Throws OutputError
  /// for what JSON cannot hold: a name that is not UTF-8.
  void finish(std::ostream& out, const io::SceneFile& file, const io::ReportSummary& summary);

 private:
  std::string page_;
  std::ostringstream check_;
  std::unique_ptr<io::ReportWriter> writer_;
};

}  // namespace graze::cli
