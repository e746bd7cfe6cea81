// SPDX-License-Identifier: MIT
// Records the calls on a scene, replays them on the library and on a brute-force scene, and reduces a log that shows a
// fault. Here the fault is written into the log.
#include <cstdio>
#include <iostream>
#include <optional>
#include <sstream>
#include <string>
#include <variant>

#include <graze/graze.hpp>
#include <graze/io/recorded_scene.hpp>
#include <graze/io/replay.hpp>
#include <graze/io/shrink.hpp>

/// A program switches recording on and off by this alias; `graze::Scene<2>` records nothing.
using World = graze::io::RecordedScene<2>;

void play(World& world) {
  const graze::ObjectId ball = world.add(graze::Circle<>{{0, 5}, 1}, {.name = "ball"});
  world.add(graze::Rect<>{{-1, 0}, {1, 1}}, {.name = "crate"});
  world.add(graze::Rect<>{{5, 0}, {6, 1}}, {.name = "another crate"});
  for (int frame = 1; frame <= 4; ++frame) {
    world.move(ball, graze::Circle<>{{0, 5 - static_cast<float>(frame)}, 1});
    world.update();
    world.snapshot()->pairs();  // not a call on the scene: not recorded
    world.nearest({0, 0}, 2);
  }
}

int main() {
  std::ostringstream text;
  World world(text);
  play(world);

  std::printf("%zu objects\n", world.scene().size());  // the scene itself, for calls that are not recorded

  const auto any_log = graze::io::parse_query_log(text.str(), "game.log");
  auto log = std::get<graze::io::QueryLog<2>>(any_log);
  const auto targets = graze::io::library_targets<2>(log.numbers);
  const graze::io::ReplayReport report = graze::io::replay(log, targets);
  std::printf("%zu calls performed again, %zu answers differ\n", report.calls, report.differing);

  // As if another version had once given a different result.
  log.entries.back().answer = log.entries[log.entries.size() - 3].answer;
  const std::optional<graze::io::QueryLog<2>> small = graze::io::shrunk(log, targets);
  if (!small) return 1;
  std::printf("%zu calls fail, and so do %zu of them\n", log.entries.size(), small->entries.size());
  graze::io::write_query_log(std::cout, *small);
  return report.differing == 0 && report.calls == log.entries.size() && small->entries.size() < log.entries.size() ? 0
                                                                                                                   : 1;
}
