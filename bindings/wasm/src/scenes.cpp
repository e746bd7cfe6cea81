// SPDX-License-Identifier: MIT
// Functions that change scenes. scene_questions.cpp and scene_queries.cpp contain the queries.
#include "scenes.hpp"

#include <cstddef>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <emscripten/bind.h>
#include <fmt/format.h>

#include <graze/io/text/in_quotes.hpp>
#include <graze/query/transformed.hpp>
#include <graze/scene/scene.hpp>

#include "arguments.hpp"
#include "placed.hpp"
#include "poses.hpp"
#include "scene_files.hpp"

namespace graze::wasm {
namespace {

SceneHandle* make_scene(int dimension) {
  auto handle = std::make_unique<SceneHandle>();
  handle->file.format = "graze.scene/1";
  in_dimension(dimension, [&](auto n) { handle->file.scene = Scene<n, double>(); });
  return handle.release();  // embind owns it
}

template <Dim N>
std::vector<Mover<N>> movers_of(const io::SceneFile& file, const Scene<N, double>& scene) {
  std::vector<Mover<N>> movers;
  for (const io::ObjectVelocity& each : file.velocities) {
    movers.push_back({each.id, scene.object(each.id).shape, Vec<N, double>(each.velocity)});
  }
  return movers;
}

SceneHandle* read_scene_text(std::string content, std::string name) {
  auto handle = std::make_unique<SceneHandle>(SceneHandle{scene_of_text(content, name)});
  handle->visit([&]<Dim N>(const Scene<N, double>& scene) {
    const auto ids = scene.ids();
    if (!ids.empty()) handle->owner = ids.front().owner;
    handle->movers = movers_of<N>(handle->file, scene);
  });
  return handle.release();  // embind owns it
}

/// Adds all shapes or none; the output contains their ids.
template <Dim N>
void add_all(SceneHandle& self, Scene<N, double>& scene, std::vector<AnyShape<N, double>> shapes,
             const ObjectOptions& options) {
  std::vector<ObjectId> ids;
  try {
    for (AnyShape<N, double>& shape : shapes) ids.push_back(scene.add(std::move(shape), options));
  } catch (...) {
    for (const ObjectId id : ids) scene.remove(id);
    throw;
  }
  for (const ObjectId id : ids) put_id(id);
  if (!ids.empty()) self.owner = ids.front().owner;
}

double add(SceneHandle& self, std::size_t place, std::string options) {
  const ObjectWords words(options);
  return self.visit([&]<Dim N>(Scene<N, double>& scene) {
    const ObjectId id = scene.add(Arguments(place).shape<N>(), words.in(scene));
    self.owner = id.owner;
    return packed_id(id.index, id.generation);
  });
}

void add_many(SceneHandle& self, std::size_t place, std::string options) {
  const ObjectWords words(options);
  self.visit([&]<Dim N>(Scene<N, double>& scene) {
    std::vector<AnyShape<N, double>> shapes = Arguments(place).shapes<N>();
    add_all(self, scene, std::move(shapes), words.in(scene));
  });
}

/// The layout of shapes of one type in the input.
enum class Row { boxes, spheres };

template <Dim N>
constexpr std::size_t numbers_in(Row row) {
  return static_cast<std::size_t>(row == Row::boxes ? 2 * N : N + 1);
}

template <Dim N>
AnyShape<N, double> shape_in_row(Row row, std::span<const double> numbers, std::size_t index) {
  if (row == Row::boxes) return box_at<N>(numbers, index);
  const auto own = numbers.subspan(index * numbers_in<N>(row), numbers_in<N>(row));
  return Sphere<N, double>{vector_at<N>(own, 0), own.back()};
}

/// Reports a defect with the index of its shape, which Scene would not know.
template <Dim N>
void require_valid_rows(Row row, std::span<const double> numbers, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const AnyShape<N, double> shape = shape_in_row<N>(row, numbers, i);
    if (is_valid(shape)) continue;
    throw std::invalid_argument(fmt::format("{} {} {}", row == Row::boxes ? "box" : "sphere", i, defect(shape)));
  }
}

template <Row row>
void add_rows(SceneHandle& self, std::size_t count, std::string options) {
  const ObjectWords words(options);
  self.visit([&]<Dim N>(Scene<N, double>& scene) {
    const auto numbers = input<double>(count * numbers_in<N>(row));
    require_valid_rows<N>(row, numbers, count);
    std::vector<AnyShape<N, double>> shapes;
    shapes.reserve(count);
    for (std::size_t i = 0; i < count; ++i) shapes.push_back(shape_in_row<N>(row, numbers, i));
    add_all(self, scene, std::move(shapes), words.in(scene));
  });
}

template <Dim N>
std::vector<Unposed<N>>& unposed_in(SceneHandle& self) {
  return std::get<std::vector<Unposed<N>>>(self.unposed);
}

/// The shape of the object without a pose: its current shape, unless it was last moved by a pose.
template <Dim N>
const AnyShape<N, double>& unposed(SceneHandle& self, ObjectId id, const Object<N, double>& object) {
  std::vector<Unposed<N>>& all = unposed_in<N>(self);
  if (id.index >= all.size()) all.resize(id.index + std::size_t{1});
  Unposed<N>& own = all[id.index];
  if (own.generation != id.generation) own = {id.generation, object.shape};
  return own.shape;
}

/// Moves objects by other means than a pose.
template <Dim N>
void move_all(SceneHandle& self, Scene<N, double>& scene, std::span<const ObjectMove<N, double>> moves) {
  scene.move(moves);
  std::vector<Unposed<N>>& all = unposed_in<N>(self);
  for (const ObjectMove<N, double>& each : moves) {
    if (each.id.index < all.size()) all[each.id.index] = {};
  }
}

void move_one(SceneHandle& self, double id, std::size_t place) {
  self.visit([&]<Dim N>(Scene<N, double>& scene) {
    const ObjectMove<N, double> move{self.id_of(id), Arguments(place).shape<N>()};
    move_all<N>(self, scene, {&move, 1});
  });
}

/// The moves of many objects: the input contains their ids, then the given number of numbers for each, from which
/// next(id, object, numbers, place) creates the new shape.
template <Dim N, class Next>
std::vector<ObjectMove<N, double>> moves_in_input(SceneHandle& self, const Scene<N, double>& scene, std::size_t count,
                                                  std::size_t width, const Next& next) {
  const auto numbers = input<double>(count * (1 + width));
  std::vector<ObjectMove<N, double>> moves;
  moves.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const ObjectId id = self.id_of(numbers[i]);
    moves.push_back({id, next(id, scene.object(id), numbers.subspan(count), i)});
  }
  return moves;
}

