// SPDX-License-Identifier: MIT
// Reads a scene from memory, prints what graze did not read, and converts it to float.
#include <cstdio>
#include <string>
#include <variant>
#include <vector>

#include <graze/graze.hpp>
#include <graze/io/omission.hpp>
#include <graze/io/scene_file.hpp>
#include <graze/io/scene_numbers.hpp>

// A Tiled map with a text object, which has no shape.
constexpr const char* map = R"(<map orientation="orthogonal" width="4" height="4" tilewidth="16" tileheight="16">
  <objectgroup id="1" name="things">
    <object id="1" name="crate" x="8" y="8" width="16" height="16"/>
    <object id="2" name="stone" x="20" y="20" width="10" height="10"><ellipse/></object>
    <object id="3" x="0" y="0" width="40" height="16"><text>Level 1</text></object>
  </objectgroup>
</map>)";

int main() {
  const graze::io::SceneFile file = graze::io::parse_scene(map, "level.tmx", ".");
  for (const graze::io::Omission& omission : file.omissions) {
    std::printf("not read: %s\n", graze::io::omission_text(omission).c_str());
  }
  // The same for other programs: as JSON, and as lines of NDJSON and CSV.
  std::printf("%s\n", graze::io::omissions_json(file.omissions).c_str());
  for (const graze::io::Omission& omission : file.omissions) {
    std::printf("%s\n%s\n", graze::io::omission_ndjson(omission).c_str(),
                graze::io::omission_csv(omission, "kind,name,x,y", "kind").c_str());
  }
  const bool is_complete = graze::io::missing_shapes(file.omissions).empty();

  // Files hold doubles. After the conversion to float, ids, names and layers are the same.
  const auto& scene = std::get<graze::Scene<2, double>>(file.scene);
  const graze::Scene<2> in_float = graze::io::scene_with_numbers<float>(scene);
  const graze::AnyShape<2> crate = graze::io::with_numbers<float>(scene.object(*scene.find("crate")).shape);
  std::printf("%zu objects, the crate is a %s; %zu pairs\n", in_float.size(), graze::type_name(crate).data(),
              in_float.pairs().size());
  return !file.omissions.empty() && is_complete && in_float.pairs().size() == scene.pairs().size() ? 0 : 1;
}
