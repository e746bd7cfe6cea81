// SPDX-License-Identifier: MIT
// Saves a scene and continues with the loaded one: an index and a generation mean the same object as before.
#include <cstdio>
#include <optional>
#include <sstream>
#include <variant>

#include <graze/graze.hpp>
#include <graze/io/json_scene.hpp>

int main() {
  graze::Scene<2, double> scene;
  const graze::ObjectId lamp = scene.add(graze::Circle<double>{{0, 8}, 0.5}, {.name = "lamp"});
  scene.add(graze::Rect<double>{{2, 0}, {3, 1}}, {.name = "crate"});
  scene.remove(lamp);
  const graze::ObjectId ball = scene.add(graze::Circle<double>{{1, 1}, 1}, {.name = "ball"});
  scene.update();

  std::stringstream file;  // or a std::ofstream
  graze::io::write_json_scene(file, {scene, "", "", graze::io::YAxis::up, {}});

  const graze::io::SceneFile saved = graze::io::parse_json_scene(file.str(), "save.json");
  auto loaded = std::get<graze::Scene<2, double>>(saved.scene);
  const std::optional<graze::ObjectId> same = loaded.find(ball.index, ball.generation);
  std::printf("index %u, generation %u: %s\n", ball.index, ball.generation, loaded.object(*same).name.c_str());
  std::printf("the lamp is %s\n", loaded.find(lamp.index, lamp.generation) ? "back" : "still gone");
  std::printf("%zu pair begins to touch, %zu in the scene that goes on\n", loaded.update().began.size(),
              scene.update().began.size());
  return loaded.events().began.size() == 1 && scene.events().stayed.size() == 1 ? 0 : 1;
}
