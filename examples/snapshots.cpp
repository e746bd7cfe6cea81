// SPDX-License-Identifier: MIT
// A snapshot does not change when the scene does: another thread reads one here, and two of them show what changed in
// between.
#include <cstdio>
#include <future>
#include <memory>

#include <graze/graze.hpp>

int main() {
  graze::Scene<2> scene;
  const graze::ObjectId ball = scene.add(graze::Circle<>{{0, 0.9F}, 1}, {.name = "ball"});
  scene.add(graze::Circle<>{{0, 5}, 1}, {.name = "balloon"});
  scene.add(graze::Plane<2>{{0, 1}, 0}, {.name = "ground"});

  const std::shared_ptr<const graze::SceneView<2>> before = scene.snapshot();  // copies no object
  std::future<std::size_t> pairs_before = std::async(std::launch::async, [before] { return before->pairs().size(); });
  scene.move(ball, graze::Circle<>{{0, 3.5F}, 1});  // the reader does not see this
  const std::shared_ptr<const graze::SceneView<2>> after = scene.snapshot();

  const graze::SceneEvents events = graze::events_between(before->pairs(), after->pairs());
  for (const graze::ObjectPair& pair : events.began) {
    std::printf("%s begins to touch %s\n", after->object(pair.a).name.c_str(), after->object(pair.b).name.c_str());
  }
  for (const graze::ObjectPair& pair : events.ended) {
    std::printf("%s no longer touches %s\n", before->object(pair.a).name.c_str(), before->object(pair.b).name.c_str());
  }
  return pairs_before.get() == 1 && events.began.size() == 1 && events.ended.size() == 1 && events.stayed.empty() ? 0
                                                                                                                  : 1;
}
