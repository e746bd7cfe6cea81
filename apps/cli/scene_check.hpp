// SPDX-License-Identifier: MIT
// The search for all touching pairs of a scene, with its reports and progress display.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include <graze/io/report/check.hpp>
#include <graze/io/scene_file.hpp>
#include <graze/scene/object.hpp>
#include <graze/scene/scene.hpp>

#include "progress.hpp"

namespace graze::cli {

/// Which pairs are reported, and with which details. `contacts` and `only_interior` apply to touching pairs, so they
/// exclude `within`.
struct CheckedPairs {
  bool only_interior = false;    ///< Only pairs whose interiors overlap.
  bool contacts = false;         ///< With the contact points.
  std::optional<double> within;  ///< All pairs at most this far apart, with their distance.
};

class SceneCheck {
 public:
  /// `file` and `progress` must outlive the check.
  SceneCheck(const io::SceneFile& file, const CheckedPairs& wanted, Progress& progress);

  /// Receives a pair to report: by name, with its details, and by id.
  using OnPair = std::function<void(const io::ReportedPair&, const ObjectPair&)>;

  /// Finds the pairs and passes them to `on_pair` in order, without storing them. They come in blocks, and
  /// `after_block` is called after each, so that a report grows while the search runs and the time of the search is
  /// measured without that of writing; the search ends if it returns false. Call once.
  void run(const OnPair& on_pair, const std::function<bool()>& after_block);

  const io::ReportHead& head() const { return head_; }

  /// Complete after `run`.
  const io::ReportSummary& summary() const { return summary_; }

 private:
  template <Dim N>
  std::vector<std::optional<io::ReportedPair>> tested(const Scene<N, double>& scene,
                                                      std::span<const ObjectPair> candidates) const;
  template <Dim N>
  void search(const Scene<N, double>& scene, const OnPair& on_pair, const std::function<bool()>& after_block);

  const io::SceneFile& file_;
  CheckedPairs wanted_;
  Progress& progress_;
  io::ReportHead head_;
  io::ReportSummary summary_;
};

}  // namespace graze::cli
