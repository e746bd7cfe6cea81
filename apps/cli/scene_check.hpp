// SPDX-License-Identifier: MIT
// The search for all pairs of a scene that touch, with its reports and the progress that a person sees.
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

/// Which pairs are reported, and what of them. `contacts` and `only_interior` are about pairs that touch, so they do
/// not go together with `within`.
struct CheckedPairs {
  bool only_interior = false;    ///< Only those whose interiors overlap.
  bool contacts = false;         ///< With the points where they touch.
  std::optional<double> within;  ///< All that are no farther apart than this, with their distance.
};

class SceneCheck {
 public:
  /// `file` and `progress` must outlive the check.
  SceneCheck(const io::SceneFile& file, const CheckedPairs& wanted, Progress& progress);

  /// Takes a pair that was asked for: by name, with what is told of it, and by id.
  using OnPair = std::function<void(const io::ReportedPair&, const ObjectPair&)>;

  /// Finds the pairs and gives them to `on_pair` in order, of which none is kept. They come in blocks, and
  /// `after_block` is called after each, so that whoever reads a report gets pairs while the search goes on, and so
  /// that the time of the search is told from that of writing; false from it ends the search. To be called once.
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
