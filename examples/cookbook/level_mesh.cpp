// SPDX-License-Identifier: MIT
// A level that is one mesh in a scene, beside other objects: a character walks on it, and shots hit its faces.
#include <array>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include <graze/query/ray_cast.hpp>
#include <graze/query/transformed.hpp>
#include <graze/scene/scene.hpp>
#include <graze/scene/slide.hpp>
#include <graze/shape/mesh.hpp>

#include "picture.hpp"

using Point = graze::Vec<3>;

/// The upper side of a profile along x that is 6 wide.
graze::Mesh<3> level_of(const std::vector<Point>& profile) {
  std::vector<Point> vertices;
  std::vector<std::array<std::uint32_t, 3>> faces;
  for (const Point& corner : profile) {
    for (const float y : {0.0F, 6.0F}) vertices.push_back(corner + Point(0, y, 0));
    const auto last = static_cast<std::uint32_t>(vertices.size()) - 1;
    if (last < 3) continue;
    faces.push_back({last - 3, last - 1, last});
    faces.push_back({last - 3, last, last - 2});
  }
  return graze::mesh_of<3>(vertices, faces);
}

int main(int argc, char** argv) {
  const graze::Mesh<3> ground = level_of({{0, 0, 0}, {5, 0, 0}, {5, 0, 0.3F}, {8, 0, 0.3F}, {12, 0, 2}, {16, 0, 2}});
  graze::Scene<3> scene;
  scene.add(ground, {.name = "level", .mobility = graze::Mobility::fixed});
  scene.add(graze::Obb<3>{{13, 2.6F, 2.5F}, {0.5F, 0.5F, 0.5F}}, {.name = "crate"});
  const graze::ObjectId hero = scene.add(graze::Capsule<3>{{1, 3, 0.6F}, {1, 3, 1.6F}, 0.5F}, {.name = "hero"});

  cookbook::Picture<3> picture("a level as a mesh");
  picture.draw(scene.object(*scene.find("crate")).shape, "crate");
  for (std::size_t face = 0; face < ground.faces().size(); ++face) picture.draw(ground.triangle(face));
  const graze::SlideOptions walk{
      .query = {.except = {&hero, 1}}, .up = {0, 0, 1}, .max_slope = 0.8, .step_height = 0.4};
  std::string wall;
  for (int frame = 1; frame <= 300; ++frame) {
    const graze::AnyShape<3> shape = scene.object(hero).shape;
    const graze::Slide<3> path = slide(scene, shape, {0.06F, 0, -0.06F}, walk);
    scene.move(hero, graze::translated<3, float>(shape, path.motion));
    for (const auto& [id, impact] : path.touches) wall = impact.normal.x > 0.9F ? scene.object(id).name : wall;
    if (frame % 30 != 0) continue;
    const Point foot = graze::bounds(scene.object(hero).shape).min + Point(0.5F, 0.5F, 0);
    const auto below = ray_cast(ground, graze::Ray<3>{foot + Point(0, 0, 0.2F), {0, 0, -1}}, 1.0F);
    std::printf("frame %3d: foot at (%5.2f, %.2f, %.2f) on face %zu\n", frame, foot.x, foot.y, foot.z,
                below ? below->face : graze::no_face);
    picture.draw(scene.object(hero).shape);
  }
  std::printf("stopped by the %s; the level has %zu faces\n", wall.c_str(), ground.faces().size());
  return picture.save(argc, argv);
}