template <Dim N, class Next>
void move_many(SceneHandle& self, Scene<N, double>& scene, std::size_t count, std::size_t width, const Next& next) {
  const auto without_id = [&next](ObjectId, const auto&... rest) { return next(rest...); };
  move_all<N>(self, scene, moves_in_input(self, scene, count, width, without_id));
}

void translate(SceneHandle& self, std::size_t count) {
  self.visit([&]<Dim N>(Scene<N, double>& scene) {
    move_many(self, scene, count, static_cast<std::size_t>(N),
              [](const Object<N, double>& object, std::span<const double> numbers, std::size_t i) {
                return graze::translated<N, double>(object.shape, vector_at<N>(numbers, i));
              });
  });
}

void place(SceneHandle& self, std::size_t count) {
  self.visit([&]<Dim N>(Scene<N, double>& scene) {
    move_many(self, scene, count, static_cast<std::size_t>(N),
              [](const Object<N, double>& object, std::span<const double> numbers, std::size_t i) {
                if (!is_valid(object.box)) {
                  throw std::invalid_argument(fmt::format(
                      "place: object {} {} has no finite bounds, so it has no center", i, io::in_quotes(object.name)));
                }
                return placed<N>(object.shape, object.box, vector_at<N>(numbers, i));
              });
  });
}

