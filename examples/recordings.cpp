// SPDX-License-Identifier: MIT
// Writes the frames of moving boxes to a file and reads them back in any order, for example to benchmark another
// program on the same boxes.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <span>
#include <vector>

#include <graze/broad/scene_generators.hpp>
#include <graze/graze.hpp>
#include <graze/io/recording.hpp>

int main() {
  const std::filesystem::path path = std::filesystem::temp_directory_path() / "graze_example.aabbs";
  graze::MovingBoxes<3> world(graze::World::brownian, 1000, 1);
  const graze::io::RecordingHead head{"brownian", "cubes", world.boxes().size(), 10, world.bounds()};
  {
    std::ofstream file(path, std::ios::binary);
    graze::io::write_recording<3>(file, head, [&world](std::size_t frame) {
      if (frame > 0) world.step();
      return world.boxes();
    });
  }

  graze::io::RecordingReader reader(path);
  std::printf("%s in %dD: %zu boxes, %zu frames\n", reader.head().scene.c_str(),
              static_cast<int>(reader.head().dimension()), reader.head().boxes, reader.head().frames);
  std::vector<graze::Aabb<3>> boxes;
  std::size_t frames = 0;
  graze::PairFinder<3> finder;
  while (reader.next(boxes)) {
    std::printf("frame %zu: %zu pairs\n", frames++, finder.find(boxes).size());
  }
  reader.seek(9);
  reader.next(boxes);
  std::filesystem::remove(path);
  const std::span<const graze::Aabb<3>> last = world.boxes();
  return frames == 10 && boxes == std::vector<graze::Aabb<3>>(last.begin(), last.end()) ? 0 : 1;
}
