// SPDX-License-Identifier: MIT
#include "bench_report.hpp"

#include <algorithm>
#include <iterator>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace graze::mpi {
namespace {

using Json = nlohmann::ordered_json;

/// A frame as if one rank had done it all: counts are sums, the time is that of the slowest.
RankFrame whole(const FrameResult& result) {
  RankFrame all = result.ranks.front();
  for (auto rank = std::next(result.ranks.begin()); rank != result.ranks.end(); ++rank) {
    all.milliseconds = std::max(all.milliseconds, rank->milliseconds);
    all.checksum += rank->checksum;
    all.frame.boxes += rank->frame.boxes;
    all.frame.searched += rank->frame.searched;
    all.frame.ghosts += rank->frame.ghosts;
    all.frame.pairs += rank->frame.pairs;
    all.frame.messages += rank->frame.messages;
    all.frame.bytes += rank->frame.bytes;
  }
  return all;
}

void append_row(std::string& text, std::size_t frame, std::string_view rank, const RankFrame& row,
                std::string_view note) {
  fmt::format_to(std::back_inserter(text), "{:>5} {:>4} {:>10.2f} {:>7.3f} {:>10} {:>10} {:>9} {:>8} {:>11} {:>10}{}\n",
                 frame, rank, row.milliseconds, row.frame.balance, row.frame.boxes, row.frame.searched,
                 row.frame.ghosts, row.frame.messages, row.frame.bytes, row.frame.pairs, note);
}

std::string_view note_of(const DistributedFrame& frame) {
  if (frame.is_cut) return "  cut anew";
  return frame.is_planned ? "  planned anew" : "";
}

double mean_milliseconds(const MpiBenchReport& report) {
  double sum = 0;
  for (const FrameResult& frame : report.frames) sum += whole(frame).milliseconds;
  return sum / static_cast<double>(report.frames.size());
}

Json counts_of(const RankFrame& row) {
  return {{"milliseconds", row.milliseconds}, {"boxes", row.frame.boxes},       {"searched", row.frame.searched},
          {"ghosts", row.frame.ghosts},       {"messages", row.frame.messages}, {"bytes", row.frame.bytes},
          {"pairs", row.frame.pairs}};
}

}  // namespace

std::string table_of(const MpiBenchReport& report) {
  std::string text = fmt::format("{}, seed {}, {} ranks with {} threads each, skin {}\n", report.world, report.seed,
                                 report.frames.front().ranks.size(), report.threads, report.skin);
  text += "frame rank         ms balance      boxes   searched    ghosts messages       bytes      pairs\n";
  for (std::size_t i = 0; i < report.frames.size(); ++i) {
    const FrameResult& frame = report.frames[i];
    for (std::size_t rank = 0; rank < frame.ranks.size(); ++rank) {
      append_row(text, i, std::to_string(rank), frame.ranks[rank], "");
    }
    append_row(text, i, "all", whole(frame), note_of(frame.ranks.front().frame));
  }
  text += fmt::format("mean: {:.2f} ms; ghosts in the last frame: {}, by the model {:.0f}; checksum {:016x}\n",
                      mean_milliseconds(report), whole(report.frames.back()).frame.ghosts,
                      report.frames.back().ghosts_model, whole(report.frames.back()).checksum);
  return text;
}

std::string json_of(const MpiBenchReport& report) {
  Json document{{"schema", "graze.mpi-bench/1"},
                {"world", report.world},
                {"seed", report.seed},
                {"boxes", report.boxes},
                {"threads", report.threads},
                {"skin", report.skin},
                {"ranks", report.frames.front().ranks.size()},
                {"mean_milliseconds", mean_milliseconds(report)}};
  Json frames = Json::array();
  for (const FrameResult& frame : report.frames) {
    const RankFrame all = whole(frame);
    Json one = counts_of(all);
    one["balance"] = all.frame.balance;
    one["is_planned"] = all.frame.is_planned;
    one["is_cut"] = all.frame.is_cut;
    one["ghosts_model"] = frame.ghosts_model;
    one["checksum"] = fmt::format("{:016x}", all.checksum);
    one["by_rank"] = Json::array();
    for (const RankFrame& rank : frame.ranks) one["by_rank"].push_back(counts_of(rank));
    frames.push_back(one);
  }
  document["frames"] = frames;
  return document.dump(2) + "\n";
}

}  // namespace graze::mpi