template <Row row>
void move_rows(SceneHandle& self, std::size_t count) {
  self.visit([&]<Dim N>(Scene<N, double>& scene) {
    const std::size_t width = numbers_in<N>(row);
    require_valid_rows<N>(row, input<double>(count * (1 + width)).subspan(count), count);
    move_many(self, scene, count, width, [](const Object<N, double>&, std::span<const double> numbers, std::size_t i) {
      return shape_in_row<N>(row, numbers, i);
    });
  });
}

/// Positions are calculated from the initial ones, so that rounding errors do not accumulate, as in `graze simulate`.
void move_to_time(SceneHandle& self, double seconds) {
  self.visit([&]<Dim N>(Scene<N, double>& scene) {
    std::vector<ObjectMove<N, double>> moves;
    if (const auto* const movers = std::get_if<std::vector<Mover<N>>>(&self.movers)) {
      for (const Mover<N>& mover : *movers) {
        if (!scene.contains(mover.id)) continue;
        moves.push_back({mover.id, graze::translated<N, double>(mover.shape, mover.velocity * seconds)});
      }
    }
    move_all<N>(self, scene, moves);
  });
}

void pose(SceneHandle& self, std::size_t count) {
  self.visit([&]<Dim N>(Scene<N, double>& scene) {
    const auto next = [&self](ObjectId id, const Object<N, double>& object, std::span<const double> numbers,
                              std::size_t i) {
      return transformed(unposed<N>(self, id, object), pose_at<N>(numbers, i));
    };
    const auto moves = moves_in_input(self, scene, count, numbers_in_pose<N>, next);
    scene.move(std::span<const ObjectMove<N, double>>(moves));
  });
}

void remove(SceneHandle& self, double id) {
  self.visit([&](auto& scene) { scene.remove(self.id_of(id)); });
}

void except(SceneHandle& self, double a, double b) {
  self.visit([&](auto& scene) { scene.except(self.id_of(a), self.id_of(b)); });
}

void accept(SceneHandle& self, double a, double b) {
  self.visit([&](auto& scene) { scene.accept(self.id_of(a), self.id_of(b)); });
}

int layer(SceneHandle& self, std::string name) {
  return self.visit([&](auto& scene) { return static_cast<int>(scene.layer(name)); });
}

/// The numbers of pairs that began and that stayed, then the pairs that began, stayed and ended.
void update(SceneHandle& self) {
  self.visit([](auto& scene) {
    const SceneEvents& events = scene.update();
    answer().push_back(static_cast<double>(events.began.size()));
    answer().push_back(static_cast<double>(events.stayed.size()));
    for (const auto* const list : {&events.began, &events.stayed, &events.ended}) {
      for (const ObjectPair& pair : *list) {
        put_id(pair.a);
        put_id(pair.b);
      }
    }
  });
}

}  // namespace

EMSCRIPTEN_BINDINGS(graze_scenes) {
  using namespace emscripten;  // NOLINT(google-build-using-namespace): as embind is written
  class_<SceneHandle>("Scene")
      .class_function("make", &Guarded<&make_scene>::call, allow_raw_pointers())
      .class_function("read", &Guarded<&read_scene_text>::call, allow_raw_pointers())
      .function("add", &Guarded<&add>::call)
      .function("addMany", &Guarded<&add_many>::call)
      .function("addBoxes", &Guarded<&add_rows<Row::boxes>>::call)
      .function("addSpheres", &Guarded<&add_rows<Row::spheres>>::call)
      .function("move", &Guarded<&move_one>::call)
      .function("translate", &Guarded<&translate>::call)
      .function("place", &Guarded<&place>::call)
      .function("moveBoxes", &Guarded<&move_rows<Row::boxes>>::call)
      .function("moveSpheres", &Guarded<&move_rows<Row::spheres>>::call)
      .function("pose", &Guarded<&pose>::call)
      .function("moveToTime", &Guarded<&move_to_time>::call)
      .function("remove", &Guarded<&remove>::call)
      .function("except", &Guarded<&except>::call)
      .function("accept", &Guarded<&accept>::call)
      .function("layer", &Guarded<&layer>::call)
      .function("update", &Guarded<&update>::call);
  function("addSceneFile", &Guarded<&add_scene_file>::call);
  function("removeSceneFiles", &Guarded<&remove_scene_files>::call);
}

}  // namespace graze::wasm
